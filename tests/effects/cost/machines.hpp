// The emulated machines that programs for boards run on, this host, and what their programs print and weigh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "zstrip/effects.hpp"

namespace zstrip::effects_cost {

inline constexpr const char* kMachines[] = {"m0", "m3", "m4f"};
inline constexpr const char* kCheckedMachine = "m3";  ///< alone, where all would take too long

/// "BITS_METHODS", hexadecimal: how programs are named.
std::string name_of(Effects effects);

/// What the program prints. `word` is its command line. Throws std::runtime_error if it fails.
std::string printed_on(const std::string& machine, const std::filesystem::path& program, const std::string& word);

/// Instructions of a run of draw.cpp's program on this host, as valgrind counts them. Throws std::runtime_error.
std::uint64_t instructions_here(const std::filesystem::path& program, const std::string& drawing);

/// Bytes of flash that a program takes.
std::uint32_t flash_of(const std::filesystem::path& program);

}  // namespace zstrip::effects_cost
