// Triangles of the span rasteriser, of all sizes, in strips that cut them: flat, shaded, textured with every distance
// of exact positions. Once with counting, which is portable.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "contracts.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "textures.hpp"
#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/depth_fit.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

struct Case {
  RasterVertex v[3];
  std::int32_t left, top, width, height;  ///< of the strip
  std::uint32_t code;                     ///< around which its cells lie
};

/// Around the strip, of a few pixels up to some hundred.
Case compact_case(Random& random) {
  Case result{};
  const std::int32_t extent = std::min(random.between(2, 700), random.between(2, 700));
  const std::uint32_t base = random.word() >> 1;
  for (RasterVertex& v : result.v) {
    v.x = random.between(-extent, extent), v.y = random.between(-extent, extent);
    v.depth = snap_depth(base + (random.word() >> random.between(4, 14)));
    const Colour colour = random.colour();
    v.r = channel_start(colour.r), v.g = channel_start(colour.g), v.b = channel_start(colour.b);
    v.u = random.between(-200 * 65536, 200 * 65536), v.v = random.between(-200 * 65536, 200 * 65536);
  }
  result.left = random.between(-60, 10), result.top = random.between(-60, 10);
  result.width = random.between(1, 60), result.height = random.between(1, 60);
  result.code = base >> 16;
  return result;
}

/// Whole runs and pieces of them, hardly tilted and steeply, with texture coordinates of all sizes.
Case long_case(Random& random, std::uint32_t number) {
  Case result{};
  for (RasterVertex& v : result.v) {
    v.x = random.below(3000) - 200, v.y = random.below(400) - 100;
    v.depth = random.word() >> (number % 5);
    const int bits = random.below(24);
    v.u = static_cast<std::int32_t>(random.word()) >> bits, v.v = static_cast<std::int32_t>(random.word()) >> bits;
  }
  result.left = random.below(60), result.top = random.below(8);
  result.width = random.between(1, 200), result.height = random.between(1, 12);
  result.code = random.word() >> (16 + number % 8);
  return result;
}

template <Shade shade, std::int32_t perspective = kPerspectiveRun>
bool differ(Random& random, Case& of, const Surface& surface, std::uint32_t number, Outcome& outcome) {
  auto& v = of.v;
  if (signed_area(v[0], v[1], v[2]) < 0) std::swap(v[1], v[2]);
  if (signed_area(v[0], v[1], v[2]) == 0) return false;
  const Pictures pictures(random, of.width, of.height, of.code);
  Statistics statistics{};
  draw_span_triangle<shade, false, true, DepthMode{}, perspective>(
      pictures.portable.target(of.left, of.top, &statistics), v[0], v[1], v[2], surface, true);
  draw_span_triangle<shade, false, false, DepthMode{}, perspective>(pictures.own.target(of.left, of.top, nullptr), v[0],
                                                                    v[1], v[2], surface, true);
  outcome.compared += statistics.depth_passes != 0 ? 1U : 0U;
  return !pictures.equal() && outcome.differs(shade == Shade::textured  ? "a textured triangle"
                                              : shade == Shade::gouraud ? "a shaded triangle"
                                                                        : "a flat triangle",
                                              number);
}

Surface textured(std::uint8_t log2_width, std::uint8_t log2_height, std::int64_t depth_offset) {
  return {.flat_colour = 0, .texture = {texels.data(), log2_width, log2_height}, .depth_offset = depth_offset};
}

bool textured_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  constexpr std::uint8_t kSizes[][2] = {{0, 0}, {0, 5}, {6, 0}, {3, 4}, {6, 6}, {8, 8}, {9, 8}};
  const auto& [log2_width, log2_height] = kSizes[static_cast<std::size_t>(random.below(7))];
  Case of = compact_case(random);
  const Surface surface = textured(log2_width, log2_height, 1 << 20);
  switch (random.below(6)) {
    case 0: return differ<Shade::textured, 8>(random, of, surface, number, outcome);
    case 1: return differ<Shade::textured, 0>(random, of, surface, number, outcome);
    default: return differ<Shade::textured>(random, of, surface, number, outcome);
  }
}

bool long_textured_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  Case of = long_case(random, number);
  const auto side = [&random] { return static_cast<std::uint8_t>(random.below(6)); };
  const Surface surface = textured(side(), side(), static_cast<std::int64_t>(random.word()) << random.below(8));
  return differ<Shade::textured>(random, of, surface, number, outcome);
}

bool one_differs(Random& random, std::uint32_t number, Outcome& outcome) {
  if (!kHasVectors && number % 9 < 5) return false;  // assembly has texels alone
  if (number % 9 < 3) {
    Case of = compact_case(random);
    return differ<Shade::flat>(random, of, {.flat_colour = 0x5678, .texture = {}, .depth_offset = 0}, number, outcome);
  }
  if (number % 9 < 5) {
    Case of = compact_case(random);
    return differ<Shade::gouraud>(random, of, {}, number, outcome);
  }
  return number % 9 < 8 ? textured_differ(random, number, outcome) : long_textured_differ(random, number, outcome);
}

}  // namespace

Outcome compare_span_triangles(std::uint32_t cases) {
  Random random(7);
  fill_texels(random);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    if (one_differs(random, number, outcome)) break;
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
