// From reset to main on a RISC-V core in machine mode: stack, .data, .bss, trap vector. Every trap is reported and ends
// the program.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "portable/fault_return.hpp"

int main();

extern "C" {
// The linker script sets these; only their addresses have a meaning.
extern std::uint32_t data_start[], data_end[], bss_start[], bss_end[];
extern const std::uint32_t data_image[];

[[noreturn]] void reset_handler();
void trap_handler();
[[noreturn, gnu::used]] void start_program();
[[gnu::used]] void report_trap(std::uint32_t cause, std::uint32_t address, std::uint32_t value);

[[gnu::used, gnu::aligned(16)]] char fault_stack[1024];
[[gnu::used]] std::uint32_t fault_return[14];  // ra, sp and s0 to s11 of mark_fault_return()'s caller
}

namespace {
constexpr int kFaultStatus = 70;
bool reported = false;
}  // namespace

// All harts of the machine start here; the first one runs the program, the others wait for ever.
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
  const std::uint32_t *image = data_image, *end = data_end;
  asm("" : "+r"(end));  // the compiler assumes that two symbols differ, but nothing may be to copy
  for (volatile std::uint32_t* word = data_start; word != end; ++word) *word = *image++;
  for (volatile std::uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
  zstrip::board::start();
  zstrip::board::halt(main());
}

[[gnu::naked]] bool zstrip::board::mark_fault_return() {
  asm volatile(
      "la t0, fault_return\n\t"
      "sw ra, 0(t0)\n\t"
      "sw sp, 4(t0)\n\t"
      "sw s0, 8(t0)\n\t"
      "sw s1, 12(t0)\n\t"
      "sw s2, 16(t0)\n\t"
      "sw s3, 20(t0)\n\t"
      "sw s4, 24(t0)\n\t"
      "sw s5, 28(t0)\n\t"
      "sw s6, 32(t0)\n\t"
      "sw s7, 36(t0)\n\t"
      "sw s8, 40(t0)\n\t"
      "sw s9, 44(t0)\n\t"
      "sw s10, 48(t0)\n\t"
      "sw s11, 52(t0)\n\t"
      "li a0, 0\n\t"
      "ret");
}

// mtvec uses two bits for its mode: the address must be a multiple of 4. The program's stack frames must not change.
[[gnu::naked, gnu::aligned(4)]] void trap_handler() {
  asm volatile(
      "csrr a0, mcause\n\t"
      "csrr a1, mepc\n\t"
      "csrr a2, mtval\n\t"
      "la sp, fault_stack + 1024\n\t"
      "call report_trap\n\t"
      "la t0, fault_return\n\t"
      "lw ra, 0(t0)\n\t"
      "lw sp, 4(t0)\n\t"
      "lw s0, 8(t0)\n\t"
      "lw s1, 12(t0)\n\t"
      "lw s2, 16(t0)\n\t"
      "lw s3, 20(t0)\n\t"
      "lw s4, 24(t0)\n\t"
      "lw s5, 28(t0)\n\t"
      "lw s6, 32(t0)\n\t"
      "lw s7, 36(t0)\n\t"
      "lw s8, 40(t0)\n\t"
      "lw s9, 44(t0)\n\t"
      "lw s10, 48(t0)\n\t"
      "lw s11, 52(t0)\n\t"
      "li a0, 1\n\t"
      "ret");
}

void report_trap(std::uint32_t cause, std::uint32_t address, std::uint32_t value) {
  using namespace zstrip::board;
  FaultWords::clear();
  FaultWords::add("cause ", cause, cause < 16 ? 4 : 32);
  FaultWords::add(" pc ", address, 32);
  print("fault: ");
  print(FaultWords::all());
  print(" value ");
  print_hex(value);
  print("\n");
  if (reported || fault_return[0] == 0) halt(kFaultStatus);
  reported = true;
}
