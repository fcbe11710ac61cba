// Files of Blender, read by the program blender: its format is that of its memory, and changes with each release.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace zstrip::sim {

/// The scene of a .blend file, exported by the installed program blender.
struct ExportedBlend {
  std::vector<std::uint8_t> glb;  ///< empty: blender is not installed, or `reason` says why it did not export it
  std::string reason{};
  std::vector<std::string> warnings{};
};

/// Runs blender, at most for `limit`, without the user's settings and without scripts of the file. A file that was not
/// written since the last call is not exported again.
ExportedBlend export_blend(const std::filesystem::path& path, std::chrono::seconds limit);

}  // namespace zstrip::sim
