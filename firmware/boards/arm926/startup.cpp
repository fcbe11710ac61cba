// From reset to main on an ARM926EJ-S: exception vectors, stack, .bss. Every exception is reported and ends the
// program.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"

int main();

extern "C" {
// Set by the linker script; only their addresses mean something.
extern std::uint32_t bss_start[], bss_end[];

[[noreturn]] void reset_handler();
void exception_handler();
[[noreturn, gnu::used]] void start_program();
[[noreturn, gnu::used]] void report_exception(std::uint32_t return_address, std::uint32_t mode);
}

namespace {
constexpr int kFaultStatus = 70;
}

// One word for each exception, at address 0. The branches reach everything: the program is far below 32 MB.
[[gnu::naked, gnu::section(".vectors"), gnu::used]] void vectors() {
  asm volatile(
      "b reset_handler\n\t"      // reset
      "b exception_handler\n\t"  // undefined instruction
      "b exception_handler\n\t"  // software interrupt: the emulator takes the one that is used before it gets here
      "b exception_handler\n\t"  // prefetch abort
      "b exception_handler\n\t"  // data abort
      "b exception_handler\n\t"  // reserved
      "b exception_handler\n\t"  // interrupt
      "b exception_handler");    // fast interrupt
}

// Supervisor mode, interrupts off: the state after reset, set again for loaders that jump here.
[[gnu::naked]] void reset_handler() {
  asm volatile(
      "msr cpsr_c, #0xD3\n\t"
      "ldr sp, =stack_top\n\t"
      "b start_program\n\t"
      ".ltorg");
}

void start_program() {
  for (volatile std::uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
  zstrip::board::start();
  zstrip::board::halt(main());
}

// Each mode has a stack pointer of its own; the program never goes on, so that its stack may be used from the top.
[[gnu::naked]] void exception_handler() {
  asm volatile(
      "mov r0, lr\n\t"
      "mrs r1, cpsr\n\t"
      "ldr sp, =stack_top\n\t"
      "b report_exception\n\t"
      ".ltorg");
}

// `return_address` is 4 or 8 bytes behind the instruction; `mode`: 0x1B undefined instruction, 0x17 abort.
void report_exception(std::uint32_t return_address, std::uint32_t mode) {
  using namespace zstrip::board;
  print("fault: mode ");
  print_hex(mode & 0x1FU);
  print(" before ");
  print_hex(return_address);
  print("\n");
  halt(kFaultStatus);
}
