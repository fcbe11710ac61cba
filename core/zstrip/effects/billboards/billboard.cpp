// Rotates billboards towards the camera, once for each instance and frame.
#include "zstrip/effects/billboards/billboard.hpp"

#include "zstrip/base/direction.hpp"
#include "zstrip/base/math.hpp"

namespace zstrip::detail {
namespace {

Wide3 column(const Transform& transform, int index) {
  return {transform.m[0][index], transform.m[1][index], transform.m[2][index]};
}

/// Sets column `index` of `to` to `axis` (2.30) with the column's length in `from`. Not inlined, to save flash.
[[gnu::noinline]] void turn_column(const Transform& from, Transform& to, int index, const Vec3& axis) {
  const Wide3 v = column(from, index);
  // 16.22, rounded down, below 2^31: entries are at most 2^24, so that the sum, with 12 bits more, is below 2^62.
  const std::int64_t length = square_root(static_cast<std::uint64_t>(v.x * v.x + v.y * v.y + v.z * v.z) << 12);
  const auto entry = [length](std::int32_t c) {
    return static_cast<Fixed>((c * length + (std::int64_t{1} << 35)) >> 36);
  };
  to.m[0][index] = entry(axis.x);
  to.m[1][index] = entry(axis.y);
  to.m[2][index] = entry(axis.z);
}

/// Returns `axis` without its component along `direction`; both are unit vectors.
Wide3 across(const Vec3& axis, const Vec3& direction) {
  const auto product = [](std::int32_t a, std::int32_t b) { return std::int64_t{a} * b; };
  const std::int64_t along =
      (product(axis.x, direction.x) + product(axis.y, direction.y) + product(axis.z, direction.z)) >> 30;  // 2.30
  return {axis.x - ((along * direction.x) >> 30), axis.y - ((along * direction.y) >> 30),
          axis.z - ((along * direction.z) >> 30)};
}

}  // namespace

Transform turned_to_viewer(const Transform& transform, Billboard billboard, const Camera& camera) {
  Transform turned = transform;
  const Wide3 y = column(transform, 1);
  Vec3 right = camera.right, back = camera.back;
  if (billboard == Billboard::viewer || y == Wide3{0, 0, 0}) {
    turn_column(transform, turned, 1, camera.up);
  } else {
    const Vec3 axis = unit(y);
    constexpr std::int64_t kMin = std::int64_t{1} << 22;  // 2.30: a 256th of a unit vector
    const Wide3 sideways = across(camera.right, axis);
    const Wide3 instead = cross(axis, camera.back);
    if (is_within(sideways, kMin) && instead == Wide3{0, 0, 0}) return transform;  // the camera has no axes
    right = unit(is_within(sideways, kMin) ? instead : sideways);
    back = unit(cross(right, axis));
  }
  turn_column(transform, turned, 0, right);
  turn_column(transform, turned, 2, back);
  return turned;
}

}  // namespace zstrip::detail
