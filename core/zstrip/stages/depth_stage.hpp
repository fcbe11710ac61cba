// Sets the mapping of a frame and clears a strip for depth formats other than z16, and for sub-ranges.
#pragma once

#include <cstdint>

#include "zstrip/geometry/depth_mapping.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/state/bounds.hpp"
#include "zstrip/state/frame_parts.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

struct DepthStage {
  static constexpr bool has_own_clear(Effects effects) {
    return methods::has_no_depth(effects) || depth_bytes(depth_format(effects)) != kDepthBytes ||
           effects.has(effect::depth_ranges);
  }

  /// Sets the cells that sub-ranges may use, and the code that means cleared.
  template <Effects effects>
  static void begin(FrameState& frame) {
    if constexpr (effects.has(effect::depth_ranges)) {
      auto& ranged = static_cast<RangedFrameState&>(frame);
      ranged.ranges.begin_frame(frame.depth, frame.plan.depth_bytes / kDepthBytes);
      ranged.cleared_code = 0;
    }
  }

  /// Replaces the mapping of z16, for which the frame was prepared. Calls change(mapping) so that effects can update
  /// data that is not in instances.
  template <Effects effects, class Change>
  static void change_mapping([[maybe_unused]] FrameState& frame, [[maybe_unused]] const Scene& scene,
                             [[maybe_unused]] const Change& change) {
    if constexpr (effects.any(effect::depth_formats | effect::depth_ranges)) {
      if (frame.fit.near == 0) return;  // nothing is visible
      const DepthMapping mapping = effects.has(effect::depth_ranges) ? depth_mapping_of_ranges(frame.fit)
                                                                     : depth_mapping(depth_format(effects), frame.fit);
      change(mapping);
      change_depth_mapping(mapping, effects.has(effect::orthographic), frame.fit, frame.origin,
                           {frame.instances, scene.instances.size()});
    }
  }

  /// Clears the z-buffer of the target and the strip's pixels, which are those of `area`.
  template <Effects effects>
  static void clear(FrameState& frame, const StripTarget& target, const Rect& area, std::uint16_t* pixels) {
    if constexpr (has_own_clear(effects)) {
      fill_pixels(pixels, static_cast<std::uint32_t>(area.width()) * static_cast<std::uint32_t>(area.height()),
                  rgb565(frame.scene->background));
      clear_depth<effects>(frame, target);
    } else {
      detail::clear(frame, static_cast<std::uint16_t>(area.width()), static_cast<std::uint16_t>(area.height()), pixels,
                    target);
    }
  }

 private:
  /// Clears 32-bit cells. With sub-ranges it gives the strip the next sub-range, which often needs no clear.
  template <Effects effects>
  static void clear_depth(FrameState& frame, const StripTarget& target) {
    const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
    if constexpr (effects.has(effect::depth_ranges)) {
      if (cells == 0) return;
      auto& ranged = static_cast<RangedFrameState&>(frame);
      const std::uint32_t usable = ranged.ranges.next(cells);
      __builtin_memset(frame.depth + usable, 0, std::size_t{cells - usable} * kDepthBytes);
      const std::int64_t up =
          (std::int64_t{ranged.ranges.cleared_code()} - ranged.cleared_code) * (1 << 16);  // 16.16 codes
      ranged.cleared_code = ranged.ranges.cleared_code();
      if constexpr (effects.has(effect::orthographic)) {
        frame.origin.depth_offset += static_cast<std::uint32_t>(up);
      } else {
        frame.fit.offset -= up;
        frame.origin.depth_offset = static_cast<std::uint32_t>(frame.fit.offset);
      }
    } else {
      __builtin_memset(frame.depth, 0, std::size_t{cells} * depth_cell_bytes(effects));
    }
  }
};

}  // namespace zstrip::detail
