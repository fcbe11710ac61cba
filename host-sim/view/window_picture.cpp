// The pixels of the window: the picture, enlarged or reduced, optionally with its strips, and lines of text below it.
#include "view/window_picture.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "image/to_rgb.hpp"
#include "zstrip/overlay.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kMargin = 6;       // pixels around the text
constexpr std::uint32_t kTextWidth = 720;  // of a window whose width is free: 59 letters
using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kBorder{96, 96, 96}, kLitBorder{255, 208, 0};

void set(RgbImage& image, std::uint32_t x, std::uint32_t y, const Rgb& colour) {
  std::ranges::copy(colour, image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (std::size_t{y} * image.width + x)));
}

RgbImage black(const WindowSize& size) {
  return {.width = size.width,
          .height = size.height,
          .rgb = std::vector<std::uint8_t>(std::size_t{3} * size.width * size.height)};
}

/// Breaks lines between words, or inside a word that is longer than a line.
std::vector<std::string> broken(TextLines text, std::size_t letters, std::size_t indent) {
  letters = std::max<std::size_t>(letters, 8);
  indent = std::min(indent, letters / 2);
  std::vector<std::string> lines;
  for (std::string rest : text) {
    while (rest.size() > letters) {
      const std::size_t space = rest.rfind(' ', letters);
      const bool between_words = space != std::string::npos && rest.find_first_not_of(' ') < space;
      const std::size_t end = between_words ? space : letters;
      lines.push_back(rest.substr(0, end));
      rest = std::string(indent, ' ') + rest.substr(std::min(rest.find_first_not_of(' ', end), rest.size()));
    }
    lines.push_back(rest);
  }
  return lines;
}

struct Letters {
  const Font* font;
  std::uint32_t width;
};
constexpr Letters kLarge{&kLargeFont, 12}, kSmall{&kSmallFont, 6};

std::vector<std::string> lines_in(TextLines text, const Letters& letters, std::uint32_t width, std::size_t indent) {
  return broken(text, (std::max(width, 2 * kMargin) - 2 * kMargin) / letters.width, indent);
}

std::uint32_t height_of(const std::vector<std::string>& lines, const Letters& letters) {
  if (lines.empty()) return 0;
  return static_cast<std::uint32_t>(lines.size()) * letters.font->line_height + 2 * kMargin;
}

constexpr std::size_t kIndent = 2;

/// Returns 0 for a text that is left out.
std::uint32_t text_height(TextLines text, const WindowSize& window, std::uint32_t picture_height) {
  const std::uint32_t height = height_of(lines_in(text, kLarge, window.width, kIndent), kLarge);
  return height + std::min(picture_height, window.height / 2) <= window.height ? height : 0;
}

/// Draws text with the letters that a device draws over its pictures, from row `top` of the window on.
void draw_text(const std::vector<std::string>& lines, const Letters& letters, std::uint32_t top, RgbImage& window) {
  const std::uint32_t height = window.height - top;
  std::vector<Label> labels;
  std::uint32_t y = kMargin;
  for (const std::string& line : lines) {
    labels.push_back({.text = line, .x = kMargin, .y = static_cast<std::int16_t>(y)});
    y += letters.font->line_height;
  }
  const Overlay overlay{.fonts = {letters.font, 1}, .labels = labels};
  std::vector<std::uint16_t> pixels(std::size_t{window.width} * height);
  draw_overlay(overlay, {0, 0, static_cast<std::int32_t>(window.width), static_cast<std::int32_t>(height)},
               pixels.data());
  const RgbImage text =
      rgb_image_of({static_cast<std::uint16_t>(window.width), static_cast<std::uint16_t>(height), PixelFormat::rgb565},
                   std::as_bytes(std::span(pixels)));
  std::ranges::copy(text.rgb, window.rgb.end() - static_cast<std::ptrdiff_t>(text.rgb.size()));
}

/// Returns the mean colour of a square of `side` pixels, as far as it lies in the picture.
Rgb mean(const RgbImage& picture, std::uint32_t left, std::uint32_t top, std::uint32_t side) {
  if (side == 1) {
    const std::uint8_t* const pixel = picture.pixel(left, top);
    return {pixel[0], pixel[1], pixel[2]};
  }
  std::array<std::uint32_t, 3> sum{};
  std::uint32_t pixels = 0;
  for (std::uint32_t y = top; y < std::min(top + side, picture.height); ++y) {
    for (std::uint32_t x = left; x < std::min(left + side, picture.width); ++x, ++pixels) {
      for (std::size_t i = 0; i < 3; ++i) sum[i] += picture.pixel(x, y)[i];
    }
  }
  Rgb colour{};
  for (std::size_t i = 0; i < 3; ++i) colour[i] = static_cast<std::uint8_t>((sum[i] + pixels / 2) / pixels);
  return colour;
}

std::uint32_t scaled(std::uint32_t length, const PictureScale& scale) {
  return std::max(length * scale.enlarged / scale.reduced, 1U);
}

/// The position of the picture in the window.
struct Place {
  std::uint32_t left, top;
  PictureScale scale;
};

Place place_in(const WindowSize& window, const WindowSize& picture, TextLines text) {
  const PictureScale scale = scale_in(window, picture, text);
  const std::uint32_t width = scaled(picture.width, scale), height = scaled(picture.height, scale);
  return {(window.width - width) / 2, (window.height - text_height(text, window, picture.height) - height) / 2, scale};
}

/// Draws a border with a width of one window pixel at any scale, so that it hides little of the picture.
void draw_border(RgbImage& window, const Rect& strip, const Place& place, const Rgb& colour) {
  const auto at = [&](std::int32_t value) {
    return static_cast<std::uint32_t>(value) * place.scale.enlarged / place.scale.reduced;
  };
  const std::uint32_t left = place.left + at(strip.left), right = place.left + std::max(at(strip.right), 1U) - 1,
                      top = place.top + at(strip.top), bottom = place.top + std::max(at(strip.bottom), 1U) - 1;
  if (left > right || top > bottom) return;  // the last rows of a reduced picture
  for (std::uint32_t x = left; x <= right; ++x) set(window, x, top, colour), set(window, x, bottom, colour);
  for (std::uint32_t y = top; y <= bottom; ++y) set(window, left, y, colour), set(window, right, y, colour);
}

}  // namespace

WindowSize wanted_window(const WindowSize& picture, std::uint32_t scale, TextLines text, const WindowSize& room) {
  for (;; --scale) {
    const std::uint32_t width = std::max(picture.width * scale, text.empty() ? 1 : kTextWidth);
    const WindowSize window{std::min(width, room.width), room.height};
    const std::uint32_t height =
        picture.height * scale + height_of(lines_in(text, kLarge, window.width, kIndent), kLarge);
    if (scale <= 1 || (picture.width * scale <= room.width && height <= room.height)) {
      return {window.width, std::min(height, room.height)};
    }
  }
}

PictureScale scale_in(const WindowSize& window, const WindowSize& picture, TextLines text) {
  const std::uint32_t height = std::max(window.height - text_height(text, window, picture.height), 1U);
  const std::uint32_t enlarged = std::min(window.width / picture.width, height / picture.height);
  if (enlarged > 0) return {.enlarged = enlarged};
  const auto parts = [](std::uint32_t of, std::uint32_t largest) { return (of + largest - 1) / largest; };
  return {.reduced = std::max(parts(picture.width, window.width), parts(picture.height, height))};
}

std::optional<PicturePixel> pixel_at(const WindowSize& window, const WindowSize& picture, TextLines text,
                                     std::int64_t x, std::int64_t y) {
  const Place place = place_in(window, picture, text);
  const std::int64_t right = x - place.left, down = y - place.top;
  if (right < 0 || down < 0 || right >= scaled(picture.width, place.scale) ||
      down >= scaled(picture.height, place.scale)) {
    return std::nullopt;
  }
  const auto unscaled = [&](std::int64_t at) {
    return static_cast<std::uint32_t>(at) * place.scale.reduced / place.scale.enlarged;
  };
  return PicturePixel{unscaled(right), unscaled(down)};
}

RgbImage window_picture(const RgbImage& picture, const StripMarks& marks, TextLines text, const WindowSize& window) {
  const Place place = place_in(window, {picture.width, picture.height}, text);
  const PictureScale& scale = place.scale;
  const std::uint32_t text_rows = text_height(text, window, picture.height);
  const std::uint32_t width = scaled(picture.width, scale), height = scaled(picture.height, scale);
  RgbImage pixels = black(window);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t left = x * scale.reduced / scale.enlarged, top = y * scale.reduced / scale.enlarged;
      set(pixels, place.left + x, place.top + y, mean(picture, left, top, scale.reduced));
    }
  }
  for (const Rect& strip : marks.strips) draw_border(pixels, strip, place, kBorder);
  if (marks.drawing < marks.strips.size()) draw_border(pixels, marks.strips[marks.drawing], place, kLitBorder);
  if (text_rows > 0)
    draw_text(lines_in(text, kLarge, window.width, kIndent), kLarge, window.height - text_rows, pixels);
  return pixels;
}

RgbImage text_page(TextLines text, std::size_t indent, const WindowSize& window) {
  const std::vector<std::string> lines = lines_in(text, kLarge, window.width, indent);
  RgbImage page = black(window);
  if (height_of(lines, kLarge) <= window.height) {
    draw_text(lines, kLarge, 0, page);
  } else {
    draw_text(lines_in(text, kSmall, window.width, indent), kSmall, 0, page);
  }
  return page;
}

}  // namespace zstrip::sim
