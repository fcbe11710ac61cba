// The CSG operands of a frame: their bounds, and the data that their stage needs to draw them.
#pragma once

#include "zstrip/effects/csg/effect.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::csg {

struct CsgBounds {
  std::uint16_t left, top, right, bottom;  ///< pixels of the picture that it can cover; empty if it is invisible
  std::uint32_t first_meshlet;             ///< counted over all instances
  bool cut;                                ///< the near plane may cut it; tested with its bounding box
  std::uint8_t unused[3];
};
static_assert(sizeof(CsgBounds) == Effect::kOperandBytes);

struct CsgState {
  std::uint32_t cache;  ///< index of the first cached vertex of operands
  std::uint32_t unused;
};
static_assert(sizeof(CsgState) == Effect::kStateBytes);

inline CsgState& state_of(const FrameState& frame) { return *effect_block(frame).at<Effect, CsgState>(); }
inline CsgBounds& bounds_of(const FrameState& frame, std::size_t operand) {
  return effect_block(frame).at<Effect, CsgBounds>(Effect::kStateBytes)[operand];
}
/// Returns the memory for strips, which lies after all operands.
inline std::byte* strip_memory(const FrameState& frame) {
  return reinterpret_cast<std::byte*>(&bounds_of(frame, frame.scene->csg.size()));
}

/// Checks a plan for a scene with CSG. `cell_bytes`: bytes of a cell of the z-buffer.
Status check_memory(const FrameRequest& request, std::uint32_t cell_bytes);

void prepare_operands(FrameState& frame, const Camera& camera);
/// Makes the operands invisible to all other stages.
void hide_operands(FrameState& frame);
/// Inverts the normals of an instance for light and environment maps; a second call restores them.
void turn_normals(const FrameState& frame, std::uint32_t instance);

}  // namespace zstrip::detail::csg
