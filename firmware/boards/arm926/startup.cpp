// From reset to main on an ARM926EJ-S: exception vectors, stack, .bss. Every exception is reported and ends the
// program.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "portable/fault_return.hpp"

int main();

extern "C" {
// The linker script sets these; only their addresses have a meaning.
extern std::uint32_t bss_start[], bss_end[];

[[noreturn]] void reset_handler();
void exception_handler();
[[noreturn, gnu::used]] void start_program();
[[gnu::used]] void report_exception(std::uint32_t return_address, std::uint32_t mode);

[[gnu::used, gnu::aligned(8)]] char fault_stack[1024];
[[gnu::used]] std::uint32_t fault_return[10];  // r4 to r11, sp and lr of mark_fault_return()'s caller
}

namespace {
constexpr int kFaultStatus = 70;
bool reported = false;
}  // namespace

// One word for each exception, at address 0. The branches reach everything: the program is far below 32 MB.
[[gnu::naked, gnu::section(".vectors"), gnu::used]] void vectors() {
  asm volatile(
      "b reset_handler\n\t"      // reset
      "b exception_handler\n\t"  // undefined instruction
      "b .\n\t"                  // software interrupt: halt() ends here without semihosting
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

[[gnu::naked]] bool zstrip::board::mark_fault_return() {
  asm volatile(
      "ldr r0, =fault_return\n\t"
      "stmia r0, {r4-r11, sp, lr}\n\t"
      "mov r0, #0\n\t"
      "bx lr\n\t"
      ".ltorg");
}

// Each mode has its own stack pointer; the program's stack frames must not change.
[[gnu::naked]] void exception_handler() {
  asm volatile(
      "mov r0, lr\n\t"
      "mrs r1, cpsr\n\t"
      "ldr sp, =fault_stack + 1024\n\t"
      "bl report_exception\n\t"
      "ldr r0, =fault_return\n\t"
      "ldmia r0, {r4-r11, sp, lr}\n\t"
      "mov r0, #1\n\t"
      "bx lr\n\t"
      ".ltorg");
}

// `return_address` is 4 or 8 bytes after the instruction; `mode`: 0x1B undefined instruction, 0x17 abort.
void report_exception(std::uint32_t return_address, std::uint32_t mode) {
  using namespace zstrip::board;
  FaultWords::clear();
  FaultWords::add("mode ", mode & 0x1FU, 32);
  FaultWords::add(" before ", return_address, 32);
  print("fault: ");
  print(FaultWords::all());
  print("\n");
  if (reported || fault_return[9] == 0) halt(kFaultStatus);
  reported = true;
}
