// Puts polygons in the painter's order for one camera, and splits what has none (Newell, Newell and Sancha, "A Solution
// to the Hidden Surface Problem", 1972). On the host: no plan could bound the number of pieces.
#pragma once

#include <cstddef>

#include "result.hpp"
#include "visibility/polygon_soup.hpp"
#include "zstrip/camera.hpp"

namespace zstrip::sim {

struct NewellOrder {
  PolygonSoup soup;  ///< from far to near
  std::size_t splits = 0;
  std::size_t moved = 0;  ///< polygons that were drawn before the one that was first by distance
};

/// Polygons that a camera cannot see, all behind the near plane, are left out; the others are cut there. A usage error
/// if more than 20,000 pieces or 50 million comparisons were needed.
Result<NewellOrder> newell_order(const PolygonSoup& soup, const Camera& camera);

}  // namespace zstrip::sim
