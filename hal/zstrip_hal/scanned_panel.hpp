// A panel without memory, as RGB (parallel) panels are: a controller of the processor reads the picture again and
// again. Two strips in its memory take the place of the picture: it reads one while the other one is drawn.
//
// The controller is an RGB peripheral with two bounce buffers (ESP32-S3), or an LTDC with two layers, whose line
// interrupt moves the layer that was read (STM32).
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::hal {

/// The picture of a scanned panel, and the strips in which its controller reads it.
struct ScanLayout {
  std::uint16_t width = 0;                       ///< pixels
  std::uint16_t height = 0;                      ///< pixels
  std::uint16_t rows = 0;                        ///< pixels; of a strip, 1..height. The last strip may have fewer
  DisplayFormat format = DisplayFormat::rgb565;  ///< format of the controller's memory, and of the pixels of write()
};

/// The time in microseconds between two requests of a controller, at most.
inline constexpr std::uint32_t kMaxScanMicroseconds = 100'000;

/// Serves the requests of a controller's interrupt. Every strip must be drawn in every refresh of the panel, each in
/// the time in which the controller reads another one; the second one of a picture has the blanking in addition.
///
/// It is a Display: write() copies a strip, as wide as the panel, into the controller's memory; strips are written in
/// order. present() below draws into that memory instead, without a copy. A strip that was complete too late ends the
/// frame with Error::underrun: the panel shows old rows there, until the next refresh. The next frame begins with the
/// next refresh. `clock` waits between two looks at the requests: briefly, or until an interrupt. It must outlive this.
template <Clock Time>
class ScannedPanel {
 public:
  /// Does not wait for the controller, which starts afterwards.
  constexpr ScannedPanel(Time& clock, const ScanLayout& layout) : clock_(clock), layout_(layout) {}

  /// Call it in the controller's interrupt, when it has read the strip in a buffer and goes on with the other buffer:
  /// `buffer`, at least as large as a strip and aligned as the renderer needs, is to hold strip `strip` as soon as that
  /// one has been read. Nothing else of this class may be called in an interrupt.
  void ask(std::span<std::byte> buffer, std::uint16_t strip) {
    const std::uint32_t asked = asked_.load(std::memory_order_relaxed) + 1;
    Request& request = requests_[asked % 2];
    request.pixels.store(buffer.data(), std::memory_order_relaxed);
    request.bytes.store(static_cast<std::uint32_t>(buffer.size()), std::memory_order_relaxed);
    request.strip.store(strip, std::memory_order_relaxed);
    asked_.store(asked, std::memory_order_release);
  }

  /// @{
  /// See the concept Display. write() waits for the request of its strip.
  constexpr std::uint16_t width() const { return layout_.width; }
  constexpr std::uint16_t height() const { return layout_.height; }
  constexpr DisplayFormat format() const { return layout_.format; }
  constexpr Error begin_frame() { return areas().cover() ? Error::none : Error::strip_layout; }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(layout_.width, layout_.height, area)) return stop(Error::area);
    if (begin_frame() != Error::none) return stop(Error::strip_layout);
    const auto strip = static_cast<std::uint16_t>(area.top / layout_.rows);
    if (area != areas().area(strip)) return stop(Error::strip_layout);
    if (pixels.size() < bytes_of(strip)) return stop(Error::pixels_too_small);
    std::span<std::byte> buffer;
    if (const Error error = take(strip, buffer); error != Error::none) return error;
    std::memcpy(buffer.data(), pixels.data(), buffer.size());
    return finish();
  }
  constexpr Error wait() { return Error::none; }
  constexpr Error end_frame() { return Error::none; }
  /// @}

  /// See the function present() below.
  template <StripRenderer Renderer>
  auto present(Renderer& renderer, const StripLayout& layout) {
    PresentResult<decltype(renderer.draw_strip(std::uint16_t{}, std::span<std::byte>{}))> result;
    const bool fits = layout.rows == layout_.rows && StripAreas(layout, layout_.width, layout_.height).cover() &&
                      (layout.columns == 0 || layout.columns == layout_.width);
    if (!fits) result.display = stop(Error::strip_layout);
    for (std::uint16_t strip = 0; result && strip < layout.count; ++strip) {
      result.strip = strip;
      std::span<std::byte> buffer;
      result.display = take(strip, buffer);
      if (!result) break;
      result.draw = renderer.draw_strip(strip, buffer);
      if (!result) {
        is_in_step_ = false;
        break;
      }
      result.display = finish();
    }
    return result;
  }

 private:
  /// The last two requests of the interrupt.
  struct Request {
    std::atomic<std::byte*> pixels = nullptr;
    std::atomic<std::uint32_t> bytes = 0;
    std::atomic<std::uint16_t> strip = 0;
  };

  constexpr std::uint16_t strips() const {
    return layout_.rows == 0 ? std::uint16_t{0}
                             : static_cast<std::uint16_t>((layout_.height + layout_.rows - 1U) / layout_.rows);
  }
  constexpr StripAreas areas() const { return {{strips(), layout_.rows, 0}, layout_.width, layout_.height}; }
  constexpr std::uint32_t bytes_of(std::uint16_t strip) const {
    return areas().area(strip).height * bytes_per_row(layout_.width, layout_.format);
  }

  /// The next frame waits for the request of its first strip, however many were missed.
  Error stop(Error error) {
    is_in_step_ = false;
    return error;
  }

  /// Waits for the request of a strip. While frames are in step with the panel, that is the request after the last one.
  /// A controller that asks for others alone in several refreshes has another layout.
  Error take(std::uint16_t strip, std::span<std::byte>& buffer) {
    constexpr std::uint32_t kStep = 2, kMaxRefreshes = 4;
    std::uint32_t others = 0;  // requests for other strips
    for (std::uint32_t waited = 0; waited <= kMaxScanMicroseconds; clock_.wait(kStep), waited += kStep) {
      const std::uint32_t asked = asked_.load(std::memory_order_acquire);
      if (asked == taken_) continue;
      const Request& request = requests_[asked % 2];
      const std::uint16_t wanted = request.strip.load(std::memory_order_relaxed);
      std::byte* const pixels = request.pixels.load(std::memory_order_relaxed);
      const std::uint32_t bytes = request.bytes.load(std::memory_order_relaxed);
      std::atomic_thread_fence(std::memory_order_acquire);
      if (asked_.load(std::memory_order_relaxed) != asked) continue;  // the interrupt may be writing a newer one
      const bool is_next = asked == taken_ + 1 && wanted == strip;
      taken_ = asked;
      waited = 0;
      if (wanted >= strips()) return stop(Error::strip_layout);
      if (is_in_step_ && !is_next) return stop(Error::underrun);
      if (wanted != strip && ++others > kMaxRefreshes * strips()) return stop(Error::strip_layout);
      if (wanted != strip) continue;
      if (bytes < bytes_of(strip)) return stop(Error::pixels_too_small);
      is_in_step_ = true;
      buffer = {pixels, bytes_of(strip)};
      return Error::none;
    }
    return stop(Error::timeout);
  }
  /// The strip is complete. It is late if the controller has already begun to read it.
  Error finish() { return asked_.load(std::memory_order_acquire) == taken_ ? Error::none : stop(Error::underrun); }

  Time& clock_;
  ScanLayout layout_;
  Request requests_[2];                   ///< the request of number n is at n % 2
  std::atomic<std::uint32_t> asked_ = 0;  ///< requests so far; only the interrupt writes it
  std::uint32_t taken_ = 0;               ///< the number of the request that was taken last
  bool is_in_step_ = false;               ///< the last strip was complete in time
};

/// Draws the strips of a frame that `renderer` has begun into the memory of the controller, each as soon as that is
/// free. `layout`: of the plan, whose strips must have the panel's rows. Display errors: those of ScannedPanel, timeout
/// if the controller does not ask, and strip_layout or pixels_too_small if it asks for a strip that the layout lacks.
template <StripRenderer Renderer, Clock Time>
auto present(Renderer& renderer, ScannedPanel<Time>& panel, const StripLayout& layout) {
  return panel.present(renderer, layout);
}

}  // namespace zstrip::hal
