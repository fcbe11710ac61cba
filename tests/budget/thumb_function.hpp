// One function of a disassembly of Thumb code: what it does to the stack pointer and where it may go.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elf_file.hpp"

namespace zstrip::budget {

struct Instruction {
  std::uint32_t address;
  std::string mnemonic;  ///< without the width that objdump appends
  std::string operands;  ///< without objdump's comments
};

struct ThumbFunction {
  std::string name;
  std::uint32_t address = 0;
  std::vector<Instruction> instructions{};
};

/// Functions in the order of the text that `objdump -d --no-show-raw-insn` prints.
std::vector<ThumbFunction> parse_disassembly(std::string_view text);

/// Bytes by which the function lowers the stack pointer. What stands on different paths is added up, so that it may be
/// more than the function ever takes, never less. Throws std::runtime_error if it cannot tell.
std::uint32_t stack_frame(const ThumbFunction& function, const ElfFile& program);

/// Addresses that the function calls or jumps to. Jumps inside itself are left out, also those that Cortex-M0 makes
/// with bl because they are far; a call of its own beginning is not.
struct Targets {
  std::vector<std::uint32_t> addresses{};
  bool through_pointer = false;
  bool next = false;  ///< it goes on to the function behind it
};
Targets targets_of(const ThumbFunction& function);

}  // namespace zstrip::budget
