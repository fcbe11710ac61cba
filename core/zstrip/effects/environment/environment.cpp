// Composes camera, transform and bounding box for the vertices of instances with an environment map, once for each
// instance and frame, in 64-bit arithmetic.
#include "zstrip/effects/environment/environment.hpp"

#include <bit>

#include "zstrip/base/direction.hpp"

namespace zstrip::detail {
namespace {

/// A form's parts in 26.38: value(p) = offset + sum part[i] * p[i] / 32768.
struct WideForm {
  std::int64_t part[3], offset;
};

/// Returns the camera's up axis with unit length; Camera::up is half as long if two samples lie side by side.
Vec3 up_of(const Camera& camera) {
  const Wide3 up = cross(camera.back, camera.right);
  return up == Wide3{0, 0, 0} ? Vec3{0, 0, 0} : unit(up);
}

}  // namespace

EyeForms eye_forms(const Mesh& mesh, const Transform& transform, const Camera& camera) {
  const Fixed half[3] = {mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
  const Fixed centre[3] = {mesh.centre.x, mesh.centre.y, mesh.centre.z};
  const Fixed eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
  const Vec3 axes[3] = {camera.right, up_of(camera), camera.back};
  std::int64_t turned[3][3] = {};  // 42.22, below 2^32
  WideForm wide[3] = {};
  std::uint64_t largest_turned = 1, reach = 1;
  for (int row = 0; row < 3; ++row) {
    const std::int32_t axis[3] = {axes[row].x, axes[row].y, axes[row].z};
    WideForm& form = wide[row];
    std::uint64_t sum = 0;
    for (int column = 0; column < 3; ++column) {
      std::int64_t& entry = turned[row][column];
      for (int k = 0; k < 3; ++k) entry += std::int64_t{axis[k]} * transform.m[k][column];  // 18.46, below 2^56
      entry >>= 24;
      largest_turned = std::max(largest_turned, static_cast<std::uint64_t>(magnitude(entry)));
      form.part[column] = -entry * half[column];  // below 2^60
      form.offset -= entry * centre[column];
      sum += static_cast<std::uint64_t>(magnitude(form.part[column]));
    }
    for (int k = 0; k < 3; ++k) {
      form.offset -= (axis[k] * (std::int64_t{transform.m[k][3]} - eye[k])) >> 8;  // 19.46
    }
    reach = std::max(reach, sum + static_cast<std::uint64_t>(magnitude(form.offset)));
  }
  // Shifts all three to 30 bits by the same amount: the direction matters, not the length.
  const int exponent = 34 - std::countl_zero(reach);
  const auto shifted = [](std::int64_t value, int shift) {
    return static_cast<std::int32_t>(
        shift >= 0 ? value >> shift : static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << -shift));
  };
  EyeForms forms{};
  LinearForm* const into[3] = {&forms.x, &forms.y, &forms.z};
  for (int row = 0; row < 3; ++row) {
    const WideForm& form = wide[row];
    // LinearForm uses half of a coefficient at p = 32768: coefficients have one bit more than the value.
    *into[row] = {shifted(form.part[0], exponent - 1), shifted(form.part[1], exponent - 1),
                  shifted(form.part[2], exponent - 1), shifted(form.offset, exponent)};
    for (int column = 0; column < 3; ++column) {
      forms.normal[row][column] =
          static_cast<std::int16_t>(turned[row][column] * (1 << 14) / static_cast<std::int64_t>(largest_turned));
    }
  }
  return forms;
}

}  // namespace zstrip::detail
