// Converts a scene to polygons in world space, and back.
#include "visibility/polygon_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "import/meshlets.hpp"
#include "text/number.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {
namespace {

SoupPoint object_position(const Mesh& mesh, const Position& p) {
  const auto along = [](Fixed centre, Fixed half, std::int16_t position) {
    return (centre + half * (position / 32768.0)) / 65536;
  };
  return {along(mesh.centre.x, mesh.half_extent.x, p.x), along(mesh.centre.y, mesh.half_extent.y, p.y),
          along(mesh.centre.z, mesh.half_extent.z, p.z)};
}

SoupPoint transformed(const Transform& t, const SoupPoint& p, double w) {
  const auto row = [&](int i) { return (t.m[i][0] * p.x + t.m[i][1] * p.y + t.m[i][2] * p.z + t.m[i][3] * w) / 65536; };
  return {row(0), row(1), row(2)};
}

std::array<double, 3> channels(const Colour& c) { return {1.0 * c.r, 1.0 * c.g, 1.0 * c.b}; }

/// Returns the lit colour as the conventions define it: ambient and directional light, times material and vertex
/// colour.
std::array<double, 3> colour_of(const Scene& scene, const Mesh& mesh, const Instance& instance, std::uint16_t vertex) {
  const Material& material = scene.materials[instance.material];
  std::array<double, 3> colour = channels(material.colour);
  if (material.lit && !mesh.normals.empty()) {
    const Normal& n = mesh.normals[vertex];
    SoupPoint normal = transformed(instance.transform, {1.0 * n.x, 1.0 * n.y, 1.0 * n.z}, 0);
    const double length = std::sqrt(dot(normal, normal));
    std::array<double, 3> light = channels(scene.ambient);
    for (const DirectionalLight& l : scene.lights) {
      const double cosine = length > 0 ? dot(normal, {l.x / 32767.0, l.y / 32767.0, l.z / 32767.0}) / length : 0;
      const std::array<double, 3> own = channels(l.colour);
      for (std::size_t i = 0; i < 3; ++i) light[i] += std::max(0.0, cosine) * own[i];
    }
    for (std::size_t i = 0; i < 3; ++i) colour[i] = std::min(255.0, colour[i] * light[i] / 255);
  }
  if (!mesh.colours.empty()) {
    const std::array<double, 3> own = channels(mesh.colours[vertex]);
    for (std::size_t i = 0; i < 3; ++i) colour[i] *= own[i] / 255;
  }
  return colour;
}

struct Vertex {
  Position position;
  Colour colour;
};

/// Writes polygons as fans of triangles into meshlets, one after the other. Equal vertices are shared within a meshlet.
class MeshletWriter {
 public:
  MeshletWriter(std::vector<Position>& positions, std::vector<Colour>& colours, std::vector<Triangle>& triangles,
                std::vector<Meshlet>& meshlets)
      : positions_(positions), colours_(colours), triangles_(triangles), meshlets_(meshlets) {}

  /// Returns false if a mesh cannot have that many vertices.
  bool add(std::span<const Vertex> corners) {
    const bool fits = !meshlets_.empty() && meshlets_.back().vertex_count + corners.size() <= kMeshletVertices &&
                      meshlets_.back().triangle_count + corners.size() - 2 <= kMeshletTriangles;
    if (positions_.size() + corners.size() > kMaxMeshVertices) return false;
    if (!fits) {
      known_.clear();
      meshlets_.push_back({.first_triangle = static_cast<std::uint32_t>(triangles_.size()),
                           .first_vertex = static_cast<std::uint16_t>(positions_.size()),
                           .vertex_count = 0,
                           .triangle_count = 0,
                           .radius = 0,
                           .centre = {}});
    }
    std::vector<std::uint16_t> indices;
    for (const Vertex& corner : corners) indices.push_back(index_of(corner));
    for (std::size_t i = 1; i + 1 < indices.size(); ++i) triangles_.push_back({indices[0], indices[i], indices[i + 1]});
    meshlets_.back().triangle_count = static_cast<std::uint16_t>(triangles_.size() - meshlets_.back().first_triangle);
    return true;
  }

 private:
  std::uint16_t index_of(const Vertex& v) {
    const std::array<int, 6> key{v.position.x, v.position.y, v.position.z, v.colour.r, v.colour.g, v.colour.b};
    const auto [known, is_new] = known_.try_emplace(key, static_cast<std::uint16_t>(positions_.size()));
    if (is_new) {
      positions_.push_back(v.position);
      colours_.push_back(v.colour);
      ++meshlets_.back().vertex_count;
    }
    return known->second;
  }

  std::vector<Position>& positions_;
  std::vector<Colour>& colours_;
  std::vector<Triangle>& triangles_;
  std::vector<Meshlet>& meshlets_;
  std::map<std::array<int, 6>, std::uint16_t> known_;  ///< of the last meshlet
};

SoupCorner between(const SoupCorner& a, const SoupCorner& b, double t) {
  const auto mix = [t](double from, double to) { return from + t * (to - from); };
  SoupCorner corner{{mix(a.position.x, b.position.x), mix(a.position.y, b.position.y), mix(a.position.z, b.position.z)},
                    {}};
  for (std::size_t i = 0; i < 3; ++i) corner.colour[i] = mix(a.colour[i], b.colour[i]);
  return corner;
}

}  // namespace

double dot(const SoupPoint& a, const SoupPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
SoupPoint cross(const SoupPoint& a, const SoupPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
SoupPoint difference(const SoupPoint& a, const SoupPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

SoupPlane SoupPlane::of(const SoupPolygon& polygon) {
  SoupPoint sum;  // Newell's normal: sum over all corners
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const SoupPoint c = cross(difference(polygon[i].position, polygon[0].position),
                              difference(polygon[i + 1].position, polygon[0].position));
    sum = {sum.x + c.x, sum.y + c.y, sum.z + c.z};
  }
  const double length = std::sqrt(dot(sum, sum));
  if (length < 1e-15) return {};
  const SoupPoint normal{sum.x / length, sum.y / length, sum.z / length};
  return {normal, dot(normal, polygon[0].position)};
}

SoupSplit split(const SoupPolygon& polygon, const SoupPlane& plane) {
  SoupSplit result;
  bool any_front = false, any_back = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SoupCorner& a = polygon[i];
    const SoupCorner& b = polygon[(i + 1) % polygon.size()];
    const double da = plane.at(a.position), db = plane.at(b.position);
    if (da >= -kOnPlane) result.front.push_back(a);
    if (da <= kOnPlane) result.back.push_back(a);
    any_front |= da > kOnPlane;
    any_back |= da < -kOnPlane;
    if ((da > kOnPlane && db < -kOnPlane) || (da < -kOnPlane && db > kOnPlane)) {
      const SoupCorner cut = between(a, b, da / (da - db));
      result.front.push_back(cut);
      result.back.push_back(cut);
    }
  }
  if (!any_front) result.front.clear();
  if (!any_back) result.back.clear();
  return result;
}

Result<PolygonSoup> soup_of(const Scene& scene) {
  PolygonSoup soup;
  soup.background = scene.background;
  if (!scene.csg.empty()) {
    return Failure{ExitStatus::usage, "the triangles of CSG cannot be split: their solids are combined in the picture"};
  }
  const auto is_double_sided = [&](const Instance& i) { return scene.materials[i.material].double_sided; };
  soup.double_sided = std::ranges::all_of(scene.instances, is_double_sided);
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Material& material = scene.materials[instance.material];
    if (mesh.billboard != Billboard::none) {
      return Failure{ExitStatus::usage, "billboards cannot be split: they turn with the camera"};
    }
    if (outline_of(scene, mesh) != nullptr) {
      return Failure{ExitStatus::usage, "instances with outlines cannot be split: hulls have no place in the order"};
    }
    if (is_lit_by_pixel(mesh, material)) {
      return Failure{ExitStatus::usage, "triangles that are lit at pixels cannot be split, only those with colours"};
    }
    if (material.texture != kNoTexture && !mesh.texcoords.empty()) {
      return Failure{ExitStatus::usage, "triangles with textures cannot be split, only those with colours"};
    }
    soup.smooth |= material.smooth;
    for (const Triangle& t : mesh.triangles) {
      SoupPolygon polygon;
      for (const std::uint16_t vertex : {t.a, t.b, t.c}) {
        polygon.push_back({transformed(instance.transform, object_position(mesh, mesh.positions[vertex]), 1),
                           colour_of(scene, mesh, instance, material.smooth ? vertex : t.a)});
      }
      if (SoupPlane::of(polygon).degenerate()) continue;
      soup.polygons.push_back(polygon);
      if (material.double_sided && !soup.double_sided) {
        std::ranges::reverse(polygon);
        soup.polygons.push_back(std::move(polygon));
      }
    }
  }
  return soup;
}

Result<SoupScene> SoupScene::of(const PolygonSoup& soup) {
  SoupScene made;
  SoupPoint low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const SoupPolygon& polygon : soup.polygons) {
    for (const SoupCorner& c : polygon) {
      const SoupPoint& p = c.position;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  if (soup.polygons.empty()) return Failure{ExitStatus::usage, "the scene has no triangle of any area to sort"};
  const auto fixed_of = [](double value) { return static_cast<Fixed>(std::lround(value * 65536)); };
  Mesh mesh;
  mesh.centre = {fixed_of((low.x + high.x) / 2), fixed_of((low.y + high.y) / 2), fixed_of((low.z + high.z) / 2)};
  const auto half = [&](double from, double to) { return fixed_of((to - from) / 2 * (32768.0 / 32700)) + 1; };
  mesh.half_extent = {half(low.x, high.x), half(low.y, high.y), half(low.z, high.z)};
  const auto position = [](double value, Fixed centre, Fixed extent) {
    const double units = (value * 65536 - centre) / extent * 32768;
    return static_cast<std::int16_t>(std::lround(std::clamp(units, -32767.0, 32767.0)));
  };
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); };
  const auto vertex_of = [&](const SoupCorner& c) {
    return Vertex{{position(c.position.x, mesh.centre.x, mesh.half_extent.x),
                   position(c.position.y, mesh.centre.y, mesh.half_extent.y),
                   position(c.position.z, mesh.centre.z, mesh.half_extent.z)},
                  {byte(c.colour[0]), byte(c.colour[1]), byte(c.colour[2]), 255}};
  };
  MeshletWriter writer(made.positions_, made.colours_, made.triangles_, made.meshlets_);
  std::vector<Vertex> corners;
  for (const SoupPolygon& polygon : soup.polygons) {
    made.first_triangle_.push_back(made.triangles_.size());
    corners.clear();
    for (const SoupCorner& c : polygon) corners.push_back(vertex_of(c));
    if (!writer.add(corners)) {
      return Failure{ExitStatus::usage, fmt::format("{} pieces have more vertices than a mesh can, {}",
                                                    grouped(soup.polygons.size()), grouped(kMaxMeshVertices))};
    }
  }
  for (Meshlet& meshlet : made.meshlets_) {
    set_bounds(meshlet, std::span(made.positions_).subspan(meshlet.first_vertex, meshlet.vertex_count),
               mesh.half_extent);
  }
  mesh.positions = made.positions_;
  mesh.colours = made.colours_;
  mesh.triangles = made.triangles_;
  mesh.meshlets = made.meshlets_;
  made.mesh_.push_back(mesh);
  made.material_.push_back({.lit = false, .smooth = soup.smooth, .double_sided = soup.double_sided});
  made.instance_.push_back({});
  made.background_ = soup.background;
  return made;
}

Scene SoupScene::scene() const {
  return {.meshes = mesh_,
          .materials = material_,
          .textures = {},
          .instances = instance_,
          .lights = {},
          .ambient = {},
          .background = background_};
}

}  // namespace zstrip::sim
