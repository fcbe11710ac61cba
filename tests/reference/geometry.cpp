// Transform, light and depth range in double; see geometry.hpp.
#include "geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace zstrip::reference {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// `one` is the integer that stands for 1.
Vector vector_of(const Vec3& v, double one) { return {v.x / one, v.y / one, v.z / one}; }
Vector vector_of(const Colour& c) { return {c.r / 255.0, c.g / 255.0, c.b / 255.0}; }
Vector unit(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return length == 0 ? v : Vector{v[0] / length, v[1] / length, v[2] / length};
}
Vector product(const Vector& a, const Vector& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

constexpr double kOne16 = 65536;          // 16.16
constexpr double kOne30 = 1 << 30;        // 2.30
constexpr double kPositionUnit = 32768;   // half extents
constexpr double kNormalUnit = 127;       // 1.7
constexpr double kDirectionUnit = 32767;  // 1.15

/// Object to world.
class Motion {
 public:
  explicit Motion(const Transform& transform) {
    for (std::size_t i = 0; i < 3; ++i) {
      rows_[i] = {transform.m[i][0] / kOne16, transform.m[i][1] / kOne16, transform.m[i][2] / kOne16};
      offset_[i] = transform.m[i][3] / kOne16;
    }
  }
  Vector point(const Vector& p) const {
    const Vector turned = rotated(p);
    return {turned[0] + offset_[0], turned[1] + offset_[1], turned[2] + offset_[2]};
  }
  /// A normal keeps its length; the transform is a rotation with one scale.
  Vector normal(const Vector& n) const {
    const double scale = std::cbrt(std::abs(determinant()));
    const Vector turned = rotated(n);
    return scale == 0 ? Vector{} : Vector{turned[0] / scale, turned[1] / scale, turned[2] / scale};
  }

 private:
  Vector rotated(const Vector& p) const { return {dot(rows_[0], p), dot(rows_[1], p), dot(rows_[2], p)}; }
  double determinant() const {
    const auto minor = [this](std::size_t a, std::size_t b) {
      return rows_[1][a] * rows_[2][b] - rows_[1][b] * rows_[2][a];
    };
    return rows_[0][0] * minor(1, 2) - rows_[0][1] * minor(0, 2) + rows_[0][2] * minor(0, 1);
  }

  std::array<Vector, 3> rows_{};
  Vector offset_{};
};

/// World to view: x right, y up, z the distance in front of the camera.
class Eye {
 public:
  explicit Eye(const Camera& camera)
      : right_(vector_of(camera.right, kOne30)),
        up_(vector_of(camera.up, kOne30)),
        back_(vector_of(camera.back, kOne30)),
        position_(vector_of(camera.eye, kOne16)) {}
  Vector seen(const Vector& world) const {
    const Vector from{world[0] - position_[0], world[1] - position_[1], world[2] - position_[2]};
    return {dot(right_, from), dot(up_, from), -dot(back_, from)};
  }

 private:
  Vector right_, up_, back_, position_;
};

Vector object_point(const Mesh& mesh, double x, double y, double z) {
  const Vector centre = vector_of(mesh.centre, kOne16), half = vector_of(mesh.half_extent, kOne16);
  return {centre[0] + half[0] * x / kPositionUnit, centre[1] + half[1] * y / kPositionUnit,
          centre[2] + half[2] * z / kPositionUnit};
}

struct DepthRange {
  double near, far;
};

/// Where the boxes of the instances lie, inside the camera's planes.
DepthRange fitted(const Scene& scene, const Camera& camera, const Eye& eye) {
  const double near = camera.near_plane / kOne16, far = camera.far_plane / kOne16;
  double nearest = far, farthest = near;
  for (const Instance& instance : scene.instances) {
    const Motion motion(instance.transform);
    double low = far, high = near;
    for (int corner = 0; corner < 8; ++corner) {
      const auto side = [corner](int axis) { return (corner >> axis & 1) != 0 ? kPositionUnit : -kPositionUnit; };
      const double distance =
          eye.seen(motion.point(object_point(scene.meshes[instance.mesh], side(0), side(1), side(2))))[2];
      low = corner == 0 ? distance : std::min(low, distance);
      high = corner == 0 ? distance : std::max(high, distance);
    }
    if (high < near || low > far) continue;
    nearest = std::min(nearest, low);
    farthest = std::max(farthest, high);
  }
  DepthRange range{std::max(nearest, near), std::min(farthest, far)};
  // Geometry in the very ends of its range must not be lost to rounding.
  range.near -= range.near * 1e-6;
  range.far += range.far * 1e-6;
  return range;
}

/// Perspective: z/w is linear in 1/w. Orthographic: in the distance.
class Projector {
 public:
  Projector(const Camera& camera, const View& view, const DepthRange& range)
      : orthographic_(camera.projection == Projection::orthographic),
        focal_(camera.focal / kOne16),
        aspect_(static_cast<double>(view.width) / view.height),
        range_(range) {}
  void project(const Vector& seen, Corner& corner) const {
    const double distance = seen[2], depth = range_.far - range_.near;
    corner.x = static_cast<float>(focal_ * seen[0] / aspect_);
    corner.y = static_cast<float>(-focal_ * seen[1]);
    corner.w = orthographic_ ? 1.0F : static_cast<float>(distance);
    const double nearness = (range_.far - distance) / depth;
    corner.z = static_cast<float>(orthographic_ ? 2 * nearness - 1 : 2 * range_.near * nearness - distance);
  }

 private:
  bool orthographic_;
  double focal_, aspect_;
  DepthRange range_;
};

/// Ambient and directional light on the material, clamped, times the vertex colour; 0..255.
class Shader {
 public:
  Shader(const Scene& scene, const Instance& instance)
      : scene_(scene),
        mesh_(scene.meshes[instance.mesh]),
        material_(scene.materials[instance.material]),
        motion_(instance.transform),
        unlit_texture_(textured() && !material_.lit) {}

  bool textured() const { return material_.texture != kNoTexture && !mesh_.texcoords.empty(); }
  Vector colour(std::uint16_t vertex) const {
    if (unlit_texture_) return {255, 255, 255};
    Vector colour = vector_of(material_.colour);
    if (material_.lit && !mesh_.normals.empty()) colour = lit(mesh_.normals[vertex]);
    if (!mesh_.colours.empty()) colour = product(colour, vector_of(mesh_.colours[vertex]));
    return {255 * colour[0], 255 * colour[1], 255 * colour[2]};
  }

 private:
  Vector lit(const Normal& own) const {
    const Vector normal = motion_.normal({own.x / kNormalUnit, own.y / kNormalUnit, own.z / kNormalUnit});
    Vector light = vector_of(scene_.ambient);
    for (const DirectionalLight& source : scene_.lights) {
      const Vector towards = unit({source.x / kDirectionUnit, source.y / kDirectionUnit, source.z / kDirectionUnit});
      const double cosine = std::clamp(dot(normal, towards), 0.0, 1.0);
      const Vector colour = vector_of(source.colour);
      for (std::size_t c = 0; c < 3; ++c) light[c] += cosine * colour[c];
    }
    const Vector reflected = product(light, vector_of(material_.colour));
    return {std::min(reflected[0], 1.0), std::min(reflected[1], 1.0), std::min(reflected[2], 1.0)};
  }

  const Scene& scene_;
  const Mesh& mesh_;
  const Material& material_;
  Motion motion_;
  bool unlit_texture_;
};

/// Signed distance in front of the near end of the depth range.
float inside(const Corner& corner) { return corner.w - corner.z; }

/// Where an edge crosses the near end; everything is linear in clip space.
Corner crossing(const Corner& a, const Corner& b) {
  const double t = static_cast<double>(inside(a)) / (static_cast<double>(inside(a)) - inside(b));
  const auto between = [t](float from, float to) {
    return static_cast<float>(from + t * (static_cast<double>(to) - from));
  };
  const float w = between(a.w, b.w);
  return {between(a.x, b.x), between(a.y, b.y), w,         w, between(a.r, b.r), between(a.g, b.g), between(a.b, b.b),
          between(a.u, b.u), between(a.v, b.v), a.triangle};
}

/// Appends what lies in front of the camera, so that OpenGL never sees a corner behind it: colours that are linear on
/// the screen mean nothing there.
void append_clipped(const std::array<Corner, 3>& triangle, std::vector<Corner>& corners) {
  std::vector<Corner> polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (inside(a) >= 0) polygon.push_back(a);
    if ((inside(a) < 0) != (inside(b) < 0)) polygon.push_back(inside(a) < 0 ? crossing(b, a) : crossing(a, b));
  }
  for (std::size_t i = 2; i < polygon.size(); ++i)
    corners.insert(corners.end(), {polygon[0], polygon[i - 1], polygon[i]});
}

}  // namespace

Geometry geometry_of(const Scene& scene, const Camera& camera, const View& view) {
  const Eye eye(camera);
  const Projector projector(camera, view, fitted(scene, camera, eye));
  Geometry geometry;
  std::uint32_t number = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Material& material = scene.materials[instance.material];
    const Motion motion(instance.transform);
    const Shader shader(scene, instance);
    Batch batch{.first_corner = static_cast<std::uint32_t>(geometry.corners.size()),
                .texture = shader.textured() ? material.texture : kNoTexture,
                .double_sided = material.double_sided};
    for (const Triangle& triangle : mesh.triangles) {
      ++number;
      const std::array<std::uint16_t, 3> vertices{triangle.a, triangle.b, triangle.c};
      std::array<Corner, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint16_t vertex = vertices[i];
        Corner& corner = corners[i];
        const Position& p = mesh.positions[vertex];
        projector.project(eye.seen(motion.point(object_point(mesh, p.x, p.y, p.z))), corner);
        const Vector colour = shader.colour(material.smooth ? vertex : triangle.a);
        corner.r = static_cast<float>(colour[0]);
        corner.g = static_cast<float>(colour[1]);
        corner.b = static_cast<float>(colour[2]);
        if (shader.textured()) {
          const double one = 1 << mesh.texcoord_bits;
          corner.u = static_cast<float>(mesh.texcoords[vertex].u / one);
          corner.v = static_cast<float>(mesh.texcoords[vertex].v / one);
        }
        corner.triangle = number;
      }
      append_clipped(corners, geometry.corners);
    }
    batch.corners = static_cast<std::uint32_t>(geometry.corners.size()) - batch.first_corner;
    geometry.batches.push_back(batch);
  }
  return geometry;
}

}  // namespace zstrip::reference
