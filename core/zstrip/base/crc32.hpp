// CRC-32 as in zlib, PNG and Ethernet: reflected, polynomial 0xEDB88320.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace zstrip {

/// Returns the CRC-32 of all bytes; 0 for none. Takes four bits in each step, with a table of 64 bytes.
std::uint32_t crc32(std::span<const std::byte> bytes);

}  // namespace zstrip
