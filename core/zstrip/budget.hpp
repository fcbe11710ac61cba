// What the planner takes and gives: counts of a scene, a budget, and the plan. Types only; comes with plan.hpp.
#pragma once

#include <cstdint>

#include "zstrip/plan/layer_bytes.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// What a plan needs to know of a scene. 0xFFFFFFFF: that many or more. An outline counts as an instance of its hull.
struct SceneCounts {
  std::uint32_t instances = 0;        ///< and outlines
  std::uint32_t triangles = 0;        ///< of all instances
  std::uint32_t vertices = 0;         ///< of all meshlets of all instances: shared ones count in each
  std::uint32_t largest_meshlet = 0;  ///< most vertices that one meshlet uses
  std::uint32_t meshlets = 0;         ///< of all instances; a mesh without any counts as one
  std::uint32_t longest_meshlet = 0;  ///< most triangles in one meshlet
  std::uint32_t quadrics = 0;         ///< of Scene::quadrics
  std::uint32_t line_sets = 0;        ///< of Scene::lines
  std::uint32_t shadow_side = 0;      ///< of the shadow map, in texels
  std::uint32_t shadow_pool = 0;      ///< bytes of the pool that it is compressed in
  std::uint32_t csg_operands = 0;     ///< of Scene::csg
  std::uint32_t edge_groups = 0;      ///< of edges that are anti-aliased, of all instances: kEdgesOfGroup each
  bool colours_in_place = false;      ///< nothing lights or tints colours of vertices: they are read from the meshes
};

/// How geometry gets into the strips.
enum class Mode : std::uint8_t {
  streamed,  ///< strips transform the meshlets that touch them again: least memory
  binned,    ///< geometry is transformed once, triangles wait in a list for each strip: least time
};

/// Which modes the planner may choose from; `any` is both where the effects have effect::bins.
enum class Modes : std::uint8_t {
  any,       ///< the faster one that fits
  streamed,  ///< Mode::streamed alone
  binned,    ///< Mode::binned alone where there are several strips; needs effect::bins
};

/// What the caller allows. Zero means: the planner decides.
struct Budget {
  std::uint32_t bytes = 0;          ///< at most, for the arena, `strip_buffers` and `layer`; 0 is kMaxArena
  std::uint16_t strip_rows = 0;     ///< rows of a strip; 0 is as many as are fastest
  std::uint16_t strip_columns = 0;  ///< pixels of a strip's row: a multiple of 8, or the view's width; 0: the width,
                                    ///< or what is fastest if `split_columns`
  bool split_columns = false;       ///< the display takes rectangles that are narrower than the picture
  std::uint8_t strip_buffers = 0;   ///< buffers of strip_pixel_bytes() that `bytes` has to hold, too: 0 .. 2
  Modes modes = Modes::any;         ///< without effect::bins all plans are streamed
  LayerBytes layer{};  ///< of a static layer that keeps this picture: its strips then begin and end between tiles
};

inline constexpr std::uint32_t kArenaAlignment = 8;     ///< bytes
inline constexpr std::uint32_t kMaxArena = 0xFFFFFFF0;  ///< bytes; needs beyond it are refused

/// How a picture is cut into strips, and the bytes of the arena by purpose. Good for any frame of a scene with the same
/// counts.
struct Plan {
  Mode mode = Mode::streamed;        ///< how geometry gets into the strips
  std::uint16_t strip_rows = 0;      ///< pixels; the last strips of a column may have fewer
  std::uint16_t strip_columns = 0;   ///< the view's width where strips are not split
  std::uint16_t strips = 0;          ///< row by row, from left to right
  std::uint32_t instance_bytes = 0;  ///< of quadrics and sets of lines, too
  std::uint32_t extent_bytes = 0;    ///< which strips a meshlet touches; none for a single streamed strip
  std::uint32_t vertex_bytes = 0;    ///< transformed vertices: of a meshlet, or of all where they are binned
  std::uint32_t depth_bytes = 0;     ///< a cell a sample; with effect::edges a pixel more on each side
  std::uint32_t colour_bytes = 0;  ///< RGB565 working strip; only for formats that are not drawn in place, samples and
                                   ///< edges
  std::uint32_t bin_bytes = 0;     ///< lists of triangles, one a strip; none where streamed
  std::uint32_t effect_bytes = 0;  ///< what effects keep through a frame: fog, local light, drawing order,
                                   ///< what CSG notes of a strip's pixels
  std::uint32_t visibility_bytes = 0;  ///< what a visibility method keeps: order of triangles, or bounds of depth
  /// The arena. It must be aligned to kArenaAlignment. Of a plan that `plan` returned never more than kMaxArena.
  constexpr std::uint32_t bytes() const {
    const std::uint64_t sum = wide_bytes();
    return sum > kMaxArena ? kMaxArena : static_cast<std::uint32_t>(sum);
  }
  /// The same without a limit, for plans from elsewhere.
  constexpr std::uint64_t wide_bytes() const {
    return std::uint64_t{instance_bytes} + extent_bytes + vertex_bytes + depth_bytes + colour_bytes + bin_bytes +
           effect_bytes + visibility_bytes;
  }
  /// The caller's pixel buffer for one strip.
  constexpr std::uint32_t strip_pixel_bytes(const View& view) const {
    return strip_rows * bytes_per_row(strip_columns, view.format);
  }
  /// Strips side by side.
  constexpr std::uint32_t columns_of_strips(const View& view) const {
    return (std::uint32_t{view.width} + strip_columns - 1U) / strip_columns;
  }
  /// Strips one below the other.
  constexpr std::uint32_t rows_of_strips(const View& view) const {
    return (std::uint32_t{view.height} + strip_rows - 1U) / strip_rows;
  }
  /// The pixels of a strip in the picture; the last ones of a row or column may be smaller. Its pixels lie without
  /// gaps: a row has bytes_per_row(area.width(), format) bytes.
  constexpr Rect strip_area(std::uint16_t strip, const View& view) const {
    const std::uint32_t across = columns_of_strips(view);
    const std::uint32_t left = strip % across * strip_columns;
    const std::uint32_t top = strip / across * strip_rows;
    const std::uint32_t right = left + strip_columns < view.width ? left + strip_columns : view.width;
    const std::uint32_t bottom = top + strip_rows < view.height ? top + strip_rows : view.height;
    return {static_cast<std::int32_t>(left), static_cast<std::int32_t>(top), static_cast<std::int32_t>(right),
            static_cast<std::int32_t>(bottom)};
  }
};

/// If `status` is ok, `plan` is valid: then it is the one of least estimated_cost that fits. If not, what is missing
/// (Error::arena_too_small with the bytes that the smallest possible plan needs, the limit, and the purpose that takes
/// the most of them), and `plan` is that smallest one. (With Modes::binned alone: the smallest of those that were
/// tried.)
struct PlanResult {
  Status status;  ///< Error::none: the plan fits the budget
  Plan plan;      ///< of least estimated_cost, or the smallest possible one
};

}  // namespace zstrip
