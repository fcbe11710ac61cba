// Runs a program for a board in the emulator and tells what it used.
#pragma once

#include <cstdint>
#include <filesystem>

#include "elf_file.hpp"
#include "usage.hpp"

namespace zstrip::budget {

struct BoardRun {
  std::uint32_t stack = 0;  ///< bytes, the deepest
  // Bytes and rows as the program itself reports them; 0 where it does not.
  std::uint32_t arena = 0;
  std::uint32_t pixels = 0;
  std::uint32_t strip_rows = 0;  ///< 0, 0: not reported
  std::uint32_t strip_columns = 0;
};

/// Throws std::runtime_error if the program fails, or says of its stack what its memory does not.
BoardRun run_on_board(const Target& target, const std::filesystem::path& program, const Section& stack);

}  // namespace zstrip::budget
