// CRC-32 as zlib, PNG and Ethernet have it: reflected, polynomial 0xEDB88320.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace zstrip {

/// Of all bytes; 0 for none. A table of 64 bytes: half a byte a step.
std::uint32_t crc32(std::span<const std::byte> bytes);

}  // namespace zstrip
