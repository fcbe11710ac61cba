// A small scene of lines, which their tests fill and draw.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "depth_picture.hpp"
#include "drawn.hpp"

namespace lines_test {

using namespace zstrip;
using picture::DepthPicture;
using picture::DepthRenderer;
using Real = long double;

inline constexpr View kView{96, 64};

/// Vertices in a box, and what is drawn of them.
struct World {
  std::vector<Position> positions;
  std::vector<Colour> colours;
  std::vector<Segment> segments;
  Mesh mesh;
  Material material{.colour = {255, 255, 255, 255}, .lit = false};
  LineSet lines;
  Camera camera;

  World() {
    camera.eye = {0, 0, fixed(8.0)};
    camera.near_plane = fixed(1.0);
    camera.far_plane = fixed(20.0);
    camera.fixed_depth_range = true;
  }
  /// Coordinates are 1/16 pixels from the middle of kView, y upwards; z up to 4 units around the origin.
  static World in_pixels() {
    World world;
    world.camera.projection = Projection::orthographic;
    world.camera.focal = kFixedOne / 32;  // half of 64 rows
    world.mesh.half_extent = {fixed(2048.0), fixed(2048.0), fixed(4.0)};
    return world;
  }
  Scene scene() {
    mesh.positions = positions;
    mesh.colours = colours;
    lines.segments = segments;
    Scene s;
    s.meshes = {&mesh, 1};
    s.materials = {&material, 1};
    s.lines = {&lines, 1};
    return s;
  }
  void line(const Position& a, const Position& b) {
    const auto first = static_cast<std::uint16_t>(positions.size());
    positions.push_back(a);
    positions.push_back(b);
    segments.push_back({first, static_cast<std::uint16_t>(first + 1)});
  }
  void point(const Position& p) {
    positions.push_back(p);
    const auto last = static_cast<std::uint16_t>(positions.size() - 1);
    segments.push_back({last, last});
  }
  void clear() {
    positions.clear();
    segments.clear();
  }
  DepthPicture draw(Effects more = {}, std::uint16_t rows = kView.height) {
    EXPECT_TRUE(validate(scene()));
    return DepthRenderer(effects_of(scene(), camera) | effect::statistics | more, kView, rows).draw(scene(), camera);
  }
};

inline std::uint32_t code_at(const DepthPicture& picture, int x, int y) {
  return picture.depth[static_cast<std::size_t>(y * kView.width + x)];
}

inline Position any_position(std::mt19937& random, int reach_x, int reach_y) {
  const auto any = [&random](int reach) {
    return static_cast<std::int16_t>(static_cast<int>(random() % static_cast<unsigned>(2 * reach + 1)) - reach);
  };
  return {any(reach_x), any(reach_y), any(32767)};
}

}  // namespace lines_test
