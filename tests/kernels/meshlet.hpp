// Random meshlets after the transform: triangles within a few pixels of one another, or so far apart that they are not
// small; in strips that cut them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "random.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/geometry/depth_fit.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::kernels_test {

/// What draws them by the processor's implementation; and, because it counts, by the portable one.
inline constexpr Effects kOwn = effect::gouraud | effect::vertex_colours;
inline constexpr Effects kPortable = kOwn | effect::statistics;

struct Meshlet {
  static constexpr std::uint16_t kFirstVertex = 1000;
  static constexpr std::size_t kVertices = 24, kTriangles = 60;

  std::array<detail::SnappedVertex, kVertices> vertices;
  std::array<Colour, kVertices> colours;
  std::array<Triangle, kTriangles> triangles;
  std::array<std::uint16_t, kTriangles> listed;  ///< of triangles
  std::int32_t left, top, width, height;         ///< of the strip

  static constexpr std::int32_t kNarrowPixels = detail::kNarrowLimit / 16;

  /// Across the axes, then also with several vertices on one row, or anywhere narrow; or at the end of that, in a long
  /// strip that begins beyond. Few vertices: triangles often share them, or have one twice.
  Meshlet(Random& random, std::uint32_t number) {
    const std::int32_t extent = number % 4 == 0   ? random.between(20, 600)
                                : number % 4 == 1 ? random.between(20, 120)
                                                  : 110;
    const bool near_axes = number % 2 == 0, beyond = number % 16 == 15;
    const std::int32_t corner_of_narrow = -16 * kNarrowPixels + random.below(500);
    const std::int32_t x = near_axes ? -extent / 2 : beyond ? corner_of_narrow : random.within(15000);
    const std::int32_t y = near_axes ? -extent / 2 : beyond ? corner_of_narrow : random.within(15000);
    const std::uint32_t base = number % 3 == 0 ? 1U << 28 : random.word() >> 1;
    const std::uint32_t range = number % 3 == 0 ? 3U << 28 : std::uint32_t{1} << random.between(18, 28);
    for (std::size_t i = 0; i < kVertices; ++i) {
      const std::int32_t row = y + random.below(extent);
      vertices[i] = {static_cast<std::int16_t>(x + random.below(extent)),
                     static_cast<std::int16_t>(number % 4 == 2 ? row & ~31 : row), base + random.word() % range};
      if (number % 5 < 2) vertices[i].depth = snap_depth(vertices[i].depth);
      colours[i] = random.colour();
    }
    const auto corner = [&random] {
      return static_cast<std::uint16_t>(kFirstVertex + random.below(static_cast<std::int32_t>(kVertices)));
    };
    for (std::size_t i = 0; i < kTriangles; ++i) {
      triangles[i] = {corner(), corner(), corner()};
      listed[i] = static_cast<std::uint16_t>(random.below(static_cast<std::int32_t>(kTriangles)));
    }
    left = (x >> 4) - 4 + random.below(8), top = (y >> 4) - 4 + random.below(8);
    width = random.between(1, 60), height = random.between(1, 60);
    if (beyond) {
      left = -kNarrowPixels - random.below(100), width = random.between(130, 400), height = random.between(1, 10);
      if (number % 32 == 31) {
        std::swap(width, height);
        top = left, left = (x >> 4) - 4 + random.below(8);
      }
    }
  }

  /// Around which the cells of a strip lie.
  std::uint32_t code() const { return vertices[0].depth >> 16; }
};

}  // namespace zstrip::kernels_test
