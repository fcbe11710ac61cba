// Faults and unexpected interrupts: says on the console what happened and where, then halts.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "cortex_m/registers.hpp"
#include "cortex_m/stack.hpp"

namespace {
constexpr int kFaultStatus = 70;
}

// The report runs on a stack of its own, because the program's may be full.
extern "C" {
[[gnu::used, gnu::aligned(8)]] char fault_stack[256];
void fault_handler();
[[noreturn, gnu::used]] void report_fault(const std::uint32_t* stacked, std::uint32_t exception);
}

[[gnu::naked]] void fault_handler() {
  asm volatile(
      ".syntax unified\n\t"
      "mrs r0, msp\n\t"
      "mrs r1, ipsr\n\t"
      "ldr r2, =fault_stack + 256\n\t"
      "mov sp, r2\n\t"
      "ldr r2, =report_fault\n\t"
      "bx r2\n\t"
      ".ltorg");
}

// `stacked` is what the processor pushed: r0-r3, r12, lr, pc, xpsr. `exception` is its number, 3 for a hard fault.
void report_fault(const std::uint32_t* stacked, std::uint32_t exception) {
  using namespace zstrip::board;
  print("fault: exception ");
  print_decimal(exception);
  if (stacked >= stack_bottom + kStackGuardBytes / 4 && stacked + 8 <= stack_top) {
    print(" pc ");
    print_hex(stacked[6]);
    print(" lr ");
    print_hex(stacked[5]);
  } else {
    print(" stack overflow");
  }
#if __ARM_ARCH_7M__ || __ARM_ARCH_7EM__
  print(" cfsr ");
  print_hex(register_at(0xE000ED28));
  print(" hfsr ");
  print_hex(register_at(0xE000ED2C));
  print(" bfar ");
  print_hex(register_at(0xE000ED38));
#endif
  print("\n");
  halt(kFaultStatus);
}
