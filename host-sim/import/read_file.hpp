// Reads whole input files; only regular ones, so that a name like /dev/zero or a FIFO never blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

/// Whether `path` names a regular file that can be opened for reading.
/// The failure's message continues "'path' ..." ("does not exist", "is a folder", ...).
Result<Done> check_readable(const std::filesystem::path& path);

Result<std::vector<std::uint8_t>> read_file(const std::filesystem::path& path);

}  // namespace zstrip::sim
