// The tables of `zstrip bench` that set visibility methods side by side: midpoint, thesis and depth-bits.
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

/// One row, before it is measured.
struct VisibilityRowCase {
  std::string scene;  ///< a built-in one, or kLayers
  View view;
  std::string method;  ///< of visibility_methods()
  std::uint8_t iterations = 0;
  DepthFormat depth_format = DepthFormat::z16;
};

/// Pairs of squares, one just behind the other, from near to far: what depth formats must tell apart.
inline constexpr std::string_view kLayers = "layers";

struct VisibilityRow {
  VisibilityRowCase row_case;
  Plan plan;
  std::uint64_t comparisons = 0;  ///< of depth with cells, tiles and nodes
  std::uint64_t cells_read = 0;   ///< besides, for bounds
  std::uint64_t fragments = 0, writes = 0;
  std::uint64_t written = 0;  ///< pixels that were written at all
  std::uint64_t wrong = 0;    ///< pixels, by the judge in double precision
  std::size_t splits = 0;     ///< of triangles, by host or renderer
  std::optional<std::uint64_t> instructions;
  double nanoseconds = 0;  ///< of one frame, least of several, without counting
};

/// "midpoint", "thesis", "depth-bits".
std::span<const std::string_view> visibility_tables();
/// The rows of a table in their order.
std::vector<VisibilityRowCase> rows_of_table(std::string_view table);

/// Takes up to a minute; shows on stderr how far it is. Instructions, counted by valgrind, only of `thesis`.
Result<std::vector<VisibilityRow>> measure_visibility(std::string_view table);
/// One row without instructions.
Result<VisibilityRow> measure_visibility_row(const VisibilityRowCase& row_case, std::uint32_t rounds);
/// Draws a row `draws` times, measuring nothing: what runs under valgrind.
Result<Done> draw_visibility_row_only(std::string_view table, std::uint32_t row, std::uint32_t draws);

/// The table for people, with the texts' figures below.
std::string visibility_text(std::string_view table, std::span<const VisibilityRow> rows);
std::string visibility_json(std::string_view table, std::span<const VisibilityRow> rows);

}  // namespace zstrip::sim
