// Converts a pixel of the picture and the depth in its cell to a place in the shadow map, without the triangle that
// drew it: the surface lies on the pixel's ray, at the distance that the depth gives.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene/depth_format.hpp"
#include "zstrip/status.hpp"

namespace zstrip::detail {

/// log2 of half a code, in 1/2^32 of all codes; the smallest one of the small float.
template <DepthFormat format>
inline constexpr int kLog2HalfCode = format == DepthFormat::z24       ? 7
                                     : format == DepthFormat::float16 ? 11
                                                                      : 15;

/// Returns the middle of the depths with this code, in 1/2^32 of all codes (near / w for the small float).
template <DepthFormat format>
constexpr std::uint32_t depth_of_code(std::uint32_t code) {
  if constexpr (format == DepthFormat::float16) {
    const std::uint32_t exponent = code >> 13;
    if (exponent == 0) return (code << 12) | (1U << 11);
    return ((code & 0x1FFF) | 0x2000) << (11 + exponent) | (1U << (10 + exponent));
  } else if constexpr (format == DepthFormat::z24) {
    return (code << 8) | 0x80;
  } else {
    return (code << 16) | 0x8000;
  }
}

/// One coordinate of the map over the picture. Perspective: offset + form / q, where q is the depth minus the depth of
/// an infinite distance; orthographic: form + per_depth depth.
struct MapForm {
  std::int32_t start, step_x, step_y;  ///< value at raster pixel (0, 0), and steps a pixel
  std::int32_t offset;                 ///< perspective only
  std::int32_t per_depth;              ///< orthographic only; the upper word of its product with half of the depth is
                                       ///< used
  std::int32_t shift;                  ///< perspective only: right shift for a q of 64 bits without leading zeros

  std::int32_t at(std::int32_t x, std::int32_t y) const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(start) +
                                     static_cast<std::uint32_t>(step_x) * static_cast<std::uint32_t>(x) +
                                     static_cast<std::uint32_t>(step_y) * static_cast<std::uint32_t>(y));
  }
};

/// The depth of a point in the map: code with code_bits, which may be negative, with half a code added as at vertices.
struct MapDepth {
  std::int32_t code;
  std::int32_t doubt;  ///< half a code of the picture's depth, in units of `code`
};

/// A caster that is nearer to the light than a point by more than this depth is never the point's own surface, unless
/// the light grazes it.
inline constexpr std::int32_t kContactTexels = 32;

struct ShadowPlace {
  MapForm column, row, code;
  std::int64_t depth_offset;  ///< DepthFit::offset, perspective only
  std::int32_t doubt;         ///< orthographic only
  std::int32_t texel_bits, code_bits;
  std::int32_t contact;  ///< depth of kContactTexels texels, in units of MapDepth::code
};

/// The coordinates of the map at the first raster pixel of a row, and the rest of their forms.
struct MapRow {
  const ShadowPlace& place;
  std::int32_t column, row, code;

  MapRow(const ShadowPlace& of, std::int32_t y)
      : place(of), column(of.column.at(0, y)), row(of.row.at(0, y)), code(of.code.at(0, y)) {}
  /// Returns the value of one of the forms, which is `start` at the first pixel.
  static std::int32_t at(std::int32_t start, const MapForm& form, std::int32_t x) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(start) +
                                     static_cast<std::uint32_t>(form.step_x) * static_cast<std::uint32_t>(x));
  }
};

/// The points in the map of a row's covered cells, one after the other. A point may lie outside of the map. Its
/// coordinates are computed one by one: where no caster lies at its column and row, its depth is not needed.
template <bool orthographic, DepthFormat format>
class MapPoint;

template <DepthFormat format>
class MapPoint<true, format> {
 public:
  explicit MapPoint(const MapRow& row) : from_(row) {}

  /// Moves to a pixel, whose cell has this code.
  void move_to(std::int32_t x, std::uint32_t code) {
    x_ = x, half_depth_ = static_cast<std::int32_t>(depth_of_code<format>(code) >> 1);
  }

  /// In texels, floor(value / 2^texel_bits), as row().
  std::int32_t column() const { return along(from_.column, from_.place.column); }
  std::int32_t row() const { return along(from_.row, from_.place.row); }
  MapDepth depth() const { return {along(from_.code, from_.place.code), from_.place.doubt}; }

 private:
  std::int32_t along(std::int32_t start, const MapForm& form) const {
    return MapRow::at(start, form, x_) + multiply_high(form.per_depth, half_depth_);
  }

  const MapRow& from_;
  std::int32_t x_ = 0, half_depth_ = 0;
};

template <DepthFormat format>
class MapPoint<false, format> {
 public:
  explicit MapPoint(const MapRow& row) : from_(row) {}

  /// Moves to a pixel, whose cell has this code. Neighbours often have the same: under a level camera a floor has one
  /// depth in each row.
  void move_to(std::int32_t x, std::uint32_t code) {
    x_ = x;
    if (code == code_) return;
    code_ = code;
    const auto q = static_cast<std::uint64_t>(std::int64_t{depth_of_code<format>(code)} + from_.place.depth_offset);
    // The first 32 bits of q without its leading zeros. By halves, because shifts of 64 bits take many instructions.
    const auto high = static_cast<std::uint32_t>(q >> 32), low = static_cast<std::uint32_t>(q);
    std::uint32_t first = 0;
    if (high != 0) {
      zeros_ = std::countl_zero(high);
      first = zeros_ == 0 ? high : high << zeros_ | low >> (32 - zeros_);
    } else {
      zeros_ = 32 + std::countl_zero(low | 1);
      first = low << (zeros_ - 32);
    }
    inverse_ = reciprocal(first | 0x80000000U);
  }

  std::int32_t column() const { return from_.place.column.offset + along(from_.column, from_.place.column); }
  std::int32_t row() const { return from_.place.row.offset + along(from_.row, from_.place.row); }
  MapDepth depth() const {
    const std::int32_t deeper = along(from_.code, from_.place.code);
    // The share of half a code in q, 0.32.
    int share_shift = 62 - kLog2HalfCode<format> - zeros_;
    // Codes of the small float are wider in higher octaves, and never less than 2^-15 of q.
    if constexpr (format == DepthFormat::float16) share_shift = std::min<std::int32_t>(share_shift, 13);
    const std::uint32_t share = share_shift < 0    ? 0x7FFFFFFFU
                                : share_shift < 32 ? static_cast<std::uint32_t>(inverse_) >> share_shift
                                                   : 0;
    const auto difference = static_cast<std::uint32_t>(deeper);
    const std::uint32_t magnitude = deeper < 0 ? 0 - difference : difference;
    return {from_.place.code.offset + deeper, static_cast<std::int32_t>(multiply_high(magnitude, share))};
  }

 private:
  std::int32_t along(std::int32_t start, const MapForm& form) const {
    return multiply_high(MapRow::at(start, form, x_), inverse_) >> std::clamp<std::int32_t>(form.shift - zeros_, 0, 31);
  }

  const MapRow& from_;
  std::int32_t x_ = 0;
  std::uint32_t code_ = 0;    ///< no covered cell has 0
  int zeros_ = 0;             ///< leading zeros of q
  std::int32_t inverse_ = 0;  ///< reciprocal of its first 32 bits
};

struct LightPicture {
  const Camera& camera;
  DepthFit fit;  ///< z16
  std::uint32_t side;
};

/// Computes the place. `fit` and `origin` are the frame's while triangles are drawn; `least` is the smallest depth that
/// depth_of_code returns. Returns Error::shadow if a texel is so small compared to the picture that 32 bits cannot
/// resolve it.
Status shadow_place(ShadowPlace& place, const LightPicture& light, const Camera& camera, const View& view,
                    const DepthFit& fit, const RasterOrigin& origin, std::uint32_t least);

}  // namespace zstrip::detail
