// What a program for a board takes of its memories, drawing one scene: read from the linked program, from the plan,
// and from a run in the emulator.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "zstrip/plan/plan.hpp"

namespace zstrip::budget {

/// How a program in the emulator says what it drew.
enum class Report : std::uint8_t {
  turntable,  ///< a line of JSON on the console, then it waits for ever
  bench,      ///< a line of JSON on the console, then it ends; takes words
  frames,     ///< the number of each frame on the console, one at a time if asked to
};

/// A program, and the scene that it draws or is to draw.
struct Target {
  const char* board;     ///< for readers
  const char* program;   ///< the file's name without its beginning "zstrip_" and its end
  const char* machine;   ///< QEMU's name of it
  const char* scene;     ///< of the catalogue of built-in scenes
  const char* workload;  ///< the benchmark's name of it
  View view;
  Report report;
  std::uint32_t stack_guard = 256;  ///< bytes of the stack that the memory protection unit takes, if there is one
};

/// Every program that draws a scene, with every scene that it draws.
const std::vector<Target>& targets();

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
  std::string name;  ///< short_name's
  std::uint32_t bytes;
  bool in_ram;
};

/// Those in flash first, in each from the largest to the smallest. Initialised variables count as RAM.
std::vector<SymbolSize> symbol_sizes(const std::filesystem::path& program);

std::filesystem::path file_of(const Target& target, const std::filesystem::path& binaries);

}  // namespace zstrip::budget
