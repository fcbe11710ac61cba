// Input and output of the planner: counts of a scene, a budget with a static layer's memory, and the plan. Types only;
// plan.hpp includes this file.
#pragma once

#include <cstdint>

#include "zstrip/status.hpp"
#include "zstrip/store/store_bytes.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// Bytes of each part of StaticLayer::Memory. All 0: no static layer.
struct LayerBytes {
  std::uint32_t depth = 0;   ///< the pool of depth
  std::uint32_t colour = 0;  ///< the pool of colour
  std::uint32_t dirty = 0;   ///< one bit for each tile

  /// Returns the bytes of all parts.
  constexpr std::uint64_t sum() const { return std::uint64_t{depth} + colour + dirty; }
};

/// Returns the bytes with pools of these sizes, which `zstrip plan` measures for a scene.
constexpr LayerBytes layer_bytes(const View& view, std::uint32_t depth_pool, std::uint32_t colour_pool) {
  return {depth_pool, colour_pool, 4 * dirty_tile_words(view.width, view.height)};
}

/// Returns the bytes with which every background fits, whatever it shows.
constexpr LayerBytes layer_bytes_worst(const View& view) {
  const std::uint32_t pool = store_bytes_worst(view.width, view.height);
  return layer_bytes(view, pool, pool);
}

/// The numbers of a scene that a plan depends on. 0xFFFFFFFF: that many or more. An outline counts as a hull's
/// instance.
struct SceneCounts {
  std::uint32_t instances = 0;        ///< with outlines
  std::uint32_t triangles = 0;        ///< sum over all instances
  std::uint32_t vertices = 0;         ///< sum over the meshlets of all instances: a shared vertex counts in each
                                      ///< meshlet
  std::uint32_t largest_meshlet = 0;  ///< the largest number of vertices that one meshlet uses
  std::uint32_t meshlets = 0;         ///< sum over all instances; a mesh without meshlets counts as one
  std::uint32_t longest_meshlet = 0;  ///< the largest number of triangles in one meshlet
  std::uint32_t quadrics = 0;         ///< number of Scene::quadrics
  std::uint32_t line_sets = 0;        ///< number of Scene::lines
  std::uint32_t shadow_side = 0;      ///< side of the shadow map, in texels
  std::uint32_t shadow_pool = 0;      ///< bytes of the pool for the compressed shadow map
  std::uint32_t csg_operands = 0;     ///< number of Scene::csg
  std::uint32_t edge_groups = 0;      ///< groups of kEdgesOfGroup anti-aliased edges, sum over all instances
  bool colours_in_place = false;      ///< vertex colours are neither lit nor tinted: they are read from the meshes
};

/// The way in which geometry gets into the strips.
enum class Mode : std::uint8_t {
  streamed,  ///< each strip transforms the meshlets that touch it again: least memory
  binned,    ///< geometry is transformed once, and each strip has a list of its triangles: least time
};

/// The modes that the planner may choose from. `any` means both modes if the effects have effect::bins.
enum class Modes : std::uint8_t {
  any,       ///< the faster one that fits
  streamed,  ///< Mode::streamed alone
  binned,    ///< Mode::binned alone if there are several strips; needs effect::bins
};

/// Limits that the caller sets. 0: the planner decides.
struct Budget {
  std::uint32_t bytes = 0;          ///< upper limit for the arena, `strip_buffers` and `layer`; 0 is kMaxArena
  std::uint16_t strip_rows = 0;     ///< rows of a strip; 0: the fastest number
  std::uint16_t strip_columns = 0;  ///< pixels of a strip's row: a multiple of 8, or the view's width; 0: the width, or
                                    ///< the fastest number with `split_columns`
  bool split_columns = false;       ///< the display accepts rectangles that are narrower than the picture
  std::uint8_t strip_buffers = 0;   ///< buffers of strip_pixel_bytes() that `bytes` must also hold: 0..2
  Modes modes = Modes::any;         ///< without effect::bins all plans are streamed
  LayerBytes layer{};  ///< the static layer that keeps this picture: strips then begin and end at borders of tiles
};

inline constexpr std::uint32_t kArenaAlignment = 8;     ///< bytes
inline constexpr std::uint32_t kMaxArena = 0xFFFFFFF0;  ///< bytes; a plan that needs more is refused

/// The strips of a picture, and the bytes of the arena by purpose. Valid for every frame with the same counts.
struct Plan {
  Mode mode = Mode::streamed;        ///< how geometry gets into the strips
  std::uint16_t strip_rows = 0;      ///< pixels; the last strips of a column may have fewer
  std::uint16_t strip_columns = 0;   ///< pixels; the view's width if rows are not split
  std::uint16_t strips = 0;          ///< numbered row by row, from left to right
  std::uint32_t instance_bytes = 0;  ///< for instances, quadrics and sets of lines
  std::uint32_t extent_bytes = 0;    ///< the strips that each meshlet touches; 0 for a single streamed strip
  std::uint32_t vertex_bytes = 0;    ///< transformed vertices: of one meshlet, or of all meshlets in Mode::binned
  std::uint32_t depth_bytes = 0;     ///< one cell a sample; with effect::edges one more pixel on each side
  std::uint32_t colour_bytes = 0;  ///< RGB565 working strip, only for samples, edges, and formats that are not drawn in
                                   ///< place
  std::uint32_t bin_bytes = 0;     ///< one list of triangles for each strip; 0 in Mode::streamed
  std::uint32_t effect_bytes = 0;  ///< data that effects keep during a frame: fog, local light, drawing order, and the
                                   ///< notes of CSG about a strip's pixels
  std::uint32_t visibility_bytes = 0;  ///< data of a visibility method: order of triangles, or bounds of depth
  /// Returns the bytes of the arena, which must be aligned to kArenaAlignment. A plan that `plan` returned never needs
  /// more than kMaxArena.
  constexpr std::uint32_t bytes() const {
    const std::uint64_t sum = wide_bytes();
    return sum > kMaxArena ? kMaxArena : static_cast<std::uint32_t>(sum);
  }
  /// Returns the sum without the limit, for plans that `plan` did not make.
  constexpr std::uint64_t wide_bytes() const {
    return std::uint64_t{instance_bytes} + extent_bytes + vertex_bytes + depth_bytes + colour_bytes + bin_bytes +
           effect_bytes + visibility_bytes;
  }
  /// Returns the bytes of the caller's pixel buffer for one strip.
  constexpr std::uint32_t strip_pixel_bytes(const View& view) const {
    return strip_rows * bytes_per_row(strip_columns, view.format);
  }
  /// Returns the number of strips side by side.
  constexpr std::uint32_t columns_of_strips(const View& view) const {
    return (std::uint32_t{view.width} + strip_columns - 1U) / strip_columns;
  }
  /// Returns the number of strips one below the other.
  constexpr std::uint32_t rows_of_strips(const View& view) const {
    return (std::uint32_t{view.height} + strip_rows - 1U) / strip_rows;
  }
  /// Returns the pixels of a strip in the picture. The last strips of a row or column may be smaller. The pixels lie in
  /// the buffer without gaps: a row has bytes_per_row(area.width(), format) bytes.
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

/// If `status` is ok, `plan` is the plan of least estimated_cost that fits the budget. If not, `status` is
/// Error::arena_too_small with the bytes that the smallest possible plan needs, the limit, and the purpose that takes
/// the most bytes; `plan` is then that smallest plan. With Modes::binned it is the smallest plan that was tried.
struct PlanResult {
  Status status;  ///< Error::none: the plan fits the budget
  Plan plan;      ///< the plan of least estimated_cost, or the smallest possible one
};

}  // namespace zstrip
