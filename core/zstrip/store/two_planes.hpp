// Finds two planes that together give the cells of a tile exactly: tiles on an edge between two flat faces.
#pragma once

#include <optional>

#include "zstrip/store/plane_fit.hpp"

namespace zstrip::detail {

/// `first` gives the cells of its cover, `others` all other cells.
struct TwoPlanes {
  Cover cover{};
  FittedPlane first, others;

  std::uint32_t bytes() const { return 1U + first.form->bytes + others.form->bytes; }  ///< after the cover
};

/// All cells of the tile must be covered. Finds most pairs of planes that meet in one line, not all of them.
std::optional<TwoPlanes> fit_two_planes(const CoveredCells& tile);

}  // namespace zstrip::detail
