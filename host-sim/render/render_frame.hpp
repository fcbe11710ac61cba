// Draws one frame of a scene into pixels: effects, plan, begin, strips.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "panel/simulated_panel.hpp"
#include "plan/ram_limit.hpp"
#include "render/picture_display.hpp"
#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {

/// Memory, time and statistics of one frame.
struct FrameReport {
  Plan plan;
  Mode mode = Mode::streamed;  ///< the mode in which it was drawn: not the planned mode if its bins overflowed
  std::uint32_t strip_pixel_bytes = 0;
  std::uint32_t drawn_strips = 0;  ///< fewer than the plan's if the panel knows the others
  Statistics statistics;
  Effects method;                   ///< the visibility method; empty: the z-buffer
  VisibilityStatistics visibility;  ///< only with a method
  Rect bounds;                      ///< of the projected scene: the only pixels that have depth
  std::uint32_t crc32 = 0;          ///< of the raw pixel bytes, as zlib computes it
  std::int64_t nanoseconds = 0;     ///< begin_frame and all strips
};

/// Returns the CRC-32, as zlib computes it.
std::uint32_t checksum(std::span<const std::byte> pixels);

/// Draws frames of one size; keeps its memory from frame to frame. Several threads draw the strips of a frame together,
/// each with its own renderer, arena and strip of pixels: the pixels and statistics are the same as with one thread.
class FrameRenderer {
 public:
  /// `added`: effects that neither scene nor view needs: a depth format and one of effect::perspective_runs.
  FrameRenderer(const View& view, const Budget& budget, Effects added = {}, unsigned threads = 1)
      : view_(view), budget_(budget), added_(added), display_(view), memory_(threads) {}

  /// Selects a method in place of the z-buffer, from the next frame on; it draws on one thread. `temporal`: keeps the
  /// set of visible meshlets for the next frame (VisibilityOptions::seen_before), and plans are streamed.
  void set_visibility(Effects method, const VisibilityOptions& options, bool temporal = false) {
    method_ = method, options_ = options, temporal_ = temporal;
  }

  /// The budget's bytes are a limit for all scenes (the default), or more may be taken.
  void set_ram_limit(RamLimit limit) { ram_limit_ = limit; }

  /// Plans and draws. Failures: ExitStatus::budget, with the bytes that are missing, their purpose, and how many are
  /// enough.
  Result<FrameReport> render(const Staging& staging);
  /// Draws with a plan that fits the scene and the view.
  Result<FrameReport> render(const Staging& placed, const Plan& plan);

  /// From now on also shows frames on `panel`, which has the view's size and format: strip by strip from two buffers
  /// alternately, on one thread. Strips that are planned have a multiple of `row_step` rows. The panel must outlive the
  /// renderer.
  void show_on(SimulatedPanel& panel, std::uint16_t row_step = 1) { panel_ = &panel, row_step_ = row_step; }

  /// Returns the pixels of the last frame.
  std::span<const std::byte> pixels() const { return display_.pixels(); }
  const View& view() const { return view_; }

 private:
  PlanResult plan_within(Budget& budget, const SceneCounts& counts, Effects effects) const;
  Result<Done> draw(const Staging& staging, const Effects& effects, FrameReport& report);
  Result<Done> draw_on_threads(const Staging& staging, const Effects& effects, FrameReport& report);

  View view_;
  Budget budget_;
  RamLimit ram_limit_ = RamLimit::given;
  Effects added_;
  Effects method_;
  VisibilityOptions options_;
  bool temporal_ = false;
  std::vector<std::uint32_t> seen_;
  PictureDisplay display_;
  SimulatedPanel* panel_ = nullptr;
  std::uint16_t row_step_ = 1;
  struct Memory {
    std::vector<std::uint64_t> arena;  ///< 8-byte words: kArenaAlignment
    std::vector<std::uint64_t> strip;
    std::vector<std::uint64_t> second_strip;
  };
  std::vector<Memory> memory_;  ///< one for each thread, at least one
};

}  // namespace zstrip::sim
