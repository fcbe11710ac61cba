// Strips of a frame drawn by two cores of one chip, as of an RP2040 or an ESP32-S3: the first core draws every other
// strip and hands all of them to the display, the second one draws the rest.
//
// Each core has a renderer with an arena of its own; scene and plan are shared, and nothing changes them meanwhile.
// There is no lock: each of two words is written by one core alone, so that a Cortex-M0 will do.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::hal {

/// What the first core asks the second one for. In memory that both see in the same way: not behind a data cache that
/// only one of them has.
template <StripRenderer Renderer>
class SecondCore {
 public:
  /// Of the renderer.
  using DrawStatus = decltype(std::declval<Renderer&>().draw_strip(std::uint16_t{}, std::span<std::byte>{}));

  /// `renderer`: drawn with by the second core alone. It must outlive this object.
  explicit constexpr SecondCore(Renderer& renderer) : renderer_(renderer) {}

  /// On the second core, again and again: does what it is asked for. False: nothing; the core may sleep until the first
  /// one wakes it (SEV and WFE), or go on with what else it does.
  bool serve() {
    const std::uint32_t asked = asked_.load(std::memory_order_acquire);
    if (asked == done_.load(std::memory_order_relaxed)) return false;
    status_ = work_ != nullptr ? run_(work_) : renderer_.draw_strip(strip_, pixels_);
    done_.store(asked, std::memory_order_release);
    return true;
  }

  /// On the first core: has `work()` done, which returns a status: the beginning of a frame by the second core's
  /// renderer. It must live until is_done(), or until the present() that follows has returned.
  template <class Work>
  void start(const Work& work) {
    work_ = &work;
    run_ = [](const void* what) -> DrawStatus { return (*static_cast<const Work*>(what))(); };
    asked_.store(asked_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
  /// On the first core: has a strip drawn. `pixels` are the second core's until is_done().
  void ask(std::uint16_t strip, std::span<std::byte> pixels) {
    work_ = nullptr, strip_ = strip, pixels_ = pixels;
    asked_.store(asked_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
  /// On the first core: whether all that was asked for is done.
  bool is_done() const { return done_.load(std::memory_order_acquire) == asked_.load(std::memory_order_relaxed); }
  /// On the first core, when it is done: how it went.
  const DrawStatus& status() const { return status_; }
  /// On the first core, when it is done: how the last start() went; success if there was none since this was called.
  DrawStatus take_start() {
    if (std::exchange(work_, nullptr) == nullptr) return {};
    return status_;
  }

 private:
  Renderer& renderer_;
  const void* work_ = nullptr;  ///< null: a strip
  DrawStatus (*run_)(const void*) = nullptr;
  std::uint16_t strip_ = 0;
  std::span<std::byte> pixels_;
  DrawStatus status_{};
  std::atomic<std::uint32_t> asked_ = 0;  ///< how often; written by the first core
  std::atomic<std::uint32_t> done_ = 0;   ///< how often it did; written by the second core
};

/// Three buffers as those of StripBuffers: two are drawn into while one is sent.
using TwoCoreBuffers = std::array<std::span<std::byte>, 3>;

/// How long a strip, or the beginning of a frame, may take on the second core, microseconds.
inline constexpr std::uint32_t kMaxStripMicroseconds = 1'000'000;

/// present() on two cores. `renderer` is the first core's. Both have begun the same frame, with the same plan; the
/// second one may still be doing so, by SecondCore::start(): its error is one of drawing. Also with an error it returns
/// only when the second core has drawn what it was asked for, but for Error::second_core: then it did not within
/// kMaxStripMicroseconds, and its buffer, its renderer and `second` stay its own until is_done(). Display errors of its
/// own: strip_layout, pixels_too_small, second_core.
template <StripRenderer Renderer, Display Panel, Clock Time>
auto present(Renderer& renderer, SecondCore<Renderer>& second, Panel& display, const StripLayout& layout,
             const TwoCoreBuffers& buffers, Time& clock) {
  using DrawStatus = typename SecondCore<Renderer>::DrawStatus;
  PresentResult<DrawStatus> result;

  const StripAreas areas(layout, display.width(), display.height());
  if (!areas.cover()) {
    result.display = Error::strip_layout;
    return result;
  }
  for (const std::span<std::byte>& buffer : buffers) {
    if (buffer.size() < areas.bytes(display.format())) {
      result.display = Error::pixels_too_small;
      return result;
    }
  }
  const auto wait_for_second = [&] {
    constexpr std::uint32_t kStep = 2;
    for (std::uint32_t waited = 0; !second.is_done(); waited += kStep) {
      if (waited >= kMaxStripMicroseconds) return false;
      clock.wait(kStep);
    }
    return true;
  };
  if (!wait_for_second()) {
    result.display = Error::second_core;
    return result;
  }
  result.draw = second.take_start();
  if (!result) return result;
  result.display = display.begin_frame();
  if (result.display != Error::none) return result;

  const auto send = [&](std::uint16_t strip) {
    result.strip = strip;
    result.display = display.wait();
    if (!result) return;
    const Area area = areas.area(strip);
    result.display =
        display.write(area, buffers[strip % 3U].first(area.height * bytes_per_row(area.width, display.format())));
  };
  // Of three buffers one holds the strip before this pair, which may be on its way; the second core's was sent before
  // it.
  for (std::uint16_t strip = 0; result && strip < layout.count; strip = static_cast<std::uint16_t>(strip + 2)) {
    const auto other = static_cast<std::uint16_t>(strip + 1);
    const bool has_other = other < layout.count;
    result.strip = strip;
    if (has_other) second.ask(other, buffers[other % 3U]);
    result.draw = renderer.draw_strip(strip, buffers[strip % 3U]);
    if (result) send(strip);
    if (!has_other) break;
    if (!wait_for_second()) {
      if (result) result.display = Error::second_core, result.strip = other;
      break;
    }
    if (!result) break;
    result.strip = other;
    result.draw = second.status();
    if (result) send(other);
  }

  const Error last_transfer = display.wait();
  const Error end = display.end_frame();
  if (result) result.display = last_transfer != Error::none ? last_transfer : end;
  return result;
}

}  // namespace zstrip::hal
