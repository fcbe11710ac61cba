// The tables of `zstrip bench` that compare visibility methods: midpoint, thesis and depth-bits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "result.hpp"
#include "visibility/drawing.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::sim {

/// One row, before the measurement.
struct VisibilityRowCase {
  std::string scene;  ///< a built-in scene, or kLayers
  View view;
  std::string method;  ///< one of visibility_methods()
  std::uint8_t iterations = 0;
  DepthFormat depth_format = DepthFormat::z16;
};

/// Pairs of squares, one just behind the other, from near to far, which depth formats must distinguish.
inline constexpr std::string_view kLayers = "layers";

struct VisibilityRow {
  VisibilityRowCase row_case;
  Plan plan;
  std::uint64_t comparisons = 0;  ///< comparisons of depth with cells, tiles and nodes
  std::uint64_t cells_read = 0;   ///< cells read in addition, for bounds
  std::uint64_t fragments = 0, writes = 0;
  std::uint64_t written = 0;  ///< pixels that were written at least once
  std::uint64_t wrong = 0;    ///< wrong pixels, by the judge in double precision
  std::size_t splits = 0;     ///< triangles split by host or renderer
  std::optional<std::uint64_t> instructions;
  double nanoseconds = 0;  ///< of one frame, minimum of several, without counts
};

/// "midpoint", "thesis", "depth-bits".
std::span<const std::string_view> visibility_tables();
/// Returns the rows of a table in their order.
std::vector<VisibilityRowCase> rows_of_table(std::string_view table);

/// Takes up to a minute; shows progress on stderr. Instructions are counted by valgrind, only for `thesis`.
Result<std::vector<VisibilityRow>> measure_visibility(std::string_view table);
/// Measures one row without instructions.
Result<VisibilityRow> measure_visibility_row(const VisibilityRowCase& row_case, std::uint32_t rounds);
/// Draws a row `draws` times without measurements; this runs under valgrind.
Result<Done> draw_visibility_row_only(std::string_view table, std::uint32_t row, std::uint32_t draws);

/// Returns the table for display, followed by the figures of the texts.
std::string visibility_text(std::string_view table, std::span<const VisibilityRow> rows);
std::string visibility_json(std::string_view table, std::span<const VisibilityRow> rows);

}  // namespace zstrip::sim
