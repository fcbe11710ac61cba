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
    DecodedTiles::Tile& tile = decoded.tiles[ty % DecodedTiles::kSide][tx % DecodedTiles::kSide];
    if (tile.column != tx || tile.row != ty) decode(tile, tx, ty, status);
    return tile.cells[row % kTileSide * kTileSide + column % kTileSide];
  }
  /// True if a caster lies between a point and the light. If the caster is far from the point, the nearest texel
  /// decides. If it is close, and so may be the point's own surface, all four texels around the point must hide it: on
  /// a plane, or on a surface that bulges towards the light, at least one of them is not nearer than the point.
  bool hides(const MapPoint& at, Status& status) {
    const std::int32_t column = at.column >> place.texel_bits, row = at.row >> place.texel_bits;
    const std::int32_t distance = distance_to(column, row, at, status);
    if (distance <= 0 || distance > place.contact) return distance > 0;
    const auto beside = [this](std::int32_t texels) { return (texels >> (place.texel_bits - 1) & 1) != 0 ? 1 : -1; };
    const std::int32_t other_column = column + beside(at.column), other_row = row + beside(at.row);
    return distance_to(other_column, row, at, status) > 0 && distance_to(column, other_row, at, status) > 0 &&
           distance_to(other_column, other_row, at, status) > 0;
  }

 private:
  /// Returns the distance from a point to the caster at a texel, towards the light, in units of MapPoint::code; 0 if
  /// there is no such caster.
  std::int32_t distance_to(std::int32_t column, std::int32_t row, const MapPoint& at, Status& status) {
    const auto side = static_cast<std::int32_t>(store.grid().width);
    if (column < 0 || row < 0 || column >= side || row >= side) return 0;
    const std::uint32_t caster = code_at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), status);
    if (caster == 0) return 0;
    const std::uint32_t code = place.code_bits >= 0 ? caster << place.code_bits : caster >> -place.code_bits;
    return static_cast<std::int32_t>(code) - at.code - at.doubt;
  }
  void decode(DecodedTiles::Tile& tile, std::uint32_t tx, std::uint32_t ty, Status& status);
};
static_assert(sizeof(ShadowState) <= shadows::Effect::kStateBytes);

/// Removes the shadow's light, the last one, from an instance that receives shadows (by = -1), or restores it (1).
inline void leave_shadowing_light(CompiledInstance& instance, const Mesh& mesh, int by) {
  if ((instance.lit || has_lit_fragments(instance.shade)) && receives_shadow(mesh.shadow)) {
    instance.light_count = static_cast<std::uint8_t>(instance.light_count + by);
  }
}

}  // namespace zstrip::detail
