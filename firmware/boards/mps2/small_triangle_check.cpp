// 40,000 small triangles by assembly and by C++; see assembly_checks.hpp.
#include "mps2/assembly_checks.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "zstrip/kernels/small_triangle.hpp"

namespace zstrip::board {
namespace {

using namespace zstrip::detail;

constexpr std::int32_t kSide = 16;  // pixels: no small triangle's box is wider or higher
using Cells = std::array<std::uint16_t, kSide * kSide>;

struct Pictures {
  Cells depth, colour;
};

/// A box of at most kSmallExtent - 1 half perimeter, anywhere in the narrow range.
void place(Random& random, SnappedVertex (&v)[3]) {
  const std::int32_t width = 1 + random.below(kSmallExtent - 2);
  const std::int32_t height = 1 + random.below(kSmallExtent - 1 - width);
  const std::int32_t left = random.below(16000) - 8000, top = random.below(16000) - 8000;
  const std::uint32_t depth = kSmallDepthDifference + random.next() / 4;
  for (SnappedVertex& vertex : v) {
    vertex.x = static_cast<std::int16_t>(left + random.below(width + 1));
    vertex.y = static_cast<std::int16_t>(top + random.below(height + 1));
    vertex.depth = depth + random.next() % (kSmallDepthDifference / 2);
  }
}

bool same(const SmallScan& a, const SmallScan& b) {
  return std::equal(a.start, a.start + 4, b.start) && std::equal(a.step_x, a.step_x + 4, b.step_x) &&
         std::equal(a.step_y, a.step_y + 4, b.step_y);
}

int differs(const char* what, std::uint32_t triangle) {
  print("self-test: ");
  print(what);
  print(" of small triangle ");
  print_decimal(triangle);
  print(" differ\n");
  return 1;
}

}  // namespace

int check_small_triangles() {
  if constexpr (!kHasThumb) {
    print("self-test: no assembly\n");
    return 0;
  } else {
    Random random;
    std::uint32_t drawn = 0;
    static Pictures portable, assembled;
    for (std::uint32_t triangle = 0; triangle < 40'000; ++triangle) {
      SnappedVertex v[3];
      place(random, v);
      Colour colours[3];
      for (Colour& colour : colours) {
        const std::uint32_t word = random.next();
        colour = {static_cast<std::uint8_t>(word >> 24), static_cast<std::uint8_t>(word >> 16),
                  static_cast<std::uint8_t>(word >> 8), 255};
      }
      std::int32_t area = (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[1].x - v[0].x) * (v[2].y - v[0].y);
      if (area < 0) {
        std::swap(v[1], v[2]);
        area = -area;
      }
      const auto [min_x, max_x] = std::minmax({v[0].x, v[1].x, v[2].x});
      const auto [min_y, max_y] = std::minmax({v[0].y, v[1].y, v[2].y});
      const std::int32_t left = min_x >> 4, top = min_y >> 4;
      const std::int32_t width = (max_x >> 4) - left, height = (max_y >> 4) - top;
      if (area == 0 || width == 0 || height == 0) continue;

      for (std::size_t i = 0; i < portable.depth.size(); ++i) {
        portable.depth[i] = static_cast<std::uint16_t>(random.next() >> (16 + triangle % 4));  // in front, and behind
        portable.colour[i] = 0;
      }
      assembled = portable;
      SmallScan scan{};
      scan.area = area, scan.anchor_x = left, scan.anchor_y = top;
      scan.width = width, scan.height = height;
      scan.depth_stride = scan.colour_stride = kSide;
      for (int i = 0; i < 3; ++i) scan.colours[i] = colours[i];
      SmallScan by_hand = scan;
      scan.depth_row = portable.depth.data(), scan.colour_row = portable.colour.data();
      by_hand.depth_row = assembled.depth.data(), by_hand.colour_row = assembled.colour.data();

      const Colour* const in_order[3] = {&colours[0], &colours[1], &colours[2]};
      set_up_small_portable<true>(scan, v[0], v[1], v[2], in_order);
      set_up_small_thumb(by_hand, v[0], v[1], v[2]);
      if (!same(scan, by_hand)) return differs("planes", triangle);
      scan_small_portable<true, false>(scan, DepthRule<DepthMode{}>{});
      scan_small_thumb(by_hand);
      if (portable.depth != assembled.depth) return differs("depths", triangle);
      if (portable.colour != assembled.colour) return differs("pixels", triangle);
      drawn += std::any_of(portable.colour.begin(), portable.colour.end(), [](std::uint16_t c) { return c != 0; });
    }
    print("self-test: ");
    print_decimal(drawn);
    print(" small triangles are equal\n");
    return 0;
  }
}

}  // namespace zstrip::board
