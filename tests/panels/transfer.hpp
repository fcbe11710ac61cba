// What tests of buses send, a command and some data, and what arrives of it.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace zstrip::panels {

inline constexpr std::array kCommand{std::byte{0x2A}};
inline constexpr std::array kPixels{std::byte{0x00}, std::byte{0xFF}, std::byte{0x80}, std::byte{0x01},
                                    std::byte{0xA5}};
/// The level of D/C and the byte, of both one after the other.
inline const std::vector<std::pair<bool, int>> kArrived{{false, 0x2A}, {true, 0x00}, {true, 0xFF},
                                                        {true, 0x80},  {true, 0x01}, {true, 0xA5}};

}  // namespace zstrip::panels
