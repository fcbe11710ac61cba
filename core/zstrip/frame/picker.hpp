// Draws one pixel of a frame, surface by surface, to find the one that it shows. The steps are those of a strip; only
// the end of the path differs, which writes down the triangle instead of a colour.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

#include "zstrip/effects/stages.hpp"
#include "zstrip/frame.hpp"
#include "zstrip/frame/picked.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/stages/raster_stage.hpp"
#include "zstrip/state/pixel_planes.hpp"

namespace zstrip::detail {

/// Returns the effects that decide which surface a pixel shows: light, fog, dithering and later drawing only
/// change its colour. Fragments keep one effect, so that their runs exist.
constexpr Effects picking_effects(Effects effects) {
  constexpr Effects kOfColours = effect::lighting | effect::gouraud | effect::vertex_colours | effect::statistics |
                                 effect::fog | effect::vertex_light | effect::pixel_shading | effect::dithered_colours |
                                 effect::dithered_format | effect::shadows | effect::edges | effect::overlay;
  return without(effects, kOfColours) | (effects.any(effect::fragments) ? effect::bilinear : Effects{});
}

/// The state of a frame, which has no other public access.
class StateOfFrame : public Frame {
 public:
  explicit StateOfFrame(const Frame& frame) : Frame(frame) {}
  template <class State>
  const State& get() const {
    return state<State>();
  }
};

/// A pixel, for triangles of narrow vertices.
class NarrowPixel {
 public:
  explicit NarrowPixel(const Rect& pixel) : right_(pixel.right * 16), bottom_(pixel.bottom * 16) {}
  /// True if NarrowPixels has no row or no column of the pixel. Signs decide, as in NarrowRows.
  bool misses(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) const {
    const auto on_one_side = [](std::int32_t i, std::int32_t j, std::int32_t k) { return ((i ^ j) | (j ^ k)) >= 0; };
    return on_one_side(a.y - bottom_, b.y - bottom_, c.y - bottom_) ||
           on_one_side(a.x - right_, b.x - right_, c.x - right_);
  }
  /// Returns the first triangle of `at` .. `end` that does not miss it, or `end`. Most do: a loop of its own has all
  /// that it needs in registers.
  [[gnu::noinline]] const Triangle* next(const Batch& batch, const Triangle* at, const Triangle* end) const {
    // The address of the mesh's vertex 0, as in Facing.
    const std::uintptr_t vertices =
        reinterpret_cast<std::uintptr_t>(batch.vertices) - batch.first_vertex * sizeof(SnappedVertex);
    const auto vertex = [vertices](std::uint32_t index) -> const SnappedVertex& {
      return *reinterpret_cast<const SnappedVertex*>(  // NOLINT(performance-no-int-to-ptr)
          vertices + index * sizeof(SnappedVertex));
    };
    const NarrowPixel self = *this;
    while (at != end && self.misses(vertex(at->a), vertex(at->b), vertex(at->c))) ++at;
    return at;
  }

 private:
  std::int32_t right_, bottom_;  // sub-pixels
};

/// Writes down the nearest triangle of one pixel.
template <Effects effects>
class PickedTriangle {
  static constexpr Effects kPicking = picking_effects(effects);
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  static constexpr DepthMode kDepth = depth_mode(kPicking);
  using Cell = DepthCell<kDepth.format>;
  using Target = TargetOf<kPicking>;
  using Assembler = AssemblerFor<kPicking>;
  using Batch = BatchOf<effects>;

 public:
  /// Draws a triangle of the batch if its box contains the target's only pixel. Returns true if the pixel shows it.
  /// `all_narrow`: no vertex of the batch needs the clipping path. `prepare(vertex)` is called for the corners of
  /// triangles that are drawn.
  template <class Prepare>
  static bool draw(const Target& target, const Batch& batch, const Triangle& triangle, bool all_narrow,
                   const Prepare& prepare, Picked& picked) {
    const auto vertex = [&batch](std::uint32_t index) -> const SnappedVertex& {
      return batch.vertices[index - batch.first_vertex];
    };
    const SnappedVertex &a = vertex(triangle.a), &b = vertex(triangle.b), &c = vertex(triangle.c);
    if constexpr (!Assembler::kUnclipped) {
      if (!all_narrow && !Assembler::Narrow::is_narrow(a, b, c)) {
        for (const std::uint32_t index : {triangle.a, triangle.b, triangle.c}) prepare(index);
        return draw_clipped(target, batch, triangle, picked);
      }
    }
    if (NarrowPixel(target.area).misses(a, b, c)) return false;
    const std::int32_t area = Assembler::Narrow::narrow_area(a, b, c);
    if (area == 0 || (area < 0 && !Assembler::Narrow::shows_both_sides(batch))) return false;
    for (const std::uint32_t index : {triangle.a, triangle.b, triangle.c}) prepare(index);
    return draw_narrow(target, batch, area > 0 ? triangle : turned_round(triangle), picked);
  }

 private:
  static bool draw_narrow(const Target& target, const Batch& batch, const Triangle& triangle, Picked& picked) {
    std::uint32_t corner[3] = {triangle.a, triangle.b, triangle.c};
    const auto snapped = [&batch](std::uint32_t index) -> const SnappedVertex& {
      return batch.vertices[index - batch.first_vertex];
    };
    rotate_to_first([&](std::uint32_t index) { return snapped(index).y * 65536 + snapped(index).x; }, corner[0],
                    corner[1], corner[2]);
    RasterVertex v[3] = {};
    for (int i = 0; i < 3; ++i) {
      const SnappedVertex& at = snapped(corner[i]);
      v[i].x = at.x, v[i].y = at.y, v[i].depth = at.depth;
      VertexAttributes<kPicking>::template load<Shade::fragments>(batch, corner[i], v[i]);
    }
    return draw_spans(target, batch, v, Assembler::Narrow::always_narrow(), picked);
  }

  static bool draw_clipped(const Target& target, const Batch& batch, const Triangle& triangle, Picked& picked) {
    if (ClipperFor<kPicking>::misses_rows(batch, triangle, target.area)) return false;
    RasterPolygon polygon;
    if (!Assembler::Clipped::template clip<Shade::fragments>(batch, triangle, polygon)) return false;
    if (!polygon.box().touches(target.area)) return false;
    bool shown = false;
    RasterVertex corner[3];
    while (polygon.cut_triangle(corner)) {
      TriangleParts parts(polygon, corner, target.area);
      for (Rect part; parts.next(part);) {
        shown |= draw_spans(part_of<Cell>(target, part), batch, corner, false, picked);
      }
    }
    return shown;
  }

  template <class Narrow>
  static bool draw_spans(const Target& target, const Batch& batch, const RasterVertex (&v)[3], Narrow narrow,
                         Picked& picked) {
    bool shown = false;
    const SpanTriangle<kDepth, TrianglePlanes> triangle(target, v[0], v[1], v[2]);
    triangle.template walk<false, true>(target, v[0], v[1], v[2], narrow,
                                        [&](const Span<Cell>& span, const auto& z, const auto& rule) {
                                          Cell code = *span.depth;
                                          if (!rule.may_draw(z.at(span.columns, span.rows), code)) return;
                                          Picked found = picked;
                                          bool hides = true;
                                          if (!shows(target, batch, v, triangle.setup, span, found, hides)) return;
                                          rule.drawn(code, hides, *span.depth);
                                          picked = found;
                                          shown = true;
                                        });
    return shown;
  }

  /// Sets the texture coordinates of a pixel that passed the depth test. Returns false if its texel discards it.
  static bool shows(const Target& target, const Batch& batch, const RasterVertex (&v)[3], const TrianglePlanes& setup,
                    const Span<Cell>& span, Picked& found, bool& hides) {
    const Shade shade = batch.instance->shade;
    found.textured = false;
    found.u = found.v = 0;
    [[maybe_unused]] const RasterVertex* const vertices[3] = {&v[0], &v[1], &v[2]};
    if constexpr (kPicking.any(effect::fragments)) {
      if (shade >= Shade::fragments) return shows_fragment(target, batch, vertices, setup, span, found, hides);
    }
    if constexpr (kPicking.has(effect::textures)) {
      if (shade >= Shade::textured && shade < Shade::fragments) {
        constexpr std::int32_t kPerspective = perspective_run(effects);
        constexpr std::int32_t kRun = kPerspective == 0 ? kPerspectiveRun : kPerspective;
        const TextureCoordinates<kOrthographic || kPerspective == 0> coordinates(setup, vertices,
                                                                                 batch.surface.depth_offset);
        set_place(batch.surface.texture, coordinates, kRun, span, found);
      }
    }
    return true;
  }

  /// Moves the first exact place of the span's run to its pixel, as fill_textured does.
  template <class Coordinates>
  static void set_place(const TextureView& texture, const Coordinates& coordinates, std::int32_t run,
                        const Span<Cell>& span, Picked& found) {
    const std::int32_t before = span.skipped & (run - 1);
    const std::int32_t left = span.whole_length - span.skipped + before;
    const TexelPosition from = coordinates.at(span.columns - before, span.rows);
    const TexelPosition to = coordinates.at(span.columns - before + std::min(left - 1, run), span.rows);
    const int log2_run = std::countr_zero(static_cast<std::uint32_t>(run));
    const auto at = [&](std::int32_t first, std::int32_t last, std::uint8_t log2_size) {
      const TextureAxis axis(log2_size);
      const std::int32_t whole = difference(last, first);
      const std::int32_t step =
          left > run ? whole >> log2_run : static_cast<std::int32_t>(long_product(whole, kInverse[left - 1]) >> 16);
      return static_cast<std::uint16_t>(
          (axis.fraction(first) + axis.fraction(step) * static_cast<std::uint32_t>(before)) >> 16);
    };
    found.textured = true;
    found.u = at(from.u, to.u, texture.log2_width), found.v = at(from.v, to.v, texture.log2_height);
  }

  /// Does the same for an instance that is drawn fragment by fragment, and tests its alpha.
  static bool shows_fragment(const Target& target, const Batch& batch, const RasterVertex* const (&vertices)[3],
                             const TrianglePlanes& setup, const Span<Cell>& span, Picked& found, bool& hides) {
    const FragmentSettings& settings = target.fragments;
    const FragmentPlanes<kPicking> planes(setup, vertices, batch.surface, target);
    FragmentRun<kPicking> run(planes, target);
    const std::int32_t before = span.skipped & (kPerspectiveRun - 1);
    const std::int32_t left = span.whole_length - span.skipped + before;
    const std::int32_t column = span.columns - before;
    const FragmentPoint from = point_at(planes, column, span.rows);
    const FragmentPoint to = point_at(planes, column + std::min(left - 1, kPerspectiveRun), span.rows);
    run.set_ends(from, to, left, before);
    std::uint32_t colour = 0xFF000000;
    if constexpr (kPicking.has(effect::textures)) {
      if (planes.textured) {
        if constexpr (kPicking.has(effect::texture_alpha)) {
          if (settings.has_texture_alpha) {
            if (settings.bilinear) {
              fetch_bilinear<false, true>(run.texels, run.place, &colour, 1);
            } else {
              fetch_alpha(run.texels, run.place, &colour, 1);
            }
          }
        }
        found.textured = true;
        if constexpr (effects.has(effect::environment)) found.textured = batch.reflections == nullptr;
        if (found.textured) {
          found.u = static_cast<std::uint16_t>(run.place.u >> 16),
          found.v = static_cast<std::uint16_t>(run.place.v >> 16);
        }
      }
    }
    hides = !run.blends();
    if (!run.blends() && !run.discards()) return true;
    multiply_alpha(factor(settings.alpha), &colour, 1);
    const std::uint32_t alpha = colour >> 24;
    return run.discards() ? alpha >= settings.cutoff : alpha != 0;
  }
};

/// One pixel of a frame.
template <Effects effects>
class Picker {
  static constexpr Effects kPicking = picking_effects(effects);
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  using Cell = DepthCell<depth_mode(kPicking).format>;

 public:
  /// The frame's state is copied, so that its counts do not change; the copy refers to the same arena.
  explicit Picker(const Frame& frame) : frame_(StateOfFrame(frame).get<FrameStateFor<effects>>()) {}

  /// `x`, `y` in pixels of the picture.
  Status pick(std::uint16_t x, std::uint16_t y, Picked& picked) {
    picked = {};
    if (frame_.scene == nullptr) return {.error = Error::not_begun};
    std::int32_t column = x, row = y;
    if constexpr (effects.has(effect::supersampled)) {
      const auto columns = static_cast<std::int32_t>(sample_columns(frame_.view));
      const auto rows = static_cast<std::int32_t>(sample_rows(frame_.view));
      column = column * columns + columns / 2, row = row * rows + rows / 2;
    }
    if (column >= frame_.view.width || row >= frame_.view.height) return {.error = Error::view_size};
    if constexpr (effects.has(effect::csg)) {
      if (const std::size_t operands = frame_.scene->csg.size(); operands != 0) {
        return {.error = Error::csg, .needed = static_cast<std::uint32_t>(operands)};
      }
    }
    if constexpr (effects.has(effect::overlay)) {
      if (frame_.scene->overlay != nullptr && pick_overlay(*frame_.scene->overlay, x, y, picked)) return {};
    }
    const Rect area{column, row, column + 1, row + 1};
    if (!area.touches(frame_.bounds)) return {};
    StripTarget target = target_at(frame_, area);
    target.depth = reinterpret_cast<std::uint16_t*>(&cell_);
    target.colour = &colour_;
    target.depth_stride = target.colour_stride = 1;
    if constexpr (effects.has(effect::quadrics)) pick_quadrics(target, picked);
    if constexpr (effects.has(effect::lines)) pick_lines(target, picked);
    const auto strip = static_cast<std::uint16_t>(static_cast<std::uint32_t>(row) / frame_.plan.strip_rows *
                                                      frame_.plan.columns_of_strips(frame_.view) +
                                                  static_cast<std::uint32_t>(column) / frame_.plan.strip_columns);
    pick_triangles(target, area, strip, picked);
    if constexpr (effects.has(effect::outlines)) name_outline(picked);
    return {};
  }

 private:
  /// Returns true if `draw` draws into the pixel. Two colours, because a surface may have one of them; a second test of
  /// its depth then gives the first one's result, because the cell did not change.
  template <class Draw>
  bool draws(const Draw& draw) {
    const Cell before = cell_;
    for (const std::uint16_t colour : {std::uint16_t{0}, std::uint16_t{0xFFFF}}) {
      colour_ = colour;
      draw();
      if (colour_ != colour || cell_ != before) return true;
    }
    return false;
  }

  /// Finds the topmost element of the overlay that changes the pixel, whatever is under it.
  bool pick_overlay(const Overlay& overlay, std::uint16_t x, std::uint16_t y, Picked& picked) {
    const auto covers = [&](const Overlay& one) {
      return draws([&] { draw_overlay(one, {x, y, x + 1, y + 1}, &colour_); });
    };
    for (std::size_t i = overlay.labels.size(); i-- > 0;) {
      if (covers({.fonts = overlay.fonts, .labels = overlay.labels.subspan(i, 1)})) {
        picked = {.shown = Shown::label, .index = static_cast<std::uint16_t>(i)};
        return true;
      }
    }
    for (std::size_t i = overlay.sprites.size(); i-- > 0;) {
      if (covers({.images = overlay.images, .sprites = overlay.sprites.subspan(i, 1)})) {
        picked = {.shown = Shown::sprite, .index = static_cast<std::uint16_t>(i)};
        return true;
      }
    }
    return false;
  }

  void pick_quadrics(const StripTarget& target, Picked& picked) {
    const std::int64_t offset = kOrthographic ? std::int64_t{frame_.origin.depth_offset} : -frame_.fit.offset;
    const CompiledQuadric* const compiled = quadrics::compiled(frame_, *frame_.scene);
    for (std::size_t i = 0; i < frame_.scene->quadrics.size(); ++i) {
      const CompiledQuadric& quadric = compiled[i];
      if (!quadric.visible) continue;
      const QuadricShade<kPicking> shade{quadric, Materials::texture_of(frame_, quadric.material)};
      const bool shown = draws([&] {
        QuadricFill<kPicking>::draw(Materials::depth_target<kPicking>(frame_, target, quadric.material), quadric,
                                    offset, shade);
      });
      if (shown) picked = {.shown = Shown::quadric, .index = static_cast<std::uint16_t>(i)};
    }
  }

  void pick_lines(const StripTarget& target, Picked& picked) {
    const Scene& scene = *frame_.scene;
    const std::span<const CompiledLines> compiled = compiled_lines(frame_.instances, scene);
    for (std::size_t i = 0; i < compiled.size(); ++i) {
      if (!compiled[i].instance.visible) continue;
      LineShade<kPicking> shade;
      if constexpr (effects.has(effect::supersampled)) {
        shade.grid = {static_cast<std::int32_t>(sample_columns(frame_.view)),
                      static_cast<std::int32_t>(sample_rows(frame_.view))};
      }
      const auto shows = [&](const LineSet& lines) {
        return draws([&] {
          LineFill<kPicking>::draw(Materials::depth_target<kPicking>(frame_, target, lines.material), compiled[i],
                                   lines, scene.meshes[lines.mesh], frame_.origin, shade);
        });
      };
      const Cell before = cell_;
      if (!shows(scene.lines[i])) continue;
      cell_ = before;
      LineSet one = scene.lines[i];
      for (std::size_t s = 0; s < scene.lines[i].segments.size(); ++s) {
        one.segments = scene.lines[i].segments.subspan(s, 1);
        if (!shows(one)) continue;
        picked = {
            .shown = Shown::line, .index = static_cast<std::uint16_t>(i), .triangle = static_cast<std::uint32_t>(s)};
      }
    }
  }

  void pick_triangles(const StripTarget& target, const Rect& pixel, std::uint16_t strip, Picked& picked) {
    if constexpr (effects.has(effect::bins)) {
      if (frame_.mode == Mode::binned) return pick_listed(target, strip, picked);
    }
    const StripGrid::Place place = frame_.grid.place_of(strip);
    std::uint32_t tested = UINT32_MAX;  // the instance whose box was compared last
    bool may_cover = false;
    std::optional<PixelPlanes> planes;
    GeometryStage::for_each_meshlet<effects>(
        frame_, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
          if (frame_.extents != nullptr && !frame_.grid.touches(frame_.extents[number], place)) return;
          const CompiledInstance& compiled = frame_.instances[instance];
          if (instance != tested) {
            tested = instance;
            may_cover = box_touches(instance, pixel);
            planes.reset();
            if (may_cover && has_spheres(instance)) {
              planes.emplace(compiled, mesh_of(instance), frame_.origin, target.area, kOrthographic);
            }
          }
          if (!may_cover || (planes && planes->miss(compiled, mesh_of(instance).meshlets[meshlet]))) return;
          const MeshletRange range = meshlet_range(mesh_of(instance), meshlet);
          const auto batch = GeometryStage::batch_for<effects>(frame_, instance, range.first_vertex, 0);
          const bool all_narrow = GeometryStage::transform<effects>(frame_, batch, range, 0);
          with_batch(target, batch, range.triangles, instance, all_narrow, [&](const auto& draw) {
            const auto prepare = [&](std::uint32_t vertex) { this->prepare(batch, vertex); };
            const NarrowPixel narrow(target.area);
            const Triangle* const end = range.triangles.data() + range.triangles.size();
            for (const Triangle* triangle = range.triangles.data(); triangle != end; ++triangle) {
              if (all_narrow) triangle = narrow.next(batch, triangle, end);
              if (triangle == end) break;
              draw(*triangle, prepare, picked);
            }
          });
        });
  }

  void pick_listed(const StripTarget& target, std::uint16_t strip, Picked& picked) {
    for (BinReader list(frame_.bins, strip); list.next_batch();) {
      const RetainedBatch& retained = frame_.batches[list.batch()];
      const MeshletRange range = meshlet_range(mesh_of(retained.instance), retained.meshlet);
      const auto batch =
          GeometryStage::batch_for<effects>(frame_, retained.instance, range.first_vertex, retained.first_vertex);
      if (!retained.all_narrow) GeometryStage::move<effects>(batch, range);
      with_batch(target, batch, range.triangles, retained.instance, retained.all_narrow, [&](const auto& draw) {
        for (auto listed = list.next_run(); !listed.empty(); listed = list.next_run()) {
          for (const std::uint16_t entry : listed)
            draw(
                range.triangles[entry], [](std::uint32_t) {}, picked);
        }
      });
    }
  }

  /// Calls visit(draw), where draw(triangle, prepare, picked) draws a triangle of the batch.
  template <class Visit>
  void with_batch(const StripTarget& target, const BatchOf<effects>& batch, std::span<const Triangle> triangles,
                  std::uint32_t instance, bool all_narrow, const Visit& visit) {
    const auto first = static_cast<std::uint32_t>(triangles.data() - mesh_of(instance).triangles.data());
    const bool turned = effects.has(effect::outlines) && is_outline(*batch.instance);
    const auto& complete = Materials::instance_target<kPicking>(frame_, target, *batch.instance);
    visit([&](const Triangle& triangle, const auto& prepare, Picked& picked) {
      Picked found = picked;
      if (!PickedTriangle<effects>::draw(complete, batch, turned ? turned_round(triangle) : triangle, all_narrow,
                                         prepare, found)) {
        return;
      }
      found.shown = Shown::instance;
      found.index = static_cast<std::uint16_t>(instance);
      found.triangle = first + static_cast<std::uint32_t>(&triangle - triangles.data());
      picked = found;
    });
  }

  /// Computes the place in an environment map of a vertex, which a mask may need.
  void prepare([[maybe_unused]] const BatchOf<effects>& batch, [[maybe_unused]] std::uint32_t vertex) {
    if constexpr (effects.has(effect::environment)) {
      if (batch.reflections == nullptr) return;
      const MeshletRange one{vertex, 1, {}};
      if constexpr (effects.has(effect::skins)) skins::move_normals(*batch.mesh, one);
      environment::reflect<kOrthographic>(frame_, batch, one);
    }
  }

  const Mesh& mesh_of(std::uint32_t instance) const { return frame_.scene->meshes[frame_.instances[instance].mesh]; }

  /// False if the instance's box misses the pixel. A hull may leave its box.
  bool box_touches(std::uint32_t instance, const Rect& pixel) const {
    const CompiledInstance& compiled = frame_.instances[instance];
    if (effects.has(effect::outlines) && is_outline(compiled)) return true;
    return bounds_of(compiled, frame_.origin, frame_.view, kOrthographic).touches(pixel);
  }

  /// True if the spheres of an instance's meshlets contain their vertices: joints and hulls move these.
  bool has_spheres(std::uint32_t instance) const {
    const Mesh& mesh = mesh_of(instance);
    if (effects.has(effect::skins) && mesh.skinning != nullptr) return false;
    if (effects.has(effect::outlines) && is_outline(frame_.instances[instance])) return false;
    return !mesh.meshlets.empty();
  }

  /// Hulls are instances after those of the caller's scene. Replaces the index of one by that of its instance.
  void name_outline(Picked& picked) const {
    if (picked.shown != Shown::instance || !is_outline(frame_.instances[picked.index])) return;
    const outlines::OutlinedScene& outlined = *outlines::outlined_of(frame_);
    std::uint32_t hull = outlined.instances;
    for (std::uint32_t i = 0; i < outlined.instances; ++i) {
      const Mesh& mesh = outlined.scene.meshes[outlined.scene.instances[i].mesh];
      if (mesh.outline == 0 || mesh.outline > outlined.outline_count) continue;
      if (hull++ != picked.index) continue;
      picked.shown = Shown::outline;
      picked.index = static_cast<std::uint16_t>(i);
      return;
    }
  }

  FrameStateFor<effects> frame_;
  Cell cell_ = 0;
  std::uint16_t colour_ = 0;
};

}  // namespace zstrip::detail
