// The blocks of a triangle that has its plane of depth already.
#include "zstrip/kernels/sse2/medium_triangle.hpp"

#include <algorithm>

#include "zstrip/kernels/sse2/blocks.hpp"

#if ZSTRIP_HAS_SSE2

namespace zstrip::detail {

using namespace blocks;

bool draw_medium_flat_sse2(const StripTarget& target, const RasterVertex& v0, const RasterVertex& v1,
                           const RasterVertex& v2, const Plane& depth, std::int32_t anchor_x, std::int32_t anchor_y,
                           std::uint16_t colour) {
  const auto [min_x, max_x] = std::minmax({v0.x, v1.x, v2.x});
  const auto [min_y, max_y] = std::minmax({v0.y, v1.y, v2.y});
  if (max_x - min_x + max_y - min_y >= kMediumExtent) return false;
  const Rect& strip = target.area;
  const Rect box{std::max(min_x >> 4, strip.left), std::max(min_y >> 4, strip.top), std::min(max_x >> 4, strip.right),
                 std::min(max_y >> 4, strip.bottom)};
  if (box.empty()) return true;
  const Blocks blocks(target, box);
  if (!blocks.fit()) return false;
  const Edges edges(v0, v1, v2);
  const __m128i z = stepped_words(depth.at(blocks.left - anchor_x, blocks.top - anchor_y), depth.step_x);
  ChannelBlock no_channels[3];
  blocks.draw<false>(edges, edges.at(blocks.left, blocks.top), z, in_all_words(depth.step_x),
                     in_all_words(depth.step_y), no_channels, colour);
  return true;
}

}  // namespace zstrip::detail

#endif
