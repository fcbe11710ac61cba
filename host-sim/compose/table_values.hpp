// Values that are common to several tables of a scene file: limits, directions, rotations.
#pragma once

#include <optional>

#include "compose/toml_table.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {

inline constexpr Limits kLength{-1e9, 1e9};
inline constexpr Limits kPositive{1e-9, 1e9};
inline constexpr Limits kDegrees{-36000, 36000};

/// Checks a direction of a camera, a light or an axis: it must not be zero.
void check_direction(TomlTable& table, const char* key, const Vector& direction);

/// Reads 'rotation', degrees about x, y and z, or 'quaternion'.
std::optional<Quaternion> read_rotation(TomlTable& table);
/// Reads 'translation', the rotation, and the scale with this key.
Placement read_placement(TomlTable& table, const char* scale);

}  // namespace zstrip::sim
