// What visibility methods add to the stages; the templates are in visibility_stages.hpp, which renderers with a method
// include.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/frame/access.hpp"

namespace zstrip {

struct Frame::Access::Methods {
  /// Checks and lays out what a method has; everything else of the frame has been prepared.
  static Status begin_frame(FrameWithMethod& frame, Effects effects, Effects called_for, const SceneCounts& counts,
                            std::span<std::byte> arena);
  static void begin_strip(FrameWithMethod& frame, Effects effects, detail::StripTarget& target);
  template <Effects effects>
  static void count_culled(FrameWithMethod& frame);

  template <Effects effects>
  static Status order_triangles(FrameWithMethod& frame, const Camera& camera);
  template <Effects effects>
  static void collect_triangles(FrameWithMethod& frame);
  template <Effects effects>
  static Status key_by_tree(FrameWithMethod& frame, const Camera& camera);
  template <Effects effects>
  static void draw_sorted(FrameWithMethod& frame, const detail::StripTarget& target, std::uint16_t strip);

  template <Effects effects>
  static bool is_left_out(Frame& frame, std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet);
  template <Effects effects>
  static bool is_hidden(FrameWithMethod& frame, const detail::StripTarget& target, std::uint32_t instance,
                        const Meshlet* meshlet);
  template <Effects effects, class Draw>
  static void draw_seen_first(FrameWithMethod& frame, const detail::StripTarget& target, const Draw& draw);
};

}  // namespace zstrip
