// 20,000 runs of texels and 4,000 textured triangles by assembly and by C++; see assembly_checks.hpp.
#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "mps2/assembly_checks.hpp"
#include "zstrip/kernels/textured_run.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::board {
namespace {

using namespace zstrip::detail;
using Run = TexturedRun<false, false, std::uint32_t, DepthRule<DepthMode{}>>;

constexpr std::int32_t kMaxPixels = 40;  // more than a run has
constexpr std::int32_t kMaxLog2 = 5;     // of a side of the texture

struct Row {
  std::array<std::uint16_t, kMaxPixels + 2> depth, colour;  // a pixel more at each end, which must stay
  bool operator==(const Row&) const = default;
};

/// Any walk over any texture: what the renderer asks for is among them.
void place(Random& random, Run& run) {
  const std::int32_t log2_width = random.below(kMaxLog2 + 1), log2_height = random.below(kMaxLog2 + 1);
  run.u = random.next(), run.v = random.next();
  run.step_u = random.next() >> random.below(16), run.step_v = random.next() >> random.below(16);
  run.z = random.next(), run.step_z = random.next() >> random.below(16);
  run.to_column = TextureAxis(static_cast<std::uint8_t>(log2_width)).to_index;
  run.to_row = log2_width + log2_height == 0 ? 31 : 32 - log2_width - log2_height;
  run.row_mask = ~((std::uint32_t{1} << log2_width) - 1);
  if (log2_width == 0) run.u = run.step_u = 0;
  if (log2_height == 0) run.v = run.step_v = 0;
}

constexpr std::int32_t kWidth = 200, kHeight = 12;
struct Strip {
  std::array<std::uint16_t, kWidth * kHeight> depth, colour;
  bool operator==(const Strip&) const = default;
};

/// Whatever counts is C++ throughout.
template <bool statistics>
void draw(Strip& strip, const Rect& area, const RasterVertex (&v)[3], const Surface& surface, Statistics& counts) {
  TargetFor<DepthMode{}> target{};
  target.area = area;
  target.view_left = target.first_column = area.left - 50;
  target.view_top = target.first_row = area.top - 50;
  target.depth = strip.depth.data(), target.colour = strip.colour.data();
  target.depth_stride = target.colour_stride = kWidth;
  target.statistics = &counts;
  draw_span_triangle<Shade::textured, false, statistics, DepthMode{}, kPerspectiveRun>(target, v[0], v[1], v[2],
                                                                                       surface, true);
}

/// Triangles with whole runs and pieces of them, hardly tilted and steeply, with texture coordinates of all sizes.
bool triangles_are_equal(Random& random, const std::uint16_t* texels) {
  static Strip portable, assembled;
  Statistics counts{};
  for (std::uint32_t i = 0; i < 4'000; ++i) {
    RasterVertex v[3] = {};
    for (RasterVertex& vertex : v) {
      vertex.x = random.below(3000) - 200, vertex.y = random.below(400) - 100;
      vertex.depth = random.next() >> (i % 5);
      const int bits = random.below(24);
      vertex.u = static_cast<std::int32_t>(random.next()) >> bits;
      vertex.v = static_cast<std::int32_t>(random.next()) >> bits;
    }
    if ((v[2].x - v[0].x) * (v[1].y - v[0].y) <= (v[1].x - v[0].x) * (v[2].y - v[0].y)) continue;
    const Surface surface{.flat_colour = 0,
                          .texture = {texels, static_cast<std::uint8_t>(random.below(kMaxLog2 + 1)),
                                      static_cast<std::uint8_t>(random.below(kMaxLog2 + 1))},
                          .depth_offset = static_cast<std::int64_t>(random.next()) << random.below(8)};
    const std::int32_t left = random.below(60), top = random.below(8);
    const Rect area{left, top, left + 1 + random.below(kWidth), top + 1 + random.below(kHeight)};
    portable.depth.fill(static_cast<std::uint16_t>(random.next() >> (16 + i % 8)));
    portable.colour.fill(0);
    assembled = portable;
    draw<true>(portable, area, v, surface, counts);
    draw<false>(assembled, area, v, surface, counts);
    if (portable == assembled) continue;
    print("self-test: textured triangle ");
    print_decimal(i);
    print(" differs\n");
    return false;
  }
  return counts.depth_passes > 100'000;
}

}  // namespace

int check_textured_runs() {
  if constexpr (!kHasThumb) {
    print("self-test: no assembly\n");
    return 0;
  } else {
    Random random;
    static std::array<std::uint16_t, std::size_t{1} << (2 * kMaxLog2)> texels;
    for (std::uint16_t& texel : texels) texel = static_cast<std::uint16_t>(random.next() >> 16);
    std::uint32_t written = 0;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
      Run run;
      place(random, run);
      run.texels = texels.data();
      Row portable, before;
      for (std::uint16_t& code : portable.depth) code = static_cast<std::uint16_t>(random.next() >> 16);
      for (std::uint16_t& pixel : portable.colour) pixel = static_cast<std::uint16_t>(random.next() >> 16);
      before = portable;
      Row assembled = portable;
      Run by_hand = run;
      const std::int32_t length = 1 + random.below(kMaxPixels);
      run.fill(portable.depth.data() + 1, portable.colour.data() + 1, length, ColourPlanes{}, nullptr);
      fill_run_thumb(by_hand, assembled.depth.data() + 1, assembled.colour.data() + 1, length);
      if (portable != assembled || run.z != by_hand.z) {
        print("self-test: run of texels ");
        print_decimal(i);
        print(" differs\n");
        return 1;
      }
      written += portable != before;
    }
    if (!triangles_are_equal(random, texels.data())) return 1;
    print("self-test: ");
    print_decimal(written);
    print(" runs of texels are equal\n");
    return 0;
  }
}

}  // namespace zstrip::board
