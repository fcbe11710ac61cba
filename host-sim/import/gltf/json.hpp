// Reads JSON with any contents: missing values, and values of another type, are null or the given default.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace zstrip::sim {

using GltfJson = nlohmann::json;

/// Returns the member of an object, or the element of an array; null if it does not exist.
const GltfJson& member(const GltfJson& json, const char* key);
const GltfJson& element(const GltfJson& array, std::size_t index);
/// Returns the number of elements of an array that is a member; 0 if it is of another type.
std::size_t count_of(const GltfJson& json, const char* key);
/// Returns the extension `name` of an object of the file; null if it does not exist.
const GltfJson& extension(const GltfJson& json, const char* name);

/// Returns a member that is an integer >= 0.
std::optional<std::size_t> index_in(const GltfJson& json, const char* key);
/// Returns a member that is a finite number.
double number_in(const GltfJson& json, const char* key, double otherwise);
bool flag_in(const GltfJson& json, const char* key);
/// Returns a member that is text; else empty.
std::string text_in(const GltfJson& json, const char* key);
/// Returns a finite number; else `otherwise`.
double to_number(const GltfJson& json, double otherwise);
/// Returns an integer >= 0.
std::optional<std::size_t> to_index(const GltfJson& json);

/// Returns a member that is an array of so many finite numbers.
template <std::size_t count>
std::array<double, count> numbers_in(const GltfJson& json, const char* key, std::array<double, count> otherwise) {
  const GltfJson& array = member(json, key);
  if (!array.is_array() || array.size() != count) return otherwise;
  for (std::size_t i = 0; i < count; ++i) otherwise[i] = to_number(array[i], otherwise[i]);
  return otherwise;
}

/// Limits a factor of a material to 0..1; a value that is not a number gives 1.
double share(double value);

}  // namespace zstrip::sim
