// Random pictures, their bytes, and turning them.
#include "picture.hpp"

#include <string>
#include <utility>

namespace zstrip::panels {
namespace {

using hal::DisplayFormat;

/// Bits of each channel; a grey counts as three equal channels.
std::array<unsigned, 3> channel_bits(DisplayFormat format) {
  switch (format) {
    case DisplayFormat::rgb444: return {4, 4, 4};
    case DisplayFormat::rgb666: return {6, 6, 6};
    case DisplayFormat::gray4: return {4, 4, 4};
    case DisplayFormat::mono: return {1, 1, 1};
    default: return {5, 6, 5};
  }
}

bool is_grey(DisplayFormat format) { return format == DisplayFormat::gray4 || format == DisplayFormat::mono; }

/// From `bits` to `more` bits, by repeating them.
unsigned widened(unsigned value, unsigned bits, unsigned more) {
  unsigned result = 0;
  for (unsigned bit = 0; bit < more; ++bit) result = result * 2 + (value >> (bits - 1 - bit % bits)) % 2;
  return result;
}

/// As it is seen: memories of colour panels have 6 bits a channel.
std::uint8_t seen(unsigned value, unsigned bits, DisplayFormat format) {
  return static_cast<std::uint8_t>(is_grey(format) ? widened(value, bits, 8) : widened(widened(value, bits, 6), 6, 8));
}

Picture turned_clockwise(const Picture& picture) {
  Picture turned = black(picture.height, picture.width);
  for (unsigned y = 0; y < picture.height; ++y) {
    for (unsigned x = 0; x < picture.width; ++x) turned.at(picture.height - 1U - y, x) = picture.at(x, y);
  }
  return turned;
}

}  // namespace

Picture black(std::uint16_t width, std::uint16_t height) {
  return {width, height, std::vector<std::array<std::uint8_t, 3>>(std::size_t{width} * height)};
}

Picture noise(std::uint16_t width, std::uint16_t height, DisplayFormat format, std::mt19937& random) {
  Picture picture = black(width, height);
  const std::array<unsigned, 3> bits = channel_bits(format);
  for (auto& pixel : picture.pixels) {
    for (std::size_t i = 0; i < 3; ++i)
      pixel[i] = seen(static_cast<unsigned>(random() >> (32 - bits[i])), bits[i], format);
    if (is_grey(format)) pixel[1] = pixel[2] = pixel[0];
  }
  return picture;
}

std::vector<std::byte> bytes_of(const Picture& picture, const hal::Area& area, DisplayFormat format) {
  std::vector<std::byte> bytes;
  const std::array<unsigned, 3> bits = channel_bits(format);
  for (unsigned y = area.top; y < unsigned{area.top} + area.height; ++y) {
    unsigned held = 0, count = 0;
    const auto put = [&](unsigned value, unsigned width) {
      held = held << width | value;
      count += width;
      while (count >= 8) bytes.push_back(static_cast<std::byte>(held >> (count -= 8)));
    };
    for (unsigned x = area.left; x < unsigned{area.left} + area.width; ++x) {
      const std::array<std::uint8_t, 3>& pixel = picture.at(x, y);
      for (std::size_t i = 0; i < (is_grey(format) ? 1U : 3U); ++i) {
        put(unsigned{pixel[i]} >> (8 - bits[i]), bits[i]);
        if (format == DisplayFormat::rgb666) put((x + y) % 4, 2);  // they do not count
      }
    }
    if (count != 0) put(0, 8 - count);
  }
  return bytes;
}

void copy(const Picture& from, const hal::Area& area, Picture& to) {
  for (unsigned y = area.top; y < unsigned{area.top} + area.height; ++y) {
    for (unsigned x = area.left; x < unsigned{area.left} + area.width; ++x) to.at(x, y) = from.at(x, y);
  }
}

Picture on_glass(const Picture& picture, const hal::Orientation& orientation) {
  Picture result = picture;
  if (orientation.mirrored) {
    for (unsigned y = 0; y < picture.height; ++y) {
      for (unsigned x = 0; x < picture.width; ++x) result.at(picture.width - 1U - x, y) = picture.at(x, y);
    }
  }
  for (int quarter = 0; quarter < static_cast<int>(orientation.rotation); ++quarter) result = turned_clockwise(result);
  return result;
}

Picture picture_of(const sim::RgbImage& image) {
  Picture picture = black(static_cast<std::uint16_t>(image.width), static_cast<std::uint16_t>(image.height));
  for (unsigned y = 0; y < image.height; ++y) {
    for (unsigned x = 0; x < image.width; ++x) {
      const std::uint8_t* const pixel = image.pixel(x, y);
      picture.at(x, y) = {pixel[0], pixel[1], pixel[2]};
    }
  }
  return picture;
}

std::string difference(const Picture& seen, const Picture& expected) {
  const auto size = [](const Picture& picture) {
    return std::to_string(picture.width) + "x" + std::to_string(picture.height);
  };
  if (seen.width != expected.width || seen.height != expected.height) {
    return size(seen) + " instead of " + size(expected);
  }
  const auto words = [](const std::array<std::uint8_t, 3>& pixel) {
    return std::to_string(pixel[0]) + "," + std::to_string(pixel[1]) + "," + std::to_string(pixel[2]);
  };
  for (unsigned y = 0; y < seen.height; ++y) {
    for (unsigned x = 0; x < seen.width; ++x) {
      if (seen.at(x, y) == expected.at(x, y)) continue;
      return "pixel " + std::to_string(x) + "," + std::to_string(y) + " is " + words(seen.at(x, y)) + ", not " +
             words(expected.at(x, y));
    }
  }
  return {};
}

}  // namespace zstrip::panels
