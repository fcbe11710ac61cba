// The block that the RP2350's boot ROM searches in the first 4 KB of the flash. It says that this is a program for the
// Cortex-M33, and gives the address of its vector table, with stack and entry point. The boot ROM sets up the flash
// itself, without a second boot stage. Source: RP2350 data sheet, 5.9 (metadata block details).
#include <cstdint>

// The linker script sets it; only its address has a meaning.
extern "C" const std::uint32_t vector_table[];

namespace {

constexpr std::uint32_t kBegin = 0xFFFFDED3, kEnd = 0xAB123579;

// An item begins with its type and its number of words; the other fields depend on the type.
constexpr std::uint32_t item(std::uint32_t type, std::uint32_t words, std::uint32_t value) {
  return value << 16 | words << 8 | type;
}
constexpr std::uint32_t kExecutable = 1, kSecure = 2U << 4, kArm = 0U << 8, kRp2350 = 1U << 12;

struct ImageDefinition {
  std::uint32_t begin = kBegin;
  std::uint32_t image_type = item(0x42, 1, kExecutable | kSecure | kArm | kRp2350);
  std::uint32_t vector_table_item = item(0x03, 2, 0);
  const std::uint32_t* vector_table_address = vector_table;
  std::uint32_t last = 3U << 8 | 0xFF;  // the words of all items
  std::uint32_t next_block = 0;         // offset of the next block; 0: this is the only one
  std::uint32_t end = kEnd;
};

[[gnu::section(".image_definition"), gnu::used]] constinit const ImageDefinition image_definition;

}  // namespace
