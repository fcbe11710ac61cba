// Draws the triangles of a meshlet: culls them, and draws them one by one, or in runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/effects.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/geometry/bins.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/small_run.hpp"
#include "zstrip/raster/assemble_narrow.hpp"

namespace zstrip::detail {

template <Effects effects>
struct Assembler {
  using Clipped = ClippedAssembler<effects>;
  using Narrow = NarrowAssembler<effects>;
  using Batch = BatchOf<effects>;
  using StripTarget = TargetOf<effects>;
  static constexpr bool kUnclipped = Narrow::kUnclipped;
  template <Shade shade, bool all_narrow>
  static constexpr bool kSmallRuns = Narrow::template kSmallRuns<shade, all_narrow>;

  /// Culls and draws `count` triangles, from triangle_at(0) on. `all_narrow`: no vertex needs the clipping path.
  template <Shade shade, bool all_narrow, class TriangleAt>
  static void draw_triangles(const StripTarget& target, const Batch& batch, std::size_t count,
                             const TriangleAt& triangle_at) {
    const SnappedVertex* const vertices = batch.vertices;
    const std::uint32_t first = batch.first_vertex;
    const bool double_sided = Narrow::shows_both_sides(batch);
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle& triangle = triangle_at(i);
      const SnappedVertex& a = vertices[triangle.a - first];
      const SnappedVertex& b = vertices[triangle.b - first];
      const SnappedVertex& c = vertices[triangle.c - first];
      if constexpr (!all_narrow && !kUnclipped) {
        if (!Narrow::is_narrow(a, b, c)) {
          Clipped::template draw_clipped<shade>(target, batch, triangle);
          continue;
        }
      }
      const std::int32_t area = Narrow::narrow_area(a, b, c);
      if (area > 0) {
        Narrow::template draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.b, triangle.c, area);
      } else if (area < 0 && double_sided) {
        Narrow::template draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.c, triangle.b, -area);
      }
    }
  }

  template <Shade shade>
  static bool fits_small_runs(const Batch& batch) {
    return shade == Shade::flat || !Narrow::shows_both_sides(batch);
  }

  /// Draws triangles from `next` on, up to the first one that is not small or not narrow, and returns its index. Not
  /// inlined, so that the other triangles do not pay for the stack of a run.
  template <Shade shade, bool all_narrow, class TriangleAt>
  [[gnu::noinline]] static std::uint32_t draw_small_run(const StripTarget& target, const Batch& batch,
                                                        std::uint32_t next, std::uint32_t count,
                                                        const TriangleAt& triangle_at) {
    SmallRun run = small_run(target, batch.vertices, VertexAttributes<effects>::kColours ? batch.colours : nullptr,
                             batch.first_vertex,
                             {shade == Shade::flat, Narrow::shows_both_sides(batch), batch.surface.flat_colour});
    if constexpr (all_narrow) return next + detail::draw_small_run(run, &triangle_at(next), count - next);
    const SnappedVertex* const vertices = batch.vertices;
    const std::uint32_t first = batch.first_vertex;
    for (; next < count; ++next) {
      const Triangle& triangle = triangle_at(next);
      if (!Narrow::is_narrow(vertices[triangle.a - first], vertices[triangle.b - first],
                             vertices[triangle.c - first]) ||
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
      if (all_narrow || Narrow::is_narrow(a, b, c)) {
        const std::int32_t area = Narrow::narrow_area(a, b, c);
        if (kHasFlatSmallRuns && Narrow::kTwoSided && area < 0) {
          Narrow::template draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.c, triangle.b, -area);
        } else {
          Narrow::template draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.b, triangle.c, area);
        }
      } else if constexpr (!kUnclipped) {
        Clipped::template draw_clipped<shade>(target, batch, triangle);
      }
    }
  }

  /// Draws these triangles with the fastest loop that accepts them.
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

  /// True if some instance may have this shade.
  static constexpr bool has_shade(Shade shade) {
    constexpr bool kAll = !effects.any(effect::shades);
    constexpr bool kTextures = effects.has(effect::textures);
    constexpr bool kGouraud = effects.has(effect::gouraud);
    switch (shade) {
      case Shade::flat: return kAll || effects.has(effect::shade_flat);
      case Shade::gouraud: return kGouraud && (kAll || effects.has(effect::shade_gouraud));
      case Shade::textured: return kTextures && (kAll || effects.has(effect::shade_textured));
      case Shade::textured_flat: return kTextures && (kAll || effects.has(effect::shade_textured_flat));
      case Shade::textured_gouraud:
        return kTextures && kGouraud && (kAll || effects.has(effect::shade_textured_gouraud));
      default:  // only the view needs dithered colours
        return effects.any(effect::fragments) &&
               (kAll || effects.any(effect::shade_fragments | effect::dithered_colours));
    }
  }

  /// Calls draw.operator()<shade>() for the instance's shade: one decision for a whole meshlet. Shades that no instance
  /// has are not instantiated, and the last shade needs no comparison.
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

  /// Draws the triangles of an outline's hull that face away.
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

  /// Draws one side of an operand: the triangles that face the viewer, or those that face away.
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
    with_shade(batch.instance->shade, [&]<Shade shade>() {
      const auto in_order = [first = triangles.data()](std::size_t i) -> const Triangle& { return first[i]; };
      if (all_narrow || kUnclipped) {
        draw_run<shade, true>(target, batch, triangles.size(), in_order);
      } else {
        draw_triangles<shade, false>(target, batch, triangles.size(), in_order);
      }
    });
  }

  /// Draws the next triangles of the list. All are to be drawn.
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

  /// Call it before the triangles of a strip, which is drawn into `area`.
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
        Narrow::template draw_narrow<shade>(target, batch, triangle, triangle.a, triangle.b, triangle.c,
                                            Narrow::area_of(batch, triangle));
        list.take(1);
      }
    } else {
      draw_rows<shade>(target, batch, triangles, list);
    }
  }

  /// Draws listed triangles up to the first one that is not small, or to the end of the batch; returns false there. Not
  /// inlined, so that the other triangles do not pay for the stack of a run.
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

  /// Copies listed triangles into an array and draws them as runs.
  template <Shade shade, class List>
  static void draw_rows(const StripTarget& target, const Batch& batch, const Triangle* triangles, List& list) {
    Triangle row[kBinChunkEntries];
    for (auto listed = list.rest(); !listed.empty() && !is_batch_entry(listed[0]); listed = list.rest()) {
      std::uint32_t count = 0;
      for (const std::uint16_t entry : listed) {
        if (is_batch_entry(entry)) break;
        const Triangle& triangle = triangles[entry];
        Triangle& next = row[count++];
        next.a = triangle.a, next.b = triangle.b, next.c = triangle.c;  // GCC would call memcpy to copy the whole
                                                                        // struct
      }
      list.take(count);
      draw_small_runs<shade, true>(target, batch, count, [&row](std::size_t i) -> const Triangle& { return row[i]; });
    }
  }
};

}  // namespace zstrip::detail
