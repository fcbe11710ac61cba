// Numbers for people: digits in groups of three.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// Returns 1234567 as "1,234,567" in every locale.
std::string grouped(std::uint64_t value);

/// Returns "1 byte", "1,234 bytes", "2 meshes".
std::string counted(std::uint64_t value, std::string_view thing);

}  // namespace zstrip::sim
