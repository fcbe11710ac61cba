// Depth formats and sub-ranges: the mapping of a frame and the clear of a strip where they are not those of z16.
#pragma once

#include <cstdint>

#include "zstrip/frame/access.hpp"
#include "zstrip/geometry/depth_mapping.hpp"

namespace zstrip {

struct Frame::Access::DepthStage {
  static constexpr bool has_own_mapping(Effects effects) {
    return effects.any(effect::depth_formats | effect::depth_ranges);
  }

  static constexpr bool has_own_clear(Effects effects) {
    return effects.has(method::painter) || depth_bytes(depth_format(effects)) != kDepthBytes ||
           effects.has(effect::depth_ranges);
  }

  /// From z16's, for which the frame has been prepared.
  template <Effects effects>
  static void change_mapping(Frame& frame, const Scene& scene) {
    if (frame.fit_.near == 0) return;  // nothing is visible
    const detail::DepthMapping mapping = effects.has(effect::depth_ranges)
                                             ? detail::depth_mapping_of_ranges(frame.fit_)
                                             : detail::depth_mapping(depth_format(effects), frame.fit_);
    if constexpr (effects.has(effect::lines)) {
      for (detail::CompiledLines& lines : lines_of(frame, scene)) {
        DepthFit fit = frame.fit_;
        detail::RasterOrigin origin = frame.origin_;
        detail::change_depth_mapping(mapping, effects.has(effect::orthographic), fit, origin, {&lines.instance, 1});
      }
    }
    detail::change_depth_mapping(mapping, effects.has(effect::orthographic), frame.fit_, frame.origin_,
                                 {frame.instances_, scene.instances.size()});
  }

  /// The first cells that the ranges may use, and the code that counts as cleared.
  static void begin_ranges(Frame& frame) {
    auto& ranged = static_cast<FrameWithDepthRanges&>(frame);
    ranged.ranges_.begin_frame(frame.depth_, frame.plan_.depth_bytes / kDepthBytes);
    ranged.cleared_code_ = 0;
  }

  /// What Access::clear does not: cells of 32 bits, and sub-ranges, where the strip gets the next one and often no
  /// clear.
  template <Effects effects>
  static void clear(Frame& frame, const detail::StripTarget& target) {
    const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
    if constexpr (effects.has(effect::depth_ranges)) {
      if (cells == 0) return;
      auto& ranged = static_cast<FrameWithDepthRanges&>(frame);
      const std::uint32_t usable = ranged.ranges_.next(cells);
      __builtin_memset(frame.depth_ + usable, 0, std::size_t{cells - usable} * kDepthBytes);
      const std::int64_t up =
          (std::int64_t{ranged.ranges_.cleared_code()} - ranged.cleared_code_) * (1 << 16);  // 16.16 codes
      ranged.cleared_code_ = ranged.ranges_.cleared_code();
      if constexpr (effects.has(effect::orthographic)) {
        frame.origin_.depth_offset += static_cast<std::uint32_t>(up);
      } else {
        frame.fit_.offset -= up;
        frame.origin_.depth_offset = static_cast<std::uint32_t>(frame.fit_.offset);
      }
    } else {
      __builtin_memset(frame.depth_, 0, std::size_t{cells} * detail::depth_cell_bytes(effects));
    }
  }
};

}  // namespace zstrip
