// FixedRenderer: a renderer for one scene and one picture, both compile-time constants. The compiler checks them, so
// that the firmware has no code for the checks; the arena is a member. This takes the least flash.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/frame.hpp"
#include "zstrip/frame/fixed_frame.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip {

/// Draws `scene`, whose meshes, materials and instances are constants, in the size and format of `view`. Only the
/// camera and the instances of a Moving can move. `more`: effects in addition to those that scene and view need, such
/// as effect::unclipped or effect::bins.
///     constexpr zstrip::View kView{128, 96, zstrip::PixelFormat::rgb565_swapped};
///     zstrip::FixedRenderer<kScene, kView, zstrip::Budget{.bytes = 2048}> renderer;
/// The compiler makes the plan, within `budget`; the arena of kPlan.bytes() bytes is in the object. An error that a
/// Renderer would return for scene, view, plan or memory is an error of the compilation. validate(scene), which reads
/// every index, is left to a static_assert of the program. Pass `counts` if the compiler cannot see the meshlets. Not
/// safe for two threads at once; separate objects are independent.
template <const Scene& scene, const View& view, Budget budget = Budget{}, Effects more = Effects{},
          Projection projection = Projection::perspective, SceneCounts counts = count(scene)>
class FixedRenderer {
 public:
  /// The effects that the pipeline is compiled for.
  static constexpr Effects kEffects = effects_of(scene, Camera{.projection = projection}) | effects_of(view) | more;

 private:
  static constexpr PlanResult kPlanned = zstrip::plan(counts, view, kEffects, budget);
  static_assert(kPlanned.status, "no plan for this scene, view and budget: zstrip plan says what is missing");
  static_assert(validate_instances(scene), "the scene is not valid: zstrip::validate says what is wrong");
  static_assert(effects_agree(kEffects), "effects that go together: kExclusions, kAlternatives");
  static_assert(kEffects.methods == 0 && !kEffects.any(effect::depth_ranges | effect::supersampled),
                "visibility methods, sub-ranges of depth and samples need a Renderer");

 public:
  /// The strips, and the layout of the arena.
  static constexpr Plan kPlan = kPlanned.plan;
  /// Bytes of the largest strip: the size of the pixel buffer.
  static constexpr std::uint32_t kStripBytes = kPlan.strip_pixel_bytes(view);

  /// The scene with its instances in RAM, so that they can move. The object holds a pointer to itself: do not move it.
  class Moving {
   public:
    constexpr Moving() : scene_(scene) {
      for (std::size_t i = 0; i < instances_.size(); ++i) instances_[i] = scene.instances[i];
      scene_.instances = instances_;
    }
    Moving(const Moving&) = delete;
    Moving& operator=(const Moving&) = delete;
    /// Returns the instances of the scene, to change their transforms.
    constexpr std::span<Instance> instances() { return instances_; }

   private:
    friend FixedRenderer;
    Scene scene_;
    std::array<Instance, scene.instances.size()> instances_{};
  };

  /// Prepares a frame seen by `camera`. Error::camera if the camera is not usable or has another projection;
  /// Error::instance for an instance that is too large for its distance; Error::clipping with effect::unclipped. After
  /// an error nothing is drawn until begin_frame succeeds.
  Status begin_frame(const Camera& camera) {
    return detail::begin_fixed_frame<kEffects>(state_, {scene, camera, view, kPlan, counts, kCalledFor}, arena_);
  }
  /// Prepares a frame with the instances of `moving`, which must not change until the last draw_strip. Error::instance
  /// also for a transform that validate_instances refuses, or a changed mesh or material.
  Status begin_frame(const Camera& camera, const Moving& moving) {
    detail::abandon(state_);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const Instance &moved = moving.instances_[i], &known = scene.instances[i];
      if (moved.mesh != known.mesh || moved.material != known.material || !detail::valid_transform(moved.transform)) {
        return {.error = Error::instance, .needed = static_cast<std::uint32_t>(i)};
      }
    }
    return detail::begin_fixed_frame<kEffects>(state_, {moving.scene_, camera, view, kPlan, counts, kCalledFor},
                                               arena_);
  }
  /// Draws kPlan.strip_area(strip, view) of the picture into `pixels`, which must lie at an even address; the former
  /// contents do not matter. The last strips of a row or column may be smaller. Strips may be drawn in any order, and
  /// repeatedly.
  Status draw_strip(std::uint16_t strip, std::span<std::byte, kStripBytes> pixels) {
    return detail::draw_fixed_strip<kEffects, view.format>(state_, strip, kPlan.strips, pixels.data());
  }
  /// Draws a strip into a buffer whose size is known only at run time, as zstrip_hal/present.hpp passes it. Returns
  /// Error::pixels_too_small if it is too small.
  Status draw_strip(std::uint16_t strip, std::same_as<std::span<std::byte>> auto pixels) {
    if (pixels.size() < kStripBytes) {
      return {.error = Error::pixels_too_small,
              .needed = kStripBytes,
              .available = static_cast<std::uint32_t>(pixels.size())};
    }
    return draw_strip(strip, pixels.template first<kStripBytes>());
  }
  /// Returns the frame that was begun last. The result refers to this object.
  FrameFor<kEffects> frame() const { return FrameFor<kEffects>(state_); }

 private:
  static constexpr Effects kCalledFor = effects_of(scene, Camera{.projection = projection});

  detail::FrameStateFor<kEffects> state_;
  alignas(kArenaAlignment) std::byte arena_[kPlan.bytes()] = {};  // zero-initialised: takes no flash
};

}  // namespace zstrip
