// What the window holds: the picture, enlarged, perhaps with its strips, and lines of text below it.
#include "view/window_picture.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "image/to_rgb.hpp"
#include "zstrip/overlay.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kMargin = 4;  // pixels around the text
using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kBorder{96, 96, 96}, kLitBorder{255, 208, 0};

void set(RgbImage& image, std::uint32_t x, std::uint32_t y, const Rgb& colour) {
  std::ranges::copy(colour, image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (std::size_t{y} * image.width + x)));
}

/// One pixel of the window wide, whatever the scale: it hides little of the picture.
void draw_border(RgbImage& window, const Rect& strip, std::uint32_t scale, const Rgb& colour) {
  const auto scaled = [scale](std::int32_t value) { return static_cast<std::uint32_t>(value) * scale; };
  const std::uint32_t left = scaled(strip.left), right = scaled(strip.right) - 1, top = scaled(strip.top),
                      bottom = scaled(strip.bottom) - 1;
  for (std::uint32_t x = left; x <= right; ++x) set(window, x, top, colour), set(window, x, bottom, colour);
  for (std::uint32_t y = top; y <= bottom; ++y) set(window, left, y, colour), set(window, right, y, colour);
}

/// In the letters that a device draws over its pictures.
RgbImage text_picture(std::span<const std::string> text, std::uint32_t width) {
  std::vector<Label> labels;
  std::uint32_t y = kMargin;
  for (const std::string& line : text) {
    labels.push_back({.text = line, .x = kMargin, .y = static_cast<std::int16_t>(y)});
    y += kLargeFont.line_height;
  }
  const std::uint32_t height = y + kMargin;
  const Overlay overlay{.fonts = {&kLargeFont, 1}, .labels = labels};
  std::vector<std::uint16_t> pixels(std::size_t{width} * height);
  draw_overlay(overlay, {0, 0, static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)}, pixels.data());
  return rgb_image_of({static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), PixelFormat::rgb565},
                      std::as_bytes(std::span(pixels)));
}

}  // namespace

RgbImage window_picture(const RgbImage& picture, std::uint32_t scale, const StripMarks& marks,
                        std::span<const std::string> text) {
  const std::uint32_t width = std::max(picture.width * scale, text.empty() ? 0 : kTextWidth);
  RgbImage window{.width = width, .height = picture.height * scale, .rgb = {}};
  window.rgb.resize(std::size_t{3} * width * window.height);
  for (std::uint32_t y = 0; y < window.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width * scale; ++x) {
      const std::uint8_t* const pixel = picture.pixel(x / scale, y / scale);
      set(window, x, y, {pixel[0], pixel[1], pixel[2]});
    }
  }
  for (const Rect& strip : marks.strips) draw_border(window, strip, scale, kBorder);
  if (marks.drawing < marks.strips.size()) draw_border(window, marks.strips[marks.drawing], scale, kLitBorder);
  if (text.empty()) return window;
  const RgbImage below = text_picture(text, width);
  window.rgb.insert(window.rgb.end(), below.rgb.begin(), below.rgb.end());
  window.height += below.height;
  return window;
}

}  // namespace zstrip::sim
