// Values that several tables of a scene file have: limits, directions, rotations.
#pragma once

#include <optional>

#include "compose/toml_table.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {

inline constexpr Limits kLength{-1e9, 1e9};
inline constexpr Limits kPositive{1e-9, 1e9};
inline constexpr Limits kDegrees{-36000, 36000};

/// A direction in which one can look, shine or turn.
void check_direction(TomlTable& table, const char* key, const Vector& direction);

/// 'rotation', degrees about x, y and z, or a 'quaternion'.
std::optional<Quaternion> read_rotation(TomlTable& table);
/// 'translation', the rotation, and the scale under this key.
Placement read_placement(TomlTable& table, const char* scale);

}  // namespace zstrip::sim
