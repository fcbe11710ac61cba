// Reads JSON with any contents.
#include "import/gltf/json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace zstrip::sim {

const GltfJson& member(const GltfJson& json, const char* key) {
  static const GltfJson null;
  if (!json.is_object()) return null;
  const auto found = json.find(key);
  return found == json.end() ? null : *found;
}

const GltfJson& element(const GltfJson& array, std::size_t index) {
  static const GltfJson null;
  return array.is_array() && index < array.size() ? array[index] : null;
}

std::size_t count_of(const GltfJson& json, const char* key) {
  const GltfJson& array = member(json, key);
  return array.is_array() ? array.size() : 0;
}

const GltfJson& extension(const GltfJson& json, const char* name) { return member(member(json, "extensions"), name); }

double to_number(const GltfJson& json, double otherwise) {
  if (!json.is_number()) return otherwise;
  const double value = json.get<double>();
  return std::isfinite(value) ? value : otherwise;
}

std::optional<std::size_t> to_index(const GltfJson& json) {
  if (json.is_number_unsigned()) return json.get<std::size_t>();
  // Some exporters write 3.0.
  constexpr double kExact = 9007199254740992.0;
  const double value = to_number(json, -1);
  if (!json.is_number_float() || value < 0 || value > kExact || value != std::floor(value)) return std::nullopt;
  return static_cast<std::size_t>(value);
}

std::optional<std::size_t> index_in(const GltfJson& json, const char* key) { return to_index(member(json, key)); }

double number_in(const GltfJson& json, const char* key, double otherwise) {
  return to_number(member(json, key), otherwise);
}

bool flag_in(const GltfJson& json, const char* key) {
  const GltfJson& flag = member(json, key);
  return flag.is_boolean() && flag.get<bool>();
}

std::string text_in(const GltfJson& json, const char* key) {
  const GltfJson& text = member(json, key);
  return text.is_string() ? text.get<std::string>() : std::string();
}

double share(double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 1; }

}  // namespace zstrip::sim
