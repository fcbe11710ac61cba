// Damage of a glTF file that leaves a picture: words and indices that stand for nothing.
#include "import/gltf/damage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

template <class Visit>
void for_each(const GltfJson& json, const char* key, const Visit& visit) {
  for (std::size_t i = 0; i < count_of(json, key); ++i) visit(element(member(json, key), i));
}

/// True if the member is an index into an array of the file that has no such element.
bool is_index_of_nothing(const GltfJson& json, const GltfJson& object, const char* key, const char* array) {
  const std::optional<std::size_t> index = index_in(object, key);
  return index && *index >= count_of(json, array);
}

/// True if the member is a text, and none of these words.
bool is_other_word(const GltfJson& object, const char* key, std::initializer_list<std::string_view> words) {
  const GltfJson& word = member(object, key);
  return word.is_string() && std::ranges::find(words, word.get<std::string>()) == words.end();
}

bool is_other_wrap(const GltfJson& sampler, const char* key) {
  constexpr std::array<std::size_t, 3> kWraps{10497, 33071, 33648};
  const std::optional<std::size_t> wrap = index_in(sampler, key);
  return wrap && std::ranges::find(kWraps, *wrap) == kWraps.end();
}

void warn_of_scene(const GltfJson& json, std::vector<std::string>& warnings) {
  if (!is_index_of_nothing(json, json, "scene", "scenes")) return;
  warnings.push_back(fmt::format("scene {} does not exist: {}", *index_in(json, "scene"),
                                 count_of(json, "scenes") > 0 ? "the first one is drawn" : "all nodes are drawn"));
}

void warn_of_materials(const GltfJson& json, std::vector<std::string>& warnings) {
  for_each(json, "materials", [&](const GltfJson& material) {
    if (!is_other_word(material, "alphaMode", {"OPAQUE", "MASK", "BLEND"})) return;
    warnings.push_back(fmt::format("material '{}' drawn opaque: its alphaMode '{}' is not OPAQUE, MASK or BLEND",
                                   printable(text_in(material, "name")), printable(text_in(material, "alphaMode"))));
  });
}

}  // namespace

void warn_of_gltf_damage(const GltfJson& json, std::vector<std::string>& warnings) {
  std::uint64_t nodes = 0, primitives = 0, textures = 0, samplers = 0, channels = 0;
  for_each(json, "nodes", [&](const GltfJson& node) {
    const bool has_parts = node.contains("translation") || node.contains("rotation") || node.contains("scale");
    if (node.contains("matrix") && has_parts) ++nodes;
  });
  for_each(json, "meshes", [&](const GltfJson& mesh) {
    for_each(mesh, "primitives", [&](const GltfJson& primitive) {
      if (is_index_of_nothing(json, primitive, "material", "materials")) ++primitives;
    });
  });
  for_each(json, "textures", [&](const GltfJson& texture) {
    if (is_index_of_nothing(json, texture, "sampler", "samplers")) ++textures;
  });
  for_each(json, "samplers", [&](const GltfJson& sampler) {
    if (is_other_wrap(sampler, "wrapS") || is_other_wrap(sampler, "wrapT")) ++samplers;
  });
  for_each(json, "animations", [&](const GltfJson& animation) {
    for_each(animation, "channels", [&](const GltfJson& channel) {
      const GltfJson& target = member(channel, "target");
      if (is_other_word(target, "path", {"translation", "rotation", "scale", "weights", "pointer"})) ++channels;
    });
  });
  const auto warn_of = [&warnings](std::uint64_t count, const char* what, const char* words) {
    if (count > 0) warnings.push_back(fmt::format("{} {}", counted(count, what), words));
  };
  warn_of_scene(json, warnings);
  warn_of(nodes, "node", "drawn by the matrix alone: translation, rotation and scale next to it are left out");
  warn_of(primitives, "part", "of meshes drawn without material: theirs does not exist");
  warn_of_materials(json, warnings);
  warn_of(textures, "texture", "repeated: the sampler does not exist");
  warn_of(samplers, "sampler", "taken as repeating: the wrap does not exist");
  warn_of(channels, "channel", "of animations left out: the path does not exist");
}

}  // namespace zstrip::sim
