// The data that a frame keeps for its shadow: the map in a compressed store, decoded tiles of it, and the mapping from
// the picture to the map.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/effects/shadows/effect.hpp"
#include "zstrip/effects/shadows/shadow_place.hpp"
#include "zstrip/store/depth_store.hpp"

namespace zstrip::detail {

/// The tiles that were read last, by column and row of tiles modulo kSide.
struct DecodedTiles {
  static constexpr std::uint32_t kSide = 4;
  struct Tile {
    std::uint16_t column, row;  ///< 0xFFFF: empty
    std::uint16_t cells[kTileCells];
  };
  Tile tiles[kSide][kSide];

  void forget() {
    for (auto& row : tiles) {
      for (Tile& tile : row) tile.column = tile.row = 0xFFFF;
    }
  }
};

struct ShadowState {
  Scene scene;                          ///< the frame's scene with these lights
  DirectionalLight lights[kMaxLights];  ///< lights of the scene; the shadow's light is the last one
  std::span<std::byte> pool;
  DepthStore store;
  Camera camera;
  DepthFit fit;
  bool empty;  ///< there are no casters
  ShadowPlace place;
  Colour* colours_in_shadow = nullptr;  ///< only in binned mode: colours of the kept vertices
  DecodedTiles decoded;

  /// Returns the map's code at a texel inside it. If the store is damaged, sets an error in `status`, once.
  std::uint32_t code_at(std::uint32_t column, std::uint32_t row, Status& status) {
    const std::uint32_t tx = column / kTileSide, ty = row / kTileSide;
    DecodedTiles::Tile* tile = &decoded.tiles[ty % DecodedTiles::kSide][tx % DecodedTiles::kSide];
    if (tile->column != tx || tile->row != ty) tile = &decode(*tile, tx, ty, status);
    return tile->cells[row % kTileSide * kTileSide + column % kTileSide];
  }
  /// True if a caster lies between a point and the light. If the caster is far from the point, the nearest texel
  /// decides. If it is close, and so may be the point's own surface, all four texels around the point must hide it: on
  /// a plane, or on a surface that bulges towards the light, at least one of them is not nearer than the point.
  template <class Point>
  bool hides(const Point& at, Status& status) {
    const std::int32_t across = at.column(), column = across >> place.texel_bits;
    if (!has(column)) return false;
    const std::int32_t down = at.row(), row = down >> place.texel_bits;
    const std::uint32_t nearest = caster_at(column, row, status);
    if (nearest == 0) return false;
    const MapDepth depth = at.depth();
    const std::int32_t distance = distance_to(nearest, depth);
    if (distance <= 0 || distance > place.contact) return distance > 0;
    return hidden_beside(across, down, depth, status);
  }

 private:
  /// True if the map has such a column, or row; one comparison, as it is as wide as it is high.
  bool has(std::int32_t column_or_row) const { return static_cast<std::uint32_t>(column_or_row) < store.grid().width; }
  /// Returns the code of the caster at a texel, 0 if there is none.
  std::uint32_t caster_at(std::int32_t column, std::int32_t row, Status& status) {
    if (!has(column) || !has(row)) return 0;
    return code_at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), status);
  }
  /// Returns the distance from a point to a caster, towards the light, in units of MapDepth::code.
  std::int32_t distance_to(std::uint32_t caster, const MapDepth& point) const {
    const std::uint32_t code = place.code_bits >= 0 ? caster << place.code_bits : caster >> -place.code_bits;
    return static_cast<std::int32_t>(code) - point.code - point.doubt;
  }
  /// True if casters at the other three of the four texels around a point hide it. A call, as few points come here.
  bool hidden_beside(std::int32_t across, std::int32_t down, const MapDepth& point, Status& status);
  /// Returns `tile`, so that compilers do not compute its address again.
  DecodedTiles::Tile& decode(DecodedTiles::Tile& tile, std::uint32_t tx, std::uint32_t ty, Status& status);
};
static_assert(sizeof(ShadowState) <= shadows::Effect::kStateBytes);

/// Removes the shadow's light, the last one, from an instance that receives shadows (by = -1), or restores it (1).
inline void leave_shadowing_light(CompiledInstance& instance, const Mesh& mesh, int by) {
  if ((instance.lit || has_lit_fragments(instance.shade)) && receives_shadow(mesh.shadow)) {
    instance.light_count = static_cast<std::uint8_t>(instance.light_count + by);
  }
}

}  // namespace zstrip::detail
