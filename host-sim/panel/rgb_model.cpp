// Signals and rows of an RGB panel.
#include "panel/rgb_model.hpp"

#include <fmt/format.h>

namespace zstrip::sim {

RgbModel::RgbModel(const RgbLimits& limits)
    : limits_(limits), glass_{.width = limits.width, .height = limits.height, .rgb = {}} {
  glass_.rgb.resize(std::size_t{3} * limits.width * limits.height);
}

void RgbModel::start(const RgbTimings& timings) {
  has_frame_ = false;
  if (timings.width != limits_.width || timings.height != limits_.height) {
    complain(fmt::format("the signals have {}x{} pixels, the glass {}x{}", timings.width, timings.height, limits_.width,
                         limits_.height));
  }
  if (timings.pixel < limits_.shortest_pixel || timings.pixel > limits_.longest_pixel) {
    complain(fmt::format("the pixel clock has {} ns, the panel needs {} to {} ns", timings.pixel.count(),
                         limits_.shortest_pixel.count(), limits_.longest_pixel.count()));
  }
  check("pulse of HSYNC", timings.columns.pulse, limits_.column_pulse);
  check("pulse and back porch of a row", timings.columns.pulse + timings.columns.back, limits_.column_back);
  check("front porch of a row", timings.columns.front, limits_.column_front);
  check("pulse of VSYNC", timings.rows.pulse, limits_.row_pulse);
  check("pulse and back porch of a frame", timings.rows.pulse + timings.rows.back, limits_.row_back);
  check("front porch of a frame", timings.rows.front, limits_.row_front);
}

void RgbModel::check(const char* what, unsigned value, const RgbLimits::Range& range) {
  if (value >= range.least && value <= range.most) return;
  complain(fmt::format("the {} is {}, the panel needs {} to {}", what, value, range.least, range.most));
}

void RgbModel::begin_frame() {
  if (has_frame_ && row_ != limits_.height) {
    complain(fmt::format("a frame had {} rows of pixels, the glass has {}", row_, limits_.height));
  }
  has_frame_ = true;
  row_ = 0;
}

void RgbModel::receive_row(std::span<const std::byte> pixels) {
  if (!has_frame_) return complain("pixels before the first VSYNC");
  if (pixels.size() != std::size_t{2} * limits_.width) {
    complain(fmt::format("a row had {} pixels, the glass has {}", pixels.size() / 2, limits_.width));
  }
  if (row_ == limits_.height) return complain("more rows of pixels than the glass has");
  std::uint8_t* to = &glass_.rgb[std::size_t{3} * limits_.width * row_++];
  for (std::size_t i = 0; i + 1 < pixels.size() && i < std::size_t{2} * limits_.width; i += 2) {
    const unsigned pixel = std::to_integer<unsigned>(pixels[i]) | std::to_integer<unsigned>(pixels[i + 1]) << 8;
    const unsigned red = pixel >> 11, green = pixel >> 5 & 63, blue = pixel & 31;
    *to++ = static_cast<std::uint8_t>(red << 3 | red >> 2);
    *to++ = static_cast<std::uint8_t>(green << 2 | green >> 4);
    *to++ = static_cast<std::uint8_t>(blue << 3 | blue >> 2);
  }
  has_signals_ = true;
  last_row_ = now();
}

std::string RgbModel::darkness() const {
  if (!has_signals_) return "the panel has received no row yet";
  if (now() - last_row_ > kFading) return "the pixel clock stands still";
  return "";
}

void RgbModel::receive_byte(Wire /*wire*/, std::uint8_t /*byte*/) {
  complain("a byte on a bus for commands, which this panel does not have");
}

}  // namespace zstrip::sim
