// The hooks of effect::edges in the stages of a frame. Before the strips they find the visible edges and their strips;
// after a strip, which was drawn with an apron, they blend its edges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "zstrip/effects/edges/apron.hpp"
#include "zstrip/effects/edges/edge_blend.hpp"
#include "zstrip/effects/edges/effect.hpp"
#include "zstrip/effects/shadows/kept.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/kernels/transform.hpp"
#include "zstrip/stages/geometry_stage.hpp"

namespace zstrip::detail::edges {

/// Neighbouring edges of an instance. Groups are small, so that a strip projects few edges that do not touch it.
struct EdgeGroup {
  std::uint8_t seen;  ///< one bit for each visible edge, the first edge in the lowest bit
  Extent extent;      ///< the strips that these edges may touch
};
static_assert(sizeof(EdgeGroup) == Effect::kGroupBytes && kEdgesOfGroup == 8);

template <Effects effects>
using ProjectionOf = EdgeProjection<effects.has(effect::orthographic), !effects.has(effect::unclipped)>;

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::edges;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    if (!request.called_for.has(effect::edges)) return {};
    if constexpr (saves_codes(effects)) {
      if (saves_codes(request.called_for)) {
        if (const Status status = check_saved(request); !status) return status;
      }
    }
    return check_request(request);
  }
  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.has(effect::edges)) survey<effects>(frame);
    return {};
  }
  template <Effects effects>
  static bool needs_working_strip(const FrameState& frame) {
    return has_apron<effects>(frame);
  }
  template <Effects effects>
  static Rect drawn_area(const FrameState& frame, const Rect& area) {
    return has_apron<effects>(frame) ? strip_with_apron(area, frame.view) : area;
  }
  template <Effects effects>
  static Status check_over(const FrameState& frame) {
    return has_apron<effects>(frame) ? Status{.error = Error::edges} : Status{};
  }
  /// Blends edges; the strip was drawn with its apron into the working strip.
  template <Effects effects>
  static void resolve(const FrameState& frame, const StripTarget& target, StripImage& image) {
    if (!has_apron<effects>(frame)) return;
    const View& view = frame.view;
    const Rect drawn = image.area, area = frame.plan.strip_area(image.strip, view);
    const std::uint16_t* const own = frame.working_colour;
    std::uint16_t* const pixels = blended_pixels(frame, image);
    copy_without_apron(own, drawn, pixels, area);
    const std::int32_t x = view.width >> 1, y = view.height >> 1;
    const auto to_raster = [x, y](const Rect& r) { return Rect{r.left - x, r.top - y, r.right - x, r.bottom - y}; };
    if (!target.area.empty()) {
      blend<effects>(frame, image.strip, {to_raster(area), pixels, to_raster(drawn), own, target.area, target.depth},
                     target.statistics);
    }
    image.area = area;
    image.pixels = pixels;
  }

 private:
  /// Finds the visible edges. Runs before other stages keep vertices, because it transforms vertices into the cache.
  template <Effects effects>
  static void survey(FrameState& frame) {
    frame.has_special_depth = true;
    for_each_set<effects>(frame, [&](std::uint32_t instance, std::span<const Edge> edges, EdgeGroup* groups) {
      const Mesh& mesh = frame.scene->meshes[frame.instances[instance].mesh];
      const ProjectionOf<effects> projection{frame.instances[instance], mesh, frame.origin};
      CachedMeshlet<effects> cache{frame, frame.instances[instance], mesh};
      if constexpr (effects.has(effect::statistics)) {
        frame.statistics.work[WorkKind::searched_edges] += static_cast<std::uint32_t>(edges.size());
      }
      for (; !edges.empty(); ++groups) {
        const std::size_t count = std::min<std::size_t>(edges.size(), kEdgesOfGroup);
        *groups = survey_group(frame, projection, edges.first(count), cache);
        edges = edges.subspan(count);
      }
    });
  }

  /// Caches the vertices of one meshlet at a time, in the meshlets' order.
  template <Effects effects>
  struct CachedMeshlet {
    FrameState& frame;
    const CompiledInstance& instance;
    const Mesh& mesh;
    std::uint32_t next = 0, first = 0;
    std::uint32_t count = 0;  ///< 0 if some vertices are not narrow

    bool has(std::uint32_t vertex) const { return vertex - first < count; }
    void count_surveyed() {
      if constexpr (effects.has(effect::statistics)) ++frame.statistics.work[WorkKind::surveyed_edges];
    }
    const SnappedVertex& at(std::uint32_t vertex) const { return frame.vertices[vertex - first]; }

    /// Goes to the next meshlet with the edge's left face; does not move if there is none.
    void go_to(const Edge& edge) {
      if (has(edge.a) && has(edge.b) && has(edge.left)) return;
      const auto meshlets = std::max<std::uint32_t>(static_cast<std::uint32_t>(mesh.meshlets.size()), 1);
      for (std::uint32_t i = next; i < meshlets; ++i) {
        const MeshletRange range = meshlet_range(mesh, i);
        const auto is_in = [&range](std::uint32_t v) { return v - range.first_vertex < range.vertex_count; };
        if (!is_in(edge.a) || !is_in(edge.b) || !is_in(edge.left)) continue;
        next = i + 1;
        first = range.first_vertex;
        const bool all_narrow = transform_vertices<raster_effects(effects)>(instance, mesh, frame.origin, first,
                                                                            range.vertex_count, frame.vertices);
        count = all_narrow ? range.vertex_count : 0;
        return;
      }
    }
  };

  /// Returns the groups of all instances. The layout of the effects' memory does not know how long a shadow's pool is.
  template <Effects effects>
  static EdgeGroup* groups_of(const FrameState& frame) {
    const EffectBlock block = effect_block(frame);
    if constexpr (effects.has(effect::shadows)) {
      if (block.has(effect::shadows)) return reinterpret_cast<EdgeGroup*>(shadows::end_of_pool(frame));
    }
    return block.at<Effect, EdgeGroup>(Effect::kStateBytes);
  }

  /// Calls visit(index, edges, groups) for each visible instance with edges.
  template <Effects effects, class Visit>
  static void for_each_set(const FrameState& frame, const Visit& visit) {
    const Scene& scene = *frame.scene;
    EdgeGroup* groups = groups_of<effects>(frame);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      const std::span<const Edge> edges = edges_of(scene, scene.instances[i].mesh);
      if (edges.empty()) continue;
      if (frame.instances[i].visible) visit(i, edges, groups);
      groups += (edges.size() + kEdgesOfGroup - 1) / kEdgesOfGroup;
    }
  }

  template <class Projection, class Cache>
  static EdgeGroup survey_group(const FrameState& frame, const Projection& projection, std::span<const Edge> edges,
                                Cache& cache) {
    EdgeGroup group{0, Extent::none()};
    Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    const Edge* const begin = edges.data();
    const Edge* const end = begin + edges.size();
    for (const Edge* edge = begin;; ++edge) {
      edge = next_that_may_show(edge, end, frame.vertices, cache.first, cache.count);
      if (edge == end) break;
      cache.count_surveyed();
      if (survey_edge(projection, *edge, cache, box)) {
        group.seen = static_cast<std::uint8_t>(group.seen | 1U << (edge - begin));
      }
    }
    if (group.seen != 0) group.extent = frame.grid.extent_of(box);
    return group;
  }

  /// Extends a box to contain a pixel.
  static void add(Rect& box, std::int32_t x, std::int32_t y) {
    x = (x - kCentreBias) >> 4, y = (y - kCentreBias) >> 4;
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
  }

  /// Returns true if an edge is a candidate to be seen, and extends `box` by its pixels.
  template <class Projection, class Cache>
  [[gnu::noinline]] static bool survey_edge(const Projection& projection, const Edge& edge, Cache& cache, Rect& box) {
    cache.go_to(edge);
    const auto corner = [&](std::uint32_t v) { return cache.has(v) ? cache.at(v) : projection(v); };
    const bool is_border = edge.right == kNoFace;
    const SnappedVertex corners[4] = {corner(edge.a), corner(edge.b), corner(edge.left),
                                      corner(is_border ? edge.left : edge.right)};
    const auto is_narrow = [](const SnappedVertex& v) { return v.x != kNotNarrow; };
    if (!Projection::kClips || std::ranges::all_of(corners, is_narrow)) {
      if (!shows(edge, corners[0], corners[1], corners[2], is_border ? nullptr : &corners[3],
                 projection.instance.double_sided)) {
        return false;
      }
      add(box, corners[0].x, corners[0].y);
      add(box, corners[1].x, corners[1].y);
      return true;
    }
    if constexpr (Projection::kClips) {
      SeenEdge seen;
      if (!see_clipped(projection, edge, seen)) return false;
      add(box, seen.a.x, seen.a.y);
      add(box, seen.b.x, seen.b.y);
    }
    return true;
  }

  template <Effects effects>
  static void blend(const FrameState& frame, std::uint16_t strip, const EdgeTarget& target, Statistics* counters) {
    const StripGrid::Place place = frame.grid.place_of(strip);
    for_each_set<effects>(frame, [&](std::uint32_t instance, std::span<const Edge> edges, const EdgeGroup* groups) {
      const ProjectionOf<effects> projection{frame.instances[instance],
                                             frame.scene->meshes[frame.instances[instance].mesh], frame.origin};
      for (std::size_t first = 0; first < edges.size(); first += kEdgesOfGroup, ++groups) {
        if (groups->seen == 0 || !frame.grid.touches(groups->extent, place)) continue;
        std::size_t index = first;
        for (std::uint32_t seen = groups->seen; seen != 0; seen >>= 1, ++index) {
          if ((seen & 1U) != 0) blend_edge<effects>(projection, edges[index], target, counters);
        }
      }
    });
  }

  /// Returns the number of pixels that the edge crosses in the strip.
  template <bool clips>
  static std::uint32_t blend_seen(const SeenEdge& seen, const EdgeTarget& target) {
    if constexpr (clips) {
      if (!seen.narrow) return EdgeBlend<std::int64_t>::draw(target, seen);
    }
    return EdgeBlend<std::int32_t>::draw(target, seen);
  }

  template <Effects effects>
  static void blend_edge(const ProjectionOf<effects>& projection, const Edge& edge, const EdgeTarget& target,
                         [[maybe_unused]] Statistics* counters) {
    using Projection = ProjectionOf<effects>;
    if constexpr (effects.has(effect::statistics)) ++counters->work[WorkKind::projected_edges];
    const SnappedVertex a = projection(edge.a), b = projection(edge.b);
    const bool narrow = !Projection::kClips || (a.x != kNotNarrow && b.x != kNotNarrow);
    if (narrow && !EdgeBlend<std::int32_t>::crosses(target, a, b)) return;
    SeenEdge seen;
    if (!see(projection, edge, a, b, seen)) return;
    const std::uint32_t pixels = blend_seen<Projection::kClips>(seen, target);
    if constexpr (effects.has(effect::statistics)) {
      ++counters->work[WorkKind::blended_edges];
      counters->work[WorkKind::pixels_of_edges] += pixels;
    }
  }
};

}  // namespace zstrip::detail::edges
