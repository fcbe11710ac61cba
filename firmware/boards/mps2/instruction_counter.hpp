// Counts executed instructions with CMSDK timer 0, in an emulator that lets every instruction take one nanosecond
// (QEMU's -icount shift=0). The timer counts down at 25 MHz, so that one tick is 40 instructions; with the image AN505
// at 20 MHz. AN547 has no such timer: its system counter of 32 MHz is scaled to one tick for each instruction. On
// riscv_virt the processor counts instructions, so that a tick is one instruction.
#pragma once

#include <cstdint>

namespace zstrip::board {

#if ZSTRIP_MPS2_IMAGE == 547
inline constexpr std::uint32_t kInstructionsPerTick = 1;
#elif ZSTRIP_MPS2_IMAGE == 505
inline constexpr std::uint32_t kInstructionsPerTick = 50;
#else
inline constexpr std::uint32_t kInstructionsPerTick = 40;
#endif

/// Starts the timer. Returns false if a loop of known length does not take the expected ticks, within 1 in 10,000: it
/// is another emulator, or it does not count instructions.
bool start_instruction_counter();

/// Adds up the ticks of the regions between resume() and pause(). The ticks of an empty region are measured on
/// construction and subtracted from each region; the sum over n regions is exact to about kInstructionsPerTick *
/// sqrt(n) instructions.
class InstructionCounter {
 public:
  InstructionCounter();
  void resume();
  void pause();
  /// Returns the instructions of all regions so far.
  std::uint64_t instructions() const;
  void reset();

 private:
  std::uint32_t started_ = 0;
  std::uint32_t regions_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint32_t empty_region_ = 0;  // 24.8 ticks
};

}  // namespace zstrip::board
