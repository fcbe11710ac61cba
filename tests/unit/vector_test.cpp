// What vectors of SSE2 draw and transform against the portable C++, bit by bit: spans of all lengths and starts,
// triangles of all sizes cut by strips, vertices; into buffers without a byte to spare.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "zstrip/kernels/small_triangle.hpp"
#include "zstrip/kernels/span.hpp"
#include "zstrip/kernels/transform.hpp"
#include "zstrip/raster/assemble.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::detail;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  std::int32_t between(std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(engine_);
  }
  std::uint32_t word() { return static_cast<std::uint32_t>(engine_()); }
  Colour colour() {
    const std::uint32_t bits = word();
    const auto channel = [&](int i) {  // ends of the range are where things wrap
      const auto kind = (bits >> (24 + 2 * i)) & 3U;
      return static_cast<std::uint8_t>(kind == 0 ? 0U : kind == 1 ? 255U : (bits >> (8 * i)) & 255U);
    };
    return {channel(0), channel(1), channel(2), 255};
  }

 private:
  std::mt19937 engine_;
};

/// Depth and colour of a strip, the same for both ways to draw.
struct Buffers {
  std::int32_t width, height;
  std::vector<std::uint16_t> depth, colour;

  Buffers(Random& random, std::int32_t columns, std::int32_t rows, std::uint32_t code)
      : width(columns),
        height(rows),
        depth(static_cast<std::size_t>(columns * rows)),
        colour(static_cast<std::size_t>(columns * rows)) {
    for (std::uint16_t& cell : depth) {
      const std::int32_t kind = random.between(0, 9);
      const std::uint32_t near_code = code + static_cast<std::uint32_t>(random.between(-2, 2));
      cell = static_cast<std::uint16_t>(kind < 4 ? 0 : kind == 4 ? 65535 : kind == 5 ? random.word() : near_code);
    }
    for (std::uint16_t& pixel : colour) pixel = static_cast<std::uint16_t>(random.word());
  }
  friend bool operator==(const Buffers&, const Buffers&) = default;

  StripTarget target(std::int32_t left, std::int32_t top, Statistics* statistics) {
    StripTarget target{};
    target.area = {left, top, left + width, top + height};
    target.view_left = -500;
    target.view_top = -500;
    target.depth = depth.data();
    target.colour = colour.data();
    target.depth_stride = target.colour_stride = width;
    target.statistics = statistics;
    return target;
  }
};

class Vectors : public testing::Test {
 protected:
  void SetUp() override {
    if (!kHasSse2) GTEST_SKIP() << "this processor has no vectors that the core knows";
  }
};

using Rule = DepthRule<DepthMode{}>;

/// Draws the same span with and without vectors; `draw(buffers' span, vectors)`.
template <class Draw>
void compare_spans(Random& random, const Plane& depth, const Draw& draw) {
  for (std::int32_t length = 1; length <= 40; ++length) {
    for (std::int32_t start = 0; start < 9; ++start) {
      const std::int32_t whole_right = random.between(0, 40);
      const std::int32_t skipped = random.between(0, 40);
      Buffers portable(random, start + length, 1, depth.at(start, 3) >> 16);
      Buffers vectors = portable;
      const auto span_of = [&](Buffers& buffers) {
        return Span<>{buffers.depth.data() + start,  buffers.colour.data() + start, length, start, 3, skipped,
                      skipped + length + whole_right};
      };
      draw(span_of(portable), false);
      draw(span_of(vectors), true);
      ASSERT_TRUE(portable == vectors) << "length " << length << ", start " << start;
    }
  }
}

TEST_F(Vectors, FlatSpans) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Plane depth{random.word(), random.word() >> random.between(0, 20), random.word()};
    compare_spans(random, depth, [&](const Span<>& span, bool vectors) {
      if (vectors) {
        fill_flat<false>(span, depth, Rule{}, 0x1234, nullptr);
      } else {
        fill_flat_portable<false>(span, depth, Rule{}, 0x1234, nullptr);
      }
    });
  }
}

TEST_F(Vectors, GouraudSpans) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Plane depth{random.word(), random.word() >> random.between(0, 20), random.word()};
    // Channels stay within 0..255 over the span.
    const auto channel = [&random] {
      return Plane{static_cast<std::uint32_t>(random.between(100 << 16, 150 << 16)),
                   static_cast<std::uint32_t>(random.between(-(1 << 17), 1 << 17)), 0};
    };
    const ColourPlanes planes{channel(), channel(), channel()};
    compare_spans(random, depth, [&](const Span<>& span, bool vectors) {
      if (vectors) {
        fill_gouraud<false>(span, depth, Rule{}, planes, nullptr);
      } else {
        fill_gouraud_portable<false>(span, depth, Rule{}, planes, nullptr);
      }
    });
  }
}

RasterVertex random_vertex(Random& random, std::int32_t extent, std::uint32_t base) {
  RasterVertex v{};
  v.x = random.between(-extent, extent);
  v.y = random.between(-extent, extent);
  v.depth = snap_depth(base + (random.word() >> random.between(4, 14)));
  const Colour colour = random.colour();
  v.r = channel_start(colour.r), v.g = channel_start(colour.g), v.b = channel_start(colour.b);
  v.u = random.between(-200 << 16, 200 << 16), v.v = random.between(-200 << 16, 200 << 16);
  return v;
}

/// Draws `count` triangles of spans with counting, which is portable, and without.
template <Shade shade, std::int32_t perspective = 16>
void compare_span_triangles(unsigned seed, int count, const Surface& surface) {
  Random random(seed);
  int drawn = 0;
  for (int i = 0; i < count; ++i) {
    const std::int32_t extent = std::min(random.between(2, 700), random.between(2, 700));
    const std::uint32_t base = random.word() >> 1;
    RasterVertex v[3] = {};
    for (RasterVertex& each : v) each = random_vertex(random, extent, base);
    if (signed_area(v[0], v[1], v[2]) < 0) std::swap(v[1], v[2]);
    if (signed_area(v[0], v[1], v[2]) == 0) continue;
    Buffers portable(random, random.between(1, 60), random.between(1, 60), base >> 16);
    Buffers vectors = portable;
    const std::int32_t left = random.between(-60, 10), top = random.between(-60, 10);
    Statistics statistics{};
    draw_span_triangle<shade, false, true, DepthMode{}, perspective>(portable.target(left, top, &statistics), v[0],
                                                                     v[1], v[2], surface, true);
    draw_span_triangle<shade, false, false, DepthMode{}, perspective>(vectors.target(left, top, nullptr), v[0], v[1],
                                                                      v[2], surface, true);
    ASSERT_TRUE(portable == vectors) << "triangle " << i;
    if (statistics.depth_passes != 0) ++drawn;
  }
  EXPECT_GT(drawn, count / 4);
}

TEST_F(Vectors, FlatTriangles) { compare_span_triangles<Shade::flat>(3, 20000, {0x5678, {}, 0}); }

TEST_F(Vectors, GouraudTriangles) { compare_span_triangles<Shade::gouraud>(4, 10000, {}); }

TEST_F(Vectors, TexturedTriangles) {
  Random random(5);
  constexpr std::uint8_t kSizes[][2] = {{0, 0}, {0, 5}, {6, 0}, {3, 4}, {6, 6}, {8, 8}, {9, 8}};
  for (const auto& [log2_width, log2_height] : kSizes) {
    std::vector<std::uint16_t> texels(std::size_t{1} << (log2_width + log2_height));
    for (std::uint16_t& texel : texels) texel = static_cast<std::uint16_t>(random.word());
    const Surface surface{0, {texels.data(), log2_width, log2_height}, 1 << 20};
    compare_span_triangles<Shade::textured>(6, 2000, surface);
    compare_span_triangles<Shade::textured, 8>(7, 500, surface);
    compare_span_triangles<Shade::textured, 0>(8, 500, surface);
  }
}

TEST_F(Vectors, SmallTriangles) {
  Random random(9);
  int drawn = 0;
  for (int i = 0; i < 60000; ++i) {
    const std::uint32_t base = random.word() >> random.between(0, 2);
    const std::int32_t extent = random.between(1, 90);
    SnappedVertex v[3];
    Colour colours[3];
    for (int k = 0; k < 3; ++k) {
      v[k].x = static_cast<std::int16_t>(random.between(-extent, extent));
      v[k].y = static_cast<std::int16_t>(random.between(-extent, extent));
      v[k].depth = snap_depth(base + (random.word() >> random.between(3, 14)));
      colours[k] = random.colour();
    }
    const auto area_of = [&v] { return (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[1].x - v[0].x) * (v[2].y - v[0].y); };
    if (area_of() < 0) std::swap(v[1], v[2]);
    const auto [min_x, max_x] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [min_y, max_y] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (area_of() == 0 || !is_small(max_x - min_x, max_y - min_y, v[0], v[1], v[2])) continue;
    Buffers portable(random, random.between(1, 20), random.between(1, 20), base >> 16);
    const std::int32_t left = random.between(-12, 4), top = random.between(-12, 4);
    const Rect box{std::max(min_x >> 4, left), std::max(min_y >> 4, top), std::min(max_x >> 4, left + portable.width),
                   std::min(max_y >> 4, top + portable.height)};
    if (box.empty()) continue;
    ++drawn;
    Buffers vectors = portable;
    const Colour* const of_vertices[3] = {&colours[0], &colours[1], &colours[2]};
    if (random.between(0, 1) == 0) {
      draw_small_triangle_portable<true, false>(portable.target(left, top, nullptr), v[0], v[1], v[2], of_vertices, 0,
                                                area_of(), min_x >> 4, min_y >> 4, box);
      draw_small_triangle<true, false>(vectors.target(left, top, nullptr), v[0], v[1], v[2], of_vertices, 0, area_of(),
                                       min_x >> 4, min_y >> 4, box);
    } else {
      draw_small_triangle_portable<false, false>(portable.target(left, top, nullptr), v[0], v[1], v[2], of_vertices,
                                                 0x9ABC, area_of(), min_x >> 4, min_y >> 4, box);
      draw_small_triangle<false, false>(vectors.target(left, top, nullptr), v[0], v[1], v[2], of_vertices, 0x9ABC,
                                        area_of(), min_x >> 4, min_y >> 4, box);
    }
    ASSERT_TRUE(portable == vectors) << "triangle " << i;
  }
  EXPECT_GT(drawn, 10000);
}

constexpr Effects kOfMeshlets = effect::gouraud | effect::vertex_colours;

/// Draws whole meshlets with counting, which is portable, and without.
template <Shade shade>
void compare_meshlets(unsigned seed) {
  Random random(seed);
  std::uint32_t drawn = 0;
  for (int i = 0; i < 12000; ++i) {
    constexpr std::uint32_t kFirst = 1000;
    SnappedVertex vertices[12];
    Colour colours[12];
    const std::int32_t extent = random.between(0, 2) == 0 ? random.between(10, 300) : random.between(10, 60);
    const std::uint32_t base = random.word() >> 1;
    for (int k = 0; k < 12; ++k) {
      vertices[k].x = static_cast<std::int16_t>(random.between(-extent, extent));
      vertices[k].y = static_cast<std::int16_t>(random.between(-extent, extent));
      vertices[k].depth = snap_depth(base + (random.word() >> random.between(4, 14)));
      colours[k] = random.colour();
    }
    std::vector<Triangle> triangles(40);
    for (Triangle& triangle : triangles) {
      const auto corner = [&] {
        return static_cast<std::uint16_t>(kFirst + static_cast<unsigned>(random.between(0, 11)));
      };
      triangle = {corner(), corner(), corner()};
    }
    CompiledInstance instance{};
    instance.shade = shade;
    instance.coloured = true;
    instance.double_sided = random.between(0, 3) == 0;
    const Mesh mesh{};
    const Batch batch{&instance, &mesh, vertices, colours, kFirst, {}, {}};
    Buffers portable(random, random.between(1, 40), random.between(1, 40), base >> 16);
    Buffers vectors = portable;
    const std::int32_t left = random.between(-25, 5), top = random.between(-25, 5);
    Statistics statistics{};
    const bool all_narrow = random.between(0, 1) == 0;
    Assembler<kOfMeshlets | effect::statistics>::draw(portable.target(left, top, &statistics), batch, triangles,
                                                      all_narrow);
    Assembler<kOfMeshlets>::draw(vectors.target(left, top, nullptr), batch, triangles, all_narrow);
    ASSERT_TRUE(portable == vectors) << "meshlet " << i;
    drawn += statistics.covering;
  }
  EXPECT_GT(drawn, 5000U);
}

TEST_F(Vectors, FlatMeshlets) { compare_meshlets<Shade::flat>(11); }

TEST_F(Vectors, GouraudMeshlets) { compare_meshlets<Shade::gouraud>(12); }

TEST_F(Vectors, Vertices) {
  Random random(10);
  constexpr std::int32_t kEdges[] = {0, 1, -1, 0x7FFF, 0x8000, -0x8000, 0x7FFF7FFF, 0x7FFF8000, INT32_MAX, INT32_MIN};
  int narrow = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto coefficient = [&] { return static_cast<std::int32_t>(random.word()) >> random.between(2, 30); };
    const auto form = [&](std::int32_t offset) {
      LinearForm result{coefficient(), coefficient(), coefficient(), offset};
      const std::int32_t edge = random.between(0, 40);  // one at most, or sums overflow
      std::int32_t* const at[] = {&result.x, &result.y, &result.z};
      if (edge < 30) *at[edge % 3] = kEdges[edge / 3];
      return result;
    };
    CompiledInstance instance{};
    instance.x = form(static_cast<std::int32_t>(random.word()) >> 3);
    instance.y = form(static_cast<std::int32_t>(random.word()) >> 3);
    instance.w = form(1 << 29);
    instance.w_near = 1 << 20;
    instance.w_range = 0x7FFFFFFF - (1 << 20);
    instance.shift_x = static_cast<std::int8_t>(random.between(14, 22));
    instance.shift_y = static_cast<std::int8_t>(random.between(14, 22));
    instance.depth_normalisation = 31;
    instance.depth_scale = random.word();
    instance.depth_shift = 3;
    const RasterOrigin origin{7, 15, random.word()};
    Position positions[5];
    for (Position& p : positions) {
      const auto coordinate = [&] {
        const std::int32_t kind = random.between(0, 7);
        return static_cast<std::int16_t>(kind == 0 ? INT16_MIN : kind == 1 ? INT16_MAX : random.between(-32768, 32767));
      };
      p = {coordinate(), coordinate(), coordinate()};
    }
    Mesh mesh{};
    mesh.positions = positions;
    SnappedVertex portable[5] = {};
    SnappedVertex vectors[5] = {};
    const auto first = static_cast<std::uint32_t>(random.between(0, 4));
    const std::uint32_t count = 5 - first;
    const bool all = transform_vertices_portable<Effects{}>(instance, mesh, origin, first, count, portable);
    ASSERT_EQ(transform_vertices<Effects{}>(instance, mesh, origin, first, count, vectors), all);
    for (std::uint32_t k = 0; k < count; ++k) {
      ASSERT_EQ(vectors[k].x, portable[k].x);
      ASSERT_EQ(vectors[k].y, portable[k].y);
      ASSERT_EQ(vectors[k].depth, portable[k].depth);
      if (portable[k].x != kNotNarrow) ++narrow;
    }
  }
  EXPECT_GT(narrow, 10000);
}

}  // namespace
