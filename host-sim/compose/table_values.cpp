// Values that are common to several tables of a scene file: limits, directions, rotations.
#include "compose/table_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace zstrip::sim {

void check_direction(TomlTable& table, const char* key, const Vector& direction) {
  if (std::ranges::all_of(direction, [](double c) { return std::abs(c) < 1e-9; })) {
    table.wrong(key, fmt::format("'{}' must have a length", key));
  }
}

std::optional<Quaternion> read_rotation(TomlTable& table) {
  const auto degrees = table.vector("rotation", kDegrees);
  const auto numbers = table.numbers("quaternion", 4, {-1, 1});
  if (degrees && numbers) table.wrong("quaternion", "give either 'rotation' or 'quaternion'");
  if (!numbers) return degrees ? std::optional(from_degrees(*degrees)) : std::nullopt;
  const Quaternion quaternion{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
  if (std::ranges::all_of(quaternion, [](double c) { return std::abs(c) < 1e-6; })) {
    table.wrong("quaternion", "'quaternion' must have a length");
    return std::nullopt;
  }
  return unit(quaternion);
}

Placement read_placement(TomlTable& table, const char* scale) {
  return {.translation = table.vector("translation", kLength).value_or(Vector{0, 0, 0}),
          .rotation = read_rotation(table).value_or(Quaternion{0, 0, 0, 1}),
          .scale = table.number_or_vector(scale, kPositive).value_or(Vector{1, 1, 1})};
}

}  // namespace zstrip::sim
