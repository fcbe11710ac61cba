// The bytes of a frame's data in its arena, for given effects and counts.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip {

/// Bytes of the renderer's records; the stages that define them assert these sizes on every target.
inline constexpr std::uint32_t kInstanceBytes = 160;
inline constexpr std::uint32_t kQuadricBytes = 384;
inline constexpr std::uint32_t kLineSetBytes = 176;
inline constexpr std::uint32_t kVertexBytes = 8;        // snapped x, y and depth
inline constexpr std::uint32_t kVertexColourBytes = 4;  // only with lighting or vertex colours
inline constexpr std::uint32_t kReflectionBytes = 4;    // coordinates in an environment map, only with
                                                        // effect::environment
inline constexpr std::uint32_t kExtentBytes = 4;        // the strips that a meshlet touches
inline constexpr std::uint32_t kBatchBytes = 8;         // a transformed meshlet, binned only
inline constexpr std::uint32_t kBinBytes = 8;           // a strip's list
inline constexpr std::uint32_t kBinChunkBytes = 32;     // part of a list: kBinChunkEntries and the number of the next
                                                        // chunk
inline constexpr std::uint32_t kBinChunkEntries = 15;
inline constexpr std::uint32_t kMaxBinChunks = 0xFFFF;
inline constexpr std::uint32_t kMaxBatches = 0x7FFF;          // limit of the numbers in bins
inline constexpr std::uint32_t kMaxListedTriangles = 0x7FFF;  // triangles of a meshlet; limit of the numbers in bins
inline constexpr std::uint32_t kMaxStrips = 0xFFFF;
inline constexpr std::uint32_t kDepthBytes = 2;          // a cell of the z-buffer, unless depth_bytes is 4
inline constexpr std::uint32_t kWorkingColourBytes = 2;  // RGB565

namespace detail {
/// Strips are split at whole bytes of every pixel format.
inline constexpr std::uint32_t kColumnStep = 8;

constexpr std::uint32_t rounded_up(std::uint64_t bytes) {
  const std::uint64_t aligned = (bytes + kArenaAlignment - 1) / kArenaAlignment * kArenaAlignment;
  return aligned > 0xFFFFFFFF ? 0xFFFFFFF8 : static_cast<std::uint32_t>(aligned);
}

/// Rounds the rows of a strip up to whole tiles, which a static layer can keep.
constexpr std::uint16_t whole_tiles(std::uint32_t rows, std::uint16_t height) {
  return static_cast<std::uint16_t>(std::min<std::uint32_t>((rows + kTileSide - 1) / kTileSide * kTileSide, height));
}

constexpr bool has_vertex_colours(Effects effects) { return effects.any(effect::lighting | effect::vertex_colours); }

/// Returns the bytes of a transformed vertex, without its reflection.
constexpr std::uint32_t coloured_bytes_per_vertex(Effects effects, const SceneCounts& counts) {
  return kVertexBytes + (has_vertex_colours(effects) && !counts.colours_in_place ? kVertexColourBytes : 0);
}
constexpr std::uint32_t bytes_per_vertex(Effects effects, const SceneCounts& counts) {
  return coloured_bytes_per_vertex(effects, counts) + (effects.has(effect::environment) ? kReflectionBytes : 0);
}

/// Returns the bytes of a vertex that bins keep: with shadows it has a second colour.
constexpr std::uint32_t retained_bytes_per_vertex(Effects effects, const SceneCounts& counts) {
  return bytes_per_vertex(effects, counts) + (effects.has(effect::shadows) ? kVertexColourBytes : 0);
}

/// True if strips are drawn with an apron: one pixel more on each side, inside the picture, because blending of edges
/// reads neighbours.
constexpr bool has_apron(Effects effects, const SceneCounts& counts) {
  return effects.has(effect::edges) && counts.edge_groups != 0;
}
constexpr std::uint64_t cells_with_apron(std::uint32_t rows, std::uint32_t columns, const View& view) {
  const auto wider = [](std::uint64_t side, std::uint64_t whole) { return side + 2 < whole ? side + 2 : whole; };
  return wider(rows, view.height) * wider(columns, view.width);
}

/// Returns the bytes for a strip with `cells` of `cell_bytes`: two layers of depth, a count and a mark for each cell.
constexpr std::uint64_t csg_strip_bytes(std::uint64_t cells, std::uint32_t cell_bytes) {
  return cells * (2 * cell_bytes + 2);
}

/// Returns the bytes for the z-buffer of a strip of the shadow map, which is one row of tiles, and for one row of
/// pixels that is never shown. begin_frame draws the map in the memory of the picture's z-buffer.
constexpr std::uint32_t shadow_strip_bytes(const SceneCounts& counts) {
  return (kTileSide * kDepthBytes + kWorkingColourBytes) * counts.shadow_side;
}

/// RGB565 is drawn straight into the caller's pixels; the other formats pass through a working strip.
constexpr bool drawn_in_place(PixelFormat format) {
  return format == PixelFormat::rgb565 || format == PixelFormat::rgb565_swapped;
}

/// Without these no fragment passes the depth test again once the z-buffer holds the codes of all that was drawn, so
/// that the codes alone keep pixels from a second pass.
inline constexpr Effects kMayPassAgain = effect::blending | effect::depth_state;

/// Returns the bytes of a strip with its apron before edges are blended and, if the caller's pixels are not RGB565, of
/// the strip's pixels after that.
constexpr std::uint64_t colour_bytes_of_edges(std::uint32_t rows, std::uint32_t columns, const View& view) {
  const std::uint64_t resolved = drawn_in_place(view.format) ? 0 : std::uint64_t{rows} * columns;
  return (cells_with_apron(rows, columns, view) + resolved) * kWorkingColourBytes;
}

/// True if the codes of a strip with its apron must survive the second pass of shadows.
constexpr bool saves_codes(Effects effects) {
  return effects.has(effect::edges | effect::shadows) && effects.any(kMayPassAgain);
}
/// Returns the bytes for codes that are saved but find no room in the strip's pixels.
constexpr std::uint64_t saved_bytes_of_edges(std::uint32_t rows, std::uint32_t columns, const View& view) {
  return (cells_with_apron(rows, columns, view) - std::uint64_t{rows} * columns) * kDepthBytes;
}

/// With several samples a pixel, strips are not drawn in place: pixels are means of samples.
constexpr bool drawn_in_place(const View& view) { return drawn_in_place(view.format) && view.samples == 1; }

constexpr std::uint64_t instance_bytes(const SceneCounts& counts) {
  return std::uint64_t{counts.instances} * kInstanceBytes + std::uint64_t{counts.quadrics} * kQuadricBytes +
         std::uint64_t{counts.line_sets} * kLineSetBytes;
}

constexpr Purpose largest_purpose(const Plan& plan, const LayerBytes& layer = {},
                                  Purpose of_visibility = Purpose::sorting) {
  Purpose purpose = Purpose::instances;
  std::uint64_t most = plan.instance_bytes;
  const auto consider = [&](Purpose candidate, std::uint64_t bytes) {
    if (bytes > most) purpose = candidate, most = bytes;
  };
  consider(Purpose::extents, plan.extent_bytes);
  consider(Purpose::vertices, plan.vertex_bytes);
  consider(Purpose::depth, plan.depth_bytes);
  consider(Purpose::colour, plan.colour_bytes);
  consider(Purpose::bins, plan.bin_bytes);
  consider(Purpose::layer, layer.sum());
  consider(Purpose::effects, plan.effect_bytes);
  consider(of_visibility, plan.visibility_bytes);
  return purpose;
}
}  // namespace detail

}  // namespace zstrip
