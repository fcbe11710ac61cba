// Chooses the words of a triangle's planes.
#include "zstrip/kernels/triangle_planes.hpp"

#include <algorithm>
#include <cstdint>

namespace zstrip::detail {

WordOrLongPlanes::WordOrLongPlanes(const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2,
                                   std::int64_t area, std::int32_t anchor_x, std::int32_t anchor_y)
    : v0_(v0), v1_(v1), v2_(v2), area_(area), anchor_x_(anchor_x), anchor_y_(anchor_y), fits_words_(false) {
  if (area >> 25 != 0) return;
  const auto short_area = static_cast<std::int32_t>(area);
  const auto is_short = [short_area](const RasterVertex& a, const RasterVertex& b) {
    const std::int32_t dx = a.x - b.x, dy = a.y - b.y;
    return sides_fit_words(std::max({dx, -dx, dy, -dy}), short_area);
  };
  // The third side has no weight.
  if (!is_short(v0, v2) || !is_short(v1, v0)) return;
  words_ = WordPlanes<void>(v0, v1, v2, short_area, anchor_x, anchor_y);
  fits_words_ = true;
}

Plane WordOrLongPlanes::long_plane(std::int64_t value_0, std::int64_t from_0_to_1, std::int64_t from_0_to_2) const {
  return setup().plane(value_0, from_0_to_1, from_0_to_2);
}

}  // namespace zstrip::detail
