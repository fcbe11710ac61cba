// Draws the frames of a case with the pipeline for the scene's effects.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "cases.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::targets {

/// What the largest case needs: 30,000 vertices of 12 bytes, and a picture.
inline constexpr std::size_t kMemoryBytes = 512 * 1024;

/// The arena, and behind it the pixels of one strip. Shared by all cases: none outlives its draw_case.
alignas(kArenaAlignment) inline std::byte memory[kMemoryBytes];

/// Draws strip after strip into memory that is full of garbage at the start of each frame.
template <const scenes::BuiltIn& built_in, Effects depth = Effects{}>
Status draw_case(const Case& frames, PictureSummary& summary) {
  constexpr Effects kEffects = effects_of(built_in.scene, built_in.camera) | depth;
  static Renderer<kEffects> renderer;
  static scenes::Staged staged;

  const View& view = frames.view;
  const auto [planned, plan] = zstrip::plan(built_in.counts, view, kEffects, {.strip_rows = frames.strip_rows});
  if (!planned) return planned;
  const std::uint32_t strip_bytes = plan.strip_pixel_bytes(view);
  const std::uint32_t needed = plan.bytes() + strip_bytes;
  if (needed > kMemoryBytes) {
    return {.error = Error::arena_too_small, .needed = needed, .available = kMemoryBytes};
  }
  const std::span<std::byte> arena(memory, plan.bytes());
  const std::span<std::byte> pixels(memory + plan.bytes(), strip_bytes);

  for (std::uint32_t index = 0; index < frames.frames; ++index) {
    const std::uint32_t frame = frames.first_frame + index;
    if constexpr (depth.has(effect::depth_ranges)) renderer = {};  // nothing in memory is its own any more
    std::memset(memory, static_cast<int>(0xA5U ^ (frame & 0xFFU)), needed);
    if (frames.motion == Motion::turntable) {
      stage(built_in, staged, frame, kFramesPerTurn, view);
    } else {
      stage_workload(built_in, staged, frame);
      if constexpr (built_in.pose != nullptr) {
        if (const Status posed = built_in.pose(frame); !posed) return posed;
      }
    }
    if (const Status begun = renderer.begin_frame(staged.scene, staged.camera, view, plan, arena); !begun) return begun;
    for (std::uint16_t strip = 0; strip < plan.strips; ++strip) {
      if (const Status drawn = renderer.draw_strip(strip, pixels); !drawn) return drawn;
      const std::uint32_t top = std::uint32_t{strip} * plan.strip_rows;
      const std::uint32_t rows = std::min<std::uint32_t>(plan.strip_rows, view.height - top);
      summary.add_pixels(pixels.first(rows * bytes_per_row(view.width, view.format)), top, rows);
      const Rect& area = renderer.frame().depth_area();
      if (area.empty()) continue;
      const auto cells = static_cast<std::size_t>(area.width()) * static_cast<std::size_t>(area.height());
      if constexpr (depth_bytes(depth_format(kEffects)) == 4) {
        summary.add_depth(std::span(renderer.frame().wide_depth(), cells));
      } else if constexpr (depth.has(effect::depth_ranges)) {
        const std::uint16_t cleared = renderer.frame().cleared_code();
        for (std::uint32_t i = 0; i < cells; ++i) {
          const std::uint16_t code = renderer.frame().depth()[i];
          const auto relative = static_cast<std::uint16_t>(code > cleared ? code - cleared : 0);
          summary.add_depth(std::span(&relative, 1));
        }
      } else {
        summary.add_depth(std::span(renderer.frame().depth(), cells));
      }
    }
  }
  return {};
}

}  // namespace zstrip::targets
