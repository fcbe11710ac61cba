// Reports faults and unexpected interrupts on the console, then returns to the place that mark_fault_return() marked; a
// second fault, or a fault without a marked place, halts the board.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "cortex_m/registers.hpp"
#include "cortex_m/stack.hpp"
#include "portable/fault_return.hpp"

namespace {
constexpr int kFaultStatus = 70;
enum : std::uint32_t { kReturnAddress = 9, kReturnWords };
constexpr std::uint32_t kThumb = 1;  // set in an address in lr, not in one in an exception frame

/// True if an exception's frame lies in the stack above its guard, and the stack limit was not reached.
bool has_frame(const std::uint32_t* stacked) {
  using namespace zstrip::board;
#if __ARM_ARCH_8M_MAIN__ || __ARM_ARCH_8_1M_MAIN__
  constexpr std::uint32_t kCfsr = 0xE000ED28, kStackOverflow = 1U << 20;
  if ((register_at(kCfsr) & kStackOverflow) != 0) return false;
#endif
  return stacked >= stack_bottom + kStackGuardBytes / 4 && stacked + 8 <= stack_top;
}
}  // namespace

// The report uses a separate stack, because the program's stack may be full.
extern "C" {
[[gnu::used, gnu::aligned(8)]] char fault_stack[176];
/// r4 to r11, sp and lr of mark_fault_return()'s caller. FPU registers are not saved: afterwards their values are
/// undefined.
[[gnu::used]] std::uint32_t fault_return[kReturnWords];
void fault_handler();
[[gnu::used]] void report_fault(const std::uint32_t* stacked, std::uint32_t exception);
}

// Armv6-M can load and store several registers at once only if they are low registers.
[[gnu::naked]] bool zstrip::board::mark_fault_return() {
  asm volatile(
      ".syntax unified\n\t"
      "ldr r0, =fault_return\n\t"
      "stmia r0!, {r4-r7}\n\t"
      "mov r1, r8\n\t"
      "mov r2, r9\n\t"
      "mov r3, r10\n\t"
      "stmia r0!, {r1-r3}\n\t"
      "mov r1, r11\n\t"
      "mov r2, sp\n\t"
      "mov r3, lr\n\t"
      "stmia r0!, {r1-r3}\n\t"
      "movs r0, #0\n\t"
      "bx lr\n\t"
      ".ltorg");
}

// Returns through an exception frame below the marked stack pointer, so that it leaves the handler: a second fault
// inside of the handler would lock up the processor.
[[gnu::naked]] void fault_handler() {
  asm volatile(
      ".syntax unified\n\t"
      "mrs r0, msp\n\t"
      "mrs r1, ipsr\n\t"
#ifdef __ARM_FP
      // FPCCR.LSPACT: the abandoned frame has reserved room for FP registers, and the next FP instruction would still
      // write them there.
      "ldr r2, =0xE000EF34\n\t"
      "ldr r3, [r2]\n\t"
      "bic r3, #1\n\t"
      "str r3, [r2]\n\t"
#endif
      "ldr r2, =fault_stack + 176\n\t"
      "mov sp, r2\n\t"
      "bl report_fault\n\t"
      "ldr r0, =fault_return\n\t"
      "ldmia r0!, {r4-r7}\n\t"
      "ldmia r0!, {r1-r3}\n\t"
      "mov r8, r1\n\t"
      "mov r9, r2\n\t"
      "mov r10, r3\n\t"
      "ldmia r0!, {r1-r3}\n\t"
      "mov r11, r1\n\t"
      "subs r2, #32\n\t"
      "mov sp, r2\n\t"
      "movs r0, #1\n\t"
      "str r0, [r2, #0]\n\t"   // true
      "str r3, [r2, #24]\n\t"  // pc
      "lsls r0, r0, #24\n\t"
      "str r0, [r2, #28]\n\t"    // xpsr: Thumb
      "ldr r0, =0xFFFFFFF9\n\t"  // return to thread mode, main stack, no FPU registers
      "bx r0\n\t"
      ".ltorg");
}

// `stacked` is the frame that the processor pushed: r0-r3, r12, lr, pc, xpsr. `exception` is its number, 3 for a hard
// fault.
void report_fault(const std::uint32_t* stacked, std::uint32_t exception) {
  using namespace zstrip::board;
  FaultWords::clear();
  std::uint32_t decimal = exception;  // becomes one decimal digit in every four bits
  for (std::uint32_t rest = exception; rest >= 10; rest -= 10) decimal += 16 - 10;
  FaultWords::add("exception ", decimal, exception < 10 ? 4 : 8);
  if (has_frame(stacked)) {
    FaultWords::add(" pc ", stacked[6], 32);
    FaultWords::add(" lr ", stacked[5], 32);
  } else {
    FaultWords::add(" stack overflow", 0, 0);
  }
  print("fault: ");
  print(FaultWords::all());
#if __ARM_ARCH_7M__ || __ARM_ARCH_7EM__ || __ARM_ARCH_8M_MAIN__ || __ARM_ARCH_8_1M_MAIN__
  constexpr std::uint32_t kCfsr = 0xE000ED28, kMmfarValid = 1U << 7, kBfarValid = 1U << 15;
  const std::uint32_t cause = register_at(kCfsr);
  print(" cfsr ");
  print_hex(cause);
  print(" hfsr ");
  print_hex(register_at(0xE000ED2C));
  if ((cause & kMmfarValid) != 0) {
    print(" mmfar ");
    print_hex(register_at(0xE000ED34));
  }
  if ((cause & kBfarValid) != 0) {
    print(" bfar ");
    print_hex(register_at(0xE000ED38));
  }
  register_at(kCfsr) = cause;  // writing ones clears them, so that the next fault has only its own bits
#endif
  print("\n");
  // Only once: an address without this bit was already used.
  if ((fault_return[kReturnAddress] & kThumb) == 0) halt(kFaultStatus);
  fault_return[kReturnAddress] -= kThumb;
}
