// Numbers for people: digits in groups of three.
#pragma once

#include <cstdint>
#include <string>

namespace zstrip::sim {

/// 1234567 as "1,234,567", whatever the locale.
std::string grouped(std::uint64_t value);

}  // namespace zstrip::sim
