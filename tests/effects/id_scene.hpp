// A scene of which every triangle, sphere and segment has a colour of its own, so that its picture says what each pixel
// shows. It has the depths, alphas and order of the scene that it is made from, and no light, fog or picture over it.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <vector>

#include "drawn.hpp"
#include "zstrip/pick.hpp"

namespace effects_test {

/// For scenes without products, edges and skins. All that it refers to must outlive it.
class IdScene {
 public:
  IdScene(const Scene& of, const Camera& camera) : of_(of) {
    scene_.background = {0, 0, 0, 255};
    for (const Finish& finish : of.finishes) {
      finishes_.push_back({.alpha_mode = finish.alpha_mode == AlphaMode::opaque ? AlphaMode::opaque : AlphaMode::mask,
                           .alpha_cutoff = finish.alpha_mode == AlphaMode::mask ? finish.alpha_cutoff : std::uint8_t{1},
                           .filter = finish.filter});
    }
    for (std::size_t i = 0; i < of.quadrics.size(); ++i) {
      quadrics_.push_back(of.quadrics[i]);
      quadrics_.back().material = add_material(of.quadrics[i].material, {.shown = Shown::quadric, .index = word(i)});
    }
    for (const Mesh& mesh : of.meshes) meshes_.push_back(without_colours(mesh));
    for (std::size_t i = 0; i < of.lines.size(); ++i) add_lines(i);
    std::vector<std::size_t> blended;
    for (std::size_t i = 0; i < of.instances.size(); ++i) {
      if (is_blended(of, of.materials[of.instances[i].material])) {
        blended.push_back(i);
      } else {
        add_instance(i);
      }
    }
    std::ranges::stable_sort(blended, std::ranges::greater(), [&](std::size_t i) { return distance_of(i, camera); });
    for (const std::size_t i : blended) add_instance(i);
    scene_.meshes = meshes_;
    scene_.materials = materials_;
    scene_.textures = textures_;
    scene_.instances = instances_;
    scene_.finishes = finishes_;
    scene_.quadrics = quadrics_;
    scene_.lines = lines_;
    scene_.outlines = outlines_;
  }
  IdScene(const IdScene&) = delete;
  IdScene& operator=(const IdScene&) = delete;

  const Scene& scene() const { return scene_; }
  /// Returns the surface that a pixel of the scene's picture shows, without texture coordinates.
  Picked shown_by(std::uint16_t pixel) const {
    return pixel == 0 ? Picked{} : shown_.at(static_cast<std::size_t>(pixel / kStep - 1));
  }

 private:
  static constexpr int kStep = 3;  ///< neighbours in the table have colours that differ in more than their last bit

  static std::uint16_t word(std::size_t value) { return static_cast<std::uint16_t>(value); }
  static Mesh without_colours(Mesh mesh) {
    mesh.colours = {};
    return mesh;
  }
  static Colour colour_of(std::uint16_t pixel) {
    const auto channel = [](int value, int bits) {
      return static_cast<std::uint8_t>(value << (8 - bits) | value >> (2 * bits - 8));
    };
    return {channel(pixel >> 11, 5), channel(pixel >> 5 & 63, 6), channel(pixel & 31, 5), 255};
  }
  /// How far the middle of an instance's box is in front of the camera's plane.
  double distance_of(std::size_t index, const Camera& camera) const {
    const Instance& instance = of_.instances[index];
    const Vec3& centre = of_.meshes[instance.mesh].centre;
    const double middle[3] = {std::ldexp(centre.x, -16), std::ldexp(centre.y, -16), std::ldexp(centre.z, -16)};
    const std::int32_t eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
    const std::int32_t back[3] = {camera.back.x, camera.back.y, camera.back.z};
    double distance = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = instance.transform.m[i];
      double world = std::ldexp(row[3], -16);
      for (std::size_t j = 0; j < 3; ++j) world += std::ldexp(row[j], -16) * middle[j];
      distance += std::ldexp(back[i], -30) * (std::ldexp(eye[i], -16) - world);
    }
    return distance;
  }
  /// The pixel of the next entry.
  std::uint16_t next(const Picked& picked) {
    shown_.push_back(picked);
    EXPECT_LT(shown_.size() * kStep, 65536U);
    return word(shown_.size() * kStep);
  }

  /// Unlit, with the depth rules and the alpha of a material.
  std::uint16_t add_material(std::uint16_t index, const Picked& picked) {
    Material material = of_.materials[index];
    const std::uint16_t pixel = next(picked);
    const std::uint8_t alpha = material.colour.a;
    material.colour = colour_of(pixel);
    material.colour.a = alpha;
    material.lit = false;
    material.smooth = false;
    const AlphaMode mode = finish_of(of_, material).alpha_mode;
    if (mode == AlphaMode::blend) material.depth_write = false;
    if (material.texture != kNoTexture) {
      const Texture& texture = of_.textures[material.texture];
      const bool has_alpha = texture.format == TextureFormat::rgb565_alpha && mode != AlphaMode::opaque;
      material.texture = has_alpha ? add_texture(texture, pixel) : kNoTexture;
    }
    materials_.push_back(material);
    return word(materials_.size() - 1);
  }

  /// The texture's alpha in one colour.
  std::uint16_t add_texture(Texture texture, std::uint16_t pixel) {
    std::vector<std::uint16_t>& words = texels_.emplace_back(texture.texels.begin(), texture.texels.end());
    std::size_t first = 0;
    int width = texture.log2_width, height = texture.log2_height;
    for (int level = 0; level <= texture.smaller_levels; ++level) {
      const auto log2_texels = static_cast<std::uint32_t>(width + height);
      std::fill_n(words.begin() + static_cast<std::ptrdiff_t>(first), std::size_t{1} << log2_texels, pixel);
      first += level_words(texture.format, log2_texels);
      width -= width > 0 ? 1 : 0, height -= height > 0 ? 1 : 0;
    }
    texture.texels = words;
    textures_.push_back(texture);
    return word(textures_.size() - 1);
  }

  void add_lines(std::size_t set) {
    for (std::size_t i = 0; i < of_.lines[set].segments.size(); ++i) {
      LineSet line = of_.lines[set];
      line.segments = line.segments.subspan(i, 1);
      line.material = add_material(
          line.material, {.shown = Shown::line, .index = word(set), .triangle = static_cast<std::uint32_t>(i)});
      lines_.push_back(line);
    }
  }

  /// The mesh with one of its triangles. It transforms the vertices between its corners.
  Mesh only(const Mesh& mesh, std::size_t triangle) {
    Mesh one = without_colours(mesh);
    one.triangles = mesh.triangles.subspan(triangle, 1);
    const Triangle& t = one.triangles[0];
    const auto [first, last] = std::minmax({t.a, t.b, t.c});
    Meshlet& meshlet = meshlets_.emplace_back();
    meshlet = {0, first, word(std::size_t{last} - first + 1), 1, 0xFFFF, {}};
    one.meshlets = {&meshlet, 1};
    one.outline = 0;
    return one;
  }

  /// An instance for each triangle.
  void add_instance(std::size_t index) {
    const Instance& instance = of_.instances[index];
    const Mesh& mesh = of_.meshes[instance.mesh];
    const Outline* const outline = outline_of(of_, mesh);
    const std::uint16_t hull = outline == nullptr || outline->hull == kOwnMesh ? instance.mesh : outline->hull;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      add(instance, only(mesh, i),
          {.shown = Shown::instance, .index = word(index), .triangle = static_cast<std::uint32_t>(i)});
    }
    if (outline == nullptr) return;
    // Outlines are drawn after the opaque instances; in the scenes of the tests their instances are the last of these.
    for (std::size_t i = 0; i < of_.meshes[hull].triangles.size(); ++i) {
      Outline line = *outline;
      line.hull = word(meshes_.size());
      meshes_.push_back(only(of_.meshes[hull], i));
      line.colour =
          colour_of(next({.shown = Shown::outline, .index = word(index), .triangle = static_cast<std::uint32_t>(i)}));
      outlines_.push_back(line);
      Mesh outlined = only(mesh, 0);
      outlined.outline = static_cast<std::uint8_t>(outlines_.size());
      add(instance, outlined, {.shown = Shown::instance, .index = word(index), .triangle = 0});
    }
  }
  void add(Instance instance, const Mesh& mesh, const Picked& picked) {
    instance.mesh = word(meshes_.size());
    instance.material = add_material(instance.material, picked);
    meshes_.push_back(mesh);
    instances_.push_back(instance);
  }

  const Scene& of_;
  Scene scene_;
  std::vector<Picked> shown_;
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  std::vector<Texture> textures_;
  std::vector<Instance> instances_;
  std::vector<Finish> finishes_;
  std::vector<Quadric> quadrics_;
  std::vector<LineSet> lines_;
  std::vector<Outline> outlines_;
  std::deque<std::vector<std::uint16_t>> texels_;
  std::deque<Meshlet> meshlets_;
};

}  // namespace effects_test
