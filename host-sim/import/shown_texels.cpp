// Applies colours that the renderer ignores for unlit textured materials.
#include "import/shown_texels.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace zstrip::sim {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kWhite{255, 255, 255};

Rgb product(const Rgb& a, const Rgb& b) {
  Rgb c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = static_cast<std::uint8_t>((a[i] * b[i] + 127) / 255);
  return c;
}

Rgb colour_of(const SourceVertex& vertex) { return {vertex.colour[0], vertex.colour[1], vertex.colour[2]}; }

bool has_one_colour(const SourceMesh& mesh) {
  return std::ranges::all_of(mesh.indices, [&](std::uint32_t index) {
    return colour_of(mesh.vertices[index]) == colour_of(mesh.vertices[mesh.indices[0]]);
  });
}

/// Returns the index of a texture whose texels are those of `texture` times a colour.
class Multiplied {
 public:
  explicit Multiplied(SourceModel& model) : model_(model) {}

  std::uint32_t texture(std::uint32_t texture, const Rgb& colour) {
    const auto [at, is_new] = known_.try_emplace({texture, colour}, texture);
    if (!is_new) return at->second;
    RgbImage image = model_.textures[texture];
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      const Rgb texel = product({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}, colour);
      std::ranges::copy(texel, image.rgb.begin() + static_cast<std::ptrdiff_t>(i));
    }
    at->second = static_cast<std::uint32_t>(model_.textures.size());
    model_.textures.push_back(std::move(image));
    model_.texture_names.push_back(model_.texture_names[texture]);
    return at->second;
  }

 private:
  SourceModel& model_;
  std::map<std::pair<std::uint32_t, Rgb>, std::uint32_t> known_;
};

}  // namespace

void multiply_unlit_texels(SourceModel& model) {
  Multiplied multiplied(model);
  for (SourceMesh& mesh : model.meshes) {
    SourceMaterial shown = model.materials[mesh.material];
    if (shown.lit || shown.texture == kNoSourceTexture || !mesh.has_texcoords) continue;
    const bool one_colour = !mesh.has_colours || has_one_colour(mesh);
    const Rgb of_vertices = mesh.has_colours && one_colour ? colour_of(mesh.vertices[mesh.indices[0]]) : kWhite;
    const Rgb colour = product(shown.colour, of_vertices);
    if (one_colour && colour == kWhite) continue;
    shown.colour = kWhite;
    if (one_colour) {
      shown.texture = multiplied.texture(shown.texture, colour);
    } else {
      shown.lit = true;
      shown.colour = {};
      shown.emissive = colour;
    }
    mesh.material = static_cast<std::uint32_t>(model.materials.size());
    model.materials.push_back(std::move(shown));
  }
}

}  // namespace zstrip::sim
