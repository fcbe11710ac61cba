// The rasteriser in double precision.
#include "accuracy/truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "accuracy/truth_light.hpp"
#include "accuracy/truth_quadrics.hpp"
#include "motion/turned_billboard.hpp"
#include "zstrip/scene/effects.hpp"

namespace zstrip::sim {
namespace {

using truth::dot;
using truth::kOne16;
using truth::kOne30;
using truth::texel_at;
using truth::transformed;
using truth::Vector;
using truth::vector_of;

/// A corner of a polygon: where it is, and how much of each corner of the triangle it is.
struct Corner {
  double x = 0, y = 0, w = 0;  ///< view space, w along the viewing direction
  Vector share{};
};

Corner between(const Corner& a, const Corner& b, double t) {
  Corner c;
  c.x = a.x + t * (b.x - a.x);
  c.y = a.y + t * (b.y - a.y);
  c.w = a.w + t * (b.w - a.w);
  for (std::size_t i = 0; i < 3; ++i) c.share[i] = a.share[i] + t * (b.share[i] - a.share[i]);
  return c;
}

/// Keeps where sign * (w - plane) >= 0.
std::vector<Corner> cut(const std::vector<Corner>& polygon, double plane, double sign) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a.w - plane);
    const double db = sign * (b.w - plane);
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0)) kept.push_back(between(a, b, da / (da - db)));
  }
  return kept;
}

/// What a triangle looks like, whatever its shape on the screen.
struct Look {
  std::uint32_t number = 0;
  std::array<Vector, 3> rgb{};                ///< 0..255, of the corners
  std::array<std::array<double, 2>, 3> uv{};  ///< texels
  const Texture* texture = nullptr;
  bool lit_texture = false;
  const Scene* scene = nullptr;        ///< only where pixels are lit: `rgb` are vertex colours then
  const Material* material = nullptr;  ///< likewise
  std::array<Vector, 3> normal{};      ///< likewise, in the world, as long as the mesh's
};

class Rasteriser {
 public:
  Rasteriser(const Camera& camera, const View& view, std::uint32_t scale, const Scene& scene, bool snap)
      : orthographic_(camera.projection == Projection::orthographic), snap_(snap), fog_(scene.fog) {
    picture_.width = view.width * scale;
    picture_.height = view.height * scale;
    TruthSample empty;
    const Colour& background = scene.background;
    empty.rgb = {static_cast<float>(background.r), static_cast<float>(background.g), static_cast<float>(background.b)};
    picture_.samples.assign(std::size_t{picture_.width} * picture_.height, empty);
    focal_ = camera.focal / kOne16 * picture_.height / 2.0;
  }

  void draw(const std::vector<Corner>& polygon, const Look& look, bool double_sided) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      draw_triangle({project(polygon[0]), project(polygon[i - 1]), project(polygon[i])}, look, double_sided);
    }
  }

  void draw(const truth::QuadricTruth& quadric, std::uint32_t number) {
    for (std::uint32_t y = 0; y < picture_.height; ++y) {
      for (std::uint32_t x = 0; x < picture_.width; ++x) {
        const std::optional<truth::QuadricSample> seen =
            quadric.at((x + 0.5 - picture_.width / 2.0) / picture_.height, 0.5 - (y + 0.5) / picture_.height);
        if (seen)
          show(picture_.samples[std::size_t{y} * picture_.width + x], number, seen->w, {seen->u, seen->v}, seen->rgb);
      }
    }
  }
  TruthPicture take() { return std::move(picture_); }

 private:
  struct Point {
    double x, y, q;  ///< picture coordinates; 1/w, or 1 without perspective
    double w;
    Vector share;
  };

  Point project(const Corner& c) const {
    const double q = orthographic_ ? 1 : 1 / c.w;
    // To nearest, halves up (docs/conventions.md).
    const auto snapped = [&](double at) { return snap_ ? std::floor(at * 16 + 0.5) / 16 : at; };
    return {snapped(picture_.width / 2.0 + c.x * q * focal_), snapped(picture_.height / 2.0 - c.y * q * focal_), q, c.w,
            c.share};
  }

  static double edge(const Point& a, const Point& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }
  /// With y downwards and a positive area: the interior lies to the right of the edge's direction.
  static bool is_top_left(const Point& a, const Point& b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

  void draw_triangle(std::array<Point, 3> p, const Look& look, bool double_sided) {
    double area = edge(p[0], p[1], p[2].x, p[2].y);
    // Counter-clockwise before y is turned downwards: negative here.
    if (area > 0 && !double_sided) return;
    if (area < 0) std::swap(p[1], p[2]), area = -area;
    if (!(area > 0)) return;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto clamped = [](double at, std::uint32_t size) {
      return static_cast<std::uint32_t>(std::clamp(std::floor(at), 0.0, static_cast<double>(size)));
    };
    const std::uint32_t x_end = clamped(right + 1, picture_.width), y_end = clamped(bottom + 1, picture_.height);
    const std::array<bool, 3> owns{is_top_left(p[1], p[2]), is_top_left(p[2], p[0]), is_top_left(p[0], p[1])};
    for (std::uint32_t y = clamped(top, picture_.height); y < y_end; ++y) {
      for (std::uint32_t x = clamped(left, picture_.width); x < x_end; ++x) {
        const double at_x = x + 0.5, at_y = y + 0.5;
        const Vector e{edge(p[1], p[2], at_x, at_y), edge(p[2], p[0], at_x, at_y), edge(p[0], p[1], at_x, at_y)};
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) inside = inside && (e[i] > 0 || (e[i] == 0 && owns[i]));
        if (inside) shade(picture_.samples[std::size_t{y} * picture_.width + x], p, e, area, look);
      }
    }
  }

  void shade(TruthSample& sample, const std::array<Point, 3>& p, const Vector& e, double area, const Look& look) const {
    double q = 0, w = 0;
    Vector share{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = e[i] / area * p[i].q;
      q += weight;
      w += e[i] / area * p[i].w;
      for (std::size_t j = 0; j < 3; ++j) share[j] += weight * p[i].share[j];
    }
    const double distance = orthographic_ ? w : 1 / q;
    if (is_hidden(sample, distance)) return;
    Vector rgb{};
    double u = 0, v = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const double part = share[j] / q;
      for (std::size_t c = 0; c < 3; ++c) rgb[c] += part * look.rgb[j][c];
      u += part * look.uv[j][0];
      v += part * look.uv[j][1];
    }
    if (look.material != nullptr) {
      Vector normal{};
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t c = 0; c < 3; ++c) normal[c] += share[j] / q * look.normal[j][c];
      }
      const Vector light = truth::lit_colour(*look.scene, *look.material, normal);
      for (std::size_t c = 0; c < 3; ++c) rgb[c] *= light[c] / 255;
    }
    if (look.texture != nullptr) {
      const Vector texel = texel_at(*look.texture, u, v);
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = look.lit_texture ? rgb[c] * texel[c] / 255 : texel[c];
    }
    show(sample, look.number, distance, {u, v}, rgb);
  }

  /// If nothing nearer is there.
  void show(TruthSample& sample, std::uint32_t number, double w, const std::array<double, 2>& uv, Vector rgb) const {
    if (is_hidden(sample, w)) return;
    if (fog_ != nullptr) {
      const double share = truth::visible_share(*fog_, w);
      const Vector other{double(fog_->colour.r), double(fog_->colour.g), double(fog_->colour.b)};
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = share * rgb[c] + (1 - share) * other[c];
    }
    sample = {number, w, static_cast<float>(uv[0]), static_cast<float>(uv[1]), {}};
    for (std::size_t c = 0; c < 3; ++c) sample.rgb[c] = static_cast<float>(std::clamp(rgb[c], 0.0, 255.0));
  }
  static bool is_hidden(const TruthSample& sample, double w) { return sample.triangle != kNoTriangle && sample.w <= w; }

  bool orthographic_, snap_;
  const Fog* fog_;
  double focal_;
  TruthPicture picture_;
};

Vector world_normal(const Transform& transform, const Normal& n) {
  return transformed(transform, {double(n.x), double(n.y), double(n.z)}, true);
}

/// The colour of a vertex without its texture, and without light where that is its pixels'.
Vector vertex_colour(const Scene& scene, const Transform& transform, const Mesh& mesh, const Material& material,
                     std::uint16_t vertex) {
  Vector rgb{double(material.colour.r), double(material.colour.g), double(material.colour.b)};
  if (is_lit_by_pixel(mesh, material)) {
    rgb = {255, 255, 255};
  } else if (material.lit && !mesh.normals.empty()) {
    rgb = truth::lit_colour(scene, material, world_normal(transform, mesh.normals[vertex]));
  }
  if (!mesh.colours.empty()) {
    const Colour& own = mesh.colours[vertex];
    rgb = {rgb[0] * own.r / 255, rgb[1] * own.g / 255, rgb[2] * own.b / 255};
  }
  return rgb;
}

bool has_own_depth(const Material& m) {
  return m.depth_test != DepthTest::nearer || !m.depth_write || m.depth_bias != 0 || m.depth_slope_bias != 0;
}

}  // namespace

Result<TruthPicture> draw_truth(const Scene& scene, const Camera& camera, const View& view, std::uint32_t scale,
                                bool snap) {
  if (std::ranges::any_of(scene.materials, has_own_depth)) {
    return Failure{ExitStatus::input,
                   "the scene has materials with a depth test, write or bias of their own: what is right there depends "
                   "on the z-buffer's codes, so that no truth can be drawn"};
  }
  constexpr Effects kKnown =
      effect::all | effect::fog | effect::emissive | effect::quadrics | effect::billboards | effect::pixel_shading;
  if (without(effects_of(scene, camera), kKnown) != Effects{}) {
    return Failure{
        ExitStatus::input,
        "the scene has highlights, point or spot lights, alpha, bilinear texels, palettes, mipmaps, environments, "
        "lines, outlines, shadows or products of solids, and the truth knows none of these: it draws triangles and "
        "quadrics with "
        "directional light, emission, textures and fog"};
  }
  Rasteriser rasteriser(camera, view, scale, scene, snap);
  const Vector right = vector_of(camera.right, kOne30), up = vector_of(camera.up, kOne30),
               back = vector_of(camera.back, kOne30), eye = vector_of(camera.eye, kOne16);
  std::uint32_t number = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Material& material = scene.materials[instance.material];
    const Transform transform = standing(scene, instance, camera);
    const Vector centre = vector_of(mesh.centre, kOne16), extent = vector_of(mesh.half_extent, kOne16);
    const bool textured = material.texture != kNoTexture && !mesh.texcoords.empty();
    const double texcoord_one = std::ldexp(1.0, mesh.texcoord_bits);
    for (const Triangle& triangle : mesh.triangles) {
      const std::array<std::uint16_t, 3> index{triangle.a, triangle.b, triangle.c};
      Look look{.number = number++, .rgb = {}, .uv = {}};
      if (is_lit_by_pixel(mesh, material)) {
        look.scene = &scene, look.material = &material;
        for (std::size_t i = 0; i < 3; ++i) look.normal[i] = world_normal(transform, mesh.normals[index[i]]);
      }
      std::vector<Corner> polygon(3);
      for (std::size_t i = 0; i < 3; ++i) {
        const Position& p = mesh.positions[index[i]];
        const Vector local{centre[0] + extent[0] * p.x / 32768, centre[1] + extent[1] * p.y / 32768,
                           centre[2] + extent[2] * p.z / 32768};
        const Vector world = transformed(transform, local, false);
        const Vector seen{world[0] - eye[0], world[1] - eye[1], world[2] - eye[2]};
        polygon[i] = {dot(seen, right), dot(seen, up), -dot(seen, back), {}};
        polygon[i].share[i] = 1;
        look.rgb[i] = vertex_colour(scene, transform, mesh, material, material.smooth ? index[i] : index[0]);
        if (textured) {
          const Texture& texture = scene.textures[material.texture];
          look.uv[i] = {std::ldexp(mesh.texcoords[index[i]].u / texcoord_one, texture.log2_width),
                        std::ldexp(mesh.texcoords[index[i]].v / texcoord_one, texture.log2_height)};
          look.texture = &texture;
          look.lit_texture = material.lit;
        }
      }
      polygon = cut(cut(polygon, camera.near_plane / kOne16, 1), camera.far_plane / kOne16, -1);
      rasteriser.draw(polygon, look, material.double_sided);
    }
  }
  for (const Quadric& quadric : scene.quadrics) {
    rasteriser.draw(truth::QuadricTruth(scene, quadric, camera), number++);
  }
  return rasteriser.take();
}

Result<Truth> find_truth(const Scene& scene, const Camera& camera, const View& view) {
  constexpr std::uint32_t kScale = 4;
  Result<TruthPicture> centres = draw_truth(scene, camera, view, 1);
  if (!centres) return centres.failure();
  const Result<TruthPicture> fine = draw_truth(scene, camera, view, kScale);
  if (!fine) return fine.failure();
  Result<TruthPicture> snapped = draw_truth(scene, camera, view, 1, true);
  if (!snapped) return snapped.failure();
  Truth truth;
  truth.centres = std::move(*centres);
  truth.snapped = std::move(*snapped);
  for (std::uint32_t y = 0; y < view.height; ++y) {
    for (std::uint32_t x = 0; x < view.width; ++x) {
      std::array<float, 3> sum{};
      std::array<std::uint32_t, 16> seen{};
      for (std::uint32_t i = 0; i < 16; ++i) {
        const TruthSample& sample = fine->at(kScale * x + i % kScale, kScale * y + i / kScale);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += sample.rgb[c] / 16;
        seen[i] = sample.triangle;
      }
      truth.mean.push_back(sum);
      truth.triangles.push_back(seen);
    }
  }
  return truth;
}

}  // namespace zstrip::sim
