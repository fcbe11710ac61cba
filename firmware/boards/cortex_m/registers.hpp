// Access to memory-mapped registers.
#pragma once

#include <cstdint>

namespace zstrip::board {

inline volatile std::uint32_t& register_at(std::uint32_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(static_cast<std::uintptr_t>(address));
}

}  // namespace zstrip::board
