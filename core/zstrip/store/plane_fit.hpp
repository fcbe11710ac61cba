// Finds a plane that gives the cells of a tile exactly, if there is one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "zstrip/store/depth_record.hpp"

namespace zstrip::detail {

/// A tile in the encoder: row y starts at cell 8 y. Cells that are not covered are ignored.
struct CoveredCells {
  std::array<std::uint16_t, kTileCells> cells{};
  Cover cover{};
  std::uint32_t width = 0, height = 0;
};

/// The fields of a record's plane, in the shortest form that gives every covered cell.
struct FittedPlane {
  const PlaneForm* form;
  std::uint32_t more_fraction;  ///< 0..7: fraction bits of the slopes, in addition to those of the start
  std::uint32_t start;
  std::int32_t slope_x, slope_y;
};

/// At least one cell must be covered. Deterministic. Finds nearly every plane that a form can represent, but not all.
std::optional<FittedPlane> fit_plane(const CoveredCells& tile);

}  // namespace zstrip::detail
