// The classes of instructions that the published timings of Cortex-M cores distinguish.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace zstrip::sim {

enum class InstructionClass : std::uint8_t {
  other,            ///< arithmetic, moves, shifts, comparisons, IT
  multiply,         ///< 32 x 32 to 32 bits, and the DSP extension's multiplications of halves
  accumulate,       ///< multiply and add or subtract, 32 bits
  long_multiply,    ///< 32 x 32 to 64 bits
  long_accumulate,  ///< 32 x 32 to 64 bits, added to 64 bits
  divide,
  load,
  store,
  load_multiple,   ///< LDM, POP, LDRD
  store_multiple,  ///< STM, PUSH, STRD
  branch,          ///< B, CBZ and CBNZ, with a condition or without
  call,            ///< BL
  branch_register  ///< BX, BLX, and loads of the program counter
};
inline constexpr std::array<std::string_view, 13> kInstructionClassNames = {"other",
                                                                            "multiply",
                                                                            "multiply_accumulate",
                                                                            "long_multiply",
                                                                            "long_multiply_accumulate",
                                                                            "divide",
                                                                            "load",
                                                                            "store",
                                                                            "load_multiple",
                                                                            "store_multiple",
                                                                            "branch",
                                                                            "call",
                                                                            "branch_register"};

struct ClassifiedInstruction {
  InstructionClass kind = InstructionClass::other;
  std::uint32_t words = 0;  ///< registers that a multiple transfer moves
  bool loads_pc = false;    ///< a load that also branches: POP {..., pc}, LDR pc, TBB
  /// An `other` instruction with an operand that is shifted, except left by 1 to 3, or with an immediate of more than 8
  /// bits, except a move: on a Cortex-M33 the results of these come late.
  bool complex = false;
};

/// `text`: a Thumb instruction as QEMU disassembles it, "ldrh.w r3, [r2, #4]".
ClassifiedInstruction classify(std::string_view text);

}  // namespace zstrip::sim
