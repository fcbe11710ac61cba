// CSG in a strip (constructive solid geometry; Goldfeather, Molnar, Turk and Fuchs 1989), before anything else is drawn
// into it. For each operand, the sides that may bound the product are peeled off layer by layer. The pixels of a layer
// that lie inside all intersected operands and outside the subtracted ones are written into the z-buffer. This needs
// two layers of depth, and a count and a mark for each pixel. Then the operands are drawn like other instances, at the
// pixels that their product has written into the z-buffer. Pixels of other products are excluded, because a face that
// was cut away may cross them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/effects/csg/csg_layers.hpp"
#include "zstrip/effects/csg/operands.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/stages/geometry_stage.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail::csg {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::csg;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    return request.called_for.has(effect::csg) ? check_memory(request, depth_cell_bytes(effects)) : Status{};
  }
  /// Prepares the operands of a frame whose instances are prepared, and hides them from all other stages.
  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (!request.called_for.has(effect::csg)) return {};
    prepare_operands(frame, request.camera);
    if (frame.extents != nullptr) survey<effects>(frame);
    hide_operands(frame);
    return {};
  }

  template <Effects effects>
  static Status check_over(const FrameState& frame) {
    const auto operands = static_cast<std::uint32_t>(frame.scene->csg.size());
    return operands == 0 ? Status{} : Status{.error = Error::csg, .needed = operands, .available = 0};
  }

  /// `target` is cleared.
  template <Effects effects>
  static void draw_surfaces(FrameState& frame, const StripTarget& target, std::uint16_t strip) {
    if (!effect_block(frame).has(effect::csg)) return;
    for_each_product(frame, target.area, target.view_left, target.view_top,
                     [&](std::size_t first, std::size_t end, const Rect& area) {
                       const StripTarget part = part_of<Cell<effects>>(target, area);
                       Layers<effects, kLayers<effects>> layers(frame, part, strip);
                       layers.find(first, end);
                       if constexpr (methods::keeps_bounds(effects)) {
                         static_cast<MethodFrameState&>(frame).state.bounds.forget(area);
                       }
                       const StripTarget found = layers.found();
                       for (std::size_t i = first; i < end; ++i)
                         colour<effects, kColours<effects>>(frame, found, strip, i);
                     });
  }

 private:
  template <Effects effects>
  using Cell = DepthCell<depth_format(effects)>;
  /// The effects of the pipeline that draws layers: coverage and codes.
  template <Effects effects>
  static constexpr Effects kLayers =
      (effects & (effect::orthographic | effect::depth_formats)) | Effects{effect::csg_layers.bits};
  /// The effects of the pipeline that draws colours. Materials of operands have default rules for depth, and bounds of
  /// depth would hide equal codes, so that it has neither.
  template <Effects effects>
  static constexpr Effects kColours = Effects{without(effects, effect::depth_state).bits | effect::csg_colours.bits};

  /// Calls visit(first operand, end of operands, pixels of `area` that the product can cover) for each visible product.
  /// `area` is in raster pixels; (view_left, view_top) is the picture's first pixel.
  template <class Visit>
  static void for_each_product(const FrameState& frame, const Rect& area, std::int32_t view_left, std::int32_t view_top,
                               const Visit& visit) {
    const std::span<const CsgOperand> operands = frame.scene->csg;
    for (std::size_t first = 0, end = 0; first < operands.size(); first = end) {
      Rect covered = area;
      for (; end < operands.size() && operands[end].product == operands[first].product; ++end) {
        if (operands[end].use != CsgUse::intersected) continue;
        covered = covered.cut_to(box_of(frame, end, view_left, view_top));
      }
      if (!covered.empty()) visit(first, end, covered);
    }
  }

  static Rect box_of(const FrameState& frame, std::size_t operand, std::int32_t left, std::int32_t top) {
    const CsgBounds& bounds = bounds_of(frame, operand);
    return {bounds.left + left, bounds.top + top, bounds.right + left, bounds.bottom + top};
  }
  static bool may_cover(const FrameState& frame, std::size_t operand, const StripTarget& target) {
    return box_of(frame, operand, target.view_left, target.view_top).touches(target.area);
  }

  /// Calls visit(number, meshlet) for the meshlets of an operand.
  template <class Visit>
  static void for_each_meshlet(const FrameState& frame, std::size_t operand, const Visit& visit) {
    const std::uint32_t instance = frame.scene->csg[operand].instance;
    const Mesh& mesh = frame.scene->meshes[frame.instances[instance].mesh];
    const std::uint32_t first = bounds_of(frame, operand).first_meshlet;
    const std::uint32_t meshlets = mesh.meshlets.empty() ? 1 : static_cast<std::uint32_t>(mesh.meshlets.size());
    for (std::uint32_t i = 0; i < meshlets; ++i) visit(first + i, i);
  }

  /// Transforms an operand's meshlet into the cache and calls visit(range, batch).
  template <Effects effects, class Visit>
  static void with_meshlet(FrameState& frame, std::size_t operand, std::uint32_t meshlet, const Visit& visit) {
    const std::uint32_t instance = frame.scene->csg[operand].instance;
    const MeshletRange range = meshlet_range(frame.scene->meshes[frame.instances[instance].mesh], meshlet);
    const std::uint32_t cache = state_of(frame).cache;
    const auto batch = GeometryStage::batch_for<effects>(frame, instance, range.first_vertex, cache);
    GeometryStage::transform<effects>(frame, batch, range, cache);
    visit(range, batch);
  }

  template <Effects effects, class Visit>
  static void for_each_in_strip(FrameState& frame, std::size_t operand, std::uint16_t strip, const Visit& visit) {
    const StripGrid::Place place = frame.grid.place_of(strip);
    for_each_meshlet(frame, operand, [&](std::uint32_t number, std::uint32_t meshlet) {
      if (frame.extents != nullptr && !frame.grid.touches(frame.extents[number], place)) return;
      with_meshlet<effects>(frame, operand, meshlet, visit);
    });
  }

  /// Finds the strips that the triangles of operands touch, facing the viewer or not.
  template <Effects effects>
  static void survey(FrameState& frame) {
    const Rect everywhere{INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX};
    for (std::size_t i = 0; i < frame.scene->csg.size(); ++i) {
      const CsgBounds& bounds = bounds_of(frame, i);
      if (bounds.left == bounds.right) continue;
      for_each_meshlet(frame, i, [&](std::uint32_t number, std::uint32_t meshlet) {
        with_meshlet<effects>(frame, i, meshlet, [&](const MeshletRange& range, const auto& batch) {
          Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
          for (const SnappedVertex& v : std::span(batch.vertices, range.vertex_count)) {
            if (v.x == kNotNarrow) {
              box = everywhere;
              break;
            }
            const std::int32_t x = v.x >> 4, y = v.y >> 4;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
          }
          frame.extents[number] = frame.grid.extent_of(box);
        });
      });
    }
  }

  /// Finds the surface of a product in a part of a strip.
  template <Effects effects, Effects drawing>
  class Layers {
   public:
    Layers(FrameState& frame, const StripTarget& part, std::uint16_t strip)
        : frame_(frame), part_(part), strip_(strip), depth_(part.template depth_row<Cell<effects>>(part.area.top)) {
      const std::size_t cells = std::size_t{frame.plan.strip_rows} * frame.plan.strip_columns;
      std::byte* const memory = strip_memory(frame);
      layer_ = reinterpret_cast<Cell<effects>*>(memory);
      before_ = layer_ + cells;
      counts_ = reinterpret_cast<std::uint8_t*>(before_ + cells);
      found_ = counts_ + cells;
    }

    /// Finds the surface of operands `first` to `end`, and writes it into the z-buffer where it is nearer.
    void find(std::size_t first, std::size_t end) {
      for_each_row([&](std::int32_t at, std::int32_t columns) { std::fill_n(found_ + at, columns, 0); });
      for (std::size_t i = first; i < end; ++i) {
        if (!may_cover(frame_, i, part_)) continue;
        for_each_row([&](std::int32_t at, std::int32_t columns) { std::fill_n(before_ + at, columns, kNearest); });
        while (peel(i)) {
          for (std::size_t other = first; other < end; ++other) {
            if (other != i && !keep_inside(other)) break;
          }
          accept();
        }
      }
    }

    /// Returns the part with only the found surface in place of the z-buffer. Valid until the next search.
    StripTarget found() const {
      for_each_row([&](std::int32_t at, std::int32_t columns) {
        for (std::int32_t i = at; i < at + columns; ++i) layer_[i] = found_[i] != 0 ? depth_[i] : 0;
      });
      return over_layer();
    }

   private:
    using Code = Cell<effects>;
    static constexpr Code kNearest = static_cast<Code>(-1);

    /// Calls visit(first cell, columns) for each row of the part, in the arrays of the strip.
    template <class Visit>
    void for_each_row(const Visit& visit) const {
      for (std::int32_t row = 0; row < part_.area.height(); ++row) visit(row * part_.depth_stride, part_.area.width());
    }
    CsgUse use_of(std::size_t operand) const { return frame_.scene->csg[operand].use; }

    StripTarget over_layer() const {
      StripTarget target = part_;
      target.depth = reinterpret_cast<std::uint16_t*>(layer_);
      return target;
    }

    void draw_side(const CsgPass& pass, const MeshletRange& range, const Batch& batch, bool away) {
      const StripTargetWithLayers complete{
          {over_layer(), Materials::depth_settings<drawing>(frame_, batch.instance->material)}, &pass};
      AssemblerFor<drawing>::draw_side(complete, batch, range.triangles, away);
    }

    /// Peels the next layer off the sides of an operand that may bound the product, behind the previous layer. Returns
    /// false if no pixel of it is visible.
    bool peel(std::size_t operand) {
      for_each_row([&](std::int32_t at, std::int32_t columns) { std::fill_n(layer_ + at, columns, Code{0}); });
      const CsgPass pass{.first_cell = layer_, .before = before_};
      for_each_in_strip<effects>(frame_, operand, strip_, [&](const MeshletRange& range, const auto& batch) {
        draw_side(pass, range, batch, use_of(operand) == CsgUse::subtracted);
      });
      bool any = false;
      for_each_row([&](std::int32_t at, std::int32_t columns) {
        for (std::int32_t i = at; i < at + columns; ++i) {
          if (layer_[i] <= depth_[i]) layer_[i] = 0;  // hidden, like all layers behind it
          before_[i] = layer_[i];
          any |= layer_[i] != 0;
        }
      });
      return any;
    }

    /// Keeps the layer's pixels that this operand does not exclude. Returns false if none remains.
    bool keep_inside(std::size_t operand) {
      if (may_cover(frame_, operand, part_)) {
        count(operand);
      } else if (use_of(operand) == CsgUse::subtracted) {
        return true;
      } else {
        for_each_row([&](std::int32_t at, std::int32_t columns) { std::fill_n(counts_ + at, columns, 0); });
      }
      bool any = false;
      const bool inside = use_of(operand) == CsgUse::intersected;
      for_each_row([&](std::int32_t at, std::int32_t columns) {
        for (std::int32_t i = at; i < at + columns; ++i) {
          if ((static_cast<std::int8_t>(counts_[i]) > 0) != inside) layer_[i] = 0;
          any |= layer_[i] != 0;
        }
      });
      return any;
    }

    /// Counts how many times the operand encloses the points just behind the layer. If the near plane may have cut the
    /// operand, it counts the faces behind these points, otherwise all other faces, so that the far plane may cut.
    void count(std::size_t operand) {
      for_each_row([&](std::int32_t at, std::int32_t columns) { std::fill_n(counts_ + at, columns, 0); });
      const bool behind = bounds_of(frame_, operand).cut;
      const std::uint8_t in = behind ? 0xFF : 1, out = behind ? 1 : 0xFF;
      const CsgPass front{.first_cell = layer_, .counts = counts_, .step = in, .behind = behind};
      const CsgPass back{.first_cell = layer_, .counts = counts_, .step = out, .behind = behind};
      for_each_in_strip<effects>(frame_, operand, strip_, [&](const MeshletRange& range, const auto& batch) {
        draw_side(front, range, batch, false);
        draw_side(back, range, batch, true);
      });
    }

    /// Accepts the remaining pixels of the layer: they are visible and hide all layers behind them.
    void accept() {
      for_each_row([&](std::int32_t at, std::int32_t columns) {
        for (std::int32_t i = at; i < at + columns; ++i) {
          if (layer_[i] != 0) depth_[i] = layer_[i], before_[i] = 0, found_[i] = 1;
        }
      });
    }

    FrameState& frame_;
    const StripTarget& part_;
    std::uint16_t strip_;
    Code* depth_;
    Code *layer_, *before_;
    std::uint8_t *counts_, *found_;
  };

  /// Draws the visible sides of an operand.
  template <Effects effects, Effects drawing>
  static void colour(FrameState& frame, const StripTarget& part, std::uint16_t strip, std::size_t operand) {
    if (!may_cover(frame, operand, part)) return;
    const std::uint32_t instance = frame.scene->csg[operand].instance;
    const bool away = frame.scene->csg[operand].use == CsgUse::subtracted;
    if (away) turn_normals(frame, instance);
    const std::uint32_t cache = state_of(frame).cache;
    for_each_in_strip<effects>(frame, operand, strip, [&](const MeshletRange& range, const auto& batch) {
      GeometryStage::shade<effects>(frame, batch, range, cache);
      AssemblerFor<drawing>::draw_side(Materials::instance_target<drawing>(frame, part, *batch.instance), batch,
                                       range.triangles, away);
    });
    if (away) turn_normals(frame, instance);
  }
};

}  // namespace zstrip::detail::csg
