// Instructions as an emulated board counts them.
#pragma once

#include "mps2/instruction_counter.hpp"

namespace zstrip::effects_cost {

using Counter = board::InstructionCounter;
inline bool start_counter() { return board::start_instruction_counter(); }
constexpr std::uint32_t repeats() { return 1; }

}  // namespace zstrip::effects_cost
