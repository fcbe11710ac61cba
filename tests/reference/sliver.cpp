// See sliver.hpp.
#include "sliver.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"

namespace zstrip::reference {

namespace {

/// Pixels: twice as far as snapping moves two vertices towards each other.
constexpr double kThin = 1.0 / 8;

double edge_length(const ScreenTriangle& triangle, int from, int to) {
  return std::hypot(triangle.x[to] - triangle.x[from], triangle.y[to] - triangle.y[from]);
}

/// Positive for triangles that face the camera; y grows downwards.
double doubled_area(const ScreenTriangle& triangle) {
  const double* const x = triangle.x;
  const double* const y = triangle.y;
  return (x[2] - x[0]) * (y[1] - y[0]) - (x[1] - x[0]) * (y[2] - y[0]);
}

bool may_face_front(const ScreenTriangle& triangle) {
  const double longest =
      std::max({edge_length(triangle, 0, 1), edge_length(triangle, 1, 2), edge_length(triangle, 2, 0)});
  return doubled_area(triangle) > -kThin * longest;
}

ScreenTriangle projected(const Corner* corners, const View& view) {
  ScreenTriangle triangle{{}, {}, 0, corners, false};
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& corner = corners[k];
    triangle.x[k] = (1 + static_cast<double>(corner.x) / corner.w) * view.width / 2;
    triangle.y[k] = (1 + static_cast<double>(corner.y) / corner.w) * view.height / 2;
    triangle.nearest = std::max(triangle.nearest, depth_code(corner));
  }
  return triangle;
}

}  // namespace

std::vector<ScreenTriangle> on_screen(const Geometry& geometry, const View& view) {
  std::vector<ScreenTriangle> triangles;
  for (const Batch& batch : geometry.batches) {
    for (std::uint32_t i = 0; i < batch.corners; i += 3) {
      ScreenTriangle triangle = projected(&geometry.corners[batch.first_corner + i], view);
      triangle.textured = batch.texture != kNoTexture;
      if (batch.double_sided || may_face_front(triangle)) triangles.push_back(triangle);
    }
  }
  return triangles;
}

double distance(const ScreenTriangle& triangle, double x, double y) {
  int left = 0, right = 0;
  double nearest = INFINITY;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double edge_x = triangle.x[j] - triangle.x[i], edge_y = triangle.y[j] - triangle.y[i];
    const double from_x = x - triangle.x[i], from_y = y - triangle.y[i];
    const double side = edge_x * from_y - edge_y * from_x;
    if (side >= 0) ++left;
    if (side <= 0) ++right;
    const double length = edge_x * edge_x + edge_y * edge_y;
    const double t = length == 0 ? 0 : std::clamp((edge_x * from_x + edge_y * from_y) / length, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(from_x - t * edge_x, from_y - t * edge_y));
  }
  return (left == 3) != (right == 3) ? 0 : nearest;  // both: all on one line
}

}  // namespace zstrip::reference
