// Composes camera and transform of a sphere or ellipsoid into the polynomials of its depth; see quadric.hpp.
#include "zstrip/effects/quadrics/quadric.hpp"

#include <algorithm>

#include "zstrip/base/scaled.hpp"
#include "zstrip/geometry/colour_product.hpp"

namespace zstrip::detail {
namespace {

/// The limits of the pixel loop's shifts. Outside of them, depth is too steep or too flat for any z-buffer.
constexpr std::int32_t kMinRootShift = -24, kMaxRootShift = 23;

/// The unit sphere's axes and centre, in the coordinates right, up, distance.
struct ViewQuadric {
  Scaled3 axis[3];
  Scaled3 centre;
};

ViewQuadric in_view(const Transform& transform, const Camera& camera) {
  const auto row = [&](const Vec3& axis, std::int64_t sign, int column) {
    const std::int64_t a[3] = {axis.x, axis.y, axis.z};
    std::int64_t sum = 0;
    if (column < 3) {
      for (int k = 0; k < 3; ++k) sum += a[k] * transform.m[k][column];  // 2.30 * 9.16, below 2^56
      return Scaled(sign * sum, -46);
    }
    const Fixed eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
    for (int k = 0; k < 3; ++k) sum += (a[k] * (std::int64_t{transform.m[k][3]} - eye[k])) >> 8;  // 26.38
    return Scaled(sign * sum, -38);
  };
  const auto column = [&](int c) {
    return Scaled3{row(camera.right, 1, c), row(camera.up, 1, c), row(camera.back, -1, c)};
  };
  return {{column(0), column(1), column(2)}, column(3)};
}

/// Computes the columns of the inverse of the matrix with these columns. Returns false if it has no inverse.
bool invert(const Scaled3 (&axis)[3], Scaled3 (&inverse)[3]) {
  const Scaled3 rows[3] = {cross(axis[1], axis[2]), cross(axis[2], axis[0]), cross(axis[0], axis[1])};
  const Scaled determinant = dot(axis[0], rows[0]);
  if (determinant.sign() == 0) return false;
  const Scaled scale = Scaled(1, 0) / determinant;
  inverse[0] = scale * Scaled3{rows[0].x, rows[1].x, rows[2].x};
  inverse[1] = scale * Scaled3{rows[0].y, rows[1].y, rows[2].y};
  inverse[2] = scale * Scaled3{rows[0].z, rows[1].z, rows[2].z};
  return true;
}

/// The range of a silhouette in one picture coordinate, in pixels.
struct Side {
  std::int32_t low, high;
};

/// Returns the begin and the end of the silhouette along `across`, one of the coordinates in view space, in pixels from
/// the picture's centre; everything if they are unknown. One pixel is added on each side.
Side silhouette(const ViewQuadric& q, Scaled Scaled3::*across, const Scaled& pixels_per_unit, bool orthographic) {
  constexpr std::int32_t kBeyond = 1 << 20;
  Scaled width2, width_depth, depth2;
  for (const Scaled3& axis : q.axis) {
    width2 = width2 + axis.*across * (axis.*across);
    width_depth = width_depth + axis.*across * axis.z;
    depth2 = depth2 + axis.z * axis.z;
  }
  const Scaled centre = q.centre.*across;
  Scaled middle = centre, reach = root(width2);
  if (!orthographic) {
    // The two planes through the eye that touch the quadric: (centre - t depth)^2 = sum of (axis - t depth)^2.
    const Scaled a = q.centre.z * q.centre.z - depth2;
    if (q.centre.z.sign() <= 0 || a < (q.centre.z * q.centre.z).shifted(-20)) return {-kBeyond, kBeyond};
    const Scaled b = centre * q.centre.z - width_depth;
    const Scaled c = centre * centre - width2;
    middle = b / a;
    reach = root(b * b - a * c) / a;
  }
  const auto pixel = [](const Scaled& value) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(value.fixed(0), -kBeyond, kBeyond));
  };
  return {pixel((middle - reach) * pixels_per_unit) - 1, pixel((middle + reach) * pixels_per_unit) + 2};
}

Rect box_of(const ViewQuadric& q, const View& view, const Scaled& pixels_per_unit, bool orthographic) {
  const Side across = silhouette(q, &Scaled3::x, pixels_per_unit, orthographic);
  const Side up = silhouette(q, &Scaled3::y, pixels_per_unit, orthographic);
  const std::int32_t left = -(view.width >> 1), top = -(view.height >> 1);
  const Rect box = Rect{across.low, -up.high, across.high + 1, -up.low + 1}.cut_to(
      {left, top, left + view.width, top + view.height});
  return box.empty() ? Rect{} : box;
}

/// A vector that is linear in pixels: its value at the anchor, and its steps to the right and down.
struct PixelPlane {
  Scaled3 start, step_x, step_y;

  template <class Map>
  PixelPlane mapped(const Map& map) const {
    return {map(start), map(step_x), map(step_y)};
  }
};

/// The largest distance of the box's pixels from the anchor.
struct Reach {
  Scaled columns, rows;
};

/// Converts to the fixed point of DirectionPlane; only the direction matters. `root_bound`: no root is greater.
DirectionPlane direction_plane(const PixelPlane& plane, const Scaled3& per_root, const Reach& reach,
                               std::int32_t root_bits, std::int32_t direction_shift) {
  const Scaled Scaled3::*const members[3] = {&Scaled3::x, &Scaled3::y, &Scaled3::z};
  std::int32_t bits = -1000;
  for (const auto member : members) {
    const Scaled bound = (plane.start.*member).magnitude() + (plane.step_x.*member).magnitude() * reach.columns +
                         (plane.step_y.*member).magnitude() * reach.rows +
                         (per_root.*member).magnitude().shifted(root_bits);
    bits = std::max(bits, bound.log2_bound());
  }
  const std::int32_t fraction = 29 - bits;
  DirectionPlane result{};
  for (int i = 0; i < 3; ++i) {
    const auto member = members[i];
    result.start[i] = static_cast<std::int32_t>((plane.start.*member).fixed(fraction));
    result.step_x[i] = static_cast<std::int32_t>((plane.step_x.*member).fixed(fraction));
    result.step_y[i] = static_cast<std::int32_t>((plane.step_y.*member).fixed(fraction));
    result.root_part[i] = static_cast<std::int32_t>((per_root.*member).fixed(fraction + direction_shift));
  }
  return result;
}

void compile_shading(CompiledQuadric& compiled, const Scene& scene, const Quadric& quadric) {
  const Material& material = scene.materials[quadric.material];
  compiled.material = quadric.material;
  compiled.lit = material.lit;
  compiled.textured = material.texture != kNoTexture;
  compiled.base = material.colour;
  compiled.ambient = product(scene.ambient, material.colour);
  compiled.light_count = material.lit ? static_cast<std::uint8_t>(scene.lights.size()) : std::uint8_t{0};
  for (int i = 0; i < compiled.light_count; ++i) {
    const DirectionalLight& light = scene.lights[static_cast<std::size_t>(i)];
    const Colour colour = product(light.colour, material.colour);
    compiled.lights[i] = {light.x, light.y, light.z, colour.r, colour.g, colour.b, 0};
  }
}

}  // namespace

void extend(DistanceRange& reach, std::span<const Quadric> quadrics, const Camera& camera) {
  for (const Quadric& quadric : quadrics) extend(reach, distance_range(quadric, camera), camera);
}

DistanceRange distance_range(const Quadric& quadric, const Camera& camera) {
  const ViewQuadric q = in_view(quadric.transform, camera);
  const Scaled reach = root(q.axis[0].z * q.axis[0].z + q.axis[1].z * q.axis[1].z + q.axis[2].z * q.axis[2].z);
  // Sums and roots have an error of 2^-28; the range is widened by more.
  const Scaled slack = (reach + q.centre.z.magnitude()).shifted(-26);
  return {(q.centre.z - reach - slack).fixed(kDistanceBits), (q.centre.z + reach + slack).fixed(kDistanceBits)};
}

Status compile_quadric(CompiledQuadric& compiled, const Scene& scene, const Quadric& quadric, const Camera& camera,
                       const View& view, const DepthFit& fit, const RasterOrigin& origin) {
  const bool orthographic = camera.projection == Projection::orthographic;
  compiled = {};
  compile_shading(compiled, scene, quadric);
  const DistanceRange range = distance_range(quadric, camera);
  if (range.farthest < fit.near || range.nearest > fit.far) return {};
  compiled.cut = range.nearest < fit.near || range.farthest > fit.far;
  compiled.shows_inside = scene.materials[quadric.material].double_sided;

  const ViewQuadric q = in_view(quadric.transform, camera);
  Scaled3 inverse[3];
  if (!invert(q.axis, inverse)) return {.error = Error::quadric};
  const Scaled pixels_per_unit(std::int64_t{camera.focal} * view.height, -kFixedBits - 1);
  compiled.box = box_of(q, view, pixels_per_unit, orthographic);
  if (compiled.box.empty()) return {};

  // The anchor is the pixel next to the centre, where products of differences stay small.
  const auto centre = [&](const Scaled& coordinate) {
    const Scaled pixels = coordinate * pixels_per_unit;
    return (orthographic || q.centre.z.sign() <= 0 ? pixels : pixels / q.centre.z).fixed(0);
  };
  const auto anchor = [](std::int64_t pixel, std::int32_t low, std::int32_t end) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(pixel, low, end - 1));
  };
  const Rect& box = compiled.box;
  compiled.anchor_x = anchor(centre(q.centre.x), box.left, box.right);
  compiled.anchor_y = anchor(-centre(q.centre.y), box.top, box.bottom);
  const auto furthest = [](std::int32_t at, std::int32_t low, std::int32_t end) {
    return Scaled(std::max(at - low, end - at), 0);
  };
  const Reach reach{furthest(compiled.anchor_x, box.left, box.right), furthest(compiled.anchor_y, box.top, box.bottom)};

  // A pixel's ray in the unit sphere's space. Perspective: distance times `ray`, minus `pole`, in units in which pixels
  // are 1 apart. Orthographic: `ray` plus distance times `pole`.
  const Scaled3 sphere_centre = q.centre.x * inverse[0] + q.centre.y * inverse[1] + q.centre.z * inverse[2];
  const auto pixel_centre = [](std::int32_t pixel, std::uint16_t size) {
    return Scaled(2 * std::int64_t{pixel} + 1 - (size & 1), -1);
  };
  const Scaled step = orthographic ? Scaled(1, 0) / pixels_per_unit : Scaled(1, 0);
  PixelPlane ray{{}, step * inverse[0], step * (Scaled(-1, 0) * inverse[1])};
  ray.start = pixel_centre(compiled.anchor_x, view.width) * ray.step_x +
              pixel_centre(compiled.anchor_y, view.height) * ray.step_y;
  ray.start = orthographic ? ray.start - sphere_centre : ray.start + pixels_per_unit * inverse[2];
  const Scaled3 pole = orthographic ? inverse[2] : sphere_centre;

  // |distance ray - pole| = 1 is a quadratic equation in distance, and also in 1 / distance. This is its leading
  // coefficient:
  Scaled leading = dot(pole, pole);
  if (!orthographic) {
    leading = leading - Scaled(1, 0);
    const Scaled least(1, -20);  // for a camera on the surface: moves it away by less than 2^-21 of a radius
    if (leading.magnitude() < least) leading = leading.sign() < 0 ? -least : least;
  }
  const bool inside = leading.sign() < 0;
  if (inside && !compiled.shows_inside) return {};

  // The depth for one unit of the solution, and the depth where the solution is 0.
  Scaled units;
  std::int64_t at_zero = 0;
  compiled.nearest = fit.quotient_at_near;
  if (orthographic) {
    const std::int64_t span = fit.quotient_at_near - fit.offset - origin.depth_offset;
    units = Scaled(span, 0) / Scaled(fit.far - fit.near, -kDistanceBits);
    compiled.nearest = span;
    compiled.farthest = 0;
    at_zero = (units * Scaled(fit.far, -kDistanceBits)).fixed(0);
  } else {
    units = Scaled(fit.quotient_at_near, 0) * Scaled(fit.near, -kDistanceBits) / pixels_per_unit;
    compiled.farthest = (Scaled(fit.quotient_at_near, 0) * Scaled(fit.near, 0) / Scaled(fit.far, 0)).fixed(0);
  }
  // The depth range or the ray is thinner than its remaining bits.
  if (units.sign() == 0 || leading.sign() == 0) return {.error = Error::quadric};
  const Scaled per_leading = units / leading;
  const auto along_pole = ray.mapped([&](const Scaled3& v) { return Scaled3{dot(v, pole), {}, {}}; });
  compiled.linear =
      static_cast<std::uint64_t>(at_zero) + static_cast<std::uint64_t>((per_leading * along_pole.start.x).fixed(0));
  compiled.linear_x = static_cast<std::uint64_t>((per_leading * along_pole.step_x.x).fixed(0));
  compiled.linear_y = static_cast<std::uint64_t>((per_leading * along_pole.step_y.x).fixed(0));

  // Discriminant: |ray|^2 (orthographic: |pole|^2) - |ray x pole|^2, which cancels less than the usual form.
  const PixelPlane across = ray.mapped([&](const Scaled3& v) { return cross(v, pole); });
  const auto product_of = [&](Scaled3 PixelPlane::*a, Scaled3 PixelPlane::*b) {
    const Scaled crossed = dot(across.*a, across.*b);
    return orthographic ? -crossed : dot(ray.*a, ray.*b) - crossed;
  };
  const Scaled square = per_leading * per_leading;
  constexpr auto kStart = &PixelPlane::start, kX = &PixelPlane::step_x, kY = &PixelPlane::step_y;
  const Scaled at_anchor =
      square * (orthographic ? dot(pole, pole) + product_of(kStart, kStart) : product_of(kStart, kStart));
  const Scaled x = (square * product_of(kStart, kX)).shifted(1), y = (square * product_of(kStart, kY)).shifted(1);
  const Scaled xx = square * product_of(kX, kX), yy = square * product_of(kY, kY);
  const Scaled xy = (square * product_of(kX, kY)).shifted(1);
  const Scaled bound = at_anchor.magnitude() + x.magnitude() * reach.columns + y.magnitude() * reach.rows +
                       xx.magnitude() * reach.columns * reach.columns + xy.magnitude() * reach.columns * reach.rows +
                       yy.magnitude() * reach.rows * reach.rows;
  // Scaled to 61 or 62 bits, with an even shift.
  compiled.root_shift = std::clamp((bound.log2_bound() - 61) >> 1, kMinRootShift, kMaxRootShift);
  const auto scaled = [&](const Scaled& value) {
    return static_cast<std::uint64_t>(value.fixed(-2 * compiled.root_shift));
  };
  compiled.radicand = scaled(at_anchor);
  compiled.radicand_x = scaled(x);
  compiled.radicand_y = scaled(y);
  compiled.radicand_xx = scaled(xx);
  compiled.radicand_xy = scaled(xy);
  compiled.radicand_yy = scaled(yy);

  const std::int32_t root_bits = 31 + compiled.root_shift;  // roots are below 2^root_bits
  compiled.direction_shift = std::max<std::int32_t>(0, root_bits - 15);
  const Scaled per_pole = Scaled(1, 0) / leading;
  const PixelPlane surface =
      ray.mapped([&](const Scaled3& v) { return v - (per_pole * dot(v, pole)) * pole; });  // where the root is 0
  const Scaled3 per_root = (Scaled(-1, 0) / units) * pole;
  if (compiled.textured) {
    compiled.surface = direction_plane(surface, per_root, reach, root_bits, compiled.direction_shift);
  }
  if (compiled.lit) {
    // Normals are transformed by the inverse's transpose.
    Scaled3 axes[3], columns[3];
    for (int c = 0; c < 3; ++c) {
      const auto entry = [&](int r) { return Scaled(quadric.transform.m[r][c], -kFixedBits); };
      axes[c] = {entry(0), entry(1), entry(2)};
    }
    if (!invert(axes, columns)) return {.error = Error::quadric};
    const auto turned = [&](const Scaled3& v) {
      return Scaled3{dot(columns[0], v), dot(columns[1], v), dot(columns[2], v)};
    };
    compiled.normal =
        direction_plane(surface.mapped(turned), turned(per_root), reach, root_bits, compiled.direction_shift);
  }
  compiled.visible = true;
  return {};
}

}  // namespace zstrip::detail
