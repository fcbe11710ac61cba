// Composes camera, transform and bounding box into the forms of a CompiledInstance, once for each instance and frame,
// in 64-bit arithmetic. docs/numerics.md has the ranges.
#include "zstrip/geometry/instance.hpp"

#include <algorithm>
#include <utility>

#include "zstrip/base/direction.hpp"
#include "zstrip/base/division.hpp"
#include "zstrip/geometry/colour_product.hpp"

namespace zstrip::detail {
namespace {

/// One row of the transform from position to view space: value(p) = offset + sum part[i] * p[i] / 32768, in 26.38.
struct ViewRow {
  std::int64_t part[3];
  std::int64_t offset;
};

/// `axis` is in 2.30.
ViewRow view_row(const Vec3& axis, const Camera& camera, const Mesh& mesh, const Transform& transform) {
  const std::int32_t a[3] = {axis.x, axis.y, axis.z};
  const Fixed half[3] = {mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
  const Fixed centre[3] = {mesh.centre.x, mesh.centre.y, mesh.centre.z};
  const Fixed eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
  ViewRow row{};
  for (int column = 0; column < 3; ++column) {
    std::int64_t rotated = 0;  // 2.30 * 9.16 = 18.46, three terms: below 2^56
    for (int k = 0; k < 3; ++k) rotated += std::int64_t{a[k]} * transform.m[k][column];
    rotated >>= 24;                             // 42.22, below 2^32
    row.part[column] = rotated * half[column];  // 26.38, below 2^60
    row.offset += rotated * centre[column];     // 26.38
  }
  for (int k = 0; k < 3; ++k) {
    const std::int64_t from_eye = std::int64_t{transform.m[k][3]} - eye[k];  // 17.16
    row.offset += (a[k] * from_eye) >> 8;                                    // 19.46 -> 26.38
  }
  return row;
}

/// Returns the largest absolute value over the bounding box.
std::uint64_t bound(const ViewRow& row) {
  return static_cast<std::uint64_t>(magnitude(row.part[0]) + magnitude(row.part[1]) + magnitude(row.part[2]) +
                                    magnitude(row.offset));
}

std::int64_t shifted_right(std::int64_t value, int shift) {
  if (shift >= 63) return value >> 63;
  return shift >= 0 ? value >> shift : static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << -shift);
}

/// A row scaled to 30 bits: real value = form's value * 2^exponent / 2^38.
struct Normalised {
  LinearForm form;
  int exponent;
};

Normalised normalise(const ViewRow& row) {
  const int exponent = 34 - std::countl_zero(bound(row) | 1);
  const auto coefficient = [&](int i) {
    // LinearForm uses half of a coefficient at p = 32768: coefficients have one bit more than the value.
    return static_cast<std::int32_t>(shifted_right(row.part[i], exponent - 1));
  };
  return {
      {coefficient(0), coefficient(1), coefficient(2), static_cast<std::int32_t>(shifted_right(row.offset, exponent))},
      exponent};
}

LinearForm shifted_right(const LinearForm& form, int shift) {
  if (shift <= 0) return form;
  if (shift > 31) shift = 31;
  return {form.x >> shift, form.y >> shift, form.z >> shift, form.offset >> shift};
}

LinearForm scaled(const LinearForm& form, std::int64_t mantissa) {
  const auto times = [mantissa](std::int32_t c) { return static_cast<std::int32_t>((c * mantissa) >> 31); };
  return {times(form.x), times(form.y), times(form.z), times(form.offset)};
}

ViewRow negated(const ViewRow& row) { return {{-row.part[0], -row.part[1], -row.part[2]}, -row.offset}; }

ViewRow distance_row(const Mesh& mesh, const Transform& transform, const Camera& camera) {
  return negated(view_row(camera.back, camera, mesh, transform));
}

/// Returns the light's direction in object space: multiplies it by the transposed transform and normalises it. Exact
/// for rotations with uniform scale.
ObjectLight object_light(const DirectionalLight& light, const Transform& transform, const Colour& material) {
  const std::int64_t direction[3] = {light.x, light.y, light.z};
  std::int64_t turned[3] = {};  // 9.16 * 1.15, three terms: below 2^42
  for (int column = 0; column < 3; ++column) {
    for (int k = 0; k < 3; ++k) turned[column] += transform.m[k][column] * direction[k];
  }
  const auto largest = static_cast<std::uint64_t>(magnitude(turned[0]) | magnitude(turned[1]) | magnitude(turned[2]));
  const Colour colour = product(light.colour, material);
  ObjectLight result{0, 0, 0, colour.r, colour.g, colour.b, 0};
  if (largest == 0) return result;
  const int shift = 34 - std::countl_zero(largest);  // to 30 bits
  for (std::int64_t& c : turned) c = shifted_right(c, shift);
  const std::uint64_t square =
      static_cast<std::uint64_t>(turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2]);
  const std::int64_t length = square_root(square);
  const auto component = [length](std::int64_t c) {  // 1.15, towards zero
    const std::uint64_t quotient =
        seldom_quotient(static_cast<std::uint64_t>(magnitude(c)) * 32767, static_cast<std::uint64_t>(length));
    return static_cast<std::int16_t>(c < 0 ? -static_cast<std::int32_t>(quotient)
                                           : static_cast<std::int32_t>(quotient));
  };
  result.x = component(turned[0]);
  result.y = component(turned[1]);
  result.z = component(turned[2]);
  return result;
}

template <bool lights>
void compile_shading(CompiledInstance& compiled, const Scene& scene, const Instance& instance) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  const Material& material = scene.materials[instance.material];
  const bool textured = material.texture != kNoTexture && !mesh.texcoords.empty();
  compiled.lit = material.lit && !mesh.normals.empty();
  compiled.coloured = !mesh.colours.empty() && !(textured && !material.lit);
  compiled.double_sided = material.double_sided;
  compiled.base = material.colour;
  compiled.ambient = product(scene.ambient, material.colour);
  if constexpr (lights) {
    compiled.light_count = compiled.lit ? static_cast<std::uint8_t>(scene.lights.size()) : std::uint8_t{0};
    for (int i = 0; i < compiled.light_count; ++i) {
      compiled.lights[i] = object_light(scene.lights[static_cast<std::size_t>(i)], instance.transform, material.colour);
    }
  }
  const bool varies = material.smooth && (compiled.lit || compiled.coloured);
  if (!textured) {
    compiled.shade = varies ? Shade::gouraud : Shade::flat;
  } else if (!material.lit) {
    compiled.shade = Shade::textured;
  } else {
    compiled.shade = varies ? Shade::textured_gouraud : Shade::textured_flat;
  }
}

/// Sets the numerator of a picture coordinate: view row times pixels per unit. `w_exponent` is the exponent of w.
Status compile_coordinate(LinearForm& form, std::int32_t& shift, const ViewRow& row, std::int64_t mantissa,
                          int mantissa_exponent, int w_exponent) {
  const Normalised normal = normalise(row);
  form = scaled(normal.form, mantissa);
  // coordinate = form * 2^(31 + mantissa_exponent + exponent - 38) / (w * 2^(w_exponent - 38)), in 1/16 pixels.
  const int binary_exponent = 31 + mantissa_exponent + normal.exponent - w_exponent;
  shift = 30 - binary_exponent;
  if (shift > 31) {
    form = shifted_right(form, shift - 31);
    shift = 31;
  }
  return shift >= 0 ? Status{} : Status{.error = Error::instance};
}

void compile_perspective_depth(CompiledInstance& compiled, const DepthFit& fit, int w_exponent) {
  // code = k / w - offset, with k = quotient_at_near * near. Near is exact here, not rounded to the instance's w: if
  // the box is large, w has few bits near the camera, and k would be wrong at every distance.
  const auto top_word = [](std::int64_t value) {
    const int zeros = std::countl_zero(static_cast<std::uint64_t>(value));
    return std::pair{static_cast<std::uint32_t>((static_cast<std::uint64_t>(value) << zeros) >> 32), zeros};
  };
  const auto [near, near_zeros] = top_word(fit.near);
  const auto [quotient, quotient_zeros] = top_word(fit.quotient_at_near);
  // With n the leading zeros of near in the instance's scale and r = 2^62 / (near 2^n): k = quotient_at_near / r.
  int normalisation = w_exponent + near_zeros - 32;
  std::uint32_t scale = multiply_high(quotient, near);
  int shift = (32 - quotient_zeros) + 2;
  if (scale < 0x80000000U) scale <<= 1, --shift;
  // Shifts of more than 31 bits are undefined; w is below 2^30, so that its reciprocal is normalised by 2 or more.
  constexpr int kMax = 33;
  if (normalisation > kMax) {
    scale = normalisation - kMax < 32 ? scale >> (normalisation - kMax) : 0;
    normalisation = kMax;
  }
  compiled.depth_scale = scale;
  compiled.depth_shift = static_cast<std::uint8_t>(shift);
  compiled.depth_normalisation = static_cast<std::uint8_t>(normalisation);
}

void compile_orthographic_depth(CompiledInstance& compiled) {
  const int normalisation = std::countl_zero(compiled.w_range);
  const std::uint64_t range = std::uint64_t{compiled.w_range} << normalisation;
  compiled.depth_scale =
      static_cast<std::uint32_t>(seldom_quotient(static_cast<std::uint64_t>(kDepthSpan) << 31, range));
  compiled.depth_shift = 1;
  compiled.depth_normalisation = static_cast<std::uint8_t>(normalisation);
}

}  // namespace

DistanceRange distance_range(const Mesh& mesh, const Transform& transform, const Camera& camera) {
  const ViewRow row = distance_row(mesh, transform, camera);
  const std::int64_t reach = magnitude(row.part[0]) + magnitude(row.part[1]) + magnitude(row.part[2]);
  return {row.offset - reach, row.offset + reach};
}

template <bool orthographic, bool lights>
Status compile_instance(CompiledInstance& compiled, const Scene& scene, const Instance& instance, const Camera& camera,
                        const View& view, const DepthFit& fit) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  compiled = {};
  compiled.mesh = instance.mesh;
  compiled.material = instance.material;
  compile_shading<lights>(compiled, scene, instance);

  const DistanceRange range = distance_range(mesh, instance.transform, camera);
  compiled.visible = range.farthest >= fit.near && range.nearest <= fit.far;
  if (!compiled.visible) return {};

  Normalised w = normalise(distance_row(mesh, instance.transform, camera));
  if constexpr (orthographic) {
    // Depth is linear in w: all instances share one scale, in which far fits as well.
    const int exponent_of_far = 34 - std::countl_zero(static_cast<std::uint64_t>(fit.far));
    if (exponent_of_far > w.exponent) {
      w = {shifted_right(w.form, exponent_of_far - w.exponent), exponent_of_far};
    }
  }

  // Pixels per unit in sixteenths, focal * height / 2 * 16, as a mantissa of 31 bits.
  const std::uint64_t sixteenths = static_cast<std::uint64_t>(camera.focal) * view.height * 8U;  // 16 fraction bits
  const int zeros = std::countl_zero(sixteenths);
  const auto mantissa = static_cast<std::int64_t>((sixteenths << zeros) >> 33);  // 2^30 .. 2^31
  const int mantissa_exponent = 33 - zeros - kFixedBits;

  const ViewRow right = view_row(camera.right, camera, mesh, instance.transform);
  const ViewRow down = negated(view_row(camera.up, camera, mesh, instance.transform));
  // Orthographic coordinates need no division: coordinate = form >> shift, as if w were 2^30.
  const int w_exponent = orthographic ? kDistanceBits - 30 : w.exponent;
  const Status status_x =
      compile_coordinate(compiled.x, compiled.shift_x, right, mantissa, mantissa_exponent, w_exponent);
  const Status status_y =
      compile_coordinate(compiled.y, compiled.shift_y, down, mantissa, mantissa_exponent, w_exponent);
  if (!status_x || !status_y) return {.error = Error::instance};

  compiled.w = w.form;
  const auto in_w = [exponent = w.exponent](Distance distance) { return shifted_right(distance, exponent); };
  constexpr std::int64_t kMax = (std::int64_t{1} << 30) - 1;
  // Rounded inwards, so that no w of the range has a code outside 1..65534.
  const std::int64_t w_near = std::max<std::int64_t>(1, -in_w(-fit.near));
  const std::int64_t w_far = in_w(fit.far) > kMax ? kMax : in_w(fit.far);
  // The depth range must span more than one step of w.
  if (w_near >= w_far) return {.error = Error::instance};
  compiled.w_near = static_cast<std::uint32_t>(w_near);
  compiled.w_range = static_cast<std::uint32_t>(w_far - w_near);
  if constexpr (orthographic) {
    compile_orthographic_depth(compiled);
  } else {
    compile_perspective_depth(compiled, fit, w.exponent);
  }
  return {};
}

template Status compile_instance<false, false>(CompiledInstance&, const Scene&, const Instance&, const Camera&,
                                               const View&, const DepthFit&);
template Status compile_instance<false, true>(CompiledInstance&, const Scene&, const Instance&, const Camera&,
                                              const View&, const DepthFit&);
template Status compile_instance<true, false>(CompiledInstance&, const Scene&, const Instance&, const Camera&,
                                              const View&, const DepthFit&);
template Status compile_instance<true, true>(CompiledInstance&, const Scene&, const Instance&, const Camera&,
                                             const View&, const DepthFit&);

}  // namespace zstrip::detail
