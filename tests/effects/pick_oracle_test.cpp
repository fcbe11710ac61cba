// pick against an oracle that finds the triangles of every pixel in space: by edge functions in homogeneous coordinates
// and long double, without clipping, snapping or a z-buffer. It abstains close to edges and where depths are close.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "../oracle/homogeneous_oracle.hpp"
#include "../oracle/rays.hpp"
#include "begun_frame.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace effects_test {
namespace {

constexpr View kPicture{160, 120};

/// A triangle that a pixel may show.
struct Candidate {
  std::uint16_t instance;
  std::uint32_t triangle;
  bool certain;             ///< its centre lies inside, not close to an edge
  double distance, either;  ///< along the viewing direction, and by how much a picture may be off
};

/// All triangles of a scene that each pixel may show.
class IdsInSpace {
 public:
  IdsInSpace(const Scene& scene, const Camera& camera, const Frame& frame)
      : camera_(camera), nearest_(std::ldexp(frame.nearest(), -16)), farthest_(std::ldexp(frame.farthest(), -16)) {
    for (std::uint16_t n = 0; n < scene.instances.size(); ++n) {
      const Instance& instance = scene.instances[n];
      const Mesh& mesh = scene.meshes[instance.mesh];
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        add(oracle::facet_of(mesh, instance.transform, mesh.triangles[t]),
            scene.materials[instance.material].double_sided, n, t);
      }
    }
  }

  const std::vector<Candidate>& at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y * kPicture.width + x)];
  }

 private:
  // Vertices are snapped to sixteenths of a pixel.
  static constexpr long double kCloseToEdge = 0.125L;

  oracle::Homogeneous projected(const oracle::Point& world) const {
    using oracle::operator-;
    const oracle::Point from_eye = world - oracle::of_place(camera_.eye);
    const double focal = std::ldexp(camera_.focal, -16) * kPicture.height / 2;
    const double w = -oracle::dot(from_eye, oracle::of_axis(camera_.back));
    return {focal * oracle::dot(from_eye, oracle::of_axis(camera_.right)) + kPicture.width / 2.0 * w,
            -focal * oracle::dot(from_eye, oracle::of_axis(camera_.up)) + kPicture.height / 2.0 * w, w};
  }

  void add(const oracle::Facet& facet, bool double_sided, std::uint16_t instance, std::uint32_t number) {
    const std::array<oracle::Homogeneous, 3> v{projected(facet.corner[0]), projected(facet.corner[1]),
                                               projected(facet.corner[2])};
    const long double near = std::ldexp(static_cast<long double>(camera_.near_plane), -16);
    const long double far = std::ldexp(static_cast<long double>(camera_.far_plane), -16);
    if (std::ranges::all_of(v, [near](const oracle::Homogeneous& c) { return c.w <= near; })) return;
    const oracle::SpaceTriangle triangle(v, near, far, kCloseToEdge);
    if (triangle.degenerate()) return;
    // Snapped corners decide which side of a triangle is seen: of a thin one it may be the other.
    const bool faces = double_sided || triangle.front_facing();
    if (!faces && !is_thin(v, near)) return;
    // The box of its corners, or all pixels if one is not in front.
    int left = 0, top = 0, right = kPicture.width, bottom = kPicture.height;
    if (std::ranges::all_of(v, [near](const oracle::Homogeneous& c) { return c.w > near; })) {
      const auto [low_x, high_x] = std::minmax({v[0].x / v[0].w, v[1].x / v[1].w, v[2].x / v[2].w});
      const auto [low_y, high_y] = std::minmax({v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w});
      const auto bound = [](long double value, int most) {
        return static_cast<int>(std::clamp<long double>(value, 0, most));
      };
      left = bound(low_x - 1, right), right = bound(high_x + 2, right);
      top = bound(low_y - 1, bottom), bottom = bound(high_y + 2, bottom);
    }
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const oracle::Verdict verdict = triangle.sees(x, y);
        if (verdict == oracle::Verdict::outside) continue;
        const auto distance = static_cast<double>(triangle.distance(x, y));
        pixels_[static_cast<std::size_t>(y * kPicture.width + x)].push_back(
            {instance, number, faces && verdict == oracle::Verdict::inside, distance,
             error_of(triangle, x, y, distance)});
      }
    }
  }

  /// True if no corner is farther from the opposite edge than corners move when they are snapped.
  static bool is_thin(const std::array<oracle::Homogeneous, 3>& v, long double near) {
    if (std::ranges::any_of(v, [near](const oracle::Homogeneous& c) { return c.w <= near; })) return false;
    long double longest = 0, doubled_area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const oracle::Homogeneous &a = v[i], &b = v[(i + 1) % 3];
      const long double ax = a.x / a.w, ay = a.y / a.w, bx = b.x / b.w, by = b.y / b.w;
      longest = std::max(longest, std::hypot(bx - ax, by - ay));
      doubled_area += ax * by - ay * bx;
    }
    return std::abs(doubled_area) <= kCloseToEdge * longest;
  }

  /// Some codes of the z-buffer, and what the snapped corners move the plane by.
  double error_of(const oracle::SpaceTriangle& triangle, int x, int y, double distance) const {
    const double code = distance * distance * (1 / nearest_ - 1 / farthest_) / 65533;
    const auto slope = [&](int right, int down) {
      return std::abs(static_cast<double>(triangle.distance(x + right, y + down)) - distance);
    };
    return 4 * code + (slope(1, 0) + slope(0, 1)) / 4;
  }

  const Camera& camera_;
  double nearest_, farthest_;
  std::vector<std::vector<Candidate>> pixels_ = std::vector<std::vector<Candidate>>(kPicture.width * kPicture.height);
};

std::string words_of(const std::vector<Candidate>& candidates) {
  std::string words;
  for (const Candidate& each : candidates) {
    words += std::to_string(each.triangle) + " of " + std::to_string(each.instance) +
             (each.certain ? " at " : " or at ") + std::to_string(each.distance) + " +- " +
             std::to_string(each.either) + "; ";
  }
  return words + "or nothing";
}

struct Judged {
  bool right;
  bool decided;  ///< nothing else would have been right
};

Judged judged(const Picked& picked, const std::vector<Candidate>& candidates) {
  // The farthest that may be seen: a certain triangle hides all behind it.
  double hidden_from = 1e30;
  for (const Candidate& each : candidates) {
    if (each.certain) hidden_from = std::min(hidden_from, each.distance + each.either);
  }
  int possible = hidden_from == 1e30 ? 1 : 0;  // the background
  bool found = picked.shown == Shown::background && possible == 1;
  for (const Candidate& each : candidates) {
    if (each.distance - each.either > hidden_from) continue;
    ++possible;
    found =
        found || (picked.shown == Shown::instance && each.instance == picked.index && each.triangle == picked.triangle);
  }
  return {found, possible == 1};
}

// A quarter of a million pixels; with ZSTRIP_LONG a million.
TEST(EffectsPick, RandomPixelsShowTrianglesThatTheOracleSees) {
  const int random_pixels = std::getenv("ZSTRIP_LONG") == nullptr ? 250'000 : 1'000'000;
  // Opaque triangles, which are all that the oracle knows.
  constexpr Effects kKnown = effect::lighting | effect::gouraud | effect::vertex_colours | effect::textures |
                             effect::shades | effect::two_sided | effect::vertex_light | effect::fog |
                             effect::pixel_shading | effect::bilinear | effect::mipmaps | effect::texture_palettes;
  std::vector<const scenes::BuiltIn*> known;
  for (const scenes::BuiltIn& built_in : scenes::built_in()) {
    const Scene& scene = built_in.scene;
    const std::size_t triangles = count(scene).triangles;
    if (triangles > 0 && triangles <= 12000 && without(effects_of(scene, built_in.camera), kKnown) == Effects{}) {
      known.push_back(&built_in);
    }
  }
  ASSERT_GE(known.size(), 6U);
  std::mt19937 random(51);
  int decided = 0, shown = 0, pixels = 0;
  for (const scenes::BuiltIn* const built_in : known) {
    for (const int percent : {100, 40}) {
      SCOPED_TRACE(testing::Message() << built_in->name << " from " << percent << " % of its distance");
      Camera camera = built_in->camera;
      for (Fixed* const part : {&camera.eye.x, &camera.eye.y, &camera.eye.z}) {
        *part = static_cast<Fixed>(std::int64_t{*part} * percent / 100);
      }
      const BegunFrame frame(built_in->scene, camera, kPicture, effects_of(built_in->scene, camera), kBinned);
      const IdsInSpace ids(built_in->scene, camera, frame.frame());
      const int share = random_pixels / static_cast<int>(2 * known.size()) + 1;
      for (int i = 0; i < share; ++i, ++pixels) {
        const int x = static_cast<int>(random() % kPicture.width), y = static_cast<int>(random() % kPicture.height);
        Picked picked;
        ASSERT_TRUE(frame.pick(x, y, picked));
        const Judged verdict = judged(picked, ids.at(x, y));
        ASSERT_TRUE(verdict.right) << "pixel " << x << ", " << y << " shows " << static_cast<int>(picked.shown)
                                   << ", triangle " << picked.triangle << " of instance " << picked.index << ", not "
                                   << words_of(ids.at(x, y));
        decided += verdict.decided ? 1 : 0;
        shown += picked.shown == Shown::instance ? 1 : 0;
      }
    }
  }
  EXPECT_GE(pixels, random_pixels);
  EXPECT_GT(shown, random_pixels / 4);
  EXPECT_GT(decided, random_pixels / 2) << "the oracle abstains too often";
}

}  // namespace
}  // namespace effects_test
