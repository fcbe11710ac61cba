// The calls of Arm semihosting that are used here (specification: Arm 2014, "Semihosting for AArch32 and AArch64").
// RISC-V has the same calls behind three instructions ("RISC-V Semihosting", version 0.4), which must not be
// compressed.
#include "cortex_m/semihosting.hpp"

#include <cstdint>

namespace zstrip::board {
namespace {

enum class Operation : std::uint32_t { get_command_line = 0x15, exit_extended = 0x20 };

std::uint32_t call(Operation operation, void* block) {
#if defined(__riscv)
  register std::uint32_t result asm("a0") = static_cast<std::uint32_t>(operation);
  register void* argument asm("a1") = block;
  asm volatile(
      ".option push\n\t"
      ".option norvc\n\t"
      ".balign 16\n\t"
      "slli x0, x0, 0x1f\n\t"
      "ebreak\n\t"
      "srai x0, x0, 7\n\t"
      ".option pop"
      : "+r"(result)
      : "r"(argument)
      : "memory");
#else
  register std::uint32_t result asm("r0") = static_cast<std::uint32_t>(operation);
  register void* argument asm("r1") = block;
  asm volatile("bkpt 0xab" : "+r"(result) : "r"(argument) : "memory");
#endif
  return result;
}

}  // namespace

std::optional<std::string_view> read_command_line(std::span<char> buffer) {
  struct {
    char* text;
    std::uint32_t size;  // size of the buffer; the host replaces it by the length of the text
  } block{buffer.data(), static_cast<std::uint32_t>(buffer.size())};
  if (call(Operation::get_command_line, &block) != 0) return std::nullopt;
  return std::string_view(block.text, block.size);
}

void exit_emulator(int status) {
  constexpr std::uint32_t kApplicationExit = 0x20026;
  std::uint32_t block[2] = {kApplicationExit, static_cast<std::uint32_t>(status)};
  call(Operation::exit_extended, block);
  for (;;) {
  }
}

}  // namespace zstrip::board
