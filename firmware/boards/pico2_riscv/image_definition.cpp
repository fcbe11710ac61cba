// The block that the RP2350's boot ROM searches in the first 4 KB of the flash, for a program of its RISC-V processors:
// as that of pico2, but with the entry point and the stack in place of a vector table. The ROM starts the RISC-V
// processors by itself if the program is for them. Source: RP2350 data sheet, 5.9.3.1 (image type), 5.9.3.4 (entry
// point).
#include <cstdint>

extern "C" {
[[noreturn]] void reset_handler();
extern std::uint32_t stack_top[];  // set by the linker script
}

namespace {

constexpr std::uint32_t kBegin = 0xFFFFDED3, kEnd = 0xAB123579;

// An item begins with its type and its number of words; the other fields depend on the type.
constexpr std::uint32_t item(std::uint32_t type, std::uint32_t words, std::uint32_t value) {
  return value << 16 | words << 8 | type;
}
constexpr std::uint32_t kExecutable = 1, kRiscv = 1U << 8, kRp2350 = 1U << 12;

struct ImageDefinition {
  std::uint32_t begin = kBegin;
  std::uint32_t image_type = item(0x42, 1, kExecutable | kRiscv | kRp2350);
  std::uint32_t entry_point_item = item(0x44, 3, 0);
  void (*entry_point)() = reset_handler;
  std::uint32_t* stack = stack_top;
  std::uint32_t last = 4U << 8 | 0xFF;  // the words of all items
  std::uint32_t next_block = 0;         // offset of the next block; 0: this is the only one
  std::uint32_t end = kEnd;
};

[[gnu::section(".image_definition"), gnu::used]] constinit const ImageDefinition image_definition;

}  // namespace
