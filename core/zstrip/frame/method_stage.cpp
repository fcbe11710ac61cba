// What no method's templates change: the memory of a method, and its state at the start of a frame and of a strip.
#include "zstrip/frame/method_stage.hpp"

#include <algorithm>

#include "zstrip/scene/validate.hpp"

namespace zstrip {

Status Frame::Access::Methods::begin_frame(FrameWithMethod& frame, Effects effects, Effects called_for,
                                           const SceneCounts& counts, std::span<std::byte> arena) {
  const Plan& plan = frame.plan_;
  const std::uint64_t needed = detail::visibility_bytes(effects, counts.triangles, plan.strip_columns, plan.strip_rows);
  if (plan.visibility_bytes < needed) {
    return {.error = Error::arena_too_small,
            .purpose = detail::visibility_purpose(effects),
            .needed = static_cast<std::uint32_t>(needed),
            .available = plan.visibility_bytes};
  }
  if (sorts_triangles(effects) && (counts.longest_meshlet > kMostSortedIndex || counts.meshlets > kMostSortedIndex ||
                                   counts.instances > kMostSortedIndex)) {
    return {.error = Error::unplannable};
  }
  std::byte* const memory = arena.data() + (plan.bytes() - plan.visibility_bytes);
  const std::uint32_t sorted = sorts_triangles(effects) ? counts.triangles * kSortedTriangleBytes : 0;
  frame.sorted_ = reinterpret_cast<detail::SortedTriangle*>(memory);
  frame.sorted_count_ = 0;
  frame.depth_bounds_ = memory + sorted;
  frame.counts_ = {};
  frame.state_ = {};
  frame.state_.counts = effects.has(effect::statistics) ? &frame.counts_ : nullptr;
  frame.state_.iterations = std::min(frame.options_.iterations, kMostIterations);
  frame.state_.cull_small = frame.options_.cull_small;
  if (effects.has(effect::depth_state)) frame.state_.keeps_order = called_for.has(effect::depth_state);
  if (effects.has(method::culling) && !frame.options_.cull_back_faces) {
    for (std::uint32_t i = 0; i < counts.instances; ++i) frame.instances_[i].double_sided = true;
  }
  if (effects.has(method::culling)) {
    const std::span<std::uint32_t> seen = frame.options_.seen_before;
    const auto found = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::copy(found, found + (found - seen.begin()), seen.begin());
    std::fill(found, seen.end(), 0U);
  }
  return {};
}

void Frame::Access::Methods::begin_strip(FrameWithMethod& frame, Effects effects, detail::StripTarget& target) {
  // Without depth memory the pixel's own address says which one it is; nothing is read or written through it.
  if (effects.has(method::painter)) target.depth = target.colour;
  const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
  frame.state_.first_cell = target.depth;
  frame.state_.overdraw = effects.has(effect::statistics) ? frame.options_.overdraw : nullptr;
  if (frame.state_.overdraw != nullptr) __builtin_memset(frame.state_.overdraw, 0, cells);
  if (effects.any(method::bounded) && cells != 0)
    frame.state_.bounds.begin(frame.depth_bounds_, target.area, target.depth);
}

}  // namespace zstrip
