// A medium textured triangle: planes in words of 32 bits, then its rows, one run of texels each.
#include "zstrip/kernels/medium_textured.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/raster/edge_walk.hpp"
#include "zstrip/raster/texture_coordinates.hpp"
#include "zstrip/raster/textured_span.hpp"

namespace zstrip::detail {
namespace {

/// From one vertex down to another.
[[gnu::noinline]] void set_edge(EdgeWalk& edge, const SnappedVertex& from, const SnappedVertex& to, std::int32_t row) {
  edge = EdgeWalk(from.x, from.y, to.x, to.y, row, std::true_type{});
}

/// Those of texture coordinates are three, of which one alone is to be code.
class TexturePlanes : public MediumPlanes {
 public:
  using MediumPlanes::MediumPlanes;
  [[gnu::noinline]] Plane plane(std::int32_t value_0, std::int32_t d1, std::int32_t d2) const {
    return MediumPlanes::plane(value_0, d1, d2);
  }
};

/// The rows of a triangle in a strip, whose sides it does not cross.
class TriangleRows {
 public:
  explicit TriangleRows(const MediumTriangle& t)
      : triangle_(t),
        // From the first vertex, the highest, the second lies to the left.
        middle_is_left_(t.v1.y < t.v2.y),
        row(std::max<std::int32_t>(t.v0.y >> 4, t.target.area.top)),
        middle_(std::min(t.v1.y, t.v2.y) >> 4),
        end_(std::min<std::int32_t>(std::max(t.v1.y, t.v2.y) >> 4, t.target.area.bottom)) {
    if (row >= end_) return;
    const bool has_upper = row < middle_;
    if (has_upper || !middle_is_left_) set_edge(left, t.v0, t.v1, row);
    if (has_upper || middle_is_left_) set_edge(right, t.v0, t.v2, row);
    if (!has_upper) set_lower_edge();
  }

  /// Goes down to a row with pixels, if it is in none. False: there is none.
  bool to_covered() {
    while (row < end_) {
      if (left.pixel < right.pixel) return true;
      go_down();
    }
    return false;
  }
  void go_down() {
    left.next_row(), right.next_row();
    if (++row == middle_ && row < end_) set_lower_edge();
  }

 private:
  void set_lower_edge() {
    if (middle_is_left_) {
      set_edge(left, triangle_.v1, triangle_.v2, row);
    } else {
      set_edge(right, triangle_.v2, triangle_.v1, row);
    }
  }

  const MediumTriangle& triangle_;
  bool middle_is_left_;

 public:
  std::int32_t row;
  EdgeWalk left, right;

 private:
  std::int32_t middle_, end_;
};

/// The planes of a triangle and its texture, for its rows.
template <TexelLight lit, bool affine>
class TexturedRows {
 public:
  /// Cannot be inlined: the edges would be without registers. For a triangle that fits_words.
  [[gnu::noinline]] TexturedRows(const MediumTriangle& t, const MediumTexture& surface, std::int32_t anchor_x,
                                 std::int32_t anchor_y) {
    TexturePlanes planes(t.v0, t.v1, t.v2, t.area, anchor_x, anchor_y);
    depth_ = planes.depth(t.v0.depth, t.v1.depth, t.v2.depth);
    coordinates_ = TextureCoordinates<affine>(planes, surface.vertices, surface.depth_offset);
    fraction_u_ = TextureAxis(surface.texture.log2_width).to_fraction;
    fraction_v_ = TextureAxis(surface.texture.log2_height).to_fraction;
    run_.set_texture(surface.texture);
    run_.step_z = depth_.step_x;
    const auto& c = surface.colours;
    if constexpr (lit == TexelLight::flat) {
      run_.r = light_factor(static_cast<std::uint32_t>(channel_start(c[0]->r)));
      run_.g = light_factor(static_cast<std::uint32_t>(channel_start(c[0]->g)));
      run_.b = light_factor(static_cast<std::uint32_t>(channel_start(c[0]->b)));
    } else if constexpr (lit == TexelLight::smooth) {
      light_.r = planes.channel(c[0]->r, c[1]->r, c[2]->r);
      light_.g = planes.channel(c[0]->g, c[1]->g, c[2]->g);
      light_.b = planes.channel(c[0]->b, c[1]->b, c[2]->b);
    }
    has_steep_light_ = planes.has_steep();
  }

  /// Whether the light changes too much for words.
  bool has_steep_light() const { return lit == TexelLight::smooth && has_steep_light_; }

  /// `length` > 0 pixels of a row. Columns and rows count from the anchor.
  void draw(std::int32_t column, std::int32_t row, std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length) {
    const auto place = coordinates_.place(column, row);
    const TexelPosition from = coordinates_.at(place);
    run_.u = static_cast<std::uint32_t>(from.u) * fraction_u_;
    run_.v = static_cast<std::uint32_t>(from.v) * fraction_v_;
    if (length > 1) {
      const TexelPosition to = coordinates_.at(coordinates_.right_of(place, length - 1));
      const std::int32_t inverse = kInverse[length - 1];
      const auto step = [inverse](std::int32_t from_here, std::int32_t to_there) {
        return static_cast<std::uint32_t>(long_product(difference(to_there, from_here), inverse) >> 16);
      };
      run_.step_u = step(from.u, to.u) * fraction_u_, run_.step_v = step(from.v, to.v) * fraction_v_;
    }
    run_.z = depth_.at(column, row);
    if constexpr (lit == TexelLight::smooth) {
      fill_smooth(depth, pixel, length, light_.r.at(column, row), light_.g.at(column, row), light_.b.at(column, row));
    } else {
      fill_run(run_, knows_texture(run_), depth, pixel, length, light_, nullptr);
    }
  }

 private:
  /// As TexturedRun::fill, for rows of a few pixels: what that keeps for the next run is not stored.
  void fill_smooth(std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length, std::uint32_t r, std::uint32_t g,
                   std::uint32_t b) {
    for (;;) {
      if (run_.rule.draws(run_.z, *depth)) {
        *pixel =
            modulated(run_.texels[((run_.v >> run_.to_row) & run_.row_mask) + (run_.u >> run_.to_column)], r, g, b);
      }
      if (--length == 0) return;
      ++depth, ++pixel;
      run_.z += run_.step_z, run_.u += run_.step_u, run_.v += run_.step_v;
      r += light_.r.step_x, g += light_.g.step_x, b += light_.b.step_x;
    }
  }

  Plane depth_;
  TextureCoordinates<affine> coordinates_;
  ColourPlanes light_;  ///< where it is smooth
  bool has_steep_light_;
  std::uint32_t fraction_u_, fraction_v_;
  TexturedRun<lit, false, std::uint32_t, DepthRule<DepthMode{}>> run_;
};

}  // namespace

template <TexelLight lit, bool affine>
bool draw_medium_textured(const MediumTriangle& t, const MediumTexture& surface) {
  const StripTarget& target = t.target;
  const auto [min_x, max_x] = std::minmax<std::int32_t>({t.v0.x, t.v1.x, t.v2.x});
  const std::int32_t anchor_x = min_x >> 4, right_side = max_x >> 4;
  const std::int32_t anchor_y = std::max<std::int32_t>(t.v0.y >> 4, target.view_top);
  if (right_side - anchor_x > kPerspectiveRun || anchor_x < target.area.left || right_side > target.area.right) {
    return false;
  }
  TriangleRows rows(t);
  // Planes are most of the work, and many a triangle covers no pixel.
  if (!rows.to_covered()) return true;
  if (!fits_words(t, max_x - min_x, std::max(t.v1.y, t.v2.y) - t.v0.y) ||
      !TextureCoordinates<affine>::fits_words(surface.vertices)) {
    return false;
  }
  TexturedRows<lit, affine> texels(t, surface, anchor_x, anchor_y);
  if (texels.has_steep_light()) return false;
  do {
    const std::int32_t column = rows.left.pixel - target.area.left;
    texels.draw(rows.left.pixel - anchor_x, rows.row - anchor_y, target.depth_row(rows.row) + column,
                target.colour_row(rows.row) + column, rows.right.pixel - rows.left.pixel);
    rows.go_down();
  } while (rows.to_covered());
  return true;
}

template bool draw_medium_textured<TexelLight::none, false>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::none, true>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::flat, false>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::flat, true>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::smooth, false>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::smooth, true>(const MediumTriangle&, const MediumTexture&);

}  // namespace zstrip::detail
