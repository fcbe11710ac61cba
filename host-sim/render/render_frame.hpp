// One frame from a scene to pixels: effects, plan, begin, strips.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "panel/simulated_panel.hpp"
#include "render/picture_display.hpp"
#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {

/// What one frame took and did.
struct FrameReport {
  Plan plan;
  Mode mode = Mode::streamed;  ///< how it was drawn: not as planned if its bins overflowed
  std::uint32_t strip_pixel_bytes = 0;
  Statistics statistics;
  Effects method;                   ///< how visibility was found; nothing: the z-buffer
  VisibilityStatistics visibility;  ///< only with a method
  Rect bounds;                      ///< of the projected scene: the only pixels that have depth
  std::uint32_t crc32 = 0;          ///< zlib's, of the raw pixel bytes
  std::int64_t nanoseconds = 0;     ///< begin_frame and all strips
};

/// zlib's CRC-32.
std::uint32_t checksum(std::span<const std::byte> pixels);

/// Draws frames of one size; keeps its memory from frame to frame. With several threads they draw the strips of a frame
/// together, each with a renderer, an arena and a strip of pixels of its own: the same pixels and statistics.
class FrameRenderer {
 public:
  /// `added`: effects that neither scene nor view calls for, a depth format and one of effect::perspective_runs.
  FrameRenderer(const View& view, const Budget& budget, Effects added = {}, unsigned threads = 1)
      : view_(view), budget_(budget), added_(added), display_(view), memory_(threads) {}

  /// Another method than the z-buffer, from the next frame on; it draws on one thread. `temporal`: what was seen is
  /// kept for the next frame (VisibilityOptions::seen_before), and plans are streamed.
  void set_visibility(Effects method, const VisibilityOptions& options, bool temporal = false) {
    method_ = method, options_ = options, temporal_ = temporal;
  }

  /// Plans and draws. Failures: ExitStatus::budget, with the bytes that are missing, for what, and how many are enough.
  Result<FrameReport> render(const Staging& staging);
  /// Draws with a plan that fits the scene and the view.
  Result<FrameReport> render(const Staging& staging, const Plan& plan);

  /// From now on frames are shown on `panel`, too, which has the view's size and format: strip by strip from two
  /// buffers in turn, on one thread. It must outlive the renderer.
  void show_on(SimulatedPanel& panel) { panel_ = &panel; }

  /// The last frame.
  std::span<const std::byte> pixels() const { return display_.pixels(); }
  const View& view() const { return view_; }

 private:
  Result<Done> draw(const Staging& staging, const Effects& effects, FrameReport& report);
  Result<Done> draw_on_threads(const Staging& staging, const Effects& effects, FrameReport& report);

  View view_;
  Budget budget_;
  Effects added_;
  Effects method_;
  VisibilityOptions options_;
  bool temporal_ = false;
  std::vector<std::uint32_t> seen_;
  PictureDisplay display_;
  SimulatedPanel* panel_ = nullptr;
  struct Memory {
    std::vector<std::uint64_t> arena;  ///< 8-byte words: kArenaAlignment
    std::vector<std::uint64_t> strip;
    std::vector<std::uint64_t> second_strip;
  };
  std::vector<Memory> memory_;  ///< of each thread, at least one
};

}  // namespace zstrip::sim
