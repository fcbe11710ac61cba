// A textured sphere to be made smaller, and how much pictures differ.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "bake_fixture.hpp"
#include "image/decode.hpp"

namespace zstrip::sim::test {

class ReducedModel : public Bake {
 protected:
  RgbImage picture(const std::string& scene, std::vector<std::string> options) {
    std::vector<std::string> arguments{"render", scene, "-o", "p.png", "--quiet", "--size", "160x160"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string bytes = read(path("p.png"));
    return *decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
  /// A 24-bit TGA of side x side texels: red grows to the right, green downwards.
  void texture(const std::string& name, int side) {
    std::string bytes(18, '\0');
    bytes[2] = 2;
    bytes[12] = bytes[14] = static_cast<char>(side & 255);
    bytes[13] = bytes[15] = static_cast<char>(side >> 8);
    bytes[16] = 24;
    bytes[17] = 0x20;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        bytes += {static_cast<char>(60), static_cast<char>(y * 255 / side), static_cast<char>(x * 255 / side)};
      }
    }
    file(name, bytes);
  }
  /// A sphere whose texture has a seam, and whose halves have different materials.
  std::string textured_sphere(int columns, int rows) {
    std::string text = "mtllib sphere.mtl\n";
    const double pi = std::numbers::pi;
    for (int row = 0; row <= rows; ++row) {
      for (int column = 0; column <= columns; ++column) {
        const double theta = pi * row / rows, phi = 2 * pi * (column % columns) / columns;
        const double x = std::sin(theta) * std::cos(phi), y = std::cos(theta), z = std::sin(theta) * std::sin(phi);
        text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
        text += "vt " + std::to_string(1.0 * column / columns) + " " + std::to_string(1 - 1.0 * row / rows) + "\n";
        text += "vn " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
      }
    }
    for (int row = 0; row < rows; ++row) {
      if (row == 0) text += "usemtl upper\n";
      if (row == rows / 2) text += "usemtl lower\n";
      for (int column = 0; column < columns; ++column) {
        const auto corner = [&](int down, int right) {
          const std::string i = std::to_string((row + down) * (columns + 1) + column + right + 1);
          return " " + i + "/" + i + "/" + i;
        };
        if (row > 0) text += "f" + corner(0, 0) + corner(0, 1) + corner(1, 1) + "\n";
        if (row < rows - 1) text += "f" + corner(0, 0) + corner(1, 1) + corner(1, 0) + "\n";
      }
    }
    file("sphere.mtl", "newmtl upper\nKd 1 1 1\nmap_Kd colours.tga\nnewmtl lower\nKd 1 1 1\nmap_Kd colours.tga\n");
    return file("sphere.obj", text);
  }
};

inline double mean_difference(const RgbImage& a, const RgbImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
  return sum / static_cast<double>(a.rgb.size());
}

}  // namespace zstrip::sim::test
