// Declares the steps that visibility methods add to the stages. zstrip/visibility.hpp defines them, for renderers
// with a method.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail {

struct MethodStage {
  template <Effects effects>
  static Status begin([[maybe_unused]] FrameState& frame, [[maybe_unused]] Effects called_for,
                      [[maybe_unused]] const Scene& scene, [[maybe_unused]] std::span<std::byte> arena) {
    if constexpr (effects.methods != 0) {
      return begin_frame(static_cast<MethodFrameState&>(frame), effects, called_for, count(scene), arena);
    }
    return {};
  }
  template <Effects effects>
  static void begin_strip([[maybe_unused]] FrameState& frame, [[maybe_unused]] StripTarget& target) {
    if constexpr (effects.methods != 0) begin_strip(static_cast<MethodFrameState&>(frame), effects, target);
  }
  /// Checks and lays out a method's data, after all other parts of the frame are prepared.
  static Status begin_frame(MethodFrameState& frame, Effects effects, Effects called_for, const SceneCounts& counts,
                            std::span<std::byte> arena);
  static void begin_strip(MethodFrameState& frame, Effects effects, StripTarget& target);
  template <Effects effects>
  static void count_culled(MethodFrameState& frame);

  template <Effects effects>
  static Status order_triangles(MethodFrameState& frame, const Camera& camera);
  template <Effects effects>
  static void collect_triangles(MethodFrameState& frame);
  template <Effects effects>
  static Status key_by_tree(MethodFrameState& frame, const Camera& camera);
  template <Effects effects>
  static void draw_sorted(MethodFrameState& frame, const StripTarget& target, std::uint16_t strip);

  template <Effects effects>
  static bool is_left_out(FrameState& frame, std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet);
  template <Effects effects>
  static bool is_hidden(MethodFrameState& frame, const StripTarget& target, std::uint32_t instance,
                        const Meshlet* meshlet);
  template <Effects effects, class Draw>
  static void draw_seen_first(MethodFrameState& frame, const StripTarget& target, const Draw& draw);
};

}  // namespace zstrip::detail
