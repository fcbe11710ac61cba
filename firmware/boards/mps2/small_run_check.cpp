// 600 random meshlets by assembly and by C++, in strips that cut them; see assembly_checks.hpp.
#include <algorithm>
#include <array>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "mps2/assembly_checks.hpp"
#include "zstrip/raster/assemble.hpp"

namespace zstrip::board {
namespace {

using namespace zstrip::detail;

// What counts is C++ throughout.
constexpr Effects kAssembled = effect::gouraud | effect::vertex_colours;
constexpr Effects kPortable = kAssembled | effect::statistics;

constexpr std::int32_t kWidth = 40, kHeight = 24;
constexpr std::uint16_t kFirstVertex = 1000;
constexpr std::uint32_t kVertices = 24, kTriangles = 60;

struct Picture {
  std::array<std::uint16_t, kWidth * kHeight> depth, colour;
  friend bool operator==(const Picture&, const Picture&) = default;
};

struct Meshlet {
  SnappedVertex vertices[kVertices];
  Colour colours[kVertices];
  Triangle triangles[kTriangles];
  std::uint16_t listed[kTriangles];
  Rect strip;  ///< not always as large as the picture
};

std::uint16_t index(Random& random) {
  return static_cast<std::uint16_t>(kFirstVertex + random.below(static_cast<std::int32_t>(kVertices)));
}

/// Within a few pixels of one another, or so far that triangles are not small; across the axes, then also with several
/// vertices on one row, or anywhere narrow.
void make(Random& random, std::uint32_t number, Meshlet& meshlet) {
  const std::int32_t extent = number % 4 == 0 ? 400 : 110;
  const std::int32_t left = number % 2 == 0 ? -extent / 2 : random.below(30000) - 15000;
  const std::int32_t top = number % 2 == 0 ? -extent / 2 : random.below(30000) - 15000;
  const std::uint32_t depth_range = number % 3 == 0 ? 3U << 28 : 1U << 28;
  for (std::uint32_t i = 0; i < kVertices; ++i) {
    const std::int32_t y = top + random.below(extent);
    meshlet.vertices[i] = {static_cast<std::int16_t>(left + random.below(extent)),
                           static_cast<std::int16_t>(number % 4 == 2 ? y & ~31 : y),
                           (1U << 28) + random.next() % depth_range};
    const std::uint32_t word = random.next();
    meshlet.colours[i] = {static_cast<std::uint8_t>(word >> 24), static_cast<std::uint8_t>(word >> 16),
                          static_cast<std::uint8_t>(word >> 8), 255};
  }
  for (std::uint32_t i = 0; i < kTriangles; ++i) {
    meshlet.triangles[i] = {index(random), index(random), index(random)};
    meshlet.listed[i] = static_cast<std::uint16_t>(random.below(static_cast<std::int32_t>(kTriangles)));
  }
  const std::int32_t first_column = (left >> 4) - 4 + random.below(8);
  const std::int32_t first_row = (top >> 4) - 4 + random.below(8);
  meshlet.strip = {first_column, first_row, first_column + 1 + random.below(kWidth),
                   first_row + 1 + random.below(kHeight)};
}

StripTarget target_of(Picture& picture, const Rect& strip, Statistics& statistics) {
  return {.area = strip,
          .view_left = strip.left,
          .view_top = strip.top,
          .first_column = strip.left,
          .first_row = strip.top,
          .depth = picture.depth.data(),
          .colour = picture.colour.data(),
          .depth_stride = kWidth,
          .colour_stride = kWidth,
          .statistics = &statistics};
}

/// In order, then again by a list.
template <Effects effects>
void draw(const Meshlet& meshlet, const CompiledInstance& instance, Picture& picture, Statistics& statistics) {
  const StripTarget target = target_of(picture, meshlet.strip, statistics);
  const Batch batch{.instance = &instance,
                    .mesh = nullptr,
                    .vertices = meshlet.vertices,
                    .colours = meshlet.colours,
                    .first_vertex = kFirstVertex,
                    .origin = {},
                    .surface = {}};
  Assembler<effects>::draw(target, batch, std::span(meshlet.triangles).first(kTriangles / 2), true);
  for (std::size_t first = 0; first < kTriangles; first += kBinChunkEntries) {
    const std::size_t count = std::min<std::size_t>(kBinChunkEntries, kTriangles - first);
    const bool all_narrow = first % 2 == 0;  // of every second chunk
    Assembler<effects>::draw_listed(target, batch, meshlet.triangles, std::span(meshlet.listed).subspan(first, count),
                                    all_narrow);
  }
}

}  // namespace

int check_small_runs() {
  if constexpr (!kHasThumb) {
    print("self-test: no assembly\n");
    return 0;
  } else {
    Random random;
    Statistics statistics{};
    static Meshlet meshlet;
    static Picture portable, assembled;
    for (std::uint32_t number = 0; number < 600; ++number) {
      make(random, number, meshlet);
      for (std::size_t i = 0; i < portable.depth.size(); ++i) {
        portable.depth[i] = static_cast<std::uint16_t>(random.next() >> (16 + number % 4));  // in front, and behind
        portable.colour[i] = 0;
      }
      assembled = portable;
      CompiledInstance instance{};
      instance.shade = Shade::gouraud;
      instance.double_sided = number % 5 == 0;
      draw<kPortable>(meshlet, instance, portable, statistics);
      draw<kAssembled>(meshlet, instance, assembled, statistics);
      if (portable == assembled) continue;
      print("self-test: pictures of meshlet ");
      print_decimal(number);
      print(" differ\n");
      return 1;
    }
    print("self-test: ");
    print_decimal(statistics.drawn);
    print(" triangles in runs are equal\n");
    return 0;
  }
}

}  // namespace zstrip::board
