// The way into a frame: which stages there are, and what of them no effect changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/effects/lines/lines.hpp"
#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/frame/effect_block.hpp"
#include "zstrip/frame/frame.hpp"
#include "zstrip/raster/assemble.hpp"
#include "zstrip/raster/raster_effects.hpp"
#include "zstrip/raster/target.hpp"

namespace zstrip {

struct Frame::Access {
  // Each has a header of its own.
  struct Checks;
  struct Csg;
  struct DepthStage;
  struct Edges;
  struct EffectStage;
  struct Geometry;
  struct Materials;
  struct Methods;
  struct Raster;
  struct Samples;
  struct Shadows;

  template <Effects effects>
  using Assembler = detail::Assembler<detail::raster_effects(effects)>;

  /// Nothing is drawn until the next frame that can begin.
  static void abandon(Frame& frame) {
    frame.scene_ = nullptr;
    frame.next_to_last_strip_ = 0;
  }
  static void lay_out_arena(Frame& frame, std::span<std::byte> arena);
  /// Turns the scene's billboards to the camera; the instances lie in the effects' part of the arena then.
  static Status turn_billboards(const Frame& frame, Scene& scene, const Camera& camera, Effects called_for);
  /// Gives the scene its outlines' hulls as instances and takes the outlines away; all of it lies in the effects' part
  /// of the arena then.
  static void add_hulls(const Frame& frame, Scene& scene, Effects called_for);
  /// The scene that add_hulls has made.
  static const Scene* keep_outlined(const Frame& frame) { return &effect_block(frame).outlined().scene; }
  /// Makes outlines of the hulls, which have been compiled as instances.
  static void prepare_outlines(Frame& frame, const Scene& scene, const Camera& camera);
  /// Compiles the instances, finds the frame's bounds.
  static Status prepare(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const DepthFit& fit);
  static void extend_bounds(Frame& frame, const Rect& box);
  /// Compiles the quadrics, for the depth mapping that the frame has now.
  static Status prepare_quadrics(Frame& frame, const Scene& scene, const Camera& camera);
  /// They lie behind the instances.
  static detail::CompiledQuadric* quadrics_of(const Frame& frame, const Scene& scene) {
    auto* const first = reinterpret_cast<std::byte*>(frame.instances_);
    return reinterpret_cast<detail::CompiledQuadric*>(first + scene.instances.size() * kInstanceBytes);
  }
  /// Compiles the sets of lines, for z16's depth mapping, of which the frame has to be still.
  static Status prepare_lines(Frame& frame, const Scene& scene, const Camera& camera);
  /// They lie behind the quadrics.
  static std::span<detail::CompiledLines> lines_of(const Frame& frame, const Scene& scene) {
    auto* const first = reinterpret_cast<std::byte*>(frame.instances_);
    return {reinterpret_cast<detail::CompiledLines*>(first + scene.instances.size() * kInstanceBytes +
                                                     scene.quadrics.size() * kQuadricBytes),
            scene.lines.size()};
  }
  /// Into strips, of the bounds that are now known.
  static void divide(Frame& frame, const Scene& scene, const View& view);
  static detail::EffectBlock effect_block(const Frame& frame, const Scene& scene) {
    return {reinterpret_cast<std::byte*>(frame.batches_) + frame.plan_.bin_bytes, frame.plan_.effect_bytes,
            scene.instances.size()};
  }
  static detail::EffectBlock effect_block(const Frame& frame) { return effect_block(frame, *frame.scene_); }

  /// `strip`: its pixels in the picture.
  static detail::StripTarget target_of(Frame& frame, const Rect& strip, std::uint16_t* pixels);
  /// `area`: pixels of the picture inside the frame's bounds. Where they and their depth lie is left to the caller.
  static detail::StripTarget target_at(Frame& frame, const Rect& area);
  static void clear(const Frame& frame, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
                    const detail::StripTarget& target);

  // The order of the stages: frame_inline.hpp.
  template <Effects effects>
  static Status begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            std::span<std::byte> arena);
  /// With billboards turned to another camera than the one that draws them.
  template <Effects effects>
  [[gnu::always_inline]] static Status begin_facing(Frame& frame, const Scene& scene, const Camera& camera,
                                                    const Camera& facing, const View& view, const Plan& plan,
                                                    std::span<std::byte> arena);
  /// With the checks done and the arena laid out.
  template <Effects effects>
  static Status prepare_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view,
                              Effects called_for, std::span<std::byte> arena);
  template <Effects effects>
  static Status draw_strip(Frame& frame, std::uint16_t strip, std::span<std::byte> pixels);
  template <Effects effects>
  static Status draw_over(Frame& frame, const Rect& area, std::span<std::uint16_t> pixels,
                          std::span<std::uint16_t> depth);
};

}  // namespace zstrip
