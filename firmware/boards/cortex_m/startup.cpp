// From reset to main: vector table, FPU, stack, memory.
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/registers.hpp"
#include "cortex_m/stack.hpp"

int main();

extern "C" {
// The linker script sets these; only their addresses have a meaning.
extern std::uint32_t data_start[], data_end[], bss_start[], bss_end[];
extern const std::uint32_t data_image[];

[[noreturn]] void reset_handler();
void fault_handler();
}

namespace {

using Handler = void (*)();

struct VectorTable {
  std::uint32_t* initial_stack;
  Handler handlers[15];
};

// No program here uses interrupts: every interrupt is reported as a fault.
[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors{
    zstrip::board::stack_top,
    {reset_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
     fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
     fault_handler}};

void set_up_memory() {
  const std::uint32_t* source = data_image;
  for (std::uint32_t* word = data_start; word != data_end; ++word) *word = *source++;
  for (std::uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
}

#ifdef __ARM_FP
void enable_fpu() {
  constexpr std::uint32_t kCoprocessorAccess = 0xE000ED88;
  zstrip::board::register_at(kCoprocessorAccess) = zstrip::board::register_at(kCoprocessorAccess) | 0xFU << 20;
  asm volatile("dsb\n\tisb" ::: "memory");
}
#endif

}  // namespace

void reset_handler() {
#ifdef __ARM_FP
  enable_fpu();
#endif
  zstrip::board::paint_stack();
  zstrip::board::guard_stack();
  set_up_memory();
  zstrip::board::start();
  zstrip::board::halt(main());
}
