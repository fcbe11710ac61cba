// The cases of `zstrip bench --table dynamic-z`: a figure whose bounding rectangle has five sizes, drawn with the
// classic z-buffer of the whole view, with one of the bounding rectangle, and with little memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bench/torus_knot.hpp"
#include "result.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The extent of the z-buffer, which sets its memory.
enum class DepthMemory : std::uint8_t {
  classic,           ///< the default view of 1024x768, completely cleared in each frame
  rectangle,         ///< the figure's bounding rectangle, as in the paper's dynamic z-buffer
  small,             ///< strips or tiles: the arena has little_bytes
  small_and_pixels,  ///< strips or tiles: the arena and the strip's pixels together have little_bytes
};
inline constexpr DepthMemory kDepthMemories[] = {DepthMemory::classic, DepthMemory::rectangle, DepthMemory::small,
                                                 DepthMemory::small_and_pixels};

/// The measurements of the paper on dynamic z-buffers: 60,000 polygons, a Pentium 4 at 2.66 GHz.
struct PaperFigures {
  std::uint32_t kilobytes;
  double milliseconds;
};

/// One picture: the figure's bounding rectangle is a square.
struct DynamicZPicture {
  std::uint16_t side;          ///< pixels
  std::uint32_t little_bytes;  ///< for DepthMemory::small and small_and_pixels
  bool classic_right;          ///< the classic picture was correct in the paper; `classic` then has its figures
  PaperFigures classic, dynamic;
};

/// Sizes in ascending order.
std::span<const DynamicZPicture> dynamic_z_pictures();

/// "classic", "rectangle", "small", "small-and-pixels".
std::string_view name(DepthMemory memory);

/// Returns the planner's budget for a row; bytes == 0: no limit.
Budget budget_of(const DynamicZPicture& picture, DepthMemory memory);

/// One row of the table, with all its memory, which can be drawn repeatedly.
class DynamicZDrawing {
 public:
  /// `knot` must outlive it. Fails with ExitStatus::budget if little_bytes are too few.
  static Result<DynamicZDrawing> prepare(const TorusKnot& knot, const DynamicZPicture& picture, DepthMemory memory);
  /// Returns the drawing that judges all rows of a picture: the figure in a view of kJudgeSide, larger than all
  /// pictures.
  static Result<DynamicZDrawing> prepare_judge(const TorusKnot& knot, const DynamicZPicture& picture);

  /// Draws: the measured work.
  Status draw();
  /// Draws into the middle of a picture of kJudgeSide x kJudgeSide pixels.
  Status draw_into(std::vector<std::uint16_t>& judged);
  /// Draws once more with effect::statistics, which draw() and draw_into() do not use.
  Result<Statistics> count_work();

  const View& view() const { return view_; }
  const Plan& plan() const { return plan_; }
  std::uint32_t pixel_bytes() const { return plan_.strip_pixel_bytes(view_); }
  /// Returns the part of the view whose z-buffer the last draw cleared.
  Rect cleared() const { return renderer_.frame().bounds(); }

 private:
  DynamicZDrawing(const TorusKnot& knot, const DynamicZPicture& picture, const View& view, bool whole_view);
  static Result<DynamicZDrawing> planned(DynamicZDrawing drawing, const Budget& budget);
  std::span<std::byte> arena() { return std::as_writable_bytes(std::span(arena_)).first(plan_.bytes()); }
  Scene scene() const;
  template <typename AfterStrip>
  Status draw_strips(AnyRenderer& renderer, AfterStrip after_strip);

  View view_;
  Camera camera_;
  std::vector<Mesh> meshes_;
  std::vector<Instance> instances_;
  Effects effects_;
  AnyRenderer renderer_;
  Plan plan_{};
  std::vector<std::uint64_t> arena_;
  std::vector<std::uint16_t> pixels_;
};

/// Side of the judge's picture, in pixels.
inline constexpr std::uint16_t kJudgeSide = 2304;

}  // namespace zstrip::sim
