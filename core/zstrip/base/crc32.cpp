// CRC-32, with four bits in each step.
#include "zstrip/base/crc32.hpp"

namespace zstrip {
namespace {

struct Table {
  std::uint32_t remainders[16];
};

constexpr Table kTable = [] {
  Table table{};
  for (std::uint32_t index = 0; index < 16; ++index) {
    std::uint32_t remainder = index;
    for (int bit = 0; bit < 4; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? 0xEDB88320U : 0);
    table.remainders[index] = remainder;
  }
  return table;
}();

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes) {
  std::uint32_t state = 0xFFFFFFFF;
  for (const std::byte byte : bytes) {
    state ^= std::to_integer<std::uint32_t>(byte);
    state = (state >> 4) ^ kTable.remainders[state & 15U];
    state = (state >> 4) ^ kTable.remainders[state & 15U];
  }
  return ~state;
}

}  // namespace zstrip
