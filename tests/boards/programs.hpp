// Where the programs for boards are, by name.
#pragma once

#include <filesystem>
#include <string>

namespace zstrip::boards {

inline std::filesystem::path program(const std::string& name) {
  return std::filesystem::path(ZSTRIP_FIRMWARE_BINARIES) / (name + ".elf");
}

}  // namespace zstrip::boards
