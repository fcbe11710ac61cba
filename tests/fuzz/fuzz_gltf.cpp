// glTF files: any bytes become a model whose numbers are in range, or a failure.
#include <cctype>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/gltf/document.hpp"
#include "import/gltf/read_gltf.hpp"
#include "require.hpp"

namespace {

using namespace zstrip::sim;

/// Larger counts are allowed, but would only slow the fuzzer down, and take its memory.
bool has_large_numbers(std::string_view text) {
  std::size_t digits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    digits = is_digit ? digits + 1 : 0;
    const bool is_exponent =
        i > 0 && (text[i] == 'e' || text[i] == 'E') && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0;
    if (digits > 5 || is_exponent) return true;
  }
  return false;
}

void judge(const SourceModel& model) {
  fuzz::require(!model.meshes.empty(), "a model has a mesh");
  for (const SourceMesh& mesh : model.meshes) {
    fuzz::require(mesh.material < model.materials.size(), "materials exist");
    fuzz::require(!mesh.indices.empty() && mesh.indices.size() % 3 == 0, "a mesh has whole triangles");
    for (const std::uint32_t index : mesh.indices) {
      fuzz::require(index < mesh.vertices.size(), "vertices exist");
      for (const float c : mesh.vertices[index].position) fuzz::require(std::isfinite(c), "corners are finite");
      if (!mesh.has_skin) continue;
      for (const std::uint8_t joint : mesh.vertices[index].joints) {
        fuzz::require(joint < model.joints.size(), "joints exist");
      }
    }
  }
  for (const SourceMaterial& material : model.materials) {
    for (const std::uint32_t texture : {material.texture, material.emissive_texture}) {
      fuzz::require(texture == kNoSourceTexture || texture < model.textures.size(), "textures exist");
    }
  }
  fuzz::require(model.textures.size() == model.texture_names.size(), "textures have names");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (has_large_numbers({reinterpret_cast<const char*>(data), size})) return 0;
  const Result<GltfDocument> document = parse_gltf({data, size});
  if (!document || document->version != 2) return 0;
  const ReadUri read_uri = [](const std::string&) -> Result<std::vector<std::uint8_t>> {
    return Failure{ExitStatus::input, "does not exist"};
  };
  const Result<SourceModel> model = read_gltf(*document, read_uri, {}, Texcoords::all);
  if (model) judge(*model);
  if (!model) {
    fuzz::require(model.failure().status == ExitStatus::input, "a damaged file is the input's fault");
    fuzz::require(model.failure().message.find('\n') == std::string::npos, "a failure is one line: %s",
                  model.failure().message.c_str());
  }
  return 0;
}
