// What the stage of an effect may do in a frame, and when. A wing's Stage replaces what it needs; the rest is no code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/geometry/depth_mapping.hpp"
#include "zstrip/stages/frame_parts.hpp"

namespace zstrip::detail {

/// What begin_frame was given.
struct FrameRequest {
  const Scene& scene;
  const Camera& camera;
  const View& view;
  const Plan& plan;
  SceneCounts counts;  ///< of the scene
  Effects called_for;  ///< by scene and camera
};

/// A strip on its way from where it was drawn to the caller's pixels.
struct StripImage {
  Rect area;              ///< of the picture
  std::uint16_t* pixels;  ///< RGB565, those of `area` without gaps
  std::byte* out;         ///< the caller's, in the view's format
  std::uint16_t strip;
};

// What frame/frame_order.hpp defines, for stages that draw a frame, or a part of one, themselves.
/// All checks of begin_frame.
template <Effects effects>
Status check_frame(const FrameRequest& request, std::span<std::byte> arena);
/// Begins a frame whose request has passed the checks. `facing`: the camera that billboards turn to, another one than
/// the request's only where pixels have several samples.
template <Effects effects>
Status begin_checked_frame(FrameState& frame, const FrameRequest& request, const Camera& facing,
                           std::span<std::byte> arena);
/// All that is in the scene, into a strip that is cleared.
template <Effects effects>
void draw_scene(FrameState& frame, const StripTarget& target, std::uint16_t strip);

/// The hooks, by what they are for: begin_frame, draw_strip, draw_over. `effects`: of the renderer, which has one of
/// kEffects. What the scene calls for may be less.
struct NoStage {
  /// Its hooks are called by renderers with any of these.
  static constexpr Effects kEffects{};

  /// Whether the plan has the memory that the effect needs, and whether the request can be drawn with it.
  template <Effects effects>
  static Status check(const FrameRequest&) {
    return {};
  }

  /// Whether instances are others than the caller's: then change_scene and keep_scene are called.
  static constexpr bool kChangesScene = false;
  /// Changes what is drawn: `drawn` is the caller's scene as the stages before have left it, and ends with begin_frame.
  template <Effects effects>
  static Status change_scene(FrameState&, Scene& /*drawn*/, const FrameRequest&, const Camera& /*facing*/) {
    return {};
  }
  /// After everything else of begin_frame: gives the frame a scene that lives as long as its strips.
  template <Effects effects>
  static void keep_scene(FrameState&, const FrameRequest&) {}

  /// Extends the distances that the depth range must hold, beyond those of instances.
  template <Effects effects>
  static void extend_reach(const FrameState&, const Scene&, const FrameRequest&, DistanceRange&) {}
  /// Instances are compiled, with the depth mapping of z16.
  template <Effects effects>
  static Status prepare_geometry(FrameState&, const Scene&, const FrameRequest&) {
    return {};
  }
  /// The depth mapping of the frame is about to change from that of z16 to this one.
  template <Effects effects>
  static void change_mapping(const FrameState&, const Scene&, const DepthMapping&) {}
  /// The depth mapping is that of the renderer's format.
  template <Effects effects>
  static Status prepare_surfaces(FrameState&, const Scene&, const FrameRequest&) {
    return {};
  }
  /// Bounds and strips are known, frame.scene is what is drawn.
  template <Effects effects>
  static Status prepare(FrameState&, const FrameRequest&) {
    return {};
  }

  /// Whether the strip is drawn into the working strip, because resolve needs it there.
  template <Effects effects>
  static bool needs_working_strip(const FrameState&) {
    return false;
  }
  /// What is drawn for a strip of this area.
  template <Effects effects>
  static Rect drawn_area(const FrameState&, const Rect& area) {
    return area;
  }
  /// The strip is cleared.
  template <Effects effects>
  static void draw_background(const FrameState&, const Rect& /*area*/, std::uint16_t* /*pixels*/) {}
  /// Before the triangles: surfaces that are opaque.
  template <Effects effects>
  static void draw_surfaces(FrameState&, const StripTarget&, std::uint16_t /*strip*/) {}
  /// Everything has been drawn.
  template <Effects effects>
  static Status finish(FrameState&, const StripTarget&, std::uint16_t /*strip*/) {
    return {};
  }
  /// Whether a part of the frame can be drawn over other pixels.
  template <Effects effects>
  static Status check_over(const FrameState&) {
    return {};
  }
  /// One step from what was drawn to pixels.
  template <Effects effects>
  static void resolve(const FrameState&, const StripTarget&, StripImage&) {}
};

}  // namespace zstrip::detail
