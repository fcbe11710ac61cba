// Two cores of one chip, as in an RP2040 or an ESP32-S3, draw one frame: each core takes the next strip as soon as it
// is free, so that strips of unequal work keep neither core waiting.
//
// Each core has a renderer with its own arena. Both share scene and plan, which must not change meanwhile. Loads and
// stores of words are enough for the synchronisation: it runs on a Cortex-M0.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_hal/shared_strips.hpp"

namespace zstrip::hal {

/// Time in microseconds that the first core waits for the second one to draw a strip, or to begin a frame.
inline constexpr std::uint32_t kMaxStripMicroseconds = 1'000'000;

/// Holds the requests of the first core to the second one. Must lie in memory that both cores see identically: not
/// behind a data cache that only one of them has.
template <StripRenderer Renderer>
class SecondCore {
 public:
  /// The type that the renderer's functions return.
  using DrawStatus = decltype(std::declval<Renderer&>().draw_strip(std::uint16_t{}, std::span<std::byte>{}));

  /// Only the second core draws with `renderer`, which must outlive this object.
  explicit constexpr SecondCore(Renderer& renderer) : renderer_(renderer) {}

  /// Call it on the second core, again and again: executes one step of the pending request. Returns false if there is
  /// nothing to do now; the core may then do other work.
  bool serve() {
    const std::uint32_t done = done_.load(std::memory_order_relaxed);
    if (asked_.load(std::memory_order_acquire) == done) return false;
    const Order& order = orders_[done % 2];
    const Progress progress = order.run(*this, order.work);
    if (progress == Progress::over) done_.store(done + 1, std::memory_order_release);
    return progress != Progress::idle;
  }

  /// Call it on the first core: requests that the second core runs `work()`, which begins a frame with that core's
  /// renderer and returns a status. `work` must live until is_done(), or until the present() that follows has
  /// returned. Call it once a frame, and only when is_done() is true: otherwise it does nothing, and that present()
  /// returns Error::second_core.
  template <class Work>
  void start(const Work& work) {
    if (!is_done()) {
      start_ = Start::refused;
      return;
    }
    start_ = Start::asked;
    ask({[](SecondCore& self, const void* what) {
           self.begun_ = (*static_cast<const Work*>(what))();
           return Progress::over;
         },
         &work});
  }
  /// Call it on the first core: true if all requests are done.
  bool is_done() const { return done_.load(std::memory_order_acquire) == asked_.load(std::memory_order_relaxed); }

  /// See the function present() below.
  template <Display Panel, Clock Time>
  PresentResult<DrawStatus> present(Renderer& own, Panel& display, const StripLayout& layout,
                                    const TwoCoreBuffers& buffers, Time& clock) {
    const Start start = std::exchange(start_, Start::none);
    const StripAreas areas(layout, display.width(), display.height());
    Error error = start == Start::refused ? Error::second_core : refuse(areas, display.format(), buffers);
    // After start() the second core may begin the frame while this one draws; without it, wait until its requests are
    // done: a status that they leave is that of an earlier frame.
    if (error == Error::none && start == Start::none) {
      if (wait_until_done(clock)) {
        begun_ = {};
      } else {
        error = Error::second_core;
      }
    }
    if (error == Error::none) error = display.begin_frame();
    if (error != Error::none) {
      if (start != Start::asked) return {{}, error};
      if (!wait_until_done(clock)) return {{}, Error::second_core};
      return {std::exchange(begun_, {}), error};
    }

    strips_.open(display, areas, layout.count, buffers);
    ask({[](SecondCore& self, const void*) {
           const DrawStatus status = std::exchange(self.begun_, {});
           if (!status) self.strips_.fail(Core::second, status, Error::none);
           return self.strips_.step(Core::second, self.renderer_);
         },
         nullptr});
    std::uint32_t waited = 0;
    bool answers = true;
    while (answers) {
      const Progress progress = strips_.step(Core::first, own);
      if (progress == Progress::over && is_done()) break;
      if (progress == Progress::worked) {
        waited = 0;
      } else {
        answers = keep_waiting(clock, waited);
      }
    }
    if (!answers) strips_.fail(Core::first, {}, Error::second_core);
    PresentResult<DrawStatus> result = strips_.result(Core::first);
    // Also after another error: only this one says that the second core keeps its buffer.
    if (!answers) result.display = Error::second_core;
    // The second core is inside a function of the display.
    if (strips_.is_display_used(Core::first)) return result;
    const Error last_transfer = display.wait();
    const Error end = display.end_frame();
    if (result) result.display = last_transfer != Error::none ? last_transfer : end;
    return result;
  }

 private:
  enum class Start : std::uint8_t { none, asked, refused };
  struct Order {
    Progress (*run)(SecondCore& self, const void* work) = nullptr;
    const void* work = nullptr;
  };

  static Error refuse(const StripAreas& areas, DisplayFormat format, const TwoCoreBuffers& buffers) {
    if (!areas.cover()) return Error::strip_layout;
    for (const std::span<std::byte>& buffer : buffers) {
      if (buffer.size() < areas.bytes(format)) return Error::pixels_too_small;
    }
    return Error::none;
  }
  void ask(const Order& order) {
    const std::uint32_t asked = asked_.load(std::memory_order_relaxed);
    orders_[asked % 2] = order;
    asked_.store(asked + 1, std::memory_order_release);
  }
  /// Waits a step. Returns false if the time limit has passed.
  template <Clock Time>
  static bool keep_waiting(Time& clock, std::uint32_t& waited) {
    constexpr std::uint32_t kStep = 2;
    if (waited >= kMaxStripMicroseconds) return false;
    clock.wait(kStep);
    waited += kStep;
    return true;
  }
  template <Clock Time>
  bool wait_until_done(Time& clock) const {
    std::uint32_t waited = 0;
    while (!is_done()) {
      if (!keep_waiting(clock, waited)) return false;
    }
    return true;
  }

  Renderer& renderer_;
  Start start_ = Start::none;             ///< requested by the first core
  DrawStatus begun_{};                    ///< result of start() on the second core, until a frame has returned it
  Order orders_[2];                       ///< arguments of start() and of a frame
  std::atomic<std::uint32_t> asked_ = 0;  ///< number of requests; written by the first core
  std::atomic<std::uint32_t> done_ = 0;   ///< number of finished requests; written by the second core
  SharedStrips<DrawStatus> strips_;
};

/// Draws and sends a frame with two cores. `renderer` is the first core's. Both renderers have begun the same frame,
/// with the same plan; the second one may still be doing so, by SecondCore::start(), and its error is then returned as
/// one of drawing, also next to an error for which the display's frame does not begin. Strips are written in order, by
/// either core: both cores call functions of `display` between begin_frame and end_frame, but never at the same time.
/// present() returns, also with an error, only when the second core is done. Error::second_core is the exception: the
/// second core finished neither a strip nor the begin of a frame within kMaxStripMicroseconds, and keeps its buffer,
/// its renderer and `second` until is_done(). If it is inside a function of the display, it keeps the display too, and
/// the display's frame has not ended. Display errors that present() itself returns: strip_layout, pixels_too_small,
/// second_core.
template <StripRenderer Renderer, Display Panel, Clock Time>
auto present(Renderer& renderer, SecondCore<Renderer>& second, Panel& display, const StripLayout& layout,
             const TwoCoreBuffers& buffers, Time& clock) {
  return second.present(renderer, display, layout, buffers, clock);
}

}  // namespace zstrip::hal
