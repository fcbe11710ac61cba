// Reading and comparing pictures in colour.
#include "colour_picture.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace zstrip::boards {
namespace {

std::uint8_t widened(unsigned value, int bits, LowBits low_bits) {
  const unsigned high = value << (8 - bits);
  return static_cast<std::uint8_t>(low_bits == LowBits::zeros ? high : high | value >> (2 * bits - 8));
}

std::string words(const std::array<std::uint8_t, 3>& colour) {
  std::ostringstream text;
  text << int{colour[0]} << ' ' << int{colour[1]} << ' ' << int{colour[2]};
  return text.str();
}

}  // namespace

ColourPicture read_ppm(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string magic;
  int width = 0, height = 0, maximum = 0;
  stream >> magic >> width >> height >> maximum;
  stream.get();
  constexpr int kMax = 4096;
  if (!stream || magic != "P6" || maximum != 255 || width <= 0 || height <= 0 || width > kMax || height > kMax) {
    throw std::runtime_error("no PPM of 8 bits a channel: " + file.string());
  }
  ColourPicture picture{width, height, {}};
  picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (!stream.read(reinterpret_cast<char*>(picture.pixels.data()),
                   static_cast<std::streamsize>(3 * picture.pixels.size()))) {
    throw std::runtime_error("the PPM is too short: " + file.string());
  }
  return picture;
}

ColourPicture widened(const std::vector<std::uint16_t>& pixels, int width, int height, LowBits low_bits) {
  if (pixels.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw std::runtime_error("the picture has another size than said");
  }
  ColourPicture picture{width, height, {}};
  for (const unsigned pixel : pixels) {
    picture.pixels.push_back(
        {widened(pixel >> 11, 5, low_bits), widened(pixel >> 5 & 63U, 6, low_bits), widened(pixel & 31U, 5, low_bits)});
  }
  return picture;
}

std::string difference(const ColourPicture& expected, const ColourPicture& actual) {
  if (expected.width != actual.width || expected.height != actual.height) return "the sizes differ";
  int count = 0;
  std::ostringstream first;
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      if (expected.at(x, y) == actual.at(x, y) || count++ > 0) continue;
      first << '(' << x << ", " << y << ") is " << words(actual.at(x, y)) << " instead of " << words(expected.at(x, y));
    }
  }
  return count == 0 ? "" : std::to_string(count) + " pixels differ, the first at " + first.str();
}

}  // namespace zstrip::boards
