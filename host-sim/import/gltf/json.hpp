// Reads JSON that may be anything: what is not there, or of another type, is null or the given default.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace zstrip::sim {

using GltfJson = nlohmann::json;

/// The member of an object, or the element of an array; null if it is not there.
const GltfJson& member(const GltfJson& json, const char* key);
const GltfJson& element(const GltfJson& array, std::size_t index);
/// The elements of an array that is a member; 0 if it is none.
std::size_t count_of(const GltfJson& json, const char* key);
/// The extension `name` of an object of the file; null if it has none.
const GltfJson& extension(const GltfJson& json, const char* name);

/// A member that is a whole number, 0 or more.
std::optional<std::size_t> index_in(const GltfJson& json, const char* key);
/// A member that is a finite number.
double number_in(const GltfJson& json, const char* key, double otherwise);
bool flag_in(const GltfJson& json, const char* key);
/// A member that is text; else empty.
std::string text_in(const GltfJson& json, const char* key);
/// What is a finite number; else `otherwise`.
double to_number(const GltfJson& json, double otherwise);
/// What is a whole number, 0 or more.
std::optional<std::size_t> to_index(const GltfJson& json);

/// A member that is an array of so many finite numbers.
template <std::size_t count>
std::array<double, count> numbers_in(const GltfJson& json, const char* key, std::array<double, count> otherwise) {
  const GltfJson& array = member(json, key);
  if (!array.is_array() || array.size() != count) return otherwise;
  for (std::size_t i = 0; i < count; ++i) otherwise[i] = to_number(array[i], otherwise[i]);
  return otherwise;
}

}  // namespace zstrip::sim
