// The size of a program for a board.
#pragma once

#include <cstdint>
#include <filesystem>

#include "result.hpp"

namespace zstrip::sim {

/// Returns the bytes that a 32-bit ELF program occupies in flash: code, constants and the image of its initialised
/// data.
Result<std::uint64_t> elf_load_bytes(const std::filesystem::path& program);

}  // namespace zstrip::sim
