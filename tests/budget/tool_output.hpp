// What a tool of the compiler prints.
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace zstrip::budget {

/// Throws std::runtime_error if the command cannot be run, or fails.
inline std::string output_of(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 65536> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

}  // namespace zstrip::budget
