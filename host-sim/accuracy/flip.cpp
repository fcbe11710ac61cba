// The colour pipeline, the feature pipeline, and their combination.
#include "accuracy/flip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zstrip::sim {
namespace {

using Vector = std::array<double, 3>;
using Plane = std::vector<double>;

constexpr double kPi = 3.14159265358979323846;
constexpr Vector kWhite{0.950428545, 1, 1.088900371};  // D65

// Converts linear sRGB to XYZ relative to the white point, and back.
constexpr double kToXyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
constexpr double kToRgb[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                 {-0.969224334, 1.875930071, 0.041554224},
                                 {0.055639423, -0.204011202, 1.057148933}};

Vector product(const double (&m)[3][3], const Vector& v) {
  Vector out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

Vector linear(const std::array<float, 3>& srgb) {
  Vector out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double s = srgb[c] / 255.0;
    out[c] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  }
  return out;
}

/// Converts to luminance and two opponent channels, linear in light.
Vector opponent(const Vector& rgb) {
  const Vector xyz = product(kToXyz, rgb);
  const double x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}
Vector rgb_of_opponent(const Vector& v) {
  const double y = (v[0] + 16) / 116, x = y + v[1] / 500, z = y - v[2] / 200;
  Vector rgb = product(kToRgb, {x * kWhite[0], y * kWhite[1], z * kWhite[2]});
  for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
  return rgb;
}

/// Converts to CIELAB with the Hunt effect: darker colours are less colourful.
Vector hunt_lab(const Vector& rgb) {
  const Vector xyz = product(kToXyz, rgb);
  constexpr double kDelta = 6.0 / 29;
  Vector f{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double t = xyz[c] / kWhite[c];
    f[c] = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  }
  const double lightness = 116 * f[1] - 16;
  return {lightness, 0.01 * lightness * 500 * (f[0] - f[1]), 0.01 * lightness * 200 * (f[1] - f[2])};
}
double hyab(const Vector& a, const Vector& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// A kernel of odd length, centred.
using Kernel = std::vector<double>;

struct Size {
  std::ptrdiff_t width, height;
};

/// Convolves along x, or along y if `down`. Values outside the picture are those at its border.
Plane convolved(const Size& size, const Plane& from, const Kernel& kernel, bool down) {
  const std::ptrdiff_t radius = static_cast<std::ptrdiff_t>(kernel.size()) / 2;
  const std::ptrdiff_t last = (down ? size.height : size.width) - 1, stride = down ? size.width : 1;
  Plane out;
  out.reserve(from.size());
  for (std::ptrdiff_t y = 0; y < size.height; ++y) {
    for (std::ptrdiff_t x = 0; x < size.width; ++x) {
      const std::ptrdiff_t here = down ? y : x, line = y * size.width + x - here * stride;
      double sum = 0;
      for (std::ptrdiff_t i = -radius; i <= radius; ++i) {
        const std::ptrdiff_t at = line + std::clamp<std::ptrdiff_t>(here + i, 0, last) * stride;
        sum += kernel[static_cast<std::size_t>(i + radius)] * from[static_cast<std::size_t>(at)];
      }
      out.push_back(sum);
    }
  }
  return out;
}

/// One term of a contrast sensitivity function as a blur: scale * sqrt(pi / spread) * e^(-pi^2 d^2 / spread), d in
/// degrees.
struct Term {
  double scale, spread;
};
constexpr Term kBlur[3][2] = {{{1, 0.0047}, {0, 0.00001}}, {{1, 0.0053}, {0, 0.00001}}, {{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidestSpread = 0.04;

/// Blurs a channel as the eye does at this distance.
Plane blurred(const Size& size, const Plane& channel, const Term (&terms)[2], double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidestSpread / (2 * kPi * kPi)) * pixels_per_degree));
  Plane out(channel.size());
  double total = 0;
  for (const Term& term : terms) {
    if (term.scale == 0) continue;
    Kernel kernel;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) {
      const double degrees = i / pixels_per_degree;
      kernel.push_back(std::exp(-kPi * kPi * degrees * degrees / term.spread));
      sum += kernel.back();
    }
    const double weight = term.scale * std::sqrt(kPi / term.spread);
    const Plane part = convolved(size, convolved(size, channel, kernel, false), kernel, true);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * part[i];
    total += weight * sum * sum;
  }
  for (double& value : out) value /= total;
  return out;
}

/// Returns the visible differences of colour at this distance, 0..1.
Plane colour_difference(const Size& size, const std::array<Plane, 3>& a, const std::array<Plane, 3>& b,
                        double pixels_per_degree) {
  constexpr double kPower = 0.7, kKnee = 0.4, kAtKnee = 0.95;
  const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kPower);
  std::array<Plane, 3> of_a, of_b;
  for (std::size_t c = 0; c < 3; ++c) {
    of_a[c] = blurred(size, a[c], kBlur[c], pixels_per_degree);
    of_b[c] = blurred(size, b[c], kBlur[c], pixels_per_degree);
  }
  Plane out(a[0].size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vector lab_a = hunt_lab(rgb_of_opponent({of_a[0][i], of_a[1][i], of_a[2][i]}));
    const Vector lab_b = hunt_lab(rgb_of_opponent({of_b[0][i], of_b[1][i], of_b[2][i]}));
    const double difference = std::pow(hyab(lab_a, lab_b), kPower), knee = kKnee * largest;
    out[i] = difference < knee ? kAtKnee / knee * difference
                               : kAtKnee + (difference - knee) / (largest - knee) * (1 - kAtKnee);
  }
  return out;
}

/// Scales the kernel: its positive values add up to 1 and its negative values to -1, each times the sum of `across`,
/// with which it is used.
void normalise(Kernel& kernel, const Kernel& across) {
  double positive = 0, negative = 0, sum = 0;
  for (const double value : kernel) (value < 0 ? negative : positive) += std::abs(value);
  for (const double value : across) sum += value;
  for (double& value : kernel) value /= (value < 0 ? negative : positive) * sum;
}

struct Features {
  Plane edges, points;  ///< the strengths of edges and points
};

Features features(const Size& size, const Plane& luminance, double pixels_per_degree) {
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  Kernel gauss, first, second;
  for (int i = -radius; i <= radius; ++i) {
    gauss.push_back(std::exp(-i * i / (2 * deviation * deviation)));
    first.push_back(-i * gauss.back());
    second.push_back((i * i / (deviation * deviation) - 1) * gauss.back());
  }
  normalise(first, gauss);
  normalise(second, gauss);
  const auto strength = [&](const Kernel& kernel) {
    const Plane across = convolved(size, convolved(size, luminance, kernel, false), gauss, true);
    const Plane down = convolved(size, convolved(size, luminance, gauss, false), kernel, true);
    Plane out(luminance.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::hypot(across[i], down[i]);
    return out;
  };
  return {strength(first), strength(second)};
}

std::array<Plane, 3> opponent_planes(std::span<const std::array<float, 3>> picture) {
  std::array<Plane, 3> planes;
  for (const auto& pixel : picture) {
    const Vector v = opponent(linear(pixel));
    for (std::size_t c = 0; c < 3; ++c) planes[c].push_back(v[c]);
  }
  return planes;
}

Plane normalised_luminance(Plane channel) {
  for (double& value : channel) value = (value + 16) / 116;
  return channel;
}

}  // namespace

std::vector<float> flip(std::uint32_t width, std::uint32_t height, std::span<const std::array<float, 3>> a,
                        std::span<const std::array<float, 3>> b, double pixels_per_degree) {
  const Size size{width, height};
  const std::array<Plane, 3> of_a = opponent_planes(a), of_b = opponent_planes(b);
  const Plane colour = colour_difference(size, of_a, of_b, pixels_per_degree);
  const Features in_a = features(size, normalised_luminance(of_a[0]), pixels_per_degree);
  const Features in_b = features(size, normalised_luminance(of_b[0]), pixels_per_degree);
  std::vector<float> result(a.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double feature = std::max(std::abs(in_a.edges[i] - in_b.edges[i]), std::abs(in_a.points[i] - in_b.points[i]));
    const double amplified = std::clamp(std::sqrt(feature / std::sqrt(2.0)), 0.0, 1.0);
    result[i] = static_cast<float>(std::pow(colour[i], 1 - amplified));
  }
  return result;
}

}  // namespace zstrip::sim
