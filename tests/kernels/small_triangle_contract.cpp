// Small triangles: the planes of their set-up, a scan of the whole box, and flat and shaded ones in strips that cut
// them. Anywhere in the narrow range, boxes of all sizes up to the largest, slivers among them.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "contracts.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "zstrip/geometry/depth_fit.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/small_triangle.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

constexpr std::int32_t kSide = 16;  // pixels: no small triangle's box is wider or higher
static_assert(kSmallExtent <= 16 * kSide);

struct Small {
  SnappedVertex v[3];
  Colour colours[3];
  std::int32_t area;
  Rect box;  ///< the whole one
};

/// A box of any size that is small, whose half perimeter is now and then the largest.
void place(Random& random, std::uint32_t number, Small& small) {
  const bool large = number % 2 == 0;
  const std::int32_t half = large ? kSmallExtent - 1 : random.between(2, kSmallExtent - 1);
  const std::int32_t width = random.between(1, half - 1), height = half - width;
  const bool far = number % 4 < 2;
  const std::int32_t left = far ? random.within(8000) : random.within(64);
  const std::int32_t top = far ? random.within(8000) : random.within(64);
  const std::uint32_t depth = kSmallDepthDifference + random.word() / 4;
  const std::uint32_t range = number % 3 == 0 ? kSmallDepthDifference / 2 : std::uint32_t{1} << random.between(10, 27);
  for (int i = 0; i < 3; ++i) {
    small.v[i].x = static_cast<std::int16_t>(left + random.between(0, width));
    small.v[i].y = static_cast<std::int16_t>(top + random.between(0, height));
    small.v[i].depth = depth + random.word() % range;
    if (number % 5 < 2) small.v[i].depth = snap_depth(small.v[i].depth);
    small.colours[i] = random.colour();
  }
}

/// False if nothing is to be drawn.
bool finish(Small& small) {
  auto& v = small.v;
  small.area = (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[1].x - v[0].x) * (v[2].y - v[0].y);
  if (small.area < 0) {
    std::swap(v[1], v[2]);
    small.area = -small.area;
  }
  const auto [min_x, max_x] = std::minmax<std::int32_t>({v[0].x, v[1].x, v[2].x});
  const auto [min_y, max_y] = std::minmax<std::int32_t>({v[0].y, v[1].y, v[2].y});
  small.box = {min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4};
  return small.area != 0 && !small.box.empty() && is_small(max_x - min_x, max_y - min_y, v[0], v[1], v[2]);
}

bool same_planes(const SmallScan& a, const SmallScan& b) {
  return std::equal(a.start, a.start + 4, b.start) && std::equal(a.step_x, a.step_x + 4, b.step_x) &&
         std::equal(a.step_y, a.step_y + 4, b.step_y);
}

/// Set-up and scan by themselves.
bool stages_differ(const Small& small, const Pictures& pictures, std::uint32_t number, Outcome& outcome) {
  SmallScan portable{};
  portable.area = small.area, portable.anchor_x = small.box.left, portable.anchor_y = small.box.top;
  portable.width = small.box.width(), portable.height = small.box.height();
  portable.depth_stride = portable.colour_stride = kSide;
  SmallScan own = portable;
  portable.depth_row = pictures.portable.depth(), portable.colour_row = pictures.portable.colour();
  own.depth_row = pictures.own.depth(), own.colour_row = pictures.own.colour();
  const Colour* const colours[3] = {&small.colours[0], &small.colours[1], &small.colours[2]};
  set_up_small_portable<true>(portable, small.v[0], small.v[1], small.v[2], colours);
  set_up_small<true, false>(own, small.v[0], small.v[1], small.v[2], colours);
  if (!same_planes(portable, own)) return outcome.differs("planes", number);
  scan_small_portable<true, false>(portable, DepthRule<DepthMode{}>{});
  scan_small<true, false>(own, DepthRule<DepthMode{}>{});
  outcome.compared += pictures.changed() ? 1U : 0U;
  return !pictures.equal() && outcome.differs("a scan", number);
}

/// In a strip of any size and place, the triangle in it or not.
template <bool gouraud>
bool drawings_differ(Random& random, const Small& small, std::uint32_t number, Outcome& outcome) {
  const std::int32_t width = random.between(1, 20), height = random.between(1, 20);
  const std::int32_t left = small.box.left + random.between(-12, 4), top = small.box.top + random.between(-12, 4);
  const Rect box{std::max(small.box.left, left), std::max(small.box.top, top), std::min(small.box.right, left + width),
                 std::min(small.box.bottom, top + height)};
  if (box.empty()) return false;
  const Pictures pictures(random, width, height, small.v[0].depth >> 16);
  const Colour* const colours[3] = {&small.colours[0], &small.colours[1], &small.colours[2]};
  draw_small_triangle_portable<gouraud, false>(pictures.portable.target(left, top, nullptr), small.v[0], small.v[1],
                                               small.v[2], colours, 0x9ABC, small.area, small.box.left, small.box.top,
                                               box);
  draw_small_triangle<gouraud, false>(pictures.own.target(left, top, nullptr), small.v[0], small.v[1], small.v[2],
                                      colours, 0x9ABC, small.area, small.box.left, small.box.top, box);
  outcome.compared += pictures.changed() ? 1U : 0U;
  return !pictures.equal() && outcome.differs(gouraud ? "a shaded triangle" : "a flat triangle", number);
}

}  // namespace

Outcome compare_small_triangles(std::uint32_t cases) {
  Random random(2);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    Small small;
    place(random, number, small);
    if (!finish(small)) continue;
    const Pictures pictures(random, kSide, kSide, small.v[0].depth >> 16);
    if (stages_differ(small, pictures, number, outcome)) break;
    if (number / 8 % 2 == 0 ? drawings_differ<true>(random, small, number, outcome)
                            : drawings_differ<false>(random, small, number, outcome)) {
      break;
    }
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
