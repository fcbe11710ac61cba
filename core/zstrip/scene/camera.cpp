// Camera placement: look-at, spherical coordinates, field of view.
#include "zstrip/camera.hpp"

#include "zstrip/base/direction.hpp"
#include "zstrip/base/math.hpp"

namespace zstrip {
namespace {

using detail::cross;
using detail::magnitude;
using detail::unit;
using detail::Wide3;

constexpr bool nearly_zero(const Wide3& v) {
  return detail::is_within(v, std::int64_t{1} << 36);  // 2^-16 of a unit vector, in 2.52
}

}  // namespace

bool usable(const Camera& camera) {
  const auto at_most_unit = [](const Vec3& axis) {
    constexpr std::int32_t kMax = (std::int32_t{1} << 30) + 64;  // 2.30, with the rounding of a unit vector
    const auto fits = [](std::int32_t c) { return c >= -kMax && c <= kMax; };
    return fits(axis.x) && fits(axis.y) && fits(axis.z);
  };
  return camera.focal > 0 && camera.near_plane > 0 && camera.far_plane > camera.near_plane &&
         at_most_unit(camera.right) && at_most_unit(camera.up) && at_most_unit(camera.back);
}

Status look_at(Camera& camera, const Vec3& eye, const Vec3& target, const Vec3& up) {
  const Wide3 backwards{std::int64_t{eye.x} - target.x, std::int64_t{eye.y} - target.y, std::int64_t{eye.z} - target.z};
  if (backwards.x == 0 && backwards.y == 0 && backwards.z == 0) return {.error = Error::camera};
  const Vec3 back = unit(backwards);
  const Vec3 hint = up == Vec3{0, 0, 0} ? Vec3{0, 1 << 30, 0} : unit(Wide3{up.x, up.y, up.z});
  Wide3 sideways = cross(hint, back);
  if (nearly_zero(sideways)) sideways = cross({0, 0, -(1 << 30)}, back);
  if (nearly_zero(sideways)) sideways = cross({0, 1 << 30, 0}, back);
  camera.right = unit(sideways);
  camera.back = back;
  camera.up = unit(cross(back, camera.right));
  camera.eye = eye;
  return {};
}

Status orbit(Camera& camera, const Vec3& target, Fixed radius, Angle phi, Angle theta) {
  if (radius <= 0) return {.error = Error::camera};
  const std::int32_t sin_phi = sine(phi);
  const std::int32_t cos_phi = cosine(phi);
  const std::int32_t sin_theta = sine(theta);
  const std::int32_t cos_theta = cosine(theta);
  const auto times = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>((std::int64_t{a} * b) >> 30);  // 2.30
  };
  // The rows of matrix S in the text, with renamed axes (see docs/conventions.md); `back` is the negative third row.
  camera.right = {cos_phi, 0, -sin_phi};
  camera.up = {-times(cos_theta, sin_phi), sin_theta, -times(cos_theta, cos_phi)};
  camera.back = {times(sin_theta, sin_phi), cos_theta, times(sin_theta, cos_phi)};
  const auto along = [radius](std::int32_t axis) { return (std::int64_t{axis} * radius) >> 30; };  // 16.16
  const std::int64_t x = target.x + along(camera.back.x);
  const std::int64_t y = target.y + along(camera.back.y);
  const std::int64_t z = target.z + along(camera.back.z);
  const auto fits = [](std::int64_t c) { return magnitude(c) <= 0x7FFFFFFF; };
  if (!fits(x) || !fits(y) || !fits(z)) return {.error = Error::camera};
  camera.eye = {static_cast<Fixed>(x), static_cast<Fixed>(y), static_cast<Fixed>(z)};
  return {};
}

Status set_field_of_view(Camera& camera, Angle vertical_field_of_view) {
  if (vertical_field_of_view <= 0 || vertical_field_of_view >= kFullTurn / 2) return {.error = Error::camera};
  // Half of an odd angle lies between two table angles, so use cot(a/2) = (1 + cos a) / sin a.
  const std::int64_t numerator = (std::int64_t{1} << 30) + cosine(vertical_field_of_view);
  const std::int64_t focal = (numerator << kFixedBits) / sine(vertical_field_of_view);
  if (focal < 1 || focal > 0x7FFFFFFF) return {.error = Error::camera};
  camera.focal = static_cast<Fixed>(focal);
  return {};
}

}  // namespace zstrip
