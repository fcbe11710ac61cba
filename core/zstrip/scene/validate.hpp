// Checks a scene once, before it is drawn any number of times. constexpr, so that the compiler can check a baked scene:
//     static_assert(validate(scene));
// A scene that passes cannot make the renderer read or write outside the scene's and the caller's memory.
#pragma once

#include "zstrip/effects.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/valid_overlay.hpp"
#include "zstrip/status.hpp"

namespace zstrip {
namespace detail {

inline constexpr Fixed kMaxMeshLength = (Fixed{1} << 28) - 1;  // 16.16: below 4096; see docs/numerics.md
inline constexpr Fixed kMaxScale = (Fixed{1} << 24) - 1;       // 16.16: below 256
inline constexpr std::uint8_t kMaxTextureLog2 = 11;

constexpr bool within(Fixed value, Fixed limit) { return value >= -limit && value <= limit; }

constexpr bool valid_meshlets(const Mesh& mesh) {
  std::uint32_t next_triangle = 0;
  for (const Meshlet& meshlet : mesh.meshlets) {
    if (meshlet.first_triangle != next_triangle || meshlet.vertex_count == 0) return false;
    next_triangle += meshlet.triangle_count;
    const std::uint32_t end_vertex = std::uint32_t{meshlet.first_vertex} + meshlet.vertex_count;
    if (end_vertex > mesh.positions.size() || next_triangle > mesh.triangles.size()) return false;
    for (const Triangle& t : mesh.triangles.subspan(meshlet.first_triangle, meshlet.triangle_count)) {
      for (const std::uint32_t index : {t.a, t.b, t.c}) {
        if (index < meshlet.first_vertex || index >= end_vertex) return false;
      }
    }
  }
  return mesh.meshlets.empty() || next_triangle == mesh.triangles.size();
}

constexpr bool valid_mesh(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  const auto one_each_or_none = [vertices](std::size_t count) { return count == 0 || count == vertices; };
  if (vertices == 0 || vertices > 65535 || mesh.triangles.size() > 0xFFFFFF) return false;
  if (!one_each_or_none(mesh.normals.size()) || !one_each_or_none(mesh.colours.size()) ||
      !one_each_or_none(mesh.texcoords.size())) {
    return false;
  }
  if (mesh.texcoord_bits < 4 || mesh.texcoord_bits > 15 || mesh.billboard > Billboard::upright ||
      mesh.shadow > ShadowRole::none) {
    return false;
  }
  for (const Fixed c : {mesh.centre.x, mesh.centre.y, mesh.centre.z}) {
    if (!within(c, kMaxMeshLength)) return false;
  }
  for (const Fixed h : {mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z}) {
    if (h < 0 || h > kMaxMeshLength) return false;
  }
  for (const Triangle& t : mesh.triangles) {
    if (t.a >= vertices || t.b >= vertices || t.c >= vertices) return false;
  }
  return valid_meshlets(mesh);
}

constexpr bool valid_transform(const Transform& transform) {
  for (const auto& row : transform.m) {
    for (int column = 0; column < 3; ++column) {
      if (!within(row[column], kMaxScale)) return false;
    }
  }
  return true;
}

/// True if no axis is longer than an entry may be: after a rotation it may lie along an axis of the world.
constexpr bool is_turnable(const Transform& transform) {
  for (int column = 0; column < 3; ++column) {
    std::int64_t square = 0;
    for (const auto& row : transform.m) square += std::int64_t{row[column]} * row[column];
    if (square > std::int64_t{kMaxScale} * kMaxScale) return false;
  }
  return true;
}

constexpr bool valid_instance(const Scene& scene, const Instance& instance) {
  return instance.mesh < scene.meshes.size() && instance.material < scene.materials.size() &&
         valid_transform(instance.transform);
}

/// Quadrics have no finish, and only directional lights light them: a material that needs more is refused.
constexpr bool valid_quadric(const Scene& scene, const Quadric& quadric) {
  if (quadric.material >= scene.materials.size() || !valid_transform(quadric.transform)) return false;
  const Material& material = scene.materials[quadric.material];
  const bool plain_texture =
      material.texture >= scene.textures.size() || scene.textures[material.texture].format == TextureFormat::rgb565;
  return material.depth_slope_bias == 0 && material.finish >= scene.finishes.size() && plain_texture &&
         (!material.lit || scene.punctual_lights.empty());
}

/// Refuses properties of materials that lines ignore.
constexpr bool valid_lines(const Scene& scene, const LineSet& lines) {
  if (lines.mesh >= scene.meshes.size() || lines.material >= scene.materials.size()) return false;
  const Material& material = scene.materials[lines.material];
  return valid_transform(lines.transform) && lines.width >= 1 && lines.width <= kMaxLineWidth &&
         material.texture == kNoTexture && material.finish >= scene.finishes.size() && material.depth_slope_bias == 0;
}

constexpr bool valid_segments(const Scene& scene, const LineSet& lines) {
  const std::size_t vertices = scene.meshes[lines.mesh].positions.size();
  for (const Segment& segment : lines.segments) {
    if (segment.a >= vertices || segment.b >= vertices) return false;
  }
  return true;
}

/// Texture coordinates in texels have 16 bits before the point: 2048 texels may repeat 16 times on either side of 0.
constexpr bool valid_texcoords(const Scene& scene, const Instance& instance) {
  const Material& material = scene.materials[instance.material];
  const std::uint16_t texture = material.texture;
  const Mesh& mesh = scene.meshes[instance.mesh];
  if (texture == kNoTexture || has_environment_map(scene, mesh, material)) return true;
  const auto fits = [&mesh](std::int32_t coordinate, std::uint8_t log2_size) {
    const std::int64_t magnitude = coordinate < 0 ? -std::int64_t{coordinate} : coordinate;
    return magnitude << log2_size < std::int64_t{1} << (15 + mesh.texcoord_bits);
  };
  for (const TexCoord& t : mesh.texcoords) {
    if (!fits(t.u, scene.textures[texture].log2_width) || !fits(t.v, scene.textures[texture].log2_height)) return false;
  }
  return true;
}

/// False if an environment map has no normals to use.
constexpr bool can_mirror(const Scene& scene, const Instance& instance) {
  return !is_environment(finish_of(scene, scene.materials[instance.material]).filter) ||
         !scene.meshes[instance.mesh].normals.empty();
}

/// Checks a set of edges; `i` is its index.
constexpr bool valid_edges(const Scene& scene, std::size_t i) {
  const EdgeSet& set = scene.edges[i];
  if (set.mesh >= scene.meshes.size() || (i != 0 && set.mesh <= scene.edges[i - 1].mesh)) return false;
  const std::size_t vertices = scene.meshes[set.mesh].positions.size();
  for (const Edge& edge : set.edges) {
    if (edge.a >= vertices || edge.b >= vertices || edge.left >= vertices) return false;
    if (edge.right != kNoFace && edge.right >= vertices) return false;
  }
  return true;
}

constexpr bool valid_fog(const Fog& fog) {
  return fog.mode <= FogMode::exponential_squared && fog.start >= 0 && fog.start < fog.end && fog.density >= 0;
}

/// Returns the words that a texture of this size, format and number of levels has.
constexpr std::size_t texel_words(const Texture& texture) {
  std::size_t words = has_palette(texture.format) ? std::size_t{1} << index_bits(texture.format) : 0;
  std::uint32_t log2_width = texture.log2_width, log2_height = texture.log2_height;
  for (std::uint32_t level = 0; level <= texture.smaller_levels; ++level) {
    words += level_words(texture.format, log2_width + log2_height);
    if (log2_width != 0) --log2_width;
    if (log2_height != 0) --log2_height;
  }
  return words;
}

constexpr bool valid_punctual_light(const PunctualLight& light) {
  return light.type <= PunctualLightType::spot && light.intensity >= 0 && light.range >= 0 && light.cosine_outer >= 0 &&
         light.cosine_outer < light.cosine_inner;
}

constexpr bool valid_finish(const Finish& finish) {
  const bool known = finish.filter <= TextureFilter::bilinear || finish.filter == TextureFilter::environment_nearest ||
                     finish.filter == TextureFilter::environment_bilinear;
  return known && finish.alpha_mode <= AlphaMode::blend;
}

/// Checks an outline without the materials of its instances.
constexpr bool valid_outline(const Scene& scene, const Outline& outline) {
  const bool has_hull =
      outline.hull == kOwnMesh || (outline.hull < scene.meshes.size() && !scene.meshes[outline.hull].normals.empty());
  return outline.width >= 1 && outline.width <= kMaxOutlineWidth && has_hull;
}

/// False for masked and blended materials: the far side of the hull would be seen through them. Indices must be valid.
constexpr bool can_have_outline(const Scene& scene, const Instance& instance, const Outline& outline) {
  const std::uint8_t finish = scene.materials[instance.material].finish;
  return !scene.meshes[hull_of(outline, instance)].normals.empty() &&
         (finish == kNoFinish || scene.finishes[finish].alpha_mode == AlphaMode::opaque);
}

/// True if the depth test passes farther fragments: then the nearest code in a cell does not keep a fragment hidden.
constexpr bool asks_for_farther(const Material& material) {
  return (static_cast<unsigned>(material.depth_test) & static_cast<unsigned>(DepthTest::farther)) != 0;
}

/// Checks the shadow. begin_frame calls it, too: lights and materials may change between frames.
constexpr bool valid_shadow(const Scene& scene, const Shadow& shadow) {
  if (shadow.light >= scene.lights.size() || shadow.log2_size < kMinShadowLog2 || shadow.log2_size > kMaxShadowLog2 ||
      shadow.slope_bias < 0) {
    return false;
  }
  for (const Material& material : scene.materials) {
    if (asks_for_farther(material)) return false;
  }
  return true;
}

/// True if the instance is a solid without holes whose surface a z-buffer can hold. Indices of instances must be valid.
constexpr bool can_be_operand(const Scene& scene, const Instance& instance) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  const Material& material = scene.materials[instance.material];
  return mesh.billboard == Billboard::none && mesh.outline == 0 && !has_depth_state(material) &&
         finish_of(scene, material).alpha_mode == AlphaMode::opaque;
}

/// Checks an operand; `i` is its index.
constexpr bool valid_csg_operand(const Scene& scene, std::size_t i) {
  const CsgOperand& operand = scene.csg[i];
  if (operand.instance >= scene.instances.size() || operand.use > CsgUse::subtracted ||
      !can_be_operand(scene, scene.instances[operand.instance])) {
    return false;
  }
  if (i != 0 && operand.product < scene.csg[i - 1].product) return false;
  bool intersects = false;
  for (const CsgOperand& other : scene.csg) {
    if (other.product == operand.product && other.use == CsgUse::intersected) intersects = true;
  }
  return intersects;
}

constexpr bool valid_texture(const Texture& texture) {
  return texture.log2_width <= kMaxTextureLog2 && texture.log2_height <= kMaxTextureLog2 &&
         texture.format <= TextureFormat::palette4 &&
         (texture.smaller_levels <= texture.log2_width || texture.smaller_levels <= texture.log2_height) &&
         texture.texels.size() >= texel_words(texture);
}

}  // namespace detail

/// Checks instances, quadrics and lines. begin_frame calls this again, because they move between frames.
constexpr Status validate_instances(const Scene& scene) {
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!detail::valid_instance(scene, scene.instances[i])) return {.error = Error::instance, .needed = i};
  }
  for (std::uint32_t i = 0; i < scene.quadrics.size(); ++i) {
    if (!detail::valid_quadric(scene, scene.quadrics[i])) return {.error = Error::quadric, .needed = i};
  }
  for (std::uint32_t i = 0; i < scene.lines.size(); ++i) {
    if (!detail::valid_lines(scene, scene.lines[i])) return {.error = Error::lines, .needed = i};
  }
  if (scene.lights.size() > kMaxLights) {
    return {.error = Error::light, .needed = static_cast<std::uint32_t>(scene.lights.size()), .available = kMaxLights};
  }
  if (scene.punctual_lights.size() > kMaxPunctualLights) {
    return {.error = Error::light,
            .needed = static_cast<std::uint32_t>(scene.punctual_lights.size()),
            .available = kMaxPunctualLights};
  }
  if (scene.shadow != nullptr && !detail::valid_shadow(scene, *scene.shadow)) return {.error = Error::shadow};
  if (scene.csg.size() > kMaxCsgOperands || (scene.shadow != nullptr && !scene.csg.empty())) {
    return {.error = Error::csg, .needed = static_cast<std::uint32_t>(scene.csg.size()), .available = kMaxCsgOperands};
  }
  for (std::uint32_t i = 0; i < scene.csg.size(); ++i) {
    if (!detail::valid_csg_operand(scene, i)) return {.error = Error::csg, .needed = i};
  }
  return {};
}

/// Checks every index, count and range of the scene. Time: linear in the triangles of each mesh, the vertices of each
/// textured instance, and the segments and edges of each set; what several of them share is checked for each.
/// Status::needed is the index of the invalid element.
constexpr Status validate(const Scene& scene) {
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    if (!detail::valid_mesh(scene.meshes[i]) || scene.meshes[i].outline > scene.outlines.size()) {
      return {.error = Error::mesh, .needed = i};
    }
  }
  for (std::uint32_t i = 0; i < scene.textures.size(); ++i) {
    if (!detail::valid_texture(scene.textures[i])) return {.error = Error::texture, .needed = i};
  }
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    const std::uint16_t texture = scene.materials[i].texture;
    if (scene.materials[i].smooth > Shading::pixel) return {.error = Error::material, .needed = i};
    if (texture != kNoTexture && texture >= scene.textures.size()) return {.error = Error::material, .needed = i};
    const std::uint8_t finish = scene.materials[i].finish;
    if (finish != kNoFinish && finish >= scene.finishes.size()) return {.error = Error::material, .needed = i};
    const bool mirrors = is_environment(finish_of(scene, scene.materials[i]).filter);
    if (texture == kNoTexture && mirrors) return {.error = Error::material, .needed = i};
    if (texture != kNoTexture && finish == kNoFinish && has_palette(scene.textures[texture].format)) {
      return {.error = Error::material, .needed = i};
    }
  }
  if (scene.finishes.size() > kNoFinish) return {.error = Error::finish, .needed = kNoFinish};
  for (std::uint32_t i = 0; i < scene.finishes.size(); ++i) {
    if (!detail::valid_finish(scene.finishes[i])) return {.error = Error::finish, .needed = i};
  }
  if (scene.outlines.size() > 255) return {.error = Error::outline, .needed = 255};
  for (std::uint32_t i = 0; i < scene.outlines.size(); ++i) {
    if (!detail::valid_outline(scene, scene.outlines[i])) return {.error = Error::outline, .needed = i};
  }
  for (std::uint32_t i = 0; i < scene.punctual_lights.size(); ++i) {
    if (!detail::valid_punctual_light(scene.punctual_lights[i])) return {.error = Error::punctual_light, .needed = i};
  }
  if (scene.fog != nullptr && !detail::valid_fog(*scene.fog)) return {.error = Error::fog};
  if (const Status status = validate_instances(scene); !status) return status;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Outline* const outline = outline_of(scene, mesh);
    if (outline != nullptr && !detail::can_have_outline(scene, instance, *outline)) {
      return {.error = Error::outline, .needed = mesh.outline - 1U};
    }
  }
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const bool is_billboard = scene.meshes[instance.mesh].billboard != Billboard::none;
    if (!detail::valid_texcoords(scene, instance) || !detail::can_mirror(scene, instance) ||
        (is_billboard && !detail::is_turnable(instance.transform))) {
      return {.error = Error::instance, .needed = i};
    }
  }
  for (std::uint32_t i = 0; i < scene.lines.size(); ++i) {
    if (!detail::valid_segments(scene, scene.lines[i])) return {.error = Error::lines, .needed = i};
  }
  for (std::uint32_t i = 0; i < scene.edges.size(); ++i) {
    if (!detail::valid_edges(scene, i)) return {.error = Error::edges, .needed = i};
  }
  return scene.overlay != nullptr ? validate(*scene.overlay) : Status{};
}

}  // namespace zstrip
