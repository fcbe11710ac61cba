// A frame drawn by two cores of one chip, as of an RP2040 or an ESP32-S3: each takes the next strip when it is free, so
// that strips of unequal work keep neither waiting.
//
// Each core has a renderer with an arena of its own; scene and plan are shared, and nothing changes them meanwhile.
// Nothing needs more than loads and stores of words: a Cortex-M0 will do.
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

/// How long the first core waits for a strip of the second one, or for its beginning of a frame, microseconds.
inline constexpr std::uint32_t kMaxStripMicroseconds = 1'000'000;

/// What the first core asks the second one for. In memory that both see in the same way: not behind a data cache that
/// only one of them has.
template <StripRenderer Renderer>
class SecondCore {
 public:
  /// Of the renderer.
  using DrawStatus = decltype(std::declval<Renderer&>().draw_strip(std::uint16_t{}, std::span<std::byte>{}));

  /// `renderer`: drawn with by the second core alone. It must outlive this object.
  explicit constexpr SecondCore(Renderer& renderer) : renderer_(renderer) {}

  /// On the second core, again and again: does one thing that it is asked for. False: nothing can be done now, and the
  /// core may go on with what else it does.
  bool serve() {
    const std::uint32_t done = done_.load(std::memory_order_relaxed);
    if (asked_.load(std::memory_order_acquire) == done) return false;
    const Order& order = orders_[done % 2];
    const Progress progress = order.run(*this, order.work);
    if (progress == Progress::over) done_.store(done + 1, std::memory_order_release);
    return progress != Progress::idle;
  }

  /// On the first core: has `work()` done, which returns a status: the beginning of a frame by the second core's
  /// renderer. It must live until is_done(), or until the present() that follows has returned. Once a frame, and only
  /// when is_done(): else nothing is done, and that present() is an Error::second_core.
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
  /// On the first core: whether all that was asked for is done.
  bool is_done() const { return done_.load(std::memory_order_acquire) == asked_.load(std::memory_order_relaxed); }

  /// What present() below does.
  template <Display Panel, Clock Time>
  PresentResult<DrawStatus> present(Renderer& own, Panel& display, const StripLayout& layout,
                                    const TwoCoreBuffers& buffers, Time& clock) {
    const Start start = std::exchange(start_, Start::none);
    const StripAreas areas(layout, display.width(), display.height());
    Error error = start == Start::refused ? Error::second_core : refuse(areas, display.format(), buffers);
    // Else the second core may still begin the frame, while this one draws.
    if (error == Error::none && start == Start::none && !wait_until_done(clock)) error = Error::second_core;
    if (error == Error::none) error = display.begin_frame();
    if (error != Error::none) {
      if (start == Start::asked && !wait_until_done(clock)) error = Error::second_core;
      return {{}, error};
    }

    strips_.open(display, areas, layout.count, buffers);
    ask({[](SecondCore& self, const void*) {
           const DrawStatus status = std::exchange(self.begun_, {});
           if (!status) self.strips_.fail(Core::second, status, Error::none);
           return self.strips_.step(Core::second, self.renderer_);
         },
         nullptr});
    std::uint32_t waited = 0;
    for (;;) {
      const Progress progress = strips_.step(Core::first, own);
      if (progress == Progress::over && is_done()) break;
      if (progress == Progress::worked) {
        waited = 0;
      } else if (!keep_waiting(clock, waited)) {
        strips_.fail(Core::first, {}, Error::second_core);
        break;
      }
    }
    PresentResult<DrawStatus> result = strips_.result(Core::first);
    // The second core is in there.
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

  static Error refuse(const StripAreas& areas, PixelFormat format, const TwoCoreBuffers& buffers) {
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
  /// False: it was too long.
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
  Start start_ = Start::none;             ///< of the first core
  DrawStatus begun_{};                    ///< of the second core: how start() went, until a frame was told
  Order orders_[2];                       ///< start(), a frame
  std::atomic<std::uint32_t> asked_ = 0;  ///< how often; written by the first core
  std::atomic<std::uint32_t> done_ = 0;   ///< how often it did; written by the second core
  SharedStrips<DrawStatus> strips_;
};

/// present() on two cores. `renderer` is the first core's. Both have begun the same frame, with the same plan; the
/// second one may still be doing so, by SecondCore::start(): its error is one of drawing. Strips are written in order,
/// by either core: functions of `display` between begin_frame and end_frame are called by both, never at once. Also
/// with an error it returns only when the second core is done, but for Error::second_core: then that had nothing for
/// the first one within kMaxStripMicroseconds, and its buffer, its renderer and `second` stay its own until is_done().
/// So does the display, and its frame has not ended, if the second core is in one of its functions. Display errors of
/// its own: strip_layout, pixels_too_small, second_core.
template <StripRenderer Renderer, Display Panel, Clock Time>
auto present(Renderer& renderer, SecondCore<Renderer>& second, Panel& display, const StripLayout& layout,
             const TwoCoreBuffers& buffers, Time& clock) {
  return second.present(renderer, display, layout, buffers, clock);
}

}  // namespace zstrip::hal
