// Extensions of a glTF file.
#include "import/gltf/extensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Two of them change only highlights, which are drawn on request.
constexpr std::array<std::string_view, 14> kRead{"EXT_mesh_gpu_instancing", "EXT_meshopt_compression",
                                                 "EXT_texture_webp",        "KHR_draco_mesh_compression",
                                                 "KHR_lights_punctual",     "KHR_materials_emissive_strength",
                                                 "KHR_materials_ior",       "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_materials_specular",  "KHR_materials_unlit",
                                                 "KHR_mesh_quantization",   "KHR_node_visibility",
                                                 "KHR_texture_transform",   "KHR_xmp_json_ld"};

/// An extension of glTF 1.0; files with it also have materials.
constexpr std::string_view kTechnique = "KHR_technique_webgl";

/// The features that are missing in the picture without an extension.
struct Lacking {
  std::string_view name, what;
};
constexpr std::array<Lacking, 20> kLacking{{
    {"EXT_instance_features", "data about copies"},
    {"EXT_lights_image_based", "light of an environment"},
    {"EXT_mesh_features", "data about parts"},
    {"EXT_structural_metadata", "data about parts"},
    {"KHR_animation_pointer", "animations of materials, lights and cameras"},
    {"KHR_materials_anisotropy", "brushed highlights"},
    {"KHR_materials_clearcoat", "coats of varnish"},
    {"KHR_materials_dispersion", "colours of a prism"},
    {"KHR_materials_iridescence", "colours of thin films"},
    {"KHR_materials_sheen", "sheen of cloth"},
    {"KHR_materials_transmission", "light through surfaces"},
    {"KHR_materials_variants", "other variants of materials"},
    {"KHR_materials_volume", "depth of glass"},
    {kTechnique, "shaders of its own"},
    {"KHR_texture_basisu", "pictures in KTX 2"},
    {"VRM", "looks and springs of avatars"},
    {"VRMC_materials_mtoon", "shading of cartoons"},
    {"VRMC_node_constraint", "joints that follow others"},
    {"VRMC_springBone", "springs of hair and clothes"},
    {"VRMC_vrm", "looks of avatars"},
}};

std::set<std::string> names_in(const GltfJson& json, const char* key) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < count_of(json, key); ++i) {
    const GltfJson& name = element(member(json, key), i);
    if (name.is_string()) names.insert(name.get<std::string>());
  }
  return names;
}

std::string lacking_of(const std::string& name) {
  const auto* const known = std::ranges::find(kLacking, name, &Lacking::name);
  return known == kLacking.end() ? "not known" : std::string(known->what);
}

/// Returns the extensions that the file has. Those of lit materials count where the file does not list them, too.
std::set<std::string> names_used(const GltfJson& json) {
  std::set<std::string> names = names_in(json, "extensionsUsed");
  for (std::size_t i = 0; i < count_of(json, "materials"); ++i) {
    const GltfJson& material = element(member(json, "materials"), i);
    if (extension(material, "KHR_materials_unlit").is_object()) continue;
    for (const Lacking& lacking : kLacking) {
      const std::string name(lacking.name);
      const char* const key = name.c_str();
      if (extension(material, key).is_object()) names.insert(name);
    }
  }
  return names;
}

}  // namespace

Result<Done> check_gltf_extensions(const GltfJson& json, std::vector<std::string>& warnings) {
  const auto is_read = [](const std::string& name) { return std::ranges::find(kRead, name) != kRead.end(); };
  std::string required, used;
  const auto append = [](std::string& list, const std::string& name) {
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", printable(name), lacking_of(name));
  };
  for (const std::string& name : names_in(json, "extensionsRequired")) {
    if (!is_read(name) && name != kTechnique) append(required, name);
  }
  if (!required.empty()) {
    return Failure{ExitStatus::input,
                   fmt::format("requires extensions that zstrip does not read: {}; export it without them", required)};
  }
  for (const std::string& name : names_used(json)) {
    if (!is_read(name)) append(used, name);
  }
  if (!used.empty()) warnings.push_back(fmt::format("drawn without: {}", used));
  return Done{};
}

}  // namespace zstrip::sim
