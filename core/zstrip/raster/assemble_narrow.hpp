// Draws a triangle with narrow vertices: computes its bounds and chooses the rasteriser.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "zstrip/effects.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/medium_textured.hpp"
#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/small_run.hpp"
#include "zstrip/kernels/small_triangle.hpp"
#include "zstrip/raster/assemble_clipped.hpp"
#include "zstrip/raster/attributes.hpp"
#include "zstrip/raster/lit_corners.hpp"
#include "zstrip/raster/span_triangle.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

template <Effects effects>
struct NarrowAssembler {
  using Clipped = ClippedAssembler<effects>;
  using Attributes = VertexAttributes<effects>;
  using Batch = BatchOf<effects>;
  using StripTarget = TargetOf<effects>;
  static constexpr DepthMode kDepth = Clipped::kDepth;
  static constexpr bool kStatistics = Clipped::kStatistics;
  static constexpr bool kUnclipped = effects.has(effect::unclipped);
  /// `std::true_type` without clipping, so that no code is generated for triangles that are not narrow.
  static constexpr auto always_narrow() {
    if constexpr (kUnclipped) {
      return std::true_type{};
    } else {
      return true;
    }
  }

  /// Returns the vertex with a depth in 16.16 codes, as small triangles need it.
  static decltype(auto) in_codes(const SnappedVertex& v) {
    if constexpr (kDepth.format == DepthFormat::float16) {
      const auto depth = static_cast<std::uint32_t>(float16_depth(v.depth, float16_octave(v.depth)));
      return SnappedVertex{v.x, v.y, depth};
    } else {
      return (v);
    }
  }

  /// True if the triangle is small and lies in one octave of the small float: only then are its codes on a plane.
  static bool is_small_in_octave(std::int32_t width, std::int32_t height, const SnappedVertex& a,
                                 const SnappedVertex& b, const SnappedVertex& c) {
    const std::uint32_t octave = float16_octave(a.depth);
    return float16_octave(b.depth) == octave && float16_octave(c.depth) == octave &&
           is_small(width, height, in_codes(a), in_codes(b), in_codes(c));
  }

  static constexpr bool kTwoSided = detail::shows_both_sides(effects);
  static bool shows_both_sides([[maybe_unused]] const Batch& batch) {
    if constexpr (!kTwoSided) return false;
    return batch.instance->double_sided;
  }

  /// Return the smallest and the largest value. Whole words: halfwords would be extended for every comparison.
  static std::pair<std::int32_t, std::int32_t> range(std::int32_t a, std::int32_t b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
  }
  static std::pair<std::int32_t, std::int32_t> range(std::int32_t a, std::int32_t b, std::int32_t c) {
    const auto [least, greatest] = range(a, b);
    return {std::min(least, c), std::max(greatest, c)};
  }

  /// True if a triangle is dropped when its box has no pixel centre, or none in the strip.
  static bool culls_small([[maybe_unused]] const StripTarget& target) {
    if constexpr (methods::culls(kDepth.method())) {
      return target.method->cull_small;
    } else {
      return true;
    }
  }

  static std::uint32_t nearest_code(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) {
    return std::max(std::max(a.depth, b.depth), c.depth) >> 16;
  }

  /// True if bounds of depth are kept for the fragments of this strip.
  static bool has_bounds([[maybe_unused]] const StripTarget& target) {
    if constexpr (methods::keeps_bounds(kDepth.method()) && kDepth.state) return is_plain(target.settings);
    return methods::keeps_bounds(kDepth.method());
  }

  /// False if the bounds of depth hide the triangle.
  static bool may_show(const StripTarget& target, const Rect& box, const SnappedVertex& a, const SnappedVertex& b,
                       const SnappedVertex& c) {
    if (!has_bounds(target)) return true;
    MethodState& method = *target.method;
    if (!method.bounds.hides(box, nearest_code(a, b, c), method.counts)) return true;
    if constexpr (kStatistics) ++method.counts->triangles;
    return false;
  }

  /// The most common pixel loops: the depth test of z16, without counting.
  static constexpr bool kIsPlain = !kStatistics && std::is_same_v<DepthRule<kDepth>, DepthRule<DepthMode{}>>;
  /// True if draw_medium or draw_medium_textured draws triangles that are larger than small ones.
  template <Shade shade>
  static constexpr bool kHasMedium = (kIsPlain && kHasMediumTriangles && shade <= Shade::gouraud);
  template <Shade shade>
  static constexpr bool kHasMediumTexturedOf = (kIsPlain && kHasMediumTextured && Clipped::kTextures &&
                                                shade >= Shade::textured && shade <= Shade::textured_gouraud &&
                                                (Clipped::kPerspective == 0 ||
                                                 Clipped::kPerspective == kPerspectiveRun));
  /// True if runs draw most triangles, so that few reach draw_narrow.
  template <Shade shade, bool all_narrow>
  static constexpr bool kSmallRuns = kIsPlain && (all_narrow ? kHasSmallRuns : kHasSmallRunsOfOne) &&
                                     (shade == Shade::gouraud || (shade == Shade::flat && kHasFlatSmallRuns));

  static bool is_narrow([[maybe_unused]] const SnappedVertex& a, [[maybe_unused]] const SnappedVertex& b,
                        [[maybe_unused]] const SnappedVertex& c) {
    if constexpr (kUnclipped) return true;
    return a.x != kNotNarrow && b.x != kNotNarrow && c.x != kNotNarrow;
  }

  /// Returns twice the signed area, positive for front faces; narrow differences are below 2^15, so 31 bits suffice.
  static std::int32_t narrow_area(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) {
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
  }

  static std::int32_t area_of(const Batch& batch, const Triangle& triangle) {
    const SnappedVertex* const vertices = batch.vertices;
    const std::uint32_t first = batch.first_vertex;
    return narrow_area(vertices[triangle.a - first], vertices[triangle.b - first], vertices[triangle.c - first]);
  }

  /// Returns the mesh's index of a vertex of the batch.
  static std::uint32_t index_of(const Batch& batch, const SnappedVertex& vertex) {
    return static_cast<std::uint32_t>(&vertex - batch.vertices) + batch.first_vertex;
  }

  /// Not inlined, so that the culling loop fits the registers of a Cortex-M.
  template <Shade shade>
  [[gnu::noinline]] static void draw_narrow(const StripTarget& target, const Batch& batch, const Triangle& provoking,
                                            std::uint32_t ia, std::uint32_t ib, std::uint32_t ic, std::int32_t area) {
    const SnappedVertex* first = batch.vertices + (ia - batch.first_vertex);
    const SnappedVertex* second = batch.vertices + (ib - batch.first_vertex);
    const SnappedVertex* third = batch.vertices + (ic - batch.first_vertex);
    rotate_to_first([](const SnappedVertex* v) { return v->y * 65536 + v->x; }, first, second, third);
    const SnappedVertex& a = *first;
    const SnappedVertex& b = *second;
    const SnappedVertex& c = *third;
    // Done before the box is computed, because these rows do not need it.
    if constexpr (kHasMediumTexturedOf<shade>) {
      if (draw_medium_with_texture<shade>(target, batch, provoking, {&a, &b, &c}, area)) return;
    }
    const auto [min_x, max_x] = range(a.x, b.x, c.x);
    const std::int32_t min_y = a.y;
    const std::int32_t max_y = range(b.y, c.y).second;
    const Rect whole{min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4};
    const Rect& strip = target.area;
    // The OR is negative if any difference is. Most triangles lie inside the strip and cover a column and a row.
    const bool is_inside = ((whole.left - strip.left) | (whole.top - strip.top) | (strip.right - whole.right) |
                            (strip.bottom - whole.bottom)) >= 0;
    Rect box = whole;
    if (!is_inside) box = whole.cut_to(strip);
    if (box.empty() && culls_small(target)) return;
    if constexpr (methods::keeps_bounds(kDepth.method())) {
      if (!box.empty() && !may_show(target, box, a, b, c)) return;
    }
    const CountedTriangle<kStatistics, shade> counted(target, whole.left, whole.top);
    constexpr bool kHasSmall = (kDepth.format == DepthFormat::z16 || kDepth.format == DepthFormat::float16) &&
                               !methods::guesses(kDepth.method()) && !kDepth.compares_codes();
    // Where runs draw the small triangles, only larger ones get here; vectors also leave some small ones.
    constexpr bool kInRuns = kSmallRuns<shade, true> && kUnclipped && !kTwoSided && !kHasVectors;
    constexpr bool kGouraud = shade == Shade::gouraud;
    [[maybe_unused]] const Colour* colours[3] = {nullptr, nullptr, nullptr};
    if constexpr (kGouraud) {
      colours[0] = batch.colours + (&a - batch.vertices);
      colours[1] = batch.colours + (&b - batch.vertices);
      colours[2] = batch.colours + (&c - batch.vertices);
    }
    [[maybe_unused]] const std::uint16_t flat_colour = Attributes::template flat_colour<shade>(batch, provoking);
    if constexpr (shade <= Shade::gouraud && kHasSmall && !kInRuns) {
      if ((kDepth.format == DepthFormat::float16 ? is_small_in_octave(max_x - min_x, max_y - min_y, a, b, c)
                                                 : is_small(max_x - min_x, max_y - min_y, a, b, c)) &&
          (!methods::culls(kDepth.method()) || !box.empty())) {
        if constexpr (methods::keeps_bounds(kDepth.method())) {
          if (has_bounds(target)) {
            target.method->bounds.cover(box, nearest_code(a, b, c));
          } else {
            target.method->bounds.forget(box);
          }
        }
        draw_small_triangle<kGouraud, kStatistics>(target, in_codes(a), in_codes(b), in_codes(c), colours, flat_colour,
                                                   area, whole.left, whole.top, box,
                                                   DepthRule<kDepth>(target, a, b, c, area));
        return;
      }
    }
    if constexpr (kHasMedium<shade> && !kInRuns) {
      if (draw_medium<kGouraud>({target, a, b, c, area}, colours, flat_colour)) return;
    }
    // Pixels in shadow are drawn again in the smallest rectangle that contains those of the strip.
    if constexpr (kHasMedium<shade> && kHasCutMedium && effects.has(effect::shadows)) {
      if (draw_cut_medium<kGouraud>({target, a, b, c, area}, colours, flat_colour)) return;
    }
    draw_narrow_spans<shade>(target, batch, provoking, a, b, c);
  }

  /// Not inlined, because the functions that it calls need stack.
  template <Shade shade>
  [[gnu::noinline]] static bool draw_medium_with_texture(const StripTarget& target, const Batch& batch,
                                                         const Triangle& provoking,
                                                         const SnappedVertex* const (&snapped)[3], std::int32_t area) {
    TexturedVertex vertices[3];
    const TexturedVertex* const corners[3] = {&vertices[0], &vertices[1], &vertices[2]};
    const Colour* colours[3] = {nullptr, nullptr, nullptr};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t index = index_of(batch, *snapped[i]);
      vertices[i].depth = snapped[i]->depth;
      Attributes::load_texture_coordinates(batch, index, vertices[i]);
      if constexpr (shade == Shade::textured_gouraud) colours[i] = &Attributes::colour_of(batch, index);
    }
    if constexpr (shade == Shade::textured_flat) colours[0] = &Attributes::colour_of(batch, provoking.a);
    constexpr TexelLight kLit = shade == Shade::textured        ? TexelLight::none
                                : shade == Shade::textured_flat ? TexelLight::flat
                                                                : TexelLight::smooth;
    constexpr bool kIsAffine = Clipped::kOrthographic || Clipped::kPerspective == 0;
    return draw_medium_textured<kLit, kIsAffine>({target, *snapped[0], *snapped[1], *snapped[2], area},
                                                 {corners, colours, batch.surface});
  }

  /// Not inlined, because it would take registers from the small triangles.
  template <Shade shade>
  [[gnu::noinline]] static void draw_narrow_spans(const StripTarget& target, const Batch& batch,
                                                  const Triangle& provoking, const SnappedVertex& a,
                                                  const SnappedVertex& b, const SnappedVertex& c) {
    RasterVertex v[3] = {};
    const SnappedVertex* const snapped[3] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i) {
      v[i].x = snapped[i]->x;
      v[i].y = snapped[i]->y;
      v[i].depth = snapped[i]->depth;
      Attributes::template load<shade>(batch, index_of(batch, *snapped[i]), v[i]);
    }
    typename Clipped::template SurfaceOf<shade> surface{batch.surface};
    surface.flat_colour = Attributes::template flat_colour<shade>(batch, provoking);
    Attributes::template take_first_colour<shade>(batch, provoking, v);
    if constexpr (Clipped::template kMayBeLit<shade>) {
      if (has_lit_fragments(batch.instance->shade)) {
        for (int i = 0; i < 3; ++i) {
          const std::uint32_t index = index_of(batch, *snapped[i]);
          surface.corners[i] = lit_corner<effects>(*batch.mesh, index, target.light);
        }
      }
    }
    Clipped::template draw_spans<shade>(target, v, surface, always_narrow());
  }
};

}  // namespace zstrip::detail
