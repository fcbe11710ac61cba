// A display whose panel is memory: what the strips leave behind is the picture.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "zstrip/view.hpp"
#include "zstrip_hal/display.hpp"

namespace zstrip::sim {

/// The same format, as the HAL and as the core name it.
hal::PixelFormat hal_format(PixelFormat format);
PixelFormat core_format(hal::PixelFormat format);

class PictureDisplay {
 public:
  explicit PictureDisplay(const View& view)
      : view_(view), pixels_(std::size_t{bytes_per_row(view.width, view.format)} * view.height) {}

  std::uint16_t width() const { return view_.width; }
  std::uint16_t height() const { return view_.height; }
  hal::PixelFormat format() const { return hal_format(view_.format); }

  hal::Error begin_frame() { return hal::Error::none; }
  /// Areas start at multiples of 8 pixels and end there or at the right side: error `area` otherwise.
  hal::Error write(const hal::Area& area, std::span<const std::byte> pixels);
  hal::Error wait() { return hal::Error::none; }
  hal::Error end_frame() { return hal::Error::none; }

  /// All rows, bytes_per_row each.
  std::span<const std::byte> pixels() const { return pixels_; }

 private:
  View view_;
  std::vector<std::byte> pixels_;
};

}  // namespace zstrip::sim
