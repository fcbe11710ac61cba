// Reads whole input files; only regular ones, so that a name like /dev/zero or a FIFO never blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

/// "; download it first: curl -LO ..." where `name` is an address of the web; else empty.
std::string advice_on_address(const std::string& name);

/// Whether `path` names a regular file that can be opened for reading, and is no pointer of Git LFS.
/// The failure's message continues "'path' ..." ("does not exist", "is a folder", ...).
Result<Done> check_readable(const std::filesystem::path& path);

/// Of any file that is read whole; some kinds have a lower limit.
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

/// `limit`: whole megabytes. A larger file is refused ("has more than 16 MB") and not read to its end.
Result<std::vector<std::uint8_t>> read_file(const std::filesystem::path& path, std::size_t limit = kMaxFileBytes);

}  // namespace zstrip::sim
