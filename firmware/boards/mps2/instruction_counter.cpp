// The timer behind the instruction counter, and its calibration.
#include "mps2/instruction_counter.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

#if ZSTRIP_MPS2_IMAGE == 547
constexpr std::uint32_t kCounterControl = 0x58100000;  // the system counter of AN547, secure
constexpr std::uint32_t kCounterScale = kCounterControl + 0x010;
constexpr std::uint32_t kCounterValue = 0x58101000;
constexpr std::uint32_t kEnable = 1U << 0, kScaled = 1U << 2;

void start_ticks() {
  register_at(kCounterScale) = 0x1F400000;  // 31.25 in 8.24 bits: at 32 MHz one step for each nanosecond
  register_at(kCounterControl) = kEnable | kScaled;
}

std::uint32_t ticks_left() { return ~register_at(kCounterValue); }
#else
#if ZSTRIP_MPS2_IMAGE == 505
constexpr std::uint32_t kTimer0 = 0x50000000;  // in AN505, secure; offset 0 is the control register
#else
constexpr std::uint32_t kTimer0 = 0x40000000;
#endif
constexpr std::uint32_t kTimerValue = 0x004;
constexpr std::uint32_t kTimerReload = 0x008;

void start_ticks() {
  register_at(kTimer0 + kTimerReload) = 0xFFFFFFFF;
  register_at(kTimer0 + kTimerValue) = 0xFFFFFFFF;
  register_at(kTimer0) = 1;
}

std::uint32_t ticks_left() { return register_at(kTimer0 + kTimerValue); }
#endif

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
  start_ticks();
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
