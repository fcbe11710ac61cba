// Draws scenes whose colours encode triangles and texels.
#include "accuracy/observation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "render/frame_refused.hpp"
#include "zstrip/renderer.hpp"

namespace zstrip::sim {
namespace {

/// Returns a colour that becomes this word of RGB565, also if less than a step is added to it.
Colour colour_of(std::uint32_t word) {
  return {static_cast<std::uint8_t>((word >> 11) << 3), static_cast<std::uint8_t>(((word >> 5) & 63) << 2),
          static_cast<std::uint8_t>((word & 31) << 3), 255};
}

/// The scene with each triangle and quadric in the colour of its label: same vertices, same bounds, same depths.
struct LabelledScene {
  std::deque<MeshData> data;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<Quadric> quadrics;
  Scene scene;

  explicit LabelledScene(const Scene& from) : scene(from) {
    std::uint32_t number = 0;
    for (const Instance& instance : from.instances) add(from, instance, number);
    for (const Quadric& quadric : from.quadrics) add(from, quadric, number);
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
    scene.quadrics = quadrics;
    scene.textures = {};
    scene.finishes = {};
    scene.fog = nullptr;
    scene.edges = {};
    scene.overlay = nullptr;
    scene.background = {0, 0, 0, 255};
  }

 private:
  // Each triangle gets its own three vertices, so that it can have a colour: one mesh may become several.
  static constexpr std::size_t kTriangles = 21845;

  /// Adds a material like this one, but without light.
  std::uint16_t plain(Material material, const Colour& colour) {
    material.colour = colour;
    material.texture = kNoTexture;
    material.finish = kNoFinish;
    material.lit = false;
    material.smooth = false;
    materials.push_back(material);
    return static_cast<std::uint16_t>(materials.size() - 1);
  }

  void add(const Scene& from, Quadric quadric, std::uint32_t& number) {
    quadric.material = plain(from.materials[quadric.material], colour_of(label_of(number++)));
    quadrics.push_back(quadric);
  }

  void add(const Scene& from, const Instance& instance, std::uint32_t& number) {
    const Mesh& mesh = from.meshes[instance.mesh];
    const std::uint16_t material = plain(from.materials[instance.material], {255, 255, 255, 255});
    const std::size_t pieces = std::max<std::size_t>(mesh.meshlets.size(), 1);
    MeshData* current = nullptr;
    const auto begin = [&] { current = &data.emplace_back(); };
    const auto finish = [&] {
      Mesh labelled = mesh;
      labelled.positions = current->positions;
      labelled.normals = {};
      labelled.texcoords = {};
      labelled.colours = current->colours;
      labelled.triangles = current->triangles;
      labelled.meshlets = current->meshlets;
      Instance copy = instance;
      copy.mesh = static_cast<std::uint16_t>(meshes.size());
      copy.material = material;
      meshes.push_back(labelled);
      instances.push_back(copy);
    };
    begin();
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const bool cut = !mesh.meshlets.empty();
      const std::size_t first = cut ? mesh.meshlets[piece].first_triangle : 0;
      const std::size_t count = cut ? mesh.meshlets[piece].triangle_count : mesh.triangles.size();
      if (cut && current->triangles.size() + count > kTriangles) finish(), begin();
      if (cut) {
        Meshlet meshlet = mesh.meshlets[piece];
        meshlet.first_triangle = static_cast<std::uint32_t>(current->triangles.size());
        meshlet.first_vertex = static_cast<std::uint16_t>(current->positions.size());
        meshlet.vertex_count = static_cast<std::uint16_t>(3 * count);
        current->meshlets.push_back(meshlet);
      }
      for (std::size_t i = 0; i < count; ++i) {
        if (!cut && current->triangles.size() == kTriangles) finish(), begin();
        const Triangle& triangle = mesh.triangles[first + i];
        const auto base = static_cast<std::uint16_t>(current->positions.size());
        for (const std::uint16_t index : {triangle.a, triangle.b, triangle.c}) {
          current->positions.push_back(mesh.positions[index]);
          current->colours.push_back(colour_of(label_of(number)));
        }
        current->triangles.push_back(
            {base, static_cast<std::uint16_t>(base + 1), static_cast<std::uint16_t>(base + 2)});
        ++number;
      }
    }
    finish();
  }
};

/// The scene with textures whose texels encode their position: their number, or, for more than 65,536 texels, the upper
/// 8 bits of row and column.
struct PlaceScene {
  std::deque<std::vector<std::uint16_t>> texels;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  Scene scene;

  explicit PlaceScene(const Scene& from) : materials(from.materials.begin(), from.materials.end()), scene(from) {
    for (const Texture& texture : from.textures) {
      std::vector<std::uint16_t>& own = texels.emplace_back();
      const std::uint32_t width = 1U << texture.log2_width, height = 1U << texture.log2_height;
      const bool small = std::uint64_t{width} * height <= 65536;
      for (std::uint32_t row = 0; row < height; ++row) {
        for (std::uint32_t column = 0; column < width; ++column) {
          own.push_back(static_cast<std::uint16_t>(small ? row * width + column
                                                         : (row * 256 / height) << 8 | (column * 256 / width)));
        }
      }
      textures.push_back({own, texture.log2_width, texture.log2_height});
    }
    for (Material& material : materials) {
      if (material.texture != kNoTexture) material.lit = false;
      material.finish = kNoFinish;
    }
    scene.finishes = {};
    scene.fog = nullptr;
    scene.edges = {};
    scene.textures = textures;
    scene.materials = materials;
  }

  static TexelSeen middle_of(const Texture& texture, std::uint16_t word) {
    const std::uint32_t width = 1U << texture.log2_width, height = 1U << texture.log2_height;
    TexelSeen seen{0, 0, static_cast<float>(width), static_cast<float>(height)};
    if (std::uint64_t{width} * height <= 65536) {
      seen.u = static_cast<float>(word % width) + 0.5F;
      const auto row = static_cast<std::uint32_t>(word / width);
      seen.v = static_cast<float>(row) + 0.5F;
    } else {
      seen.u = (static_cast<float>(word & 255) + 0.5F) * seen.width / 256;
      seen.v = (static_cast<float>(word >> 8) + 0.5F) * seen.height / 256;
    }
    return seen;
  }
};

std::uint16_t word_at(std::span<const std::byte> pixels, std::size_t pixel) {
  std::uint16_t word = 0;
  std::memcpy(&word, pixels.data() + 2 * pixel, 2);
  return word;
}

}  // namespace

DepthSeen depth_of(DepthFormat format, std::uint32_t code) {
  if (format != DepthFormat::float16) return {static_cast<double>(code), 1};
  const std::uint32_t exponent = code >> 13;
  if (exponent == 0) return {(code + 0.5) * 4096, 4096};
  const double step = std::ldexp(1.0, static_cast<int>(11 + exponent));
  return {((0x2000 | (code & 0x1FFF)) + 0.5) * step, step};
}

std::vector<const Texture*> textures_of(const Scene& scene) {
  std::vector<const Texture*> found;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const std::uint16_t texture = scene.materials[instance.material].texture;
    const bool textured = texture != kNoTexture && !mesh.texcoords.empty();
    found.insert(found.end(), mesh.triangles.size(), textured ? &scene.textures[texture] : nullptr);
  }
  for (const Quadric& quadric : scene.quadrics) {
    const std::uint16_t texture = scene.materials[quadric.material].texture;
    found.push_back(texture == kNoTexture ? nullptr : &scene.textures[texture]);
  }
  return found;
}

Result<Drawn> draw(const Staging& staged, const View& view, Effects extra, const Budget& budget, bool with_depth) {
  const Effects effects = effects_of(staged.scene, staged.camera) | extra;
  const auto [status, plan] = zstrip::plan(count(staged.scene), view, effects, budget);
  if (!status) return frame_refused("the picture cannot be drawn", status);
  std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1);
  std::vector<std::uint64_t> strip(plan.strip_pixel_bytes(view) / 8 + 1);
  AnyRenderer renderer(effects);
  if (const Status begun = renderer.begin_frame(staged.scene, staged.camera, view, plan,
                                                std::as_writable_bytes(std::span(arena)).first(plan.bytes()));
      !begun) {
    return frame_refused("the picture cannot be drawn", begun);
  }
  Drawn drawn;
  for (std::uint16_t i = 0; i < plan.strips; ++i) {
    const Rect area = plan.strip_area(i, view);
    const std::span<std::byte> pixels =
        std::as_writable_bytes(std::span(strip))
            .first(std::size_t{bytes_per_row(view.width, view.format)} * static_cast<std::size_t>(area.height()));
    if (const Status done = renderer.draw_strip(i, pixels); !done)
      return frame_refused("the picture cannot be drawn", done);
    drawn.pixels.insert(drawn.pixels.end(), pixels.begin(), pixels.end());
  }
  if (!with_depth) return drawn;
  drawn.code.assign(std::size_t{view.width} * view.height, 0);
  const FrameWithDepthRanges frame = renderer.frame();
  const Rect& area = frame.depth_area();
  const bool wide = depth_bytes(depth_format(effects)) == 4;
  const std::uint32_t cleared = effects.has(effect::depth_ranges) ? frame.cleared_code() : 0;
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    for (std::int32_t x = area.left; x < area.right; ++x) {
      const auto cell = static_cast<std::size_t>((y - area.top) * area.width() + x - area.left);
      const std::uint32_t code = wide ? frame.wide_depth()[cell] : frame.depth()[cell];
      drawn.code[static_cast<std::size_t>(y) * view.width + static_cast<std::size_t>(x)] =
          code > cleared ? code - cleared : 0;
    }
  }
  return drawn;
}

std::vector<std::array<std::uint8_t, 3>> to_rgb(const View& view, std::span<const std::byte> pixels) {
  std::vector<std::array<std::uint8_t, 3>> rgb;
  const std::size_t row_bytes = bytes_per_row(view.width, view.format);
  for (std::size_t y = 0; y < view.height; ++y) {
    for (std::size_t x = 0; x < view.width; ++x) {
      const auto byte_at = [&](std::size_t at) { return std::to_integer<unsigned>(pixels[y * row_bytes + at]); };
      if (view.format == PixelFormat::gray4) {
        const auto grey = static_cast<std::uint8_t>(17 * (x % 2 == 0 ? byte_at(x / 2) >> 4 : byte_at(x / 2) & 15));
        rgb.push_back({grey, grey, grey});
      } else if (view.format == PixelFormat::mono) {
        const std::uint8_t grey = ((byte_at(x / 8) >> (7 - x % 8)) & 1) != 0 ? 255 : 0;
        rgb.push_back({grey, grey, grey});
      } else {
        const unsigned word = word_at(pixels, y * view.width + x);
        const unsigned r = word >> 11, g = (word >> 5) & 63, b = word & 31;
        rgb.push_back({static_cast<std::uint8_t>(r << 3 | r >> 2), static_cast<std::uint8_t>(g << 2 | g >> 4),
                       static_cast<std::uint8_t>(b << 3 | b >> 2)});
      }
    }
  }
  return rgb;
}

Result<Observation> observe(const Staging& staged, const View& view, const Settings& settings) {
  const Budget whole{.strip_rows = view.height, .modes = Modes::streamed};
  const Effects effects = without(extra_effects(settings), effect::bins);
  const View coloured = picture(settings, view);
  const View words{view.width, view.height, PixelFormat::rgb565};

  const Result<Drawn> picture = draw(staged, coloured, effects, whole, false);
  if (!picture) return picture.failure();
  const Effects unblended = without(effects, effect::edges);
  const LabelledScene labelled(staged.scene);
  Result<Drawn> labels = draw({labelled.scene, staged.camera}, words,
                              without(unblended, effect::perspective_runs | effect::fragments), whole, true);
  if (!labels) return labels.failure();
  Observation seen;
  for (const auto& [r, g, b] : to_rgb(coloured, picture->pixels))
    seen.rgb.push_back({static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)});
  for (std::size_t i = 0; i < labels->code.size(); ++i) {
    seen.depth.push_back(depth_of(depth_format(effects), labels->code[i]));
    seen.label.push_back(word_at(labels->pixels, i));
  }
  // A bilinear pixel shows several texels, and texels of mipmaps are not in the truth.
  const Effects called_for = effects_of(staged.scene, staged.camera);
  if (!called_for.has(effect::textures) || called_for.any(effect::bilinear | effect::mipmaps)) return seen;

  const PlaceScene places(staged.scene);
  const Result<Drawn> texels = draw({places.scene, staged.camera}, words, unblended, whole, false);
  if (!texels) return texels.failure();
  const std::vector<const Texture*> textures = textures_of(staged.scene);
  std::map<std::uint32_t, const Texture*> by_label;
  for (std::uint32_t i = 0; i < textures.size(); ++i) by_label.emplace(label_of(i), textures[i]);
  for (std::size_t i = 0; i < seen.label.size(); ++i) {
    const auto found = by_label.find(seen.label[i]);
    const Texture* texture = found == by_label.end() ? nullptr : found->second;
    seen.texel.push_back(texture == nullptr ? TexelSeen{}
                                            : PlaceScene::middle_of(*texture, word_at(texels->pixels, i)));
  }
  return seen;
}

}  // namespace zstrip::sim
