// Scenes that tell visibility methods apart, in world units, seen along -z by an orthographic or perspective camera.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "visibility/drawing.hpp"
#include "visibility/methods.hpp"
#include "visibility/numbered_scene.hpp"
#include "visibility/polygon_soup.hpp"
#include "visibility/surface_judge.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim::test {

using Corners = std::array<SoupPoint, 3>;

inline SoupScene scene_of(const std::vector<Corners>& triangles) {
  PolygonSoup soup;
  soup.double_sided = true;
  double shade = 60;
  for (const Corners& t : triangles) {
    SoupPolygon polygon;
    for (const SoupPoint& p : t) polygon.push_back({p, {shade, 255 - shade, 128}});
    soup.polygons.push_back(polygon);
    shade = shade > 200 ? 60 : shade + 70;
  }
  Result<SoupScene> scene = SoupScene::of(soup);
  EXPECT_TRUE(scene) << scene.failure().message;
  return std::move(*scene);
}

/// The thesis's polygons; greater z is nearer.
inline std::vector<Corners> thesis_polygons() {
  return {{{{1, 5, -4}, {3, 4, -2}, {5, 1, 0}}}, {{{4, 5, -1.5}, {3.5, 2.5, -1}, {1, 0.5, -0.5}}}};
}
/// Three bars, each over the next and under the one before.
inline std::vector<Corners> cycle() {
  return {{{{0.3, 1.2, -2}, {5.7, 0.2, 0}, {5.7, 1.8, 0}}},
          {{{5.2, 0.3, -2}, {3.6, 5.7, 0}, {2.2, 4.9, 0}}},
          {{{3.2, 5.7, -2}, {0.3, 1.0, 0}, {1.6, 0.2, 0}}}};
}
/// Two triangles that go through each other.
inline std::vector<Corners> crossing() {
  return {{{{0.5, 1, -3}, {5.5, 2, 0}, {3, 5, -1.5}}}, {{{5.5, 1, -3}, {3, 5.5, -1.4}, {0.5, 2.5, 0}}}};
}

inline Camera camera_at(Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.eye = {3 * kFixedOne, 3 * kFixedOne, 8 * kFixedOne};
  camera.near_plane = kFixedOne / 2;
  camera.far_plane = 40 * kFixedOne;
  camera.focal = projection == Projection::orthographic ? kFixedOne / 4 : 2 * kFixedOne;
  return camera;
}

inline MethodRequest request(std::string_view method, const View& view, std::uint16_t strip_rows = 0) {
  const Result<VisibilityMethod> found = parse_visibility(std::string(method));
  EXPECT_TRUE(found) << method;
  MethodRequest made{.view = view, .budget = {}, .effects = found->effects, .options = {}};
  made.budget.strip_rows = strip_rows;
  made.budget.modes = Modes::streamed;
  return made;
}

inline LookedAtFrame drawn(const Staging& staging, const MethodRequest& request) {
  Result<LookedAtFrame> frame = draw_looked_at(staging, request);
  EXPECT_TRUE(frame) << frame.failure().message;
  return frame ? std::move(*frame) : LookedAtFrame{};
}

/// Pixels that the judge finds wrong. The scene is numbered for it.
inline int wrong(const Staging& staging, const MethodRequest& request, int* covered = nullptr) {
  Result<NumberedScene> numbered = NumberedScene::of(staging.scene);
  EXPECT_TRUE(numbered);
  const Staging judged{numbered->scene(), staging.camera};
  const LookedAtFrame frame = drawn(judged, request);
  SurfaceJudge judge(judged.scene, staging.camera, request.view);
  judge.find_nearest({.nearness = 1.5 * nearness_of_code(staging.camera, frame.nearest, frame.farthest)});
  int count = 0;
  for (const std::uint8_t pixel : wrong_pixels(judge, frame.pixels, request.view)) count += pixel;
  if (covered != nullptr) {
    *covered = 0;
    for (int y = 0; y < request.view.height; ++y) {
      for (int x = 0; x < request.view.width; ++x) *covered += judge.is_covered(x, y);
    }
  }
  return count;
}

}  // namespace zstrip::sim::test
