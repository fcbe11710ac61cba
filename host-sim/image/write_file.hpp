// Writes files completely or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "result.hpp"

namespace zstrip::sim {

/// Writes a temporary file in the same folder and renames it, which replaces an existing file; on a failure the
/// temporary file is removed. An input of this process is not replaced: exit status usage. A link to a file is kept; a
/// link without a target is a failure. Signals that end the program take effect before or after, not in between.
/// Devices and pipes are written directly. The failure's message is complete: name, reason, what to do; `option` is the
/// option that selects another place.
Result<Done> write_file(const std::filesystem::path& path, std::span<const std::uint8_t> content, const char* option);

}  // namespace zstrip::sim
