// Converts sRGB to CIELAB, smooths it, and computes the distance.
#include "accuracy/perceived.hpp"

#include <algorithm>
#include <cmath>

namespace zstrip::sim {
namespace {

// Cube root of numbers of 0.008 to 1.1, by Newton's method. Libraries differ in the last bit of their cbrt and pow, so
// that the playground's picture would differ from the command's.
double cube_root(double x) {
  double root = 1;
  for (int i = 0; i < 12; ++i) root -= (root - x / (root * root)) / 3;
  return root;
}

float length(float a, float b) { return std::sqrt(a * a + b * b); }

double power_2_4(double x) {
  double root = 1;  // the fifth root
  for (int i = 0; i < 12; ++i) root -= (root - x / (root * root * root * root)) / 5;
  return x * x * root * root;
}

std::array<float, 3> lab(const std::array<float, 3>& srgb) {
  std::array<double, 3> linear{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double s = srgb[c] / 255.0;
    linear[c] = s <= 0.04045 ? s / 12.92 : power_2_4((s + 0.055) / 1.055);
  }
  const auto [r, g, b] = linear;
  // sRGB to XYZ relative to its white point, D65.
  const std::array<double, 3> xyz{(0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505, 0.2126 * r + 0.7152 * g + 0.0722 * b,
                                  (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089};
  std::array<double, 3> f{};
  for (std::size_t c = 0; c < 3; ++c) f[c] = xyz[c] > 0.008856 ? cube_root(xyz[c]) : 7.787 * xyz[c] + 16.0 / 116;
  return {static_cast<float>(116 * f[1] - 16), static_cast<float>(500 * (f[0] - f[1])),
          static_cast<float>(200 * (f[1] - f[2]))};
}

/// 3x3 binomial: keeps about as much of one pixel's contrast as is visible on a display of 67 pixels a degree.
std::vector<std::array<float, 3>> smoothed(std::uint32_t width, std::uint32_t height,
                                           const std::vector<std::array<float, 3>>& from) {
  std::vector<std::array<float, 3>> out(from.size());
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      std::array<float, 3> sum{};
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const auto at_x =
              static_cast<std::size_t>(std::clamp(static_cast<int>(x) + dx, 0, static_cast<int>(width) - 1));
          const auto at_y =
              static_cast<std::size_t>(std::clamp(static_cast<int>(y) + dy, 0, static_cast<int>(height) - 1));
          const float weight = static_cast<float>((2 - std::abs(dx)) * (2 - std::abs(dy))) / 16;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * from[at_y * width + at_x][c];
        }
      }
      out[std::size_t{y} * width + x] = sum;
    }
  }
  return out;
}

}  // namespace

std::vector<float> perceived_difference(std::uint32_t width, std::uint32_t height,
                                        std::span<const std::array<float, 3>> a,
                                        std::span<const std::array<float, 3>> b) {
  const auto prepared = [&](std::span<const std::array<float, 3>> picture) {
    std::vector<std::array<float, 3>> converted;
    converted.reserve(picture.size());
    for (const auto& colour : picture) converted.push_back(lab(colour));
    return smoothed(width, height, converted);
  };
  const auto of_a = prepared(a), of_b = prepared(b);
  std::vector<float> difference(of_a.size());
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    difference[i] = std::abs(of_a[i][0] - of_b[i][0]) + length(of_a[i][1] - of_b[i][1], of_a[i][2] - of_b[i][2]);
  }
  return difference;
}

}  // namespace zstrip::sim
