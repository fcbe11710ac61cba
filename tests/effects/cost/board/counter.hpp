// Instructions as an emulated board counts them, and the drawing that its command line names.
#pragma once

#include <cstdint>

#include "cortex_m/semihosting.hpp"
#include "mps2/instruction_counter.hpp"

namespace zstrip::effects_cost {

using Counter = board::InstructionCounter;
inline bool start_counter() { return board::start_instruction_counter(); }
constexpr std::uint32_t repeats() { return 1; }
inline std::uint32_t chosen_drawing() {
  char buffer[16];
  std::uint32_t number = 0;
  const auto words = board::read_command_line(buffer);
  if (!words || words->empty()) return ~0U;
  for (const char digit : *words) number = 10 * number + static_cast<std::uint32_t>(digit - '0');
  return number;
}

}  // namespace zstrip::effects_cost
