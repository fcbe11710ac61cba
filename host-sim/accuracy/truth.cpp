// Converts a scene to polygons with corners and looks, which truth_raster.hpp draws.
#include "accuracy/truth.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>

#include "accuracy/truth_light.hpp"
#include "accuracy/truth_quadrics.hpp"
#include "accuracy/truth_raster.hpp"
#include "motion/turned_billboard.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {
namespace {

using truth::ColourKind;
using truth::Corner;
using truth::dot;
using truth::kOne16;
using truth::kOne30;
using truth::Look;
using truth::transformed;
using truth::Vector;
using truth::vector_of;

Corner between(const Corner& a, const Corner& b, double t) {
  Corner c;
  c.x = a.x + t * (b.x - a.x);
  c.y = a.y + t * (b.y - a.y);
  c.w = a.w + t * (b.w - a.w);
  for (std::size_t i = 0; i < 3; ++i) c.share[i] = a.share[i] + t * (b.share[i] - a.share[i]);
  return c;
}

/// Keeps the part of the polygon with sign * (w - plane) >= 0.
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

Vector world_normal(const Transform& transform, const Normal& n) {
  return transformed(transform, {double(n.x), double(n.y), double(n.z)}, true);
}

/// True if each sample is lit: everywhere except on flat faces; with interpolation of light only as `stages` says.
bool is_lit_at_samples(const Mesh& mesh, const Material& material, const Stages& stages) {
  if (!material.lit || mesh.normals.empty()) return false;
  return material.smooth == Shading::pixel || (material.smooth && !stages.interpolation);
}

ColourKind kind_of(const Mesh& mesh, const Material& material, bool textured) {
  if (textured) return material.lit ? ColourKind::lit_texel : ColourKind::texel;
  const bool varies = (material.lit && !mesh.normals.empty()) || !mesh.colours.empty();
  return material.smooth && varies ? ColourKind::gradient : ColourKind::even;
}

/// Returns the colour of a vertex without its texture, and without light if samples are lit.
Vector vertex_colour(const Scene& scene, const Transform& transform, const Mesh& mesh, const Material& material,
                     std::uint16_t vertex, bool lit_at_samples) {
  Vector rgb{double(material.colour.r), double(material.colour.g), double(material.colour.b)};
  if (lit_at_samples) {
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

/// "outlines (room.toml line 12: has an outline: 'ink', 'pencil')"
std::string in_words(const FoundEffect& found) {
  const std::string place = found.origin.empty() ? "" : found.origin + ": ";
  const std::string materials =
      found.materials.empty() ? "" : fmt::format(": '{}'", fmt::join(found.materials, "', '"));
  return fmt::format("{} ({}{}{})", found.effect.name, place, found.effect.called_for_by, materials);
}

constexpr std::uint32_t kScale = 4;

/// Returns one of the 16 samples of a pixel.
const TruthSample& sample_of(const TruthPicture& fine, std::uint32_t x, std::uint32_t y, std::uint32_t i) {
  return fine.at(kScale * x + i % kScale, kScale * y + i / kScale);
}

MeanPicture mean_of(const TruthPicture& fine, const View& view) {
  MeanPicture mean;
  for (std::uint32_t y = 0; y < view.height; ++y) {
    for (std::uint32_t x = 0; x < view.width; ++x) {
      std::array<float, 3> sum{};
      for (std::uint32_t i = 0; i < 16; ++i) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += sample_of(fine, x, y, i).rgb[c] / 16;
      }
      mean.push_back(sum);
    }
  }
  return mean;
}

}  // namespace

Result<Done> check_truth(const Scene& scene, const Camera& camera, const Origins& origins) {
  constexpr Effects kDrawn = effect::all | effect::shades | effect::fog | effect::emissive | effect::quadrics |
                             effect::billboards | effect::pixel_shading;
  const Effects others = without(effects_of(scene, camera), kDrawn);
  if (others == Effects{}) return Done{};
  std::string list;
  for (const FoundEffect& found : find_effects(scene, camera, others, origins)) {
    list += fmt::format("{}{}", list.empty() ? "" : ", ", in_words(found));
  }
  return Failure{
      ExitStatus::input,
      fmt::format("no truth can be drawn of effects in this scene: {}; it can be drawn of triangles and quadrics "
                  "with directional light, emission, vertex colours, nearest texels and fog{}",
                  list,
                  others.has(effect::depth_state)
                      ? "; the result of a depth test or bias depends on the z-buffer's codes"
                      : "")};
}

Result<TruthPicture> draw_truth(const Scene& scene, const Camera& camera, const View& view, std::uint32_t scale,
                                const Stages& stages) {
  if (const Result<Done> checked = check_truth(scene, camera, {}); !checked) return checked.failure();
  truth::Rasteriser rasteriser(camera, view, scale, scene, stages);
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
    const bool lit_at_samples = is_lit_at_samples(mesh, material, stages);
    const truth::FixedTransform fixed(mesh, transform, camera, view);
    for (const Triangle& triangle : mesh.triangles) {
      const std::array<std::uint16_t, 3> index{triangle.a, triangle.b, triangle.c};
      Look look{.number = number++, .rgb = {}, .uv = {}, .kind = kind_of(mesh, material, textured)};
      if (lit_at_samples) {
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
        if (stages.transform) {
          const truth::FixedVertex vertex = fixed.at(p);
          polygon[i] = {vertex.x, vertex.y, vertex.w, {}};
        }
        polygon[i].share[i] = 1;
        look.rgb[i] =
            vertex_colour(scene, transform, mesh, material, material.smooth ? index[i] : index[0], lit_at_samples);
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
    const Material& material = scene.materials[quadric.material];
    const ColourKind texels = material.lit ? ColourKind::lit_texel : ColourKind::texel;
    rasteriser.draw(truth::QuadricTruth(scene, quadric, camera), number++,
                    material.texture == kNoTexture ? ColourKind::gradient : texels);
  }
  return rasteriser.take();
}

Result<MeanPicture> draw_mean(const Scene& scene, const Camera& camera, const View& view) {
  const Result<TruthPicture> fine = draw_truth(scene, camera, view, kScale);
  if (!fine) return fine.failure();
  return mean_of(*fine, view);
}

Result<Truth> find_truth(const Scene& scene, const Camera& camera, const View& view) {
  Result<TruthPicture> centres = draw_truth(scene, camera, view, 1);
  if (!centres) return centres.failure();
  const Result<TruthPicture> fine = draw_truth(scene, camera, view, kScale);
  if (!fine) return fine.failure();
  Result<TruthPicture> snapped = draw_truth(scene, camera, view, 1, {.snapping = true});
  if (!snapped) return snapped.failure();
  Truth truth;
  truth.centres = std::move(*centres);
  truth.snapped = std::move(*snapped);
  truth.mean = mean_of(*fine, view);
  for (std::uint32_t y = 0; y < view.height; ++y) {
    for (std::uint32_t x = 0; x < view.width; ++x) {
      std::array<std::uint32_t, 16> seen{};
      for (std::uint32_t i = 0; i < 16; ++i) seen[i] = sample_of(*fine, x, y, i).triangle;
      truth.triangles.push_back(seen);
    }
  }
  return truth;
}

}  // namespace zstrip::sim
