// What a program for a board takes of its memories, drawing one scene: read from the linked program, from the plan,
// and from a run in the emulator.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "targets.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::budget {

/// All in bytes.
struct Usage {
  const Target* target = nullptr;
  std::uint32_t code = 0;            ///< flash: instructions and the constants between them
  std::uint32_t constants = 0;       ///< flash: read-only data, the scene's tables above all
  std::uint32_t initial_data = 0;    ///< flash: what initialised variables begin with
  std::uint32_t arena = 0;           ///< RAM
  std::uint32_t pixels = 0;          ///< RAM: one strip, or two
  std::uint32_t statics = 0;         ///< RAM: all other variables
  std::uint32_t stack_bound = 0;     ///< RAM: the stack is never deeper
  std::uint32_t stack_measured = 0;  ///< the deepest that it was in the emulator
  std::uint32_t stack_reserved = 0;  ///< RAM: what the linker script gives it
  Plan plan{};                       ///< of the arena

  std::uint32_t flash() const { return code + constants + initial_data; }
  std::uint32_t ram() const { return arena + pixels + statics + stack_reserved; }
};

/// `binaries` is the folder of the programs, with the lists of their object files. Throws std::runtime_error, with what
/// went wrong.
Usage measure(const Target& target, const std::filesystem::path& binaries);

/// Functions or objects of one name in flash or in RAM.
struct SymbolSize {
  std::string name;  ///< reader_name's, without arguments
  std::uint32_t bytes;
  bool in_ram;
};

/// Those in flash first, in each from the largest to the smallest. Initialised variables count as RAM.
std::vector<SymbolSize> symbol_sizes(const std::filesystem::path& program);

}  // namespace zstrip::budget
