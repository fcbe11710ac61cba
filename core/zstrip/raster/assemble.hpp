// From three indices to a rasterised triangle: cull, bound, choose the rasteriser; or leave it to clipping.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "zstrip/effects.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/effects/pixel_shading/lit_corners.hpp"
#include "zstrip/geometry/bins.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/medium_textured.hpp"
#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/small_run.hpp"
#include "zstrip/kernels/small_triangle.hpp"
#include "zstrip/raster/assemble_clipped.hpp"
#include "zstrip/raster/attributes.hpp"
#include "zstrip/raster/fragment.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

template <Effects effects>
struct Assembler : ClippedAssembler<effects> {
  using Clipped = ClippedAssembler<effects>;
  using typename Clipped::Attributes;
  using typename Clipped::Batch;
  using typename Clipped::StripTarget;
  template <Shade shade>
  using SurfaceOf = typename Clipped::template SurfaceOf<shade>;
  using Clipped::kDepth;
  using Clipped::kOrthographic;
  using Clipped::kStatistics;
  using Clipped::kTextures;
  static constexpr bool kUnclipped = effects.has(effect::unclipped);
  /// True; without clipping a type that says so, and paths for triangles that are not narrow are no code.
  static constexpr auto always_narrow() {
    if constexpr (kUnclipped) {
      return std::true_type{};
    } else {
      return true;
    }
  }

  /// The vertex with 16.16 codes: what small triangles take.
  static decltype(auto) in_codes(const SnappedVertex& v) {
    if constexpr (kDepth.format == DepthFormat::float16) {
      const auto depth = static_cast<std::uint32_t>(float16_depth(v.depth, float16_octave(v.depth)));
      return SnappedVertex{v.x, v.y, depth};
    } else {
      return (v);
    }
  }

  /// Of the small float's vertices only those of one octave have their codes on a plane.
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

  /// Least and greatest; of whole words, or every comparison extends halfwords.
  static std::pair<std::int32_t, std::int32_t> range(std::int32_t a, std::int32_t b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
  }
  static std::pair<std::int32_t, std::int32_t> range(std::int32_t a, std::int32_t b, std::int32_t c) {
    const auto [least, greatest] = range(a, b);
    return {std::min(least, c), std::max(greatest, c)};
  }

  /// Whether a triangle that has no pixel's centre in its box, or none in the strip, is left out.
  static bool culls_small([[maybe_unused]] const StripTarget& target) {
    if constexpr (kDepth.any(method::culling)) {
      return target.method->cull_small;
    } else {
      return true;
    }
  }

  static std::uint32_t nearest_code(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) {
    return std::max(std::max(a.depth, b.depth), c.depth) >> 16;
  }

  /// Whether bounds of depth apply to fragments in this strip.
  static bool has_bounds([[maybe_unused]] const StripTarget& target) {
    if constexpr (kDepth.any(method::bounded) && kDepth.state) return is_plain(target.settings);
    return kDepth.any(method::bounded);
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

  /// Cannot be inlined: keeps the culling loop small enough for the registers of a Cortex-M.
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
    const auto [min_x, max_x] = range(a.x, b.x, c.x);
    const std::int32_t min_y = a.y;
    const std::int32_t max_y = range(b.y, c.y).second;
    const Rect whole{min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4};
    const Rect& strip = target.area;
    // The sign of all differences at once: most triangles lie inside the strip and cover a column and a row.
    const bool is_inside = ((whole.left - strip.left) | (whole.top - strip.top) | (strip.right - whole.right) |
                            (strip.bottom - whole.bottom)) >= 0;
    Rect box = whole;
    if (!is_inside) {
      box = {std::max(box.left, strip.left), std::max(box.top, strip.top), std::min(box.right, strip.right),
             std::min(box.bottom, strip.bottom)};
    }
    if (box.empty() && culls_small(target)) return;
    if constexpr (kDepth.any(method::bounded)) {
      if (!box.empty() && !may_show(target, box, a, b, c)) return;
    }
    const CountedTriangle<kStatistics> counted(target, whole.left, whole.top);
    constexpr bool kHasSmall = (kDepth.format == DepthFormat::z16 || kDepth.format == DepthFormat::float16) &&
                               !kDepth.any(method::midpoint) && !kDepth.compares_codes();
    // What a run of small triangles has left is not small, nor medium; but vectors leave what has no room for blocks.
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
          (!kDepth.any(method::culling) || !box.empty())) {
        if constexpr (kDepth.any(method::bounded)) {
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
    if constexpr (kHasMediumTexturedOf<shade>) {
      if (draw_medium_with_texture<shade>(target, batch, provoking, {&a, &b, &c}, area)) return;
    }
    draw_narrow_spans<shade>(target, batch, provoking, a, b, c);
  }

  template <Shade shade>
  static constexpr bool kHasMediumTexturedOf =
      kHasMediumTextured&& kTextures&& shade >= Shade::textured&& shade <= Shade::textured_gouraud && !kStatistics &&
      (Clipped::kPerspective == 0 || Clipped::kPerspective == kPerspectiveRun) &&
      std::is_same_v<DepthRule<kDepth>, DepthRule<DepthMode{}>>;

  /// Cannot be inlined: the stack of what it calls.
  template <Shade shade>
  [[gnu::noinline]] static bool draw_medium_with_texture(const StripTarget& target, const Batch& batch,
                                                         const Triangle& provoking,
                                                         const SnappedVertex* const (&snapped)[3], std::int32_t area) {
    TexturedVertex vertices[3];
    const TexturedVertex* const corners[3] = {&vertices[0], &vertices[1], &vertices[2]};
    const Colour* colours[3] = {nullptr, nullptr, nullptr};
    for (int i = 0; i < 3; ++i) {
      const auto index = static_cast<std::uint32_t>(snapped[i] - batch.vertices) + batch.first_vertex;
      vertices[i].depth = snapped[i]->depth;
      Attributes::load_texture_coordinates(batch, index, vertices[i]);
      if constexpr (shade == Shade::textured_gouraud) colours[i] = &Attributes::colour_of(batch, index);
    }
    if constexpr (shade == Shade::textured_flat) colours[0] = &Attributes::colour_of(batch, provoking.a);
    constexpr TexelLight kLit = shade == Shade::textured        ? TexelLight::none
                                : shade == Shade::textured_flat ? TexelLight::flat
                                                                : TexelLight::smooth;
    constexpr bool kIsAffine = kOrthographic || Clipped::kPerspective == 0;
    return draw_medium_textured<kLit, kIsAffine>({target, *snapped[0], *snapped[1], *snapped[2], area},
                                                 {corners, colours, batch.surface});
  }

  /// Whether triangles larger than small ones are drawn by draw_medium.
  template <Shade shade>
  static constexpr bool kHasMedium = kHasMediumTriangles&& shade <= Shade::gouraud && !kStatistics &&
                                     std::is_same_v<DepthRule<kDepth>, DepthRule<DepthMode{}>>;

  /// Cannot be inlined: small triangles keep the registers that it would take.
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
      Attributes::template load<shade>(
          batch, static_cast<std::uint32_t>(snapped[i] - batch.vertices) + batch.first_vertex, v[i]);
    }
    SurfaceOf<shade> surface{batch.surface};
    surface.flat_colour = Attributes::template flat_colour<shade>(batch, provoking);
    Attributes::template take_first_colour<shade>(batch, provoking, v);
    if constexpr (Clipped::template kMayBeLit<shade>) {
      if (has_lit_fragments(batch.instance->shade)) {
        for (int i = 0; i < 3; ++i) {
          const auto index = static_cast<std::uint32_t>(snapped[i] - batch.vertices) + batch.first_vertex;
          surface.corners[i] = lit_corner<effects>(*batch.mesh, index, target.light);
        }
      }
    }
    Clipped::template draw_spans<shade>(target, v, surface, always_narrow());
  }

  /// Twice the signed area, positive for front faces; differences of narrow coordinates are below 2^15, so 31 bits
  /// suffice.
  static std::int32_t narrow_area(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) {
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
  }

  /// Culls and draws `count` triangles, triangle_at(0) on. `all_narrow`: no vertex of the batch needs the clipping
  /// path.
  template <Shade shade, bool all_narrow, class TriangleAt>
  static void draw_triangles(const StripTarget& target, const Batch& batch, std::size_t count,
                             const TriangleAt& triangle_at) {
    const SnappedVertex* const vertices = batch.vertices;
    const std::uint32_t first = batch.first_vertex;
    const bool double_sided = shows_both_sides(batch);
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle& triangle = triangle_at(i);
      const SnappedVertex& a = vertices[triangle.a - first];
      const SnappedVertex& b = vertices[triangle.b - first];
      const SnappedVertex& c = vertices[triangle.c - first];
      if constexpr (!all_narrow && !kUnclipped) {
        if (!is_narrow(a, b, c)) {
          Clipped::template draw_clipped<shade>(target, batch, triangle);
          continue;
        }
      }
      const std::int32_t area = narrow_area(a, b, c);
      if (area > 0) {
        draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.b, triangle.c, area);
      } else if (area < 0 && double_sided) {
        draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.c, triangle.b, -area);
      }
    }
  }

  /// Whether most triangles never come to draw_narrow.
  template <Shade shade, bool all_narrow>
  static constexpr bool kSmallRuns = (all_narrow ? kHasSmallRuns : kHasSmallRunsOfOne) &&
                                     (shade == Shade::gouraud || (shade == Shade::flat && kHasFlatSmallRuns)) &&
                                     !kStatistics && std::is_same_v<DepthRule<kDepth>, DepthRule<DepthMode{}>>;

  static bool is_narrow([[maybe_unused]] const SnappedVertex& a, [[maybe_unused]] const SnappedVertex& b,
                        [[maybe_unused]] const SnappedVertex& c) {
    if constexpr (kUnclipped) return true;
    return a.x != kNotNarrow && b.x != kNotNarrow && c.x != kNotNarrow;
  }

  template <Shade shade>
  static bool fits_small_runs(const Batch& batch) {
    return shade == Shade::flat || !shows_both_sides(batch);
  }

  /// Draws triangles from `next` on, up to the first that is not small or not narrow, and returns its index. Cannot be
  /// inlined: the others need the stack that a run takes.
  template <Shade shade, bool all_narrow, class TriangleAt>
  [[gnu::noinline]] static std::uint32_t draw_small_run(const StripTarget& target, const Batch& batch,
                                                        std::uint32_t next, std::uint32_t count,
                                                        const TriangleAt& triangle_at) {
    SmallRun run = small_run(target, batch.vertices, Attributes::kColours ? batch.colours : nullptr, batch.first_vertex,
                             {shade == Shade::flat, shows_both_sides(batch), batch.surface.flat_colour});
    if constexpr (all_narrow) return next + detail::draw_small_run(run, &triangle_at(next), count - next);
    const SnappedVertex* const vertices = batch.vertices;
    const std::uint32_t first = batch.first_vertex;
    for (; next < count; ++next) {
      const Triangle& triangle = triangle_at(next);
      if (!is_narrow(vertices[triangle.a - first], vertices[triangle.b - first], vertices[triangle.c - first]) ||
          detail::draw_small_run(run, &triangle, 1) == 0) {
        break;
      }
    }
    return next;
  }

  template <Shade shade, bool all_narrow, class TriangleAt>
  static void draw_small_runs(const StripTarget& target, const Batch& batch, std::uint32_t count,
                              const TriangleAt& triangle_at) {
    for (std::uint32_t i = 0; i < count; ++i) {
      i = draw_small_run<shade, all_narrow>(target, batch, i, count, triangle_at);
      if (i == count) return;
      const Triangle& triangle = triangle_at(i);
      const SnappedVertex& a = batch.vertices[triangle.a - batch.first_vertex];
      const SnappedVertex& b = batch.vertices[triangle.b - batch.first_vertex];
      const SnappedVertex& c = batch.vertices[triangle.c - batch.first_vertex];
      if (all_narrow || is_narrow(a, b, c)) {
        const std::int32_t area = narrow_area(a, b, c);
        if (kHasFlatSmallRuns && kTwoSided && area < 0) {
          draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.c, triangle.b, -area);
        } else {
          draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.b, triangle.c, area);
        }
      } else if constexpr (!kUnclipped) {
        Clipped::template draw_clipped<shade>(target, batch, triangle);
      }
    }
  }

  /// Those with the loop that is quickest for them.
  template <Shade shade, bool all_narrow, class TriangleAt>
  static void draw_run(const StripTarget& target, const Batch& batch, std::size_t count,
                       const TriangleAt& triangle_at) {
    if constexpr (kSmallRuns<shade, all_narrow>) {
      if (fits_small_runs<shade>(batch)) {
        return draw_small_runs<shade, all_narrow>(target, batch, static_cast<std::uint32_t>(count), triangle_at);
      }
    }
    draw_triangles<shade, all_narrow>(target, batch, count, triangle_at);
  }

  template <Shade shade>
  static void draw_shaded(const StripTarget& target, const Batch& batch, std::span<const Triangle> triangles,
                          bool all_narrow) {
    const Triangle* const first = triangles.data();
    const auto in_order = [first](std::size_t i) -> const Triangle& { return first[i]; };
    if (all_narrow || kUnclipped) {
      draw_run<shade, true>(target, batch, triangles.size(), in_order);
    } else {
      draw_triangles<shade, false>(target, batch, triangles.size(), in_order);
    }
  }

  /// Whether some instance may have this shade.
  static constexpr bool has_shade(Shade shade) {
    constexpr bool kAll = !effects.any(effect::shades);
    constexpr bool kGouraud = effects.has(effect::gouraud);
    switch (shade) {
      case Shade::flat: return kAll || effects.has(effect::shade_flat);
      case Shade::gouraud: return kGouraud && (kAll || effects.has(effect::shade_gouraud));
      case Shade::textured: return kTextures && (kAll || effects.has(effect::shade_textured));
      case Shade::textured_flat: return kTextures && (kAll || effects.has(effect::shade_textured_flat));
      case Shade::textured_gouraud:
        return kTextures && kGouraud && (kAll || effects.has(effect::shade_textured_gouraud));
      default:  // the view alone calls for dithered colours
        return effects.any(effect::fragments) &&
               (kAll || effects.any(effect::shade_fragments | effect::dithered_colours));
    }
  }

  /// Calls draw.operator()<shade>() for the instance's shade. One decision for a whole meshlet; shades that no instance
  /// has are not instantiated, and the last one needs no comparison.
  template <class Draw>
  static void with_shade(Shade shade, const Draw& draw) {
    try_shades<Shade::fragments, Shade::textured, Shade::textured_flat, Shade::textured_gouraud, Shade::gouraud,
               Shade::flat>(shade < Shade::fragments ? shade : Shade::fragments, draw);
  }
  template <Shade first, Shade... others, class Draw>
  static void try_shades(Shade shade, const Draw& draw) {
    constexpr bool kIsLast = !(has_shade(others) || ...);
    if constexpr (has_shade(first)) {
      if (kIsLast || shade == first) return draw.template operator()<first>();
    }
    if constexpr (!kIsLast) try_shades<others...>(shade, draw);
  }

  /// `triangles`, `count` of them, of an outline: those that face away.
  template <class TriangleAt>
  [[gnu::noinline]] static void draw_hull(const StripTarget& target, const Batch& batch, std::size_t count,
                                          const TriangleAt& triangle_at) {
    const auto turned = [&triangle_at](std::size_t i) { return turned_round(triangle_at(i)); };
    if constexpr (has_shade(Shade::fragments)) {
      if (batch.instance->shade >= Shade::fragments) {
        return draw_triangles<Shade::fragments, false>(target, batch, count, turned);
      }
    }
    draw_triangles<Shade::flat, false>(target, batch, count, turned);
  }

  /// Of an operand: those that face the viewer, or those that face away.
  static void draw_side(const StripTarget& target, const Batch& batch, std::span<const Triangle> triangles, bool away) {
    const auto turned = [triangles, away](std::size_t i) { return away ? turned_round(triangles[i]) : triangles[i]; };
    with_shade(batch.instance->shade,
               [&]<Shade shade>() { draw_triangles<shade, false>(target, batch, triangles.size(), turned); });
  }

  static void draw(const StripTarget& target, const Batch& batch, std::span<const Triangle> triangles,
                   bool all_narrow) {
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) {
        return draw_hull(target, batch, triangles.size(),
                         [triangles](std::size_t i) -> const Triangle& { return triangles[i]; });
      }
    }
    with_shade(batch.instance->shade, [&]<Shade shade>() { draw_shaded<shade>(target, batch, triangles, all_narrow); });
  }

  /// Only those that come next in the list, a BinReader or ListedTriangles. They face the viewer, or both sides show.
  template <class List>
  static void draw_listed(const StripTarget& target, const Batch& batch, std::span<const Triangle> triangles,
                          List& list, bool all_narrow) {
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) {
        for_each_run(list, [&](std::span<const std::uint16_t> listed) {
          draw_hull(target, batch, listed.size(),
                    [&](std::size_t i) -> const Triangle& { return triangles[listed[i]]; });
        });
        return;
      }
    }
    with_shade(batch.instance->shade, [&]<Shade shade>() {
      if constexpr (kSmallRuns<shade, true>) {
        if ((all_narrow || kUnclipped) && fits_small_runs<shade>(batch)) {
          return draw_listed_small<shade>(target, batch, triangles.data(), list);
        }
      }
      for_each_run(list, [&](std::span<const std::uint16_t> listed) {
        draw_run<shade, false>(target, batch, listed.size(),
                               [&](std::size_t i) -> const Triangle& { return triangles[listed[i]]; });
      });
    });
  }

  template <class List, class Visit>
  static void for_each_run(List& list, const Visit& visit) {
    for (auto listed = list.next_run(); !listed.empty(); listed = list.next_run()) visit(listed);
  }

  /// Before those of a strip, which is drawn into `area`.
  static void begin_listed([[maybe_unused]] const Bins& bins, [[maybe_unused]] const Rect& area) {
    if constexpr (kHasListedRuns && has_shade(Shade::gouraud)) {
      if constexpr (kSmallRuns<Shade::gouraud, true>) {
        if (CarriedTriangles* const carried = CarriedTriangles::in(bins)) carried->begin_strip(bins, area);
      }
    }
  }

  template <Shade shade, class List>
  static void draw_listed_small(const StripTarget& target, const Batch& batch, const Triangle* triangles, List& list) {
    if constexpr (kHasListedRuns && std::is_same_v<List, BinReader>) {
      while (draw_listed_run(target, batch, triangles, list)) {
        const Triangle& triangle = triangles[list.rest()[0]];
        draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.b, triangle.c, area_of(batch, triangle));
        list.take(1);
      }
    } else {
      draw_rows<shade>(target, batch, triangles, list);
    }
  }

  /// Up to the first triangle that is not small, or the end of the batch: then false. Cannot be inlined: the others
  /// need the stack that a run takes.
  [[gnu::noinline]] static bool draw_listed_run(const StripTarget& target, const Batch& batch,
                                                const Triangle* triangles, BinReader& list) {
    CarriedTriangles* const carried = CarriedTriangles::in(list.bins());
    ThumbListedRun run({target, batch.vertices, batch.colours, batch.first_vertex}, triangles, list.batch(), carried);
    bool stops = false;
    for (auto listed = list.rest(); !stops && !listed.empty() && !is_batch_entry(listed[0]); listed = list.rest()) {
      const std::uint32_t count = draw_listed_run_thumb2(run, listed.data(), static_cast<std::uint32_t>(listed.size()));
      list.take(count);
      stops = count != listed.size() && !is_batch_entry(listed[count]);
    }
    if (carried != nullptr) carried->read = run.read, carried->write = run.write;
    return stops;
  }

  static std::int32_t area_of(const Batch& batch, const Triangle& triangle) {
    const SnappedVertex* const vertices = batch.vertices;
    const std::uint32_t first = batch.first_vertex;
    return narrow_area(vertices[triangle.a - first], vertices[triangle.b - first], vertices[triangle.c - first]);
  }

  /// Runs of triangles that lie in a row.
  template <Shade shade, class List>
  static void draw_rows(const StripTarget& target, const Batch& batch, const Triangle* triangles, List& list) {
    Triangle row[kBinChunkEntries];
    for (auto listed = list.rest(); !listed.empty() && !is_batch_entry(listed[0]); listed = list.rest()) {
      std::uint32_t count = 0;
      for (const std::uint16_t entry : listed) {
        if (is_batch_entry(entry)) break;
        const Triangle& triangle = triangles[entry];
        Triangle& next = row[count++];
        next.a = triangle.a, next.b = triangle.b, next.c = triangle.c;  // GCC calls memcpy for a whole one
      }
      list.take(count);
      draw_small_runs<shade, true>(target, batch, count, [&row](std::size_t i) -> const Triangle& { return row[i]; });
    }
  }
};

}  // namespace zstrip::detail
