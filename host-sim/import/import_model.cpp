// The import, step by step: read, convert textures for the renderer, normals, sides, texture coordinates, weld,
// quantise.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "image/resample.hpp"
#include "import/emission.hpp"
#include "import/folded_textures.hpp"
#include "import/metals.hpp"
#include "import/model.hpp"
#include "import/quantise.hpp"
#include "import/read_model.hpp"
#include "import/shown_texels.hpp"
#include "import/sides.hpp"
#include "import/surface.hpp"
#include "import/surface_detail.hpp"
#include "import/texcoords.hpp"
#include "import/wraps.hpp"
#include "text/number.hpp"
#include "text/step_report.hpp"

namespace zstrip::sim {

namespace {

/// Halves textures until their sides are at most the given ones, with a warning.
void lower_textures(SourceModel& source, const std::vector<TextureSides>& sides) {
  std::size_t lowered = 0;
  std::string largest_change;
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < source.textures.size(); ++i) {
    RgbImage& texture = source.textures[i];
    const std::uint32_t width = texture.width;
    const std::uint32_t height = texture.height;
    const auto too_wide = [&] { return log2_of(texture.width) > sides[i].log2_width; };
    const auto too_high = [&] { return log2_of(texture.height) > sides[i].log2_height; };
    while (too_wide() || too_high()) texture = halve(texture, too_wide(), too_high());
    const std::uint32_t factor = width / texture.width * (height / texture.height);
    if (factor > 1) ++lowered;
    if (factor <= std::max(most, 1U)) continue;
    most = factor;
    largest_change = fmt::format("from {}x{} to {}x{} texels", width, height, texture.width, texture.height);
  }
  if (lowered == 0) return;
  source.warnings.push_back(fmt::format("{} lowered, at most {}: a triangle repeats it too often for more",
                                        counted(lowered, "texture"), largest_change));
}

}  // namespace

Result<Model> import_model(const std::filesystem::path& path, std::optional<UpAxis> up, Texcoords texcoords,
                           BackFaces back_faces, Shine shine, const Reduction& reduction) {
  const std::string file = path.filename().string();
  tell_step(fmt::format("reading '{}'", file));
  Result<SourceModel> read = read_model(path, up, texcoords, shine);
  if (!read) return read.failure();
  SourceModel& source = *read;
  const auto named = [&path](const std::string& message) {
    return Failure{ExitStatus::input, fmt::format("'{}' {}", path.string(), message)};
  };

  tell_step(fmt::format("finding the surfaces of '{}'", file));
  if (const std::size_t painted = paint_surface_detail(source); painted > 0) {
    source.warnings.push_back(
        fmt::format("light and shade of normal and occlusion maps painted into {}: they do not follow lights",
                    counted(painted, "texture")));
  }
  show_emission(source);
  if (shine.style == MaterialStyle::rich) show_metals(source);
  show_wraps(source);
  multiply_unlit_texels(source);
  generate_missing_normals(source);
  std::vector<Outside> outsides = find_outsides(source);
  std::optional<Reduced> reduced;
  if (reduction.removes_triangles()) {
    tell_step(fmt::format("removing triangles of '{}'", file));
    for (SourceMesh& mesh : source.meshes) weld(mesh);
    reduced = remove_triangles(source, reduction);
    for (std::size_t i = source.meshes.size(); i-- > 0;) {
      if (!source.meshes[i].indices.empty()) continue;
      source.meshes.erase(source.meshes.begin() + static_cast<std::ptrdiff_t>(i));
      outsides.erase(outsides.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (!reduced->keeps_limit) {
      source.warnings.push_back(
          fmt::format("{} are left, more than asked for: {}", counted(reduced->triangles, "triangle"), kTrianglesStay));
    } else if (reduced->slides) {
      source.warnings.emplace_back(
          "so few triangles take vertices at which colours, joints or the texture change: they may slide visibly");
    }
  }
  if (back_faces == BackFaces::lit_alike) split_sides(source, outsides);
  if (source.meshes.size() > kMaxMeshes) return named(kTooManyMeshes);
  Shrunk shrunk = reduction.fold_textures ? fold_textures(source) : Shrunk{};
  const Shrunk smaller = fit_textures(source, reduction.texture_side);
  if (!reduction.fold_textures) shrunk = smaller;

  tell_step(fmt::format("merging the vertices of '{}'", file));
  std::vector<MeshTraits> traits;
  std::uint64_t clamped = 0;
  std::vector<TextureSides> sides(source.textures.size());
  for (std::size_t i = 0; i < source.meshes.size(); ++i) {
    SourceMesh& mesh = source.meshes[i];
    const SourceMaterial& material = source.materials[mesh.material];
    MeshTraits& trait = traits.emplace_back();
    trait.double_sided = material.double_sided.value_or(!outsides[i].is_closed);
    weld(mesh);
    if (!mesh.has_texcoords) continue;
    if (material.texture == kNoSourceTexture) {
      constexpr int kLog2Side = 8;  // of a texture that has not been read yet
      trait.texcoord_bits = fit_texcoords(mesh, kLog2Side, clamped);
      weld(mesh);
      continue;
    }
    const RgbImage& texture = source.textures[material.texture];
    trait.texcoord_bits = fit_texcoords(mesh, log2_of(std::max(texture.width, texture.height)), clamped);
    TextureSides& side = sides[material.texture];
    const TextureSides longest = longest_sides(mesh, trait.texcoord_bits);
    side.log2_width = std::min(side.log2_width, longest.log2_width);
    side.log2_height = std::min(side.log2_height, longest.log2_height);
    weld(mesh);
  }
  lower_textures(source, sides);
  if (clamped > 0) {
    source.warnings.push_back(fmt::format("{} clamped: one triangle repeats its texture more than 2000 times",
                                          counted(clamped, "texture coordinate")));
  }
  Result<Model> model = quantise(source, traits);
  if (!model) return named(model.failure().message);
  model->reduced = reduced;
  if (reduction.texture_side > 0 || reduction.fold_textures) model->shrunk = shrunk;
  return model;
}

}  // namespace zstrip::sim
