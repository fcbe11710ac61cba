// Counts executed instructions with the processor's own counter, in an emulator that counts them (QEMU's -icount).
#include "mps2/instruction_counter.hpp"

namespace zstrip::board {
namespace {

/// Returns the count modulo 2^32, which is enough for a region.
std::uint32_t retired() {
  std::uint32_t count;
  asm volatile("csrr %0, minstret" : "=r"(count));
  return count;
}

/// Executes 2 * count instructions and a few more.
void run_loop(std::uint32_t count) {
  asm volatile(
      "1: addi %0, %0, -1\n\t"
      "bnez %0, 1b"
      : "+r"(count));
}

}  // namespace

bool start_instruction_counter() {
  constexpr std::uint32_t kLoops = 1'000'000;
  const std::uint32_t before = retired();
  run_loop(kLoops);
  const std::uint32_t counted = retired() - before;
  return counted >= 2 * kLoops && counted <= 2 * kLoops + 100;
}

InstructionCounter::InstructionCounter() {
  resume();
  pause();
  empty_region_ = static_cast<std::uint32_t>(ticks_);
  reset();
}

void InstructionCounter::resume() { started_ = retired(); }

void InstructionCounter::pause() {
  ticks_ += retired() - started_;
  ++regions_;
}

std::uint64_t InstructionCounter::instructions() const { return ticks_ - std::uint64_t{regions_} * empty_region_; }

void InstructionCounter::reset() {
  ticks_ = 0;
  regions_ = 0;
}

}  // namespace zstrip::board
