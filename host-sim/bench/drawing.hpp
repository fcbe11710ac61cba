// One workload with its plan and memory, drawn on the host frame by frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {

class Drawing {
 public:
  /// Plans `bench_case`; a budget that is too small is a failure with ExitStatus::budget.
  static Result<Drawing> prepare(const BenchCase& bench_case);

  /// Moves camera and model to a frame of the workload; this is set-up, which is not measured.
  void stage(std::uint32_t frame);
  /// Draws the staged frame: the measured work. Calls `after_strip` with the pixels of each strip.
  template <typename AfterStrip>
  Status draw(AfterStrip after_strip) {
    if (const Status posed = built_in_->pose != nullptr ? built_in_->pose(frame_) : Status{}; !posed) return posed;
    if (const Status begun = renderer_.begin_frame(staged_->scene, staged_->camera, view_, plan_, arena()); !begun) {
      return begun;
    }
    for (std::uint16_t strip = 0; strip < plan_.strips; ++strip) {
      if (const Status drawn = renderer_.draw_strip(strip, pixels_); !drawn) return drawn;
      after_strip(std::span<const std::byte>(pixels_).first(strip_bytes(strip)));
    }
    return {};
  }
  Status draw() {
    return draw([](std::span<const std::byte>) {});
  }

  const Plan& plan() const { return plan_; }
  /// Returns the bytes of arena, one strip of pixels, and the scene's data of a pose.
  std::uint64_t ram_bytes() const { return std::uint64_t{plan_.bytes()} + pixels_.size() + built_in_->pose_bytes; }

 private:
  Drawing(const BenchCase& bench_case, const scenes::BuiltIn& built_in, Effects effects, const Plan& plan);
  std::span<std::byte> arena() { return std::as_writable_bytes(std::span(arena_)).first(plan_.bytes()); }
  std::size_t strip_bytes(std::uint16_t strip) const;

  const scenes::BuiltIn* built_in_;
  std::unique_ptr<scenes::Staged> staged_;
  std::uint32_t frame_ = 0;
  View view_;
  Plan plan_;
  AnyRenderer renderer_;
  std::vector<std::uint64_t> arena_;
  std::vector<std::byte> pixels_;
};

}  // namespace zstrip::sim
