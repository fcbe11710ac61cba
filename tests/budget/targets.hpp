// Which programs for boards there are, and which scenes they draw.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "zstrip/effects.hpp"
#include "zstrip/view.hpp"

namespace zstrip::budget {

/// How a program in the emulator says what it drew.
enum class Report : std::uint8_t {
  turntable,  ///< a line of JSON on the console, then it waits for ever
  bench,      ///< a line of JSON on the console, then it ends; takes words
  none,       ///< there is no emulator for it
  recorded,   ///< it runs in the emulator of tests/pico alone, which records the stack in docs/measured/pico.csv
  frames,     ///< the number of each frame on the console, one at a time if asked to
};

/// A program, and the scene that it draws or is to draw.
struct Target {
  const char* board;     ///< for readers
  const char* program;   ///< the file's name without its beginning "zstrip_" and its end
  const char* machine;   ///< QEMU's name of it
  const char* scene;     ///< of the catalogue of built-in scenes, or the showroom's background
  const char* workload;  ///< the benchmark's name of it
  View view;
  Report report;
  std::uint32_t stack_guard;        ///< bytes of the stack that the memory protection unit takes, if there is one
  std::uint16_t strip_rows = 0;     ///< of the program's plan; 0: as its budget or its report says
  std::uint16_t strip_columns = 0;  ///< likewise
  int serial_port = 0;              ///< that is the console
  bool binned = false;              ///< its plan keeps vertices and lists of triangles
  int frames = 64;  ///< drawn for Report::frames: a whole turn, fewer where the emulator takes seconds for each
};

/// Every program that draws a scene, with every scene that it draws.
std::span<const Target> targets();

/// What its scene calls for. Throws std::runtime_error if there is no such scene.
Effects effects_of(const Target& target);

/// The program's file in the folder of all programs.
std::filesystem::path file_of(const Target& target, const std::filesystem::path& binaries);

}  // namespace zstrip::budget
