// Finds the planes around a pixel; see pixel_planes.hpp.
#include "zstrip/state/pixel_planes.hpp"

#include <algorithm>
#include <bit>

#include "zstrip/base/unit_vector.hpp"

namespace zstrip::detail {
namespace {

constexpr int kRatioBits = 8;
constexpr std::uint64_t kMaxRatio = std::uint64_t{1} << 36;
constexpr std::int32_t kUnbounded = INT32_MAX;  // the shift of a plane that no sphere misses

int bits_beyond(std::uint64_t value, int bits) { return std::max(0, 64 - std::countl_zero(value) - bits); }

std::uint64_t absolute(std::int64_t value) { return static_cast<std::uint64_t>(value < 0 ? -value : value); }

/// Returns value * 2^exponent, for an exponent of -1 .. 30.
std::int64_t scaled(std::int32_t value, int exponent) {
  return exponent < 0 ? value >> 1 : std::int64_t{value} * (std::int64_t{1} << exponent);
}

}  // namespace

PixelPlanes::PixelPlanes(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin,
                         const Rect& pixel, bool orthographic)
    : w_(orthographic ? LinearForm{0, 0, 0, 1 << 30} : instance.w),
      exponent_x_(30 - instance.shift_x),
      exponent_y_(30 - instance.shift_y) {
  // A sphere's radius in the positions of an axis is larger where the half extent is smaller than the largest.
  const Fixed extents[3] = {mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
  const auto largest = static_cast<std::uint64_t>(std::max(std::max(extents[0], extents[1]), extents[2]));
  std::uint64_t ratios[3];
  for (int i = 0; i < 3; ++i) {
    ratios[i] = kMaxRatio;
    if (extents[i] <= 0) continue;
    const auto extent = static_cast<std::uint64_t>(extents[i]);
    ratios[i] = std::min(((largest << kRatioBits) + extent - 1) / extent, kMaxRatio);
  }
  constexpr std::int32_t kPixel = 16;
  left_ = plane_of(instance.x, exponent_x_, pixel.left * 16 - origin.bias_x - kPixel, ratios);
  right_ = plane_of(instance.x, exponent_x_, pixel.right * 16 - origin.bias_x + kPixel, ratios);
  top_ = plane_of(instance.y, exponent_y_, pixel.top * 16 - origin.bias_y - kPixel, ratios);
  bottom_ = plane_of(instance.y, exponent_y_, pixel.bottom * 16 - origin.bias_y + kPixel, ratios);
}

// Not inlined, because there are four calls.
[[gnu::noinline]] PixelPlanes::Plane PixelPlanes::plane_of(const LinearForm& form, int exponent, std::int32_t at,
                                                           const std::uint64_t (&ratios)[3]) const {
  const std::uint64_t steepness[3] = {absolute(scaled(form.x, exponent) - std::int64_t{at} * w_.x),
                                      absolute(scaled(form.y, exponent) - std::int64_t{at} * w_.y),
                                      absolute(scaled(form.z, exponent) - std::int64_t{at} * w_.z)};
  // The length of the gradient where the sphere is round, rounded up: 24 bits of each steepness, 15 of each product.
  const int first = bits_beyond(std::max(std::max(steepness[0], steepness[1]), steepness[2]), 24);
  std::uint64_t gradient[3];
  for (int i = 0; i < 3; ++i) {
    gradient[i] = steepness[i] == 0 ? 0 : ((steepness[i] >> first) + 1) * ratios[i];
    if (gradient[i] != 0 && ratios[i] == kMaxRatio) return {at, 0, kUnbounded};
  }
  const int second = bits_beyond(std::max(std::max(gradient[0], gradient[1]), gradient[2]), 15);
  std::uint32_t square = 0;
  for (const std::uint64_t each : gradient) {
    const auto part = static_cast<std::uint32_t>(each >> second) + 1;
    square += part * part;
  }
  constexpr int kFormBits = 16;  // fraction bits of a form's products
  const int shift = first + second - kRatioBits - kFormBits;
  return {at, root_of_word(square) + 1, shift > 30 ? kUnbounded : shift};
}

[[gnu::noinline]] bool PixelPlanes::misses(const Plane& low, const Plane& high, std::int32_t numerator, std::int32_t w,
                                           int exponent, std::uint16_t radius) const {
  const std::int64_t value = scaled(numerator, exponent);
  // Forms are rounded down three times, at the centre and at a vertex. Clipping moves a point by less than the rest.
  const std::int64_t moved = (std::int64_t{4} << std::max(0, exponent)) + (5 << 16);
  const auto beyond = [&](const Plane& plane, int sign) {
    if (plane.shift == kUnbounded) return false;
    const std::uint64_t product = std::uint64_t{radius} * plane.reach;
    const std::uint64_t reach = plane.shift >= 0 ? product << plane.shift : (product >> -plane.shift) + 1;
    return sign * (value - std::int64_t{plane.at} * w) > static_cast<std::int64_t>(reach) + moved;
  };
  return beyond(low, -1) || beyond(high, 1);
}

bool PixelPlanes::miss(const CompiledInstance& instance, const Meshlet& meshlet) const {
  const std::int32_t w = w_.at(meshlet.centre);
  return misses(top_, bottom_, instance.y.at(meshlet.centre), w, exponent_y_, meshlet.radius) ||
         misses(left_, right_, instance.x.at(meshlet.centre), w, exponent_x_, meshlet.radius);
}

}  // namespace zstrip::detail
