// Triangles anywhere in space before the default camera axes, and what the homogeneous oracle says about them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "homogeneous_oracle.hpp"
#include "lattice.hpp"

namespace hard_cases {

class Space {
 public:
  /// A mesh of the given half extent around the origin; the camera on +z at `eye_z`. All 16.16.
  Space(Fixed half_extent, Fixed eye_z) {
    model.mesh.half_extent = {half_extent, half_extent, half_extent};
    model.material = {.lit = false, .smooth = false, .double_sided = true};
    camera.eye = {0, 0, eye_z};
  }

  Model model;
  Camera camera;
  View view = kView;

  void add(const std::array<Position, 3>& corners, Colour colour = kWhite) {
    const auto first = static_cast<std::uint16_t>(model.positions.size());
    for (const Position& p : corners) {
      model.positions.push_back(p);
      model.colours.push_back(colour);
    }
    model.triangles.push_back({first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2)});
  }

  Picture draw(std::uint16_t strip_rows = 0) {
    Scene scene = model.scene();
    scene.background = {0, 0, 0, 255};
    return picture::render(scene, camera, view, strip_rows == 0 ? view.height : strip_rows);
  }

  oracle::Homogeneous homogeneous(const Position& p) const {
    const long double unit = model.mesh.half_extent.x / 65536.0L / 32768;
    const long double w = camera.eye.z / 65536.0L - p.z * unit;
    const long double across = camera.projection == Projection::perspective ? w : 1;
    const long double scale = camera.focal / 65536.0L * view.height / 2;
    return {view.width / 2.0L * across + scale * p.x * unit, view.height / 2.0L * across - scale * p.y * unit, w};
  }

  /// Perspective only.
  oracle::SpaceTriangle exact(const Triangle& t, long double tolerance) const {
    return {{homogeneous(model.positions[t.a]), homogeneous(model.positions[t.b]), homogeneous(model.positions[t.c])},
            camera.near_plane / 65536.0L,
            camera.far_plane / 65536.0L,
            tolerance};
  }

  /// Compares the picture of all triangles with the oracle, wherever it does not abstain. Empty if right.
  std::string verdict(const Picture& picture, long double tolerance) const {
    if (!picture.status) return message(picture.status.error);
    std::vector<oracle::SpaceTriangle> triangles;
    for (const Triangle& t : model.triangles) triangles.push_back(exact(t, tolerance));
    for (const oracle::SpaceTriangle& t : triangles) {
      if (t.degenerate()) return {};
    }
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        bool seen = false, unsure = false;
        for (const oracle::SpaceTriangle& t : triangles) {
          const oracle::Verdict verdict = t.sees(x, y);
          seen |= verdict == oracle::Verdict::inside;
          unsure |= verdict == oracle::Verdict::abstains;
        }
        if (!seen && unsure) continue;
        if ((pixel_at(picture, x, y, view.width) != 0) != seen) {
          std::ostringstream text;
          text << words() << (seen ? "lacks " : "should not have ") << x << ',' << y;
          return text.str();
        }
      }
    }
    return {};
  }

  std::string words() const {
    std::ostringstream text;
    for (const Position& p : model.positions) text << '{' << p.x << ',' << p.y << ',' << p.z << "} ";
    return text.str();
  }
};

/// Pixels from one division of a span to the next.
inline constexpr int kSpan = 16;
/// The curvature of value(x, y) along a row, from kSpan pixels left of the picture to kSpan right of it: at the pixels
/// of the triangle, which are those that are drawn, and outside of the picture those that the oracle sees; 0 elsewhere.
using RowOfCurvature = std::array<long double, kView.width + 2 * kSpan>;
template <class Value>
RowOfCurvature curvature_along(const Picture& picture, const oracle::SpaceTriangle& exact, int y, const Value& value) {
  RowOfCurvature row{};
  for (int x = -kSpan; x < kView.width + kSpan; ++x) {
    const bool is_in_picture = x >= 0 && x < kView.width;
    if (is_in_picture ? pixel_at(picture, x, y) == 0 : exact.sees(x, y) != oracle::Verdict::inside) continue;
    row.at(static_cast<std::size_t>(x + kSpan)) = std::abs(value(x + 1, y) - 2 * value(x, y) + value(x - 1, y));
  }
  return row;
}
/// The largest within a span to either side of x.
inline long double largest_near(const RowOfCurvature& row, int x) {
  return *std::max_element(row.begin() + x, row.begin() + x + 2 * kSpan + 1);
}

}  // namespace hard_cases
