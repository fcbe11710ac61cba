// The hooks of an effect's stage in a frame. A wing's Stage overrides the hooks that it needs; others have no code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/geometry/depth_mapping.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail {

struct FrameRequest {
  const Scene& scene;
  const Camera& camera;
  const View& view;
  const Plan& plan;
  SceneCounts counts;
  Effects called_for;  ///< effects that scene and camera need
};

/// A strip between drawing and the caller's pixels.
struct StripImage {
  Rect area;              ///< in the picture
  std::uint16_t* pixels;  ///< RGB565 pixels of `area`, without gaps
  std::byte* out;         ///< the caller's memory, in the view's format
  std::uint16_t strip;
};

// frame/frame_order.hpp defines these, for stages that draw a whole frame or a part of one.
/// Runs all checks of begin_frame.
template <Effects effects>
Status check_frame(const FrameRequest& request, std::span<std::byte> arena);
/// Begins a frame whose request has passed the checks. `facing`: the camera towards which billboards rotate; it differs
/// from the request's only if pixels have several samples.
template <Effects effects>
Status begin_checked_frame(FrameState& frame, const FrameRequest& request, const Camera& facing,
                           std::span<std::byte> arena);
/// Draws the whole scene into a cleared strip.
template <Effects effects>
void draw_scene(FrameState& frame, const StripTarget& target, std::uint16_t strip);

/// The hooks, grouped by begin_frame, draw_strip and draw_over. `effects` are those of the renderer, which has one of
/// kEffects; the scene may need fewer.
struct NoStage {
  /// The renderer calls the hooks if it has any of these.
  static constexpr Effects kEffects{};

  /// Checks that the plan has the memory that the effect needs, and that the request can be drawn with it.
  template <Effects effects>
  static Status check(const FrameRequest&) {
    return {};
  }

  /// True if the effect changes instances: then change_scene and keep_scene are called.
  static constexpr bool kChangesScene = false;
  /// Changes the drawn scene. `drawn` is the caller's scene as the previous stages have left it, and exists until
  /// begin_frame returns.
  template <Effects effects>
  static Status change_scene(FrameState&, Scene& /*drawn*/, const FrameRequest&, const Camera& /*facing*/) {
    return {};
  }
  /// Runs at the end of begin_frame: sets a scene that lives as long as the strips.
  template <Effects effects>
  static void keep_scene(FrameState&, const FrameRequest&) {}

  /// Extends the distances that the depth range must contain, in addition to those of instances.
  template <Effects effects>
  static void extend_reach(const FrameState&, const Scene&, const FrameRequest&, DistanceRange&) {}
  /// Runs when instances are compiled, with the depth mapping of z16.
  template <Effects effects>
  static Status prepare_geometry(FrameState&, const Scene&, const FrameRequest&) {
    return {};
  }
  /// Runs before the frame's depth mapping changes from that of z16 to this one.
  template <Effects effects>
  static void change_mapping(const FrameState&, const Scene&, const DepthMapping&) {}
  /// Runs when the depth mapping is that of the renderer's format.
  template <Effects effects>
  static Status prepare_surfaces(FrameState&, const Scene&, const FrameRequest&) {
    return {};
  }
  /// Runs when bounds and strips are known and frame.scene is the drawn scene.
  template <Effects effects>
  static Status prepare(FrameState&, const FrameRequest&) {
    return {};
  }

  /// True if the strip must be drawn into the working strip, because resolve needs it there.
  template <Effects effects>
  static bool needs_working_strip(const FrameState&) {
    return false;
  }
  /// Returns the area that is drawn for a strip with this area.
  template <Effects effects>
  static Rect drawn_area(const FrameState&, const Rect& area) {
    return area;
  }
  /// Runs when the strip is cleared.
  template <Effects effects>
  static void draw_background(const FrameState&, const Rect& /*area*/, std::uint16_t* /*pixels*/) {}
  /// Draws opaque surfaces before the triangles.
  template <Effects effects>
  static void draw_surfaces(FrameState&, const StripTarget&, std::uint16_t /*strip*/) {}
  /// Runs when everything is drawn.
  template <Effects effects>
  static Status finish(FrameState&, const StripTarget&, const StripImage&) {
    return {};
  }
  template <Effects effects>
  static Status check_over(const FrameState&) {
    return {};
  }
  /// Does one step of the conversion from the drawn strip to pixels.
  template <Effects effects>
  static void resolve(const FrameState&, const StripTarget&, StripImage&) {}
};

}  // namespace zstrip::detail
