// Begins frames with effect::unclipped, whose stage checks the box of every instance; see clipping.hpp.
#include "bake/clipping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "text/number.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip::sim {
namespace {

/// Frames of a rotation or an animation that boards show (BakedMotion of firmware/boards).
constexpr std::uint32_t kFramesOfBoards = 64;
/// Angles have 16 bits: a rotation has no other poses.
constexpr std::uint32_t kPosesOfTurn = 65536;
/// Boxes that can be checked in about a second.
constexpr std::uint64_t kMaxChecks = std::uint64_t{1} << 22;

struct Motion {
  std::uint32_t poses;   ///< number of frames to check
  const char* name;      ///< "a rotation"
  std::string where;     ///< ClippingRecord::where
  bool is_part = false;  ///< the poses are a part of a rotation, which has further poses between them
};

std::uint32_t affordable(std::uint32_t poses, std::size_t instances) {
  const std::uint64_t most = std::max<std::uint64_t>(kMaxChecks / std::max<std::size_t>(instances, 1), kFramesOfBoards);
  while (poses > most) poses /= 2;
  return poses;
}

/// Returns the effect that needs clipping, and why.
std::optional<std::string> excluded_by(Effects effects) {
  if (effects.methods != 0) return "visibility methods split triangles, or look at boxes of their own";
  for (const EffectName& known : kEffectNames) {
    if (!effects.has(known.effect)) continue;
    for (const Exclusion& rule : kExclusions) {
      if (rule.one == effect::unclipped && known.effect.any(rule.other)) {
        return fmt::format("{} need it: {}", known.name, rule.why);
      }
    }
  }
  return {};
}

/// Returns the corners of an instance's box in world space, 16.16.
std::array<std::array<double, 3>, 8> corners_of(const Mesh& mesh, const Transform& transform) {
  const Vec3 &centre = mesh.centre, &half = mesh.half_extent;
  std::array<std::array<double, 3>, 8> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto side = [i](std::size_t axis) { return (i >> axis & 1) != 0 ? 1.0 : -1.0; };
    const double p[3] = {centre.x + side(0) * half.x, centre.y + side(1) * half.y, centre.z + side(2) * half.z};
    for (std::size_t row = 0; row < 3; ++row) {
      const Fixed(&m)[4] = transform.m[row];
      corners[i][row] = (m[0] * p[0] + m[1] * p[1] + m[2] * p[2]) / kFixedOne + m[3];
    }
  }
  return corners;
}

/// Returns a camera that sees less, by the largest movement between two of `poses` poses of a rotation: if these poses
/// pass with it, all poses pass with the scene's own camera. A coordinate of a rotating point is A + R cos(angle), with
/// R at most the distance from the axis, and exceeds those of the poses on both sides by R (1 - cos(pi / poses)). The
/// same holds for the distance of a point from a side of the view, which is a sum of two coordinates. Angles and
/// matrices are rounded to 16 bits.
Camera with_room_between(const BakedScene& baked, std::uint32_t poses) {
  double radius = 0;
  for (const Instance& instance : baked.scene.instances) {
    for (const auto& corner : corners_of(baked.scene.meshes[instance.mesh], instance.transform)) {
      radius = std::max(radius, std::hypot(corner[0], corner[2]));
    }
  }
  constexpr double kRounding = 1.0 / 16384;
  const double room = radius * (1 - std::cos(std::numbers::pi / poses) + kRounding) + 8;
  Camera camera = baked.camera;
  // Size of a unit at distance 1, in thousands of pixels; samples double it.
  const double scale = static_cast<double>(camera.focal) / kFixedOne * baked.view.height / 1000;
  const double share =
      camera.projection == Projection::orthographic ? scale * room / kFixedOne : (1 + scale) * room / camera.near_plane;
  const auto whole = [](double value) { return static_cast<Fixed>(std::min<double>(value, INT32_MAX)); };
  camera.focal = whole(std::ceil(camera.focal * (1 + 2 * share)));
  camera.near_plane = whole(std::ceil(camera.near_plane + room));
  camera.far_plane = whole(std::floor(camera.far_plane - room));
  return camera;
}

/// Describes why an instance was refused: "crosses the near plane".
std::string crossing(const Scene& scene, const Instance& instance, const Camera& camera) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (const auto& corner : corners_of(scene.meshes[instance.mesh], instance.transform)) {
    constexpr double kAxisOne = 1 << 30;
    const double distance = (camera.back.x * (camera.eye.x - corner[0]) + camera.back.y * (camera.eye.y - corner[1]) +
                             camera.back.z * (camera.eye.z - corner[2])) /
                            kAxisOne;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  if (nearest < camera.near_plane) return "crosses the near plane";
  if (farthest > camera.far_plane) return "crosses the far plane";
  constexpr double kManyTimes = 50;  // instances that are refused for this have a ratio near a hundred
  if (farthest > kManyTimes * nearest) {
    return fmt::format("has a far side {:.0f} times as far away as its near one", farthest / nearest);
  }
  return "leaves the thousand pixels around the picture's centre";
}

/// Frame `frame` of `frames` of the motion, with the movement of boards. Edges are left out: they have the boxes of
/// their instances.
class MovedScene {
 public:
  MovedScene(const BakedScene& baked, const Camera& camera)
      : at_rest_{baked.scene, camera, baked.animation, baked.turn},
        instances_(baked.scene.instances.size()),
        lines_(baked.scene.lines.size()) {
    at_rest_.scene.edges = {};
  }
  scenes::BakedFrame at(std::uint32_t frame, std::uint32_t frames) {
    return scenes::stage(at_rest_, frame, frames, {.instances = instances_, .lines = lines_});
  }
  bool can_turn() const { return scenes::can_turn(at_rest_); }

 private:
  scenes::AtRest at_rest_;
  std::vector<Instance> instances_;
  std::vector<LineSet> lines_;
};

/// Checks `frames` frames of the motion. Returns nothing, or the reason why clipping stays.
template <Effects effects>
std::optional<std::string> refused_in(const BakedScene& baked, const Motion& motion) {
  const PlanResult planned = plan(count(baked.scene), baked.view, effects);
  if (!planned.status) return fmt::format("its poses cannot be checked: {}", message(planned.status.error));
  std::vector<std::uint64_t> memory(planned.plan.bytes() / sizeof(std::uint64_t) + 1);
  const auto renderer = std::make_unique<Renderer<effects>>();
  MovedScene moved(baked, motion.is_part ? with_room_between(baked, motion.poses) : baked.camera);
  if (!moved.can_turn()) return "a rotating instance is too far away for it";
  // The frames of boards first, because one of 64 frame numbers is easier to find.
  for (const std::uint32_t frames : {std::min(kFramesOfBoards, motion.poses), motion.poses}) {
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
      const auto [scene, camera] = moved.at(frame, frames);
      const Status begun =
          renderer->begin_frame(scene, camera, baked.view, planned.plan, std::as_writable_bytes(std::span(memory)));
      if (begun) continue;
      const std::string when =
          frames == 1 ? "" : fmt::format(" in frame {} of {} of {}", grouped(frame), grouped(frames), motion.name);
      if (begun.error != Error::clipping) return fmt::format("{}{}", message(begun.error), when);
      return fmt::format("instance {} {}{}", grouped(begun.needed),
                         crossing(scene, scene.instances[begun.needed], camera), when);
    }
  }
  return {};
}

ClippingRecord checked(const BakedScene& baked, const Motion& motion) {
  constexpr Effects kChecked =
      without(effect::of_scenes, effect::orthographic | effect::outlines | effect::edges | effect::shadows) |
      effect::unclipped;
  const bool parallel = baked.camera.projection == Projection::orthographic;
  std::optional<std::string> why =
      parallel ? refused_in<kChecked | effect::orthographic>(baked, motion) : refused_in<kChecked>(baked, motion);
  if (why) return {.poses = motion.poses, .where = {}, .why = std::move(*why)};
  return {.left_out = true, .poses = motion.poses, .where = motion.where, .why = {}};
}

}  // namespace

ClippingRecord find_clipping(const BakedScene& baked, bool turntable) {
  const auto stays = [](std::string why) { return ClippingRecord{.where = {}, .why = std::move(why)}; };
  if (const std::optional<std::string> why = excluded_by(baked.effects)) return stays(*why);
  const std::size_t instances = baked.scene.instances.size();
  if (!baked.animation.tracks.empty()) {
    const std::uint32_t duration = std::max<std::uint32_t>(baked.animation.duration, 1);
    const std::uint32_t poses = std::max(affordable(duration, instances), kFramesOfBoards);
    return checked(baked, {poses, "the animation",
                           fmt::format("in any of the {} {} of the animation", grouped(poses),
                                       poses == duration ? "milliseconds" : "frames")});
  }
  // Joints and morph targets move vertices within the boxes of their meshes.
  if (baked.skins.move()) {
    return checked(baked, {1, "", baked.skins.meshes.empty() ? "however it morphs" : "wherever its joints move"});
  }
  if (!turntable) return stays("without --turntable it is not known how the scene moves");
  if (baked.turn.what == Turning::nothing) return stays("nothing rotates, so the program has to move the camera");
  const std::uint32_t poses = affordable(kPosesOfTurn, instances);
  return checked(baked, {poses, "a rotation", "in any pose of a rotation", poses != kPosesOfTurn});
}

}  // namespace zstrip::sim
