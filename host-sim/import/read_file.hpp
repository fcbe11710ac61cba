// Reads complete input files; only regular files, so that a name like /dev/zero or a FIFO never blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

/// Returns "; download it first: curl -LO ..." if `name` is a web address; else empty.
std::string advice_on_address(const std::string& name);

/// Checks that `path` is a regular file that can be opened for reading, and not a pointer of Git LFS. The failure's
/// message continues "'path' ..." ("does not exist", "is a folder", ...).
Result<Done> check_readable(const std::filesystem::path& path);

/// Limit for all files that are read completely; some kinds have a lower limit.
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

/// `limit`: whole megabytes. A larger file is refused ("has more than 16 MB") and not read to its end. write_file
/// does not replace a file that was read.
Result<std::vector<std::uint8_t>> read_file(const std::filesystem::path& path, std::size_t limit = kMaxFileBytes);

}  // namespace zstrip::sim
