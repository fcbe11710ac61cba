// From reset to main on a RISC-V core in machine mode: stack, .bss, trap vector. Every trap is reported and ends the
// program.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"

int main();

extern "C" {
// Set by the linker script; only their addresses mean something.
extern std::uint32_t bss_start[], bss_end[];

[[noreturn]] void reset_handler();
void trap_handler();
[[noreturn, gnu::used]] void start_program();
[[noreturn, gnu::used]] void report_trap(std::uint32_t cause, std::uint32_t address, std::uint32_t value);
}

namespace {
constexpr int kFaultStatus = 70;
}

// All harts of the machine start here; the first one runs the program, others wait for ever.
[[gnu::naked, gnu::section(".reset")]] void reset_handler() {
  asm volatile(
      "csrr t0, mhartid\n"
      "1: bnez t0, 1b\n\t"
      "la sp, stack_top\n\t"
      "la t0, trap_handler\n\t"
      "csrw mtvec, t0\n\t"
      "j start_program");
}

void start_program() {
  for (volatile std::uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
  zstrip::board::start();
  zstrip::board::halt(main());
}

// mtvec keeps two bits for itself: the address must be a multiple of 4. The program never goes on, so that its stack
// may be used from the top.
[[gnu::naked, gnu::aligned(4)]] void trap_handler() {
  asm volatile(
      "csrr a0, mcause\n\t"
      "csrr a1, mepc\n\t"
      "csrr a2, mtval\n\t"
      "la sp, stack_top\n\t"
      "j report_trap");
}

void report_trap(std::uint32_t cause, std::uint32_t address, std::uint32_t value) {
  using namespace zstrip::board;
  print("fault: cause ");
  print_decimal(cause);
  print(" pc ");
  print_hex(address);
  print(" value ");
  print_hex(value);
  print("\n");
  halt(kFaultStatus);
}
