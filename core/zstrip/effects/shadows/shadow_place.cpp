// Composes the cameras of picture and light into the forms of a ShadowPlace; docs/numerics.md has the bits.
#include "zstrip/effects/shadows/shadow_place.hpp"

#include "zstrip/base/scaled.hpp"

namespace zstrip::detail {
namespace {

Scaled3 axis_of(const Vec3& axis) { return {Scaled(axis.x, -30), Scaled(axis.y, -30), Scaled(axis.z, -30)}; }

/// Returns, for an axis of any length, the vector whose product with it is 1; 0 if it has none.
Scaled3 dual(const Scaled3& axis) {
  const Scaled square = dot(axis, axis);
  if (square.sign() == 0) return {};
  return Scaled(1, 0) / square * axis;
}

/// One coordinate of the map for a position in the world: at + along * (position - light's eye).
struct MapAxis {
  Scaled3 along;
  Scaled at;
};

/// That coordinate for a pixel and its distance w: offset + w (x, y, 1) for perspective, else offset + x + y + w.
struct PixelAxis {
  Scaled offset, x, y, w;
};

struct PictureAxes {
  Scaled3 eye, right, down, away;  ///< from the light's eye; per pixel, at distance 1
  Scaled centre_x, centre_y;       ///< position of raster pixel (0, 0), in pixels
  Scaled reach_x, reach_y;         ///< the picture's largest distance from the middle, in pixels

  PictureAxes(const Camera& camera, const Camera& light, const View& view) {
    const auto apart = [](Fixed a, Fixed b) { return Scaled(std::int64_t{a} - b, -kFixedBits); };
    eye = {apart(camera.eye.x, light.eye.x), apart(camera.eye.y, light.eye.y), apart(camera.eye.z, light.eye.z)};
    const Scaled pixel = Scaled(1, 0) / Scaled(std::int64_t{camera.focal} * view.height, -kFixedBits - 1);
    right = pixel * dual(axis_of(camera.right));
    down = -pixel * dual(axis_of(camera.up));
    away = Scaled(-1, 0) * dual(axis_of(camera.back));
    centre_x = Scaled(1 - (view.width & 1), -1);
    centre_y = Scaled(1 - (view.height & 1), -1);
    reach_x = Scaled(view.width / 2 + 1, 0);
    reach_y = Scaled(view.height / 2 + 1, 0);
  }

  PixelAxis see(const MapAxis& map) const {
    return {map.at + dot(map.along, eye), dot(map.along, right), dot(map.along, down), dot(map.along, away)};
  }
};

/// A form over the picture: its value at raster pixel (0, 0), its steps, and its bound over all pixels.
struct PixelForm {
  Scaled start, x, y, bound;

  PixelForm(const Scaled& at_centre, const Scaled& step_x, const Scaled& step_y, const PictureAxes& picture)
      : start(at_centre + step_x * picture.centre_x + step_y * picture.centre_y),
        x(step_x),
        y(step_y),
        bound(at_centre.magnitude() + step_x.magnitude() * picture.reach_x + step_y.magnitude() * picture.reach_y) {}

  void store(MapForm& form, std::int32_t bits) const {
    const auto fixed = [bits](const Scaled& value) { return static_cast<std::int32_t>(value.fixed(bits)); };
    form.start = fixed(start);
    form.step_x = fixed(x);
    form.step_y = fixed(y);
  }
};

/// Prepares a coordinate in two steps: bits() is called before another coordinate limits the number of bits.
class Perspective {
 public:
  Perspective(const PixelAxis& axis, const Scaled& per_inverse, const Scaled& least_q, const PictureAxes& picture)
      : offset_(axis.offset), form_(per_inverse * axis.w, per_inverse * axis.x, per_inverse * axis.y, picture) {
    bits_ = 27 - (form_.bound / least_q + offset_.magnitude()).log2_bound();
  }
  std::int32_t bits() const { return bits_; }
  void store(MapForm& form, std::int32_t bits) const {
    const std::int32_t form_bits = 29 - form_.bound.log2_bound();
    form_.store(form, form_bits);
    form.offset = static_cast<std::int32_t>(offset_.fixed(bits));
    // 2^62 divided by the upper word of q: 94 minus the leading zeros; 32 bits are the product's lower word.
    form.shift = 62 + form_bits - bits;
  }

 private:
  Scaled offset_;
  PixelForm form_;
  std::int32_t bits_;
};

class Orthographic {
 public:
  Orthographic(const PixelAxis& axis, const Scaled& distance_of_0, const Scaled& per_depth, const PictureAxes& picture)
      : per_depth_(-(axis.w * per_depth)), form_(axis.offset + axis.w * distance_of_0, axis.x, axis.y, picture) {
    bits_ = 28 - (form_.bound + per_depth_.magnitude().shifted(32)).log2_bound();
  }
  std::int32_t bits() const { return bits_; }
  void store(MapForm& form, std::int32_t bits) const {
    form_.store(form, bits);
    form.per_depth = static_cast<std::int32_t>(per_depth_.fixed(bits + 33));
  }
  /// Returns the result in units of the coordinate.
  std::int32_t times(std::int32_t log2_depth, std::int32_t bits) const {
    return static_cast<std::int32_t>(per_depth_.magnitude().shifted(log2_depth).fixed(bits)) + 1;
  }

 private:
  Scaled per_depth_;
  PixelForm form_;
  std::int32_t bits_;
};

/// If the casters' depth is so small compared to the picture that whole codes do not fit, fraction bits are negative
/// down to this limit.
constexpr std::int32_t kMinCodeBits = -12;

/// Stores all three coordinates with as many bits as fit, at most 16 and 12.
template <class Coordinate>
Status store(ShadowPlace& place, const Coordinate& column, const Coordinate& row, const Coordinate& code,
             const Scaled& contact) {
  place.texel_bits = std::min<std::int32_t>(std::min(column.bits(), row.bits()), 16);
  place.code_bits = std::min<std::int32_t>(code.bits(), 12);
  if (place.texel_bits < 1 || place.code_bits < kMinCodeBits) return {.error = Error::shadow};
  column.store(place.column, place.texel_bits);
  row.store(place.row, place.texel_bits);
  code.store(place.code, place.code_bits);
  place.contact =
      static_cast<std::int32_t>(std::min<std::int64_t>(contact.fixed(place.code_bits), std::int64_t{1} << 29));
  return {};
}

}  // namespace

Status shadow_place(ShadowPlace& place, const LightPicture& light, const Camera& camera, const View& view,
                    const DepthFit& fit, const RasterOrigin& origin, std::uint32_t least) {
  place = {};
  place.depth_offset = fit.offset;
  const Scaled texels_per_unit(std::int64_t{light.camera.focal} * light.side, -kFixedBits - 1);
  const Scaled middle(light.side, -1);
  const MapAxis column{texels_per_unit * axis_of(light.camera.right), middle};
  const MapAxis row{-texels_per_unit * axis_of(light.camera.up), middle};
  // Codes grow towards the light, beginning at far: the distance is -back * (position - eye).
  const Scaled codes_per_unit = Scaled(kDepthSpan, -16) / Scaled(light.fit.far - light.fit.near, -kDistanceBits);
  const MapAxis code{codes_per_unit * axis_of(light.camera.back),
                     Scaled(kDepthOfFar, -16) + codes_per_unit * Scaled(light.fit.far, -kDistanceBits)};
  const auto length = [](const MapAxis& axis) { return root(dot(axis.along, axis.along)); };
  const Scaled coarser = length(column) < length(row) ? length(column) : length(row);
  const Scaled contact = Scaled(kContactTexels, 0) * length(code) / coarser;
  const PictureAxes picture(camera, light.camera, view);
  const PixelAxis columns = picture.see(column), rows = picture.see(row), codes = picture.see(code);
  if (camera.projection == Projection::orthographic) {
    const std::int64_t span = fit.quotient_at_near - fit.offset - origin.depth_offset;
    const Scaled per_depth = Scaled(fit.far - fit.near, -kDistanceBits) / Scaled(span, 0);
    const Scaled distance_of_0 = Scaled(fit.far, -kDistanceBits) + per_depth * Scaled(origin.depth_offset, 0);
    const Orthographic deeper(codes, distance_of_0, per_depth, picture);
    const Status status = store(place, Orthographic(columns, distance_of_0, per_depth, picture),
                                Orthographic(rows, distance_of_0, per_depth, picture), deeper, contact);
    place.doubt = deeper.times(std::countr_zero(least), place.code_bits);
    return status;
  }
  const Scaled per_inverse = Scaled(fit.quotient_at_near, 0) * Scaled(fit.near, -kDistanceBits);
  // The small float has codes for every distance, however far.
  const Scaled at_far = per_inverse / Scaled(fit.far, -kDistanceBits), below = at_far - at_far.shifted(-12);
  const Scaled of_code(std::int64_t{least} + fit.offset, 0);
  const Scaled least_q = of_code < below ? below : of_code;
  if (least_q.sign() <= 0) return {.error = Error::shadow};
  return store(place, Perspective(columns, per_inverse, least_q, picture),
               Perspective(rows, per_inverse, least_q, picture), Perspective(codes, per_inverse, least_q, picture),
               contact);
}

}  // namespace zstrip::detail
