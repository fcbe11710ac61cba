// How a glTF 2.0 file interpolates its animations: from its JSON, the first chunk of a .glb.
#include "import/gltf_interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "import/read_file.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::json;

/// The part of the file that is JSON.
std::span<const std::uint8_t> json_of(std::span<const std::uint8_t> file) {
  constexpr std::size_t kBegin = 20;  // of the first chunk's data: a header of 12 bytes, length, type
  if (file.size() < kBegin || std::string(file.begin(), file.begin() + 4) != "glTF") return file;
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) length |= std::size_t{file[12 + i]} << 8 * i;
  return file.subspan(kBegin, std::min(length, file.size() - kBegin));
}

const Json& nothing() {
  static const Json null;
  return null;
}

/// The member of an object, or the element of an array; null if it is not there.
const Json& at(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() ? *found : nothing();
}
const Json& at(const Json& array, const Json& index) {
  if (!array.is_array() || !index.is_number_unsigned() || index.get<std::uint64_t>() >= array.size()) return nothing();
  return array[index.get<std::size_t>()];
}

std::string text_of(const Json& json) { return json.is_string() ? json.get<std::string>() : std::string(); }

/// As Assimp names it.
std::string name_of_node(const Json& nodes, const Json& index) {
  std::string name = text_of(at(at(nodes, index), "name"));
  return name.empty() && index.is_number_unsigned() ? fmt::format("nodes[{}]", index.get<std::uint64_t>()) : name;
}

Interpolation interpolation_of(const Json& sampler) {
  const std::string word = text_of(at(sampler, "interpolation"));
  if (word == "STEP") return Interpolation::step;
  return word == "CUBICSPLINE" ? Interpolation::cubic_spline : Interpolation::linear;
}

std::vector<NodeInterpolation> read_animation(const Json& animation, const Json& nodes) {
  std::vector<NodeInterpolation> found;
  const Json& channels = at(animation, "channels");
  if (!channels.is_array()) return found;
  for (const Json& channel : channels) {
    const Json& target = at(channel, "target");
    NodeInterpolation& node = found.emplace_back();
    node.node = name_of_node(nodes, at(target, "node"));
    const Interpolation interpolation = interpolation_of(at(at(animation, "samplers"), at(channel, "sampler")));
    const std::string path = text_of(at(target, "path"));
    if (path == "translation") node.translation = interpolation;
    if (path == "rotation") node.rotation = interpolation;
    if (path == "scale") node.scale = interpolation;
  }
  return found;
}

}  // namespace

std::vector<std::vector<NodeInterpolation>> read_interpolations(const std::filesystem::path& path) {
  std::vector<std::vector<NodeInterpolation>> all;
  const Result<std::vector<std::uint8_t>> file = read_file(path);
  if (!file) return all;
  const std::span<const std::uint8_t> text = json_of(*file);
  const Json document = Json::parse(text.begin(), text.end(), nullptr, false);
  const Json& animations = at(document, "animations");
  if (!animations.is_array()) return all;
  for (const Json& animation : animations) all.push_back(read_animation(animation, at(document, "nodes")));
  return all;
}

}  // namespace zstrip::sim
