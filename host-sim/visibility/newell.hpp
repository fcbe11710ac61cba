// Sorts polygons in the painter's order for one camera, and splits polygons that have no order (Newell, Newell and
// Sancha, "A Solution to the Hidden Surface Problem", 1972). Runs on the host, because no plan could bound the number
// of pieces.
#pragma once

#include <cstddef>

#include "result.hpp"
#include "visibility/polygon_soup.hpp"
#include "zstrip/camera.hpp"

namespace zstrip::sim {

struct NewellOrder {
  PolygonSoup soup;  ///< from far to near
  std::size_t splits = 0;
  std::size_t moved = 0;  ///< polygons that were drawn before the first polygon by distance
};

/// Leaves out polygons that the camera cannot see because they are behind the near plane, and cuts the others there.
/// Returns a usage error if more than 20,000 pieces or 50 million comparisons are needed.
Result<NewellOrder> newell_order(const PolygonSoup& soup, const Camera& camera);

}  // namespace zstrip::sim
