// What no method's templates change: the memory of a method, and its state at the start of a frame and of a strip.
#include "zstrip/stages/method_stage.hpp"

#include <algorithm>

#include "zstrip/scene/validate.hpp"

namespace zstrip::detail {

Status MethodStage::begin_frame(MethodFrameState& frame, Effects effects, Effects called_for, const SceneCounts& counts,
                                std::span<std::byte> arena) {
  const Plan& plan = frame.plan;
  const std::uint64_t needed = visibility_bytes(effects, counts.triangles, plan.strip_columns, plan.strip_rows);
  if (plan.visibility_bytes < needed) {
    return {.error = Error::arena_too_small,
            .purpose = visibility_purpose(effects),
            .needed = static_cast<std::uint32_t>(needed),
            .available = plan.visibility_bytes};
  }
  if (sorts_triangles(effects) && (counts.longest_meshlet > kMaxSortedIndex || counts.meshlets > kMaxSortedIndex ||
                                   counts.instances > kMaxSortedIndex)) {
    return {.error = Error::unplannable};
  }
  std::byte* const memory = arena.data() + (plan.bytes() - plan.visibility_bytes);
  const std::uint32_t sorted = sorts_triangles(effects) ? counts.triangles * kSortedTriangleBytes : 0;
  frame.sorted = reinterpret_cast<SortedTriangle*>(memory);
  frame.sorted_count = 0;
  frame.depth_bounds = memory + sorted;
  frame.counts = {};
  frame.state = {};
  frame.state.counts = effects.has(effect::statistics) ? &frame.counts : nullptr;
  frame.state.iterations = std::min(frame.options.iterations, kMaxIterations);
  frame.state.cull_small = frame.options.cull_small;
  if (effects.has(effect::depth_state)) frame.state.keeps_order = called_for.has(effect::depth_state);
  if (effects.has(method::culling) && !frame.options.cull_back_faces) {
    for (std::uint32_t i = 0; i < counts.instances; ++i) frame.instances[i].double_sided = true;
  }
  if (effects.has(method::culling)) {
    const std::span<std::uint32_t> seen = frame.options.seen_before;
    const auto found = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::copy(found, found + (found - seen.begin()), seen.begin());
    std::fill(found, seen.end(), 0U);
  }
  return {};
}

void MethodStage::begin_strip(MethodFrameState& frame, Effects effects, StripTarget& target) {
  // Without depth memory the pixel's own address identifies it; nothing is read or written through it.
  if (effects.has(method::painter)) target.depth = target.colour;
  const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
  frame.state.first_cell = target.depth;
  frame.state.overdraw = effects.has(effect::statistics) ? frame.options.overdraw : nullptr;
  if (frame.state.overdraw != nullptr) __builtin_memset(frame.state.overdraw, 0, cells);
  if (effects.any(method::bounded) && cells != 0)
    frame.state.bounds.begin(frame.depth_bounds, target.area, target.depth);
}

}  // namespace zstrip::detail
