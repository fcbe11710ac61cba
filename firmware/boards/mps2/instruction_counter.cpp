// The timer behind the instruction counter, and its calibration.
#include "mps2/instruction_counter.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

#if defined(__ARM_ARCH_8M_MAIN__)
constexpr std::uint32_t kTimer0 = 0x50000000;  // of AN505, secure; offset 0 is the control register
#else
constexpr std::uint32_t kTimer0 = 0x40000000;
#endif
constexpr std::uint32_t kTimerValue = 0x004;
constexpr std::uint32_t kTimerReload = 0x008;

std::uint32_t ticks_left() { return register_at(kTimer0 + kTimerValue); }

/// Executes 2 * count instructions and a few more.
void run_loop(std::uint32_t count) {
  asm volatile(
      ".syntax unified\n"
      "1: subs %0, %0, #1\n\t"
      "bne 1b"
      : "+l"(count)
      :
      : "cc");
}

}  // namespace

bool start_instruction_counter() {
  register_at(kTimer0 + kTimerReload) = 0xFFFFFFFF;
  register_at(kTimer0 + kTimerValue) = 0xFFFFFFFF;
  register_at(kTimer0) = 1;
  constexpr std::uint32_t kLoops = 1'000'000;
  constexpr std::uint32_t kExpected = 2 * kLoops / kInstructionsPerTick;
  const std::uint32_t before = ticks_left();
  run_loop(kLoops);
  const std::uint32_t ticks = before - ticks_left();
  return ticks >= kExpected - kExpected / 10'000 && ticks <= kExpected + kExpected / 10'000;
}

InstructionCounter::InstructionCounter() {
  constexpr std::uint32_t kRegions = 4096;
  for (std::uint32_t region = 0; region < kRegions; ++region) {
    resume();
    pause();
  }
  empty_region_ = static_cast<std::uint32_t>((ticks_ << 8) / kRegions);
  reset();
}

void InstructionCounter::resume() { started_ = ticks_left(); }

void InstructionCounter::pause() {
  ticks_ += started_ - ticks_left();
  ++regions_;
}

std::uint64_t InstructionCounter::instructions() const {
  const std::uint64_t empty = (std::uint64_t{regions_} * empty_region_) >> 8;
  return ticks_ > empty ? (ticks_ - empty) * kInstructionsPerTick : 0;
}

void InstructionCounter::reset() {
  ticks_ = 0;
  regions_ = 0;
}

}  // namespace zstrip::board
