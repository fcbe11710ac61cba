// What effects keep from begin_frame to the strips: the last part of the arena, which only plans with such effects
// have.
#pragma once

#include <span>

#include "zstrip/effects/environment/environment.hpp"
#include "zstrip/effects/local_light/local_light.hpp"
#include "zstrip/effects/shadows/shadow_map.hpp"
#include "zstrip/geometry/extent.hpp"
#include "zstrip/raster/fragment_settings.hpp"

namespace zstrip::detail {

/// An instance in the order of drawing.
struct DrawOrder {
  Distance distance;  ///< of the middle of its box from the camera's plane
  std::uint32_t instance, unused;
};
static_assert(sizeof(DrawOrder) == kDrawOrderBytes);

/// The texture coordinates of what mirrors the surroundings lie behind the colours of vertices.
struct FrameReflections {
  std::uint32_t first;  ///< bytes from the vertices
  std::uint32_t unused;
};
static_assert(sizeof(FrameReflections) == kFrameReflectionsBytes);

/// A scene with its outlines' hulls as instances behind all others, and without outlines.
struct OutlinedScene {
  Scene scene;                  ///< has none of its outlines, but says where the first is
  std::uint32_t outline_count;  ///< the caller's
  std::uint32_t instances;      ///< the caller's

  std::span<const Outline> outlines() const { return {scene.outlines.data(), outline_count}; }
};
static_assert(sizeof(OutlinedScene) <= kOutlinedSceneBytes && alignof(OutlinedScene) <= kArenaAlignment);

/// Of an operand of a product.
struct CsgBounds {
  std::uint16_t left, top, right, bottom;  ///< pixels of the picture that it can cover; nothing if it cannot be seen
  std::uint32_t first_meshlet;             ///< among those of all instances
  bool cut;                                ///< by the near plane, as far as its box says
  std::uint8_t unused[3];
};
static_assert(sizeof(CsgBounds) == kCsgOperandBytes);

struct CsgState {
  std::uint32_t cache;  ///< where the vertices of operands are transformed
  std::uint32_t unused;
};
static_assert(sizeof(CsgState) == kCsgStateBytes);

struct EdgeState {
  std::uint32_t unused[2];
};
static_assert(sizeof(EdgeState) == kEdgeStateBytes);

/// As many edges of an instance as there are bits.
struct EdgeGroup {
  std::uint32_t seen;  ///< a bit each, the first is the lowest
  Extent extent;       ///< the strips that those can lie in
};
static_assert(sizeof(EdgeGroup) == kEdgeGroupBytes && kEdgesOfGroup == 32);

/// The arena's last part. It is laid out by the effects that the scene calls for, not by those of the pipeline: a
/// superset draws with the plan of the exact set. Parts whose effects has() denies must not be asked for.
class EffectBlock {
 public:
  /// `memory`: `bytes` of the plan, aligned to kArenaAlignment.
  EffectBlock(std::byte* memory, std::uint32_t bytes) : memory_(memory), bytes_(bytes) {}

  /// Comes before anything else. `instances`: hulls of outlines among them. `bytes` are effect_bytes of these or more.
  void lay_out(Effects called_for, std::uint32_t instances) const {
    if (bytes_ != 0) *reinterpret_cast<Header*>(memory_) = {called_for.bits, instances, 0};
  }
  bool has(Effects effects) const { return bytes_ != 0 && (header().bits & effects.bits) != 0; }

  FogCurve& fog() const { return *reinterpret_cast<FogCurve*>(memory_ + sizeof(Header)); }
  std::span<DrawOrder> order() const { return {reinterpret_cast<DrawOrder*>(memory_ + order_at()), instances()}; }
  FrameLights& lights() const { return *reinterpret_cast<FrameLights*>(memory_ + lights_at()); }
  InstanceShading& shading(std::size_t instance) const {
    return reinterpret_cast<InstanceShading*>(memory_ + lights_at() + kFrameLightsBytes)[instance];
  }
  /// Only begin_frame looks at them.
  std::span<Instance> turned() const { return {reinterpret_cast<Instance*>(memory_ + turned_at()), instances()}; }
  FrameReflections& reflections() const { return *reinterpret_cast<FrameReflections*>(memory_ + reflections_at()); }
  EyeForms& eye_forms(std::size_t instance) const {
    return reinterpret_cast<EyeForms*>(memory_ + reflections_at() + kFrameReflectionsBytes)[instance];
  }
  ShadowState& shadows() const { return *reinterpret_cast<ShadowState*>(memory_ + shadows_at()); }
  /// What lies behind everything else.
  std::span<std::byte> shadow_pool() const {
    const std::size_t first = shadows_at() + kShadowStateBytes;
    return {memory_ + first, bytes_ - first};
  }
  /// No scene has shadows, too.
  CsgState& csg() const { return *reinterpret_cast<CsgState*>(memory_ + csg_at()); }
  CsgBounds& csg_bounds(std::size_t operand) const {
    return reinterpret_cast<CsgBounds*>(memory_ + csg_at() + kCsgStateBytes)[operand];
  }
  /// What strips may use; lies behind everything else.
  std::byte* csg_strip(std::size_t operands) const {
    return memory_ + csg_at() + kCsgStateBytes + operands * kCsgOperandBytes;
  }
  /// No scene has shadows or products, too.
  EdgeGroup* edge_groups() const { return reinterpret_cast<EdgeGroup*>(memory_ + csg_at() + kEdgeStateBytes); }
  OutlinedScene& outlined() const { return *reinterpret_cast<OutlinedScene*>(memory_ + outlined_at()); }

 private:
  static_assert(sizeof(FogCurve) == kFogBytes && kFogBytes % kArenaAlignment == 0);
  std::size_t order_at() const { return sizeof(Header) + (has(effect::fog) ? kFogBytes : 0); }
  std::size_t lights_at() const { return order_at() + (has(effect::blending) ? instances() * kDrawOrderBytes : 0); }
  static_assert(sizeof(Instance) == kTurnedInstanceBytes);
  std::size_t turned_at() const {
    const std::size_t lights = kFrameLightsBytes + instances() * kInstanceShadingBytes;
    return lights_at() + (has(effect::local_light) ? lights : 0);
  }
  std::size_t reflections_at() const {
    return turned_at() + (has(effect::billboards | effect::outlines) ? instances() * kTurnedInstanceBytes : 0);
  }
  std::size_t outlined_at() const {
    const std::size_t reflections = kFrameReflectionsBytes + instances() * kEyeFormsBytes;
    return rounded_up(reflections_at() + (has(effect::environment) ? reflections : 0));
  }
  std::size_t shadows_at() const {
    return rounded_up(outlined_at() + (has(effect::outlines) ? kOutlinedSceneBytes : 0));
  }
  std::size_t csg_at() const { return shadows_at(); }

  struct Header {
    std::uint64_t bits;  ///< of the effects that the scene calls for
    std::uint32_t instances, unused;
  };
  static_assert(sizeof(Header) == kEffectHeaderBytes);
  const Header& header() const { return *reinterpret_cast<const Header*>(memory_); }
  std::size_t instances() const { return header().instances; }

  std::byte* memory_;
  std::uint32_t bytes_;
};

}  // namespace zstrip::detail
