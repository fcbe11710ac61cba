// A rasteriser in double precision for the small float, and what the renderer draws.
#include "images.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "../oracle/depth_picture.hpp"

namespace store_test {
namespace {

using namespace zstrip;

struct ViewPoint {
  double x, y, w;
};

ViewPoint between(const ViewPoint& a, const ViewPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

struct ScreenPoint {
  std::int64_t x, y;  ///< 1/16 pixels
  double inverse_w;
};

/// The part of `content` in the smallest rectangle that holds all drawn cells.
Image cropped(std::span<const std::uint16_t> depth, std::span<const std::uint16_t> content, const View& view) {
  int left = view.width, right = 0, top = view.height, bottom = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      if (depth[static_cast<std::size_t>(y * view.width + x)] == 0) continue;
      left = std::min(left, x), right = std::max(right, x + 1);
      top = std::min(top, y), bottom = std::max(bottom, y + 1);
    }
  }
  if (right <= left) return {};
  Image image{static_cast<std::uint16_t>(right - left), static_cast<std::uint16_t>(bottom - top), {}};
  for (int y = top; y < bottom; ++y) {
    const auto row = content.subspan(static_cast<std::size_t>(y * view.width + left), image.width);
    image.cells.insert(image.cells.end(), row.begin(), row.end());
  }
  return image;
}

class Rasteriser {
 public:
  Rasteriser(const Camera& camera, const View& view) : camera_(camera), view_(view) {
    cells.resize(std::size_t{view.width} * view.height);
  }

  ViewPoint to_view(const Mesh& mesh, const Transform& t, const Position& p) const {
    const auto object = [](std::int32_t centre, std::int32_t half, std::int16_t at) {
      return (centre + half * (at / 32768.0)) / kFixedOne;
    };
    const double o[3] = {object(mesh.centre.x, mesh.half_extent.x, p.x), object(mesh.centre.y, mesh.half_extent.y, p.y),
                         object(mesh.centre.z, mesh.half_extent.z, p.z)};
    double d[3];
    for (int i = 0; i < 3; ++i) {
      d[i] = (t.m[i][0] * o[0] + t.m[i][1] * o[1] + t.m[i][2] * o[2] + t.m[i][3]) / kFixedOne;
    }
    d[0] -= camera_.eye.x / 65536.0, d[1] -= camera_.eye.y / 65536.0, d[2] -= camera_.eye.z / 65536.0;
    const auto along = [&d](const Vec3& axis) {
      return (axis.x * d[0] + axis.y * d[1] + axis.z * d[2]) / (1 << 30);  // 2.30
    };
    return {along(camera_.right), along(camera_.up), -along(camera_.back)};
  }

  void draw(const std::array<ViewPoint, 3>& corners, bool double_sided) {
    const double near = camera_.near_plane / 65536.0;
    std::vector<ScreenPoint> polygon;
    for (std::size_t i = 0; i < 3; ++i) {
      const ViewPoint &a = corners[i], &b = corners[(i + 1) % 3];
      if (a.w >= near) polygon.push_back(project(a));
      if ((a.w >= near) != (b.w >= near)) polygon.push_back(project(between(a, b, (near - a.w) / (b.w - a.w))));
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) fill(polygon[0], polygon[i - 1], polygon[i], double_sided);
  }

  std::vector<std::uint16_t> cells;

 private:
  ScreenPoint project(const ViewPoint& p) const {
    const double scale = camera_.focal / 65536.0 * view_.height / 2 / p.w;
    return {std::llround((view_.width / 2.0 + scale * p.x) * 16), std::llround((view_.height / 2.0 - scale * p.y) * 16),
            1 / p.w};
  }

  /// Twice the area of a, b, (x, y); positive where (x, y) lies to the right of a -> b on the screen.
  static std::int64_t edge(const ScreenPoint& a, const ScreenPoint& b, std::int64_t x, std::int64_t y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }
  static bool owns(const ScreenPoint& a, const ScreenPoint& b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

  void fill(const ScreenPoint& a, ScreenPoint b, ScreenPoint c, bool double_sided) {
    std::int64_t area = edge(a, b, c.x, c.y);
    if (area < 0) {
      // Counter-clockwise with y up is negative here: the front.
      std::swap(b, c);
      area = -area;
    } else if (!double_sided || area == 0) {
      return;
    }
    const auto first = [](std::int64_t v) { return static_cast<int>(std::max<std::int64_t>(v / 16 - 1, 0)); };
    const auto last = [](std::int64_t v, int size) {
      return static_cast<int>(std::min<std::int64_t>(v / 16 + 1, size));
    };
    const int right = last(std::max({a.x, b.x, c.x}), view_.width),
              bottom = last(std::max({a.y, b.y, c.y}), view_.height);
    for (int y = first(std::min({a.y, b.y, c.y})); y < bottom; ++y) {
      for (int x = first(std::min({a.x, b.x, c.x})); x < right; ++x) {
        const std::int64_t u = edge(b, c, x * 16 + 8, y * 16 + 8), v = edge(c, a, x * 16 + 8, y * 16 + 8),
                           w = edge(a, b, x * 16 + 8, y * 16 + 8);
        if (u < (owns(b, c) ? 0 : 1) || v < (owns(c, a) ? 0 : 1) || w < (owns(a, b) ? 0 : 1)) continue;
        const double inverse_w = (static_cast<double>(u) * a.inverse_w + static_cast<double>(v) * b.inverse_w +
                                  static_cast<double>(w) * c.inverse_w) /
                                 static_cast<double>(area);
        const double code = std::floor(camera_.near_plane / 65536.0 * inverse_w * 4294967296.0);
        std::uint16_t& cell = cells[static_cast<std::size_t>(y * view_.width + x)];
        cell = std::max(
            {cell, std::uint16_t{1}, small_float(static_cast<std::uint32_t>(std::clamp(code, 0.0, 4294967295.0)))});
      }
    }
  }

  Camera camera_;
  View view_;
};

}  // namespace

Image draw_small_float(const Scene& scene, const Camera& camera, const View& view) {
  Rasteriser rasteriser(camera, view);
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    std::vector<ViewPoint> points;
    for (const Position& p : mesh.positions) points.push_back(rasteriser.to_view(mesh, instance.transform, p));
    for (const Triangle& t : mesh.triangles) {
      rasteriser.draw({points[t.a], points[t.b], points[t.c]}, scene.materials[instance.material].double_sided);
    }
  }
  return cropped(rasteriser.cells, rasteriser.cells, view);
}

namespace {

/// The whole view; empty if the renderer refuses the scene.
struct Drawn {
  std::vector<std::uint16_t> depth, colour;
};

Drawn draw(const Scene& scene, const Camera& camera, const View& view) {
  const picture::DepthPicture drawn = picture::render_depth(scene, camera, view);
  if (!drawn.status) return {};
  return {{drawn.depth.begin(), drawn.depth.end()}, rgb565_of(drawn)};
}

}  // namespace

Image draw_fitted(const Scene& scene, const Camera& camera, const View& view) {
  const Drawn drawn = draw(scene, camera, view);
  return drawn.depth.empty() ? Image{} : cropped(drawn.depth, drawn.depth, view);
}

Image draw_colour(const Scene& scene, const Camera& camera, const View& view) {
  const Drawn drawn = draw(scene, camera, view);
  return drawn.depth.empty() ? Image{} : cropped(drawn.depth, drawn.colour, view);
}

}  // namespace store_test
