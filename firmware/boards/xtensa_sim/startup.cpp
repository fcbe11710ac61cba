// From reset to main on an Xtensa processor without register windows: stack, .bss, exception vectors. Every exception
// is reported and ends the program. Source: Xtensa Instruction Set Architecture Reference Manual, 4.4.1 (exceptions).
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"

int main();

extern "C" {
// The linker script sets these; only their addresses have a meaning.
extern std::uint32_t bss_start[], bss_end[];

[[noreturn, gnu::used]] void start_program();
[[noreturn, gnu::used]] void report_exception(const char* kind, std::uint32_t cause, std::uint32_t address);

[[gnu::used, gnu::aligned(16)]] char fault_stack[1024];
[[gnu::used]] extern const char cause_words[] = "cause ";
[[gnu::used]] extern const char debug_cause_words[] = "debug cause ";
}

// The machine begins at the first byte of its ROM, with all interrupts masked and in exception mode, which rsil would
// not end.
asm(".section .reset, \"ax\"\n"
    ".global reset_handler\n"
    "reset_handler:\n\t"
    "j 1f\n\t"
    ".balign 4\n\t"
    ".literal_position\n"
    "1:\n\t"
    "movi a2, vectors\n\t"
    "wsr.vecbase a2\n\t"
    "movi a2, 1\n\t"  // PS: no exception, interrupts of level 1 masked
    "wsr.ps a2\n\t"
    "rsync\n\t"
    "movi a1, stack_top\n\t"
    "movi a0, start_program\n\t"
    "jx a0\n"
    ".text");

// The offsets of the processor's vectors from VECBASE.
asm(".section .vectors, \"ax\"\n"
    ".begin no-transform\n"
    "vectors:\n"
    ".org 0x10\n\t"  // debug: a break instruction
    "j debug_exception\n"
    ".org 0x20\n\t"  // non-maskable interrupt
    "j exception\n"
    ".org 0x30\n\t"  // in kernel mode
    "j exception\n"
    ".org 0x50\n\t"  // in user mode
    "j exception\n"
    ".org 0x70\n\t"  // in an exception
    "j exception\n"
    ".balign 4\n"
    ".end no-transform\n\t"
    ".literal_position\n"
    "exception:\n\t"
    "movi a2, cause_words\n\t"
    "rsr.exccause a3\n\t"
    "rsr.epc1 a4\n"
    "1:\n\t"
    "movi a1, fault_stack + 1024\n\t"
    "movi a0, report_exception\n\t"
    "jx a0\n"
    "debug_exception:\n\t"
    "movi a2, debug_cause_words\n\t"
    "rsr.debugcause a3\n\t"
    "rsr.epc2 a4\n\t"
    "j 1b\n"
    ".text");

void start_program() {
  for (volatile std::uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
  zstrip::board::start();
  zstrip::board::halt(main());
}

void report_exception(const char* kind, std::uint32_t cause, std::uint32_t address) {
  constexpr int kFaultStatus = 70;
  using namespace zstrip::board;
  print("fault: ");
  print(kind);
  print_decimal(cause);
  print(" pc ");
  print_hex(address);
  print("\n");
  halt(kFaultStatus);
}
