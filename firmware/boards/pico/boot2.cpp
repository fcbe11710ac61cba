// The second boot stage: the boot ROM copies the first 256 bytes of the flash to the end of the RAM, checks their CRC
// and jumps to them. They teach the flash interface to read in place and start the program. Source: RP2040 data
// sheet, 2.8.1 (boot sequence), 4.10 (SSI).
//
// Machine code, written here as numbers: its checksum is then reckoned by the compiler.
#include <array>
#include <cstddef>
#include <cstdint>

namespace {

// The few Thumb instructions that are used (Armv6-M architecture reference manual, A6.7).
enum Register : std::uint16_t { r0, r1, r2, r3 };
constexpr std::uint16_t load_constant(Register to, unsigned words_from_pc) {
  return static_cast<std::uint16_t>(0x4800U | static_cast<unsigned>(to) << 8 | words_from_pc);
}
constexpr std::uint16_t move(Register to, unsigned value) {
  return static_cast<std::uint16_t>(0x2000U | static_cast<unsigned>(to) << 8 | value);
}
constexpr std::uint16_t store(Register from, Register base, unsigned offset) {
  return static_cast<std::uint16_t>(0x6000U | (offset / 4) << 6 | static_cast<unsigned>(base) << 3 | from);
}
constexpr std::uint16_t load(Register to, Register base, unsigned offset) {
  return static_cast<std::uint16_t>(0x6800U | (offset / 4) << 6 | static_cast<unsigned>(base) << 3 | to);
}
constexpr std::uint16_t jump(Register to) {
  return static_cast<std::uint16_t>(0x4700U | static_cast<unsigned>(to) << 3);
}
constexpr std::uint16_t kSetMainStack[] = {0xF380, 0x8808};  // msr msp, r0

// SSI registers, 4.10.13.
constexpr std::uint32_t kSsi = 0x18000000;
constexpr unsigned kControl0 = 0x00, kControl1 = 0x04, kEnable = 0x08, kBaudRate = 0x14;
constexpr std::uint32_t kSpiControl0 = kSsi + 0xF4;
// Frames of 32 bits, one data line, "EEPROM read": a command and an address, then data for as long as it is clocked.
constexpr std::uint32_t kReadFrames = 31U << 16 | 3U << 8;
// Command 03h, serial read, which every flash has: 8 bits of command, 24 of address, no wait cycles.
constexpr std::uint32_t kReadCommand = 0x03U << 24 | 2U << 8 | (24U / 4) << 2;
constexpr unsigned kClockBy4 = 4;

constexpr std::uint32_t kVectorTableOffset = 0xE000ED08;  // VTOR
constexpr std::uint32_t kProgram = 0x10000100;

constexpr std::size_t kBytes = 256, kCheckedBytes = 252;
constexpr std::size_t kHalfwords = 22;  // of code; the constants follow
static_assert(kHalfwords % 2 == 0, "constants lie at multiples of four bytes");

consteval std::array<std::uint8_t, kCheckedBytes> code_and_constants() {
  constexpr std::array kConstants{kSsi, kReadFrames, kSpiControl0, kReadCommand, kProgram, kVectorTableOffset};
  // From instruction `index` to constant `number`: the processor adds to its own address, plus 4, rounded down to
  // words.
  const auto words = [](unsigned index, unsigned number) {
    return static_cast<unsigned>((kHalfwords * 2 + number * 4 - (index * 2 + 4) / 4 * 4) / 4);
  };
  const std::array<std::uint16_t, kHalfwords> code{
      load_constant(r3, words(0, 0)),  // the SSI
      move(r1, 0),
      store(r1, r3, kEnable),  // off while it is set up
      move(r1, kClockBy4),
      store(r1, r3, kBaudRate),
      load_constant(r1, words(5, 1)),
      store(r1, r3, kControl0),
      load_constant(r1, words(7, 3)),
      load_constant(r0, words(8, 2)),
      store(r1, r0, 0),
      move(r1, 0),
      store(r1, r3, kControl1),  // one frame of data an access
      move(r1, 1),
      store(r1, r3, kEnable),
      load_constant(r2, words(14, 4)),  // the program's vector table
      load_constant(r1, words(15, 5)),
      store(r2, r1, 0),
      // The first two entries are the stack and where to begin.
      load(r0, r2, 0),
      load(r1, r2, 4),
      kSetMainStack[0],
      kSetMainStack[1],
      jump(r1),
  };
  std::array<std::uint8_t, kCheckedBytes> bytes{};
  const auto put = [&bytes](std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  for (std::size_t i = 0; i < code.size(); ++i) put(2 * i, code[i], 2);
  for (std::size_t i = 0; i < kConstants.size(); ++i) put(2 * kHalfwords + 4 * i, kConstants[i], 4);
  return bytes;
}

/// CRC-32 with the polynomial 04C11DB7, highest bit first, from all ones, not inverted (2.8.1.3.1).
consteval std::uint32_t checksum(const std::array<std::uint8_t, kCheckedBytes>& bytes) {
  std::uint32_t remainder = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) {
    remainder ^= static_cast<std::uint32_t>(byte) << 24;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder << 1) ^ ((remainder & 0x80000000) != 0 ? 0x04C11DB7U : 0U);
    }
  }
  return remainder;
}

consteval std::array<std::uint8_t, kBytes> boot_stage() {
  const std::array<std::uint8_t, kCheckedBytes> checked = code_and_constants();
  const std::uint32_t crc = checksum(checked);
  std::array<std::uint8_t, kBytes> bytes{};
  for (std::size_t i = 0; i < kCheckedBytes; ++i) bytes[i] = checked[i];
  for (std::size_t i = 0; i < 4; ++i) bytes[kCheckedBytes + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  return bytes;
}

[[gnu::section(".boot2"), gnu::used]] constinit const std::array<std::uint8_t, kBytes> boot2 = boot_stage();

}  // namespace
