// Writes files so that a name never stands for half a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "result.hpp"

namespace zstrip::sim {

/// Writes a temporary file in the same folder and renames it, replacing what was there; on a failure the temporary
/// file is removed. A link to a file stays one; one that leads nowhere is a failure. Signals that end the program take
/// effect before or after, not between. Devices and pipes are written directly. The failure's message is whole: name,
/// reason, what to do; `option` is the one that names another place.
Result<Done> write_file(const std::filesystem::path& path, std::span<const std::uint8_t> content, const char* option);

}  // namespace zstrip::sim
