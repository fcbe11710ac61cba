// The import, step by step: read, normals, sides, texture coordinates, weld, quantise.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "image/resample.hpp"
#include "import/model.hpp"
#include "import/quantise.hpp"
#include "import/read_model.hpp"
#include "import/surface.hpp"
#include "import/texcoords.hpp"

namespace zstrip::sim {

Result<Model> import_model(const std::filesystem::path& path, UpAxis up) {
  Result<SourceModel> read = read_model(path, up);
  if (!read) return read.failure();
  SourceModel& source = *read;

  generate_missing_normals(source);
  const std::vector<bool> closed_outside = find_closed_outsides(source);
  for (RgbImage& texture : source.textures) texture = resample_to_power_of_two(std::move(texture));

  std::vector<MeshTraits> traits;
  std::uint64_t clamped = 0;
  for (std::size_t i = 0; i < source.meshes.size(); ++i) {
    SourceMesh& mesh = source.meshes[i];
    const SourceMaterial& material = source.materials[mesh.material];
    MeshTraits& trait = traits.emplace_back();
    trait.double_sided = material.double_sided.value_or(!closed_outside[i]);
    weld(mesh);
    if (!mesh.has_texcoords) continue;
    const RgbImage& texture = source.textures[material.texture];
    trait.texcoord_bits = fit_texcoords(mesh, log2_of(std::max(texture.width, texture.height)), clamped);
    weld(mesh);
  }
  if (clamped > 0) {
    source.warnings.push_back(
        fmt::format("{} texture coordinates clamped: one triangle repeats its texture more than 2000 times", clamped));
  }
  Result<Model> model = quantise(source, traits);
  if (!model) return Failure{model.failure().status, fmt::format("'{}' {}", path.string(), model.failure().message)};
  return model;
}

}  // namespace zstrip::sim
