// A display whose panel is memory: the picture consists of the strips that were written.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "zstrip/view.hpp"
#include "zstrip_hal/display.hpp"

namespace zstrip::sim {

/// Converts the core's name of a format to the HAL's.
hal::DisplayFormat hal_format(PixelFormat format);
PixelFormat core_format(hal::DisplayFormat format);

class PictureDisplay {
 public:
  explicit PictureDisplay(const View& view)
      : view_(view), pixels_(std::size_t{bytes_per_row(view.width, view.format)} * view.height) {}

  std::uint16_t width() const { return view_.width; }
  std::uint16_t height() const { return view_.height; }
  hal::DisplayFormat format() const { return hal_format(view_.format); }

  hal::Error begin_frame() { return hal::Error::none; }
  /// Areas must start at multiples of 8 pixels, and end at multiples or at the right side; error `area` otherwise.
  hal::Error write(const hal::Area& area, std::span<const std::byte> pixels);
  hal::Error wait() { return hal::Error::none; }
  hal::Error end_frame() { return hal::Error::none; }

  /// Returns all rows, bytes_per_row each.
  std::span<const std::byte> pixels() const { return pixels_; }

 private:
  View view_;
  std::vector<std::byte> pixels_;
};

}  // namespace zstrip::sim
