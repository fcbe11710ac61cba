// What effect::edges adds to the stages of a frame: before the strips, which edges show and in which strips; after a
// strip, which was drawn with an apron, the edges in it are blended.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/effects/edges/edge_blend.hpp"
#include "zstrip/frame/checks.hpp"
#include "zstrip/frame/geometry_stage.hpp"
#include "zstrip/resolve/convert.hpp"

namespace zstrip {

struct Frame::Access::Edges {
  static bool called_for(const Frame& frame) { return effect_block(frame).has(effect::edges); }

  /// A strip and a pixel more on each side that lies in the picture.
  static Rect with_apron(const Rect& area, const View& view) {
    return {std::max<std::int32_t>(area.left - 1, 0), std::max<std::int32_t>(area.top - 1, 0),
            std::min<std::int32_t>(area.right + 1, view.width), std::min<std::int32_t>(area.bottom + 1, view.height)};
  }

  /// Finds out which edges show. Comes before anything else keeps vertices: they are transformed into the cache.
  template <Effects effects>
  static void survey(Frame& frame) {
    frame.has_special_depth_ = true;
    for_each_set(frame, [&](std::uint32_t instance, std::span<const Edge> edges, detail::EdgeGroup* groups) {
      const Mesh& mesh = frame.scene_->meshes[frame.instances_[instance].mesh];
      const detail::EdgeProjection<effects.has(effect::orthographic)> projection{frame.instances_[instance], mesh,
                                                                                 frame.origin_};
      CachedMeshlet<effects> cache{frame, frame.instances_[instance], mesh};
      for (; !edges.empty(); ++groups) {
        const std::size_t count = std::min<std::size_t>(edges.size(), kEdgesOfGroup);
        *groups = survey_group(frame, projection, edges.first(count), cache);
        edges = edges.subspan(count);
      }
    });
  }

  /// `strip` was drawn: with its apron, which is `drawn`, into the working strip and `target`.
  template <Effects effects>
  static void resolve(Frame& frame, std::uint16_t strip, const Rect& drawn, const detail::StripTarget& target,
                      std::byte* out) {
    const View& view = frame.view_;
    const Rect area = frame.plan_.strip_area(strip, view);
    const std::uint16_t* const own = frame.working_colour_;
    std::uint16_t* const pixels = detail::drawn_in_place(view.format)
                                      ? reinterpret_cast<std::uint16_t*>(out)
                                      : frame.working_colour_ + static_cast<std::size_t>(drawn.width()) *
                                                                    static_cast<std::size_t>(drawn.height());
    copy(own, drawn, pixels, area);
    const std::int32_t x = frame.view_.width >> 1, y = frame.view_.height >> 1;
    const auto to_raster = [x, y](const Rect& r) { return Rect{r.left - x, r.top - y, r.right - x, r.bottom - y}; };
    blend<effects>(frame, strip, {to_raster(area), pixels, to_raster(drawn), own, target.area, target.depth});
    if constexpr (effects.has(effect::dithered_format)) {
      if (view.dither) dither_pixels(view.format, area, pixels);
    }
    convert_pixels(view.format, static_cast<std::uint16_t>(area.width()), static_cast<std::uint16_t>(area.height()),
                   pixels, out);
  }

 private:
  /// The vertices of one meshlet at a time, in the meshlets' order.
  template <Effects effects>
  struct CachedMeshlet {
    Frame& frame;
    const detail::CompiledInstance& instance;
    const Mesh& mesh;
    std::uint32_t next = 0, first = 0;
    std::uint32_t count = 0;  ///< none if some are not narrow

    bool has(std::uint32_t vertex) const { return vertex - first < count; }
    const detail::SnappedVertex& at(std::uint32_t vertex) const { return frame.vertices_[vertex - first]; }

    /// Goes on to the next meshlet that has the left face; stays where it is if none has.
    void go_to(const Edge& edge) {
      if (has(edge.a) && has(edge.b) && has(edge.left)) return;
      const auto meshlets = std::max<std::uint32_t>(static_cast<std::uint32_t>(mesh.meshlets.size()), 1);
      for (std::uint32_t i = next; i < meshlets; ++i) {
        const Geometry::MeshletRange range = Geometry::meshlet_range(mesh, i);
        const auto is_in = [&range](std::uint32_t v) { return v - range.first_vertex < range.vertex_count; };
        if (!is_in(edge.a) || !is_in(edge.b) || !is_in(edge.left)) continue;
        next = i + 1;
        first = range.first_vertex;
        const bool all_narrow = detail::transform_vertices<detail::raster_effects(effects)>(
            instance, mesh, frame.origin_, first, range.vertex_count, frame.vertices_);
        count = all_narrow ? range.vertex_count : 0;
        return;
      }
    }
  };

  /// Calls visit(index, edges, its groups) for each instance that can be seen and has edges.
  template <class Visit>
  static void for_each_set(const Frame& frame, const Visit& visit) {
    const Scene& scene = *frame.scene_;
    detail::EdgeGroup* groups = effect_block(frame).edge_groups();
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      const std::span<const Edge> edges = edges_of(scene, scene.instances[i].mesh);
      if (edges.empty()) continue;
      if (frame.instances_[i].visible) visit(i, edges, groups);
      groups += (edges.size() + kEdgesOfGroup - 1) / kEdgesOfGroup;
    }
  }

  template <bool orthographic, class Cache>
  static detail::EdgeGroup survey_group(const Frame& frame, const detail::EdgeProjection<orthographic>& projection,
                                        std::span<const Edge> edges, Cache& cache) {
    detail::EdgeGroup group{0, detail::Extent::none()};
    Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    const Edge* const begin = edges.data();
    const Edge* const end = begin + edges.size();
    for (const Edge* edge = begin;; ++edge) {
      edge = detail::next_that_may_show(edge, end, frame.vertices_, cache.first, cache.count);
      if (edge == end) break;
      if (survey_edge(projection, *edge, cache, box)) group.seen |= std::uint32_t{1} << (edge - begin);
    }
    if (group.seen != 0) group.extent = frame.grid_.extent_of(box);
    return group;
  }

  /// Extends a box of pixels by one.
  static void add(Rect& box, std::int32_t x, std::int32_t y) {
    x = (x - detail::kCentreBias) >> 4, y = (y - detail::kCentreBias) >> 4;
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
  }

  /// Whether an edge shows; then extends `box` by its pixels.
  template <bool orthographic, class Cache>
  [[gnu::noinline]] static bool survey_edge(const detail::EdgeProjection<orthographic>& projection, const Edge& edge,
                                            Cache& cache, Rect& box) {
    cache.go_to(edge);
    const auto corner = [&](std::uint32_t v) { return cache.has(v) ? cache.at(v) : projection(v); };
    const bool is_border = edge.right == kNoFace;
    const detail::SnappedVertex corners[4] = {corner(edge.a), corner(edge.b), corner(edge.left),
                                              corner(is_border ? edge.left : edge.right)};
    if (std::ranges::all_of(corners, [](const detail::SnappedVertex& v) { return v.x != detail::kNotNarrow; })) {
      if (!detail::shows(edge, corners[0], corners[1], corners[2], is_border ? nullptr : &corners[3],
                         projection.instance.double_sided)) {
        return false;
      }
      add(box, corners[0].x, corners[0].y);
      add(box, corners[1].x, corners[1].y);
      return true;
    }
    detail::SeenEdge seen;
    if (!detail::see_clipped(projection, edge, seen)) return false;
    add(box, seen.a.x, seen.a.y);
    add(box, seen.b.x, seen.b.y);
    return true;
  }

  static void copy(const std::uint16_t* from, const Rect& drawn, std::uint16_t* to, const Rect& area);

  template <Effects effects>
  static void blend(const Frame& frame, std::uint16_t strip, const detail::EdgeTarget& target) {
    const std::int32_t row = strip / frame.grid_.across(), column = strip % frame.grid_.across();
    for_each_set(frame, [&](std::uint32_t instance, std::span<const Edge> edges, const detail::EdgeGroup* groups) {
      const detail::EdgeProjection<effects.has(effect::orthographic)> projection{
          frame.instances_[instance], frame.scene_->meshes[frame.instances_[instance].mesh], frame.origin_};
      for (std::size_t first = 0; first < edges.size(); first += kEdgesOfGroup, ++groups) {
        if (groups->seen == 0 || !frame.grid_.touches(groups->extent, row, column)) continue;
        std::size_t index = first;
        for (std::uint32_t seen = groups->seen; seen != 0; seen >>= 1, ++index) {
          if ((seen & 1U) != 0) blend_edge(projection, edges[index], target);
        }
      }
    });
  }

  template <bool orthographic>
  static void blend_edge(const detail::EdgeProjection<orthographic>& projection, const Edge& edge,
                         const detail::EdgeTarget& target) {
    const detail::SnappedVertex a = projection(edge.a), b = projection(edge.b);
    const bool narrow = a.x != detail::kNotNarrow && b.x != detail::kNotNarrow;
    if (narrow && !detail::EdgeBlend<std::int32_t>::crosses(target, a, b)) return;
    detail::SeenEdge seen;
    if (!detail::see(projection, edge, a, b, seen)) return;
    if (seen.narrow) {
      detail::EdgeBlend<std::int32_t>::draw(target, seen);
    } else {
      detail::EdgeBlend<std::int64_t>::draw(target, seen);
    }
  }
};

}  // namespace zstrip
