// Hard cases G: changes of a scene that must not change its picture.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

/// Triangles on the lattice, each facing and at a depth of its own, no two the same: order cannot matter.
struct Layers {
  std::vector<Corners2> triangles;
  std::vector<Colour> colours;
  std::vector<int> order;  ///< depth grows with the index, drawing follows this

  explicit Layers(int count) {
    for (int i = 0; i < count; ++i) {
      triangles.push_back(any_triangle(between(1, 700)));
      colours.push_back({any_byte(), any_byte(), static_cast<std::uint8_t>(8 + between(0, 247)), 255});
      order.push_back(i);
    }
  }

  Picture draw(std::int64_t dx = 0, std::int64_t dy = 0) const {
    Lattice lattice;
    lattice.model().material.double_sided = true;
    for (const int i : order) {
      Corners2 moved = triangles[static_cast<std::size_t>(i)];
      for (oracle::Point& p : moved) p.x += dx, p.y += dy;
      const int z = 1000 * i - 16000;
      lattice.add(moved, colours[static_cast<std::size_t>(i)], {z, z, z});
    }
    // The same bounding box whatever is in it: depth range and rectangle stay as they are.
    return lattice.draw();
  }
};

RC_GTEST_PROP(HardCases, G63_OpaqueTrianglesInAnotherOrder, ()) {
  Layers layers(between(2, 30));
  const Picture first = layers.draw();
  std::reverse(layers.order.begin(), layers.order.end());
  RC_ASSERT(layers.draw().pixels == first.pixels);
  for (std::size_t i = layers.order.size(); i > 1; --i) {
    std::swap(layers.order[i - 1], layers.order[static_cast<std::size_t>(between(0, static_cast<int>(i) - 1))]);
  }
  RC_ASSERT(layers.draw().pixels == first.pixels);
}

RC_GTEST_PROP(HardCases, G63_SplitAtALatticePoint, ()) {
  // A triangle against the three that a lattice point inside it makes of it, and the two of a point on its edge.
  const Corners2 t = any_triangle(between(4, 900));
  const std::int64_t a = between(0, 16), b = between(0, 16 - static_cast<int>(a));
  const oracle::Point inside{t[0].x + (a * (t[1].x - t[0].x) + b * (t[2].x - t[0].x)) / 16,
                             t[0].y + (a * (t[1].y - t[0].y) + b * (t[2].y - t[0].y)) / 16};
  const auto turn = [](const oracle::Point& p, const oracle::Point& q, const oracle::Point& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  // Rounding may have put the point outside.
  const std::int64_t whole = turn(t[0], t[1], t[2]);
  for (std::size_t i = 0; i < 3; ++i) RC_PRE(turn(t[i], t[(i + 1) % 3], inside) * (whole > 0 ? 1 : -1) >= 0);
  const auto mask = [](const std::vector<Corners2>& triangles) {
    Lattice lattice;
    lattice.model().material.double_sided = true;
    for (const Corners2& c : triangles) lattice.add(c);
    const Picture picture = lattice.draw();
    return std::pair{picture.pixels, picture.statistics.fragments};
  };
  RC_ASSERT(mask({t}) == mask({{t[0], t[1], inside}, {t[1], t[2], inside}, {t[2], t[0], inside}}));
}

RC_GTEST_PROP(HardCases, G63_MovedByWholePixels, ()) {
  const Layers layers(between(1, 12));
  const int dx = between(-20, 20), dy = between(-15, 15);
  const Picture at_rest = layers.draw(), moved = layers.draw(16 * dx, 16 * dy);
  for (int y = 0; y < kView.height; ++y) {
    for (int x = 0; x < kView.width; ++x) {
      if (x + dx < 0 || x + dx >= kView.width || y + dy < 0 || y + dy >= kView.height) continue;
      RC_ASSERT(pixel_at(moved, x + dx, y + dy) == pixel_at(at_rest, x, y));
    }
  }
}

RC_GTEST_PROP(HardCases, G63_HiddenGeometryAdded, ()) {
  // Behind a wall, inside the same bounds.
  Lattice lattice;
  lattice.model().material.double_sided = true;
  const std::int64_t w = kView.width * 16, h = kView.height * 16;
  lattice.add({{{0, 0}, {0, h}, {w, h}}}, {200, 100, 50, 255}, {5000, 5000, 5000});
  lattice.add({{{0, 0}, {w, h}, {w, 0}}}, {50, 100, 200, 255}, {5000, 5000, 5000});
  const Picture wall = lattice.draw();
  for (int i = between(1, 10); i > 0; --i) {
    const auto z = [] { return between(-32000, 4000); };
    lattice.add(any_triangle(between(1, 900)), {255, 255, 255, 255}, {z(), z(), z()});
  }
  RC_ASSERT(lattice.draw().pixels == wall.pixels);
}

RC_GTEST_PROP(HardCases, G63_AnEffectThatIsThereButNotUsed, ()) {
  // A renderer with more effects than the scene calls for draws the same picture.
  Model model = picture::random_model(static_cast<unsigned>(between(0, 1'000'000)), 20, 9000);
  if (between(0, 1) == 0) model.texels.clear();
  if (!model.texels.empty() && between(0, 1) == 0) model.material.texture = 0;
  model.material.lit = between(0, 1) == 0;
  model.material.smooth = between(0, 1) == 0;
  const Scene scene = model.scene();
  const Camera camera;
  const Picture exact = picture::render(scene, camera, kView, kView.height);
  const Effects more =
      effects_of(scene, camera) | effect::lighting | effect::gouraud | effect::vertex_colours | effect::textures;
  RC_ASSERT(picture::draw(more, scene, camera, kView).pixels == exact.pixels);
}

TEST(HardCases, G63_AFullTurnInAnyNumberOfStepsEndsWhereItBegan) {
  Model model = picture::random_model(7, 60, 8000);
  model.texels.clear();
  const auto picture_at = [&](Angle angle) {
    Camera camera;
    EXPECT_TRUE(orbit(camera, {0, 0, 0}, 4 * kFixedOne, angle, kFullTurn / 5));
    return picture::render(model.scene(), camera, kView, kView.height).pixels;
  };
  const std::vector<std::byte> start = picture_at(0);
  for (const int steps : {1, 4, 16, 64}) {
    Angle angle = 0;
    for (int i = 0; i < steps; ++i) angle += kFullTurn / steps;
    EXPECT_EQ(picture_at(angle), start) << steps;
    EXPECT_EQ(picture_at(-angle), start) << steps;
  }
}

}  // namespace
}  // namespace hard_cases
