// Planes in words of 32 bits, where they suffice, against those of 64: triangles from slivers to the guard band's size,
// values that change by little and by more than a word holds.
#include <cstdint>
#include <utility>

#include "contracts.hpp"
#include "random.hpp"
#include "zstrip/kernels/triangle_planes.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

bool small_planes_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  const bool narrow = random.below(8) != 0;
  const std::int32_t width = random.between(1, 1 << random.between(2, narrow ? 14 : 25));
  const std::int32_t height = random.between(1, 1 << random.between(2, narrow ? 14 : 25));
  const std::int32_t left = random.within(narrow ? 1 << 13 : 1 << 24), top = random.within(narrow ? 1 << 13 : 1 << 24);
  RasterVertex v[3]{};
  for (RasterVertex& vertex : v) vertex.x = left + random.below(width), vertex.y = top + random.below(height);
  if (signed_area(v[0], v[1], v[2]) < 0) std::swap(v[1], v[2]);
  const std::int64_t area = signed_area(v[0], v[1], v[2]);
  if (area == 0) return false;
  const std::int32_t anchor_x = (left >> 4) + random.below((width >> 4) + 1);
  const std::int32_t anchor_y = (top >> 4) + random.below((height >> 4) + 1);
  const WordOrLongPlanes own(v[0], v[1], v[2], area, anchor_x, anchor_y);
  const PlaneSetup setup(v[0], v[1], v[2], area, anchor_x, anchor_y);
  const int less = random.below(31);
  const auto value = [&random, less] { return std::int64_t{static_cast<std::int32_t>(random.word())} >> less; };
  // A difference of two words has up to 33 bits.
  const std::int64_t first = value(), to_1 = value() - value(), to_2 = value() - value();
  const Plane expected = setup.plane(first, to_1, to_2), plane = own.plane(first, to_1, to_2);
  if (own.in_words()) ++outcome.compared;
  const bool same = plane.start == expected.start && plane.step_x == expected.step_x && plane.step_y == expected.step_y;
  return !same && outcome.differs("the planes of a triangle", number);
}

}  // namespace

Outcome compare_triangle_planes(std::uint32_t cases) {
  Random random(14);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    if (small_planes_differ(random, number, outcome)) break;
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
