// Reading and comparing pictures of 16 greys.
#include "grey_picture.hpp"

#include <sstream>
#include <stdexcept>

#include "colour_picture.hpp"

namespace zstrip::boards {
namespace {

std::string position(int x, int y) {
  std::ostringstream text;
  text << '(' << x << ", " << y << ')';
  return text.str();
}

}  // namespace

GreyPicture read_scaled_ppm(const std::filesystem::path& file, int scale) {
  const ColourPicture pixels = read_ppm(file);
  const int width = pixels.width, height = pixels.height;
  if (width % scale != 0 || height % scale != 0) {
    throw std::runtime_error("the screen's size is no multiple of its scale");
  }
  GreyPicture picture{width / scale, height / scale, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t expected = pixels.at(x / scale * scale, y / scale * scale)[0];
      for (const std::uint8_t channel : pixels.at(x, y)) {
        if (channel != expected) throw std::runtime_error("no even grey square at " + position(x, y));
      }
      if (x % scale != 0 || y % scale != 0) continue;
      if (expected % 17 != 0) throw std::runtime_error("no level of 16 greys at " + position(x, y));
      picture.levels.push_back(expected / 17);
    }
  }
  return picture;
}

GreyPicture unpack_gray4(const std::vector<std::byte>& bytes, int width, int height) {
  const int row_bytes = (width + 1) / 2;
  GreyPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto pair = std::to_integer<unsigned>(bytes.at(static_cast<std::size_t>(y * row_bytes + x / 2)));
      picture.levels.push_back(static_cast<std::uint8_t>(x % 2 == 0 ? pair >> 4 : pair & 15U));
    }
  }
  return picture;
}

std::string difference(const GreyPicture& expected, const GreyPicture& actual) {
  if (expected.width != actual.width || expected.height != actual.height) return "the sizes differ";
  int count = 0;
  std::string first;
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      if (expected.at(x, y) == actual.at(x, y) || count++ > 0) continue;
      first = position(x, y) + " is " + std::to_string(actual.at(x, y)) + " instead of " +
              std::to_string(expected.at(x, y));
    }
  }
  return count == 0 ? "" : std::to_string(count) + " pixels differ, the first at " + first;
}

}  // namespace zstrip::boards
