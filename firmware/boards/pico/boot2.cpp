// The second boot stage: the boot ROM copies the first 256 bytes of the flash to the end of the RAM, checks their CRC
// and jumps to them. They make the flash readable in place over four lines, which the Pico's Winbond W25Q16JV and most
// similar chips support, and start the program. Sources: RP2040 data sheet, 2.8.1 (boot sequence), 2.19 (pads), 4.10
// (SSI); W25Q16JV data sheet, 7.1 (status registers), 8.2 (instructions).
//
// The compiler assembles the machine code, so that it can also compute its checksum.
#include <array>
#include <cstddef>
#include <cstdint>

namespace {

constexpr std::size_t kBytes = 256, kCheckedBytes = 252;

enum Register : std::uint16_t { r0, r1, r2, r3, r4 };
enum class If : std::uint16_t { zero = 0xD000, not_zero = 0xD100, negative = 0xD400 };

/// Assembles the few Thumb instructions that are used (Armv6-M architecture reference manual, A6.7), and the constants
/// after them. Addresses are in halfwords from the begin.
class Assembler {
 public:
  consteval explicit Assembler(unsigned first_constant) : first_constant_(first_constant) {}

  consteval void move(Register to, unsigned value) { put(0x2000U | unsigned{to} << 8 | value); }
  consteval void move(Register to, Register from) { put(0x0000U | unsigned{from} << 3 | to); }
  consteval void load(Register to, Register base, unsigned offset) {
    put(0x6800U | (offset / 4) << 6 | unsigned{base} << 3 | to);
  }
  consteval void store(Register from, Register base, unsigned offset) {
    put(0x6000U | (offset / 4) << 6 | unsigned{base} << 3 | from);
  }
  consteval void clear_bits(Register in, Register bits) { put(0x4380U | unsigned{bits} << 3 | in); }
  consteval void test(Register value, Register bits) { put(0x4200U | unsigned{bits} << 3 | value); }
  consteval void shift_left(Register to, Register from, unsigned by) {
    put(0x0000U | by << 6 | unsigned{from} << 3 | to);
  }
  consteval void jump(Register to) { put(0x4700U | unsigned{to} << 3); }
  consteval void return_to_caller() { put(0x4770); }                         // bx lr
  consteval void keep_caller(Register in) { put(0x4600U | 14U << 3 | in); }  // mov in, lr
  consteval void set_main_stack(Register from) { put(0xF380U | from), put(0x8808); }
  consteval void load_constant(Register to, std::uint32_t value) {
    constants_[constants_in_use_] = value;
    // The processor adds the offset to the instruction's address plus 4, rounded down to words.
    put(0x4800U | unsigned{to} << 8 | (first_constant_ / 2 + constants_in_use_++ - (length_ + 2) / 2));
  }
  consteval void branch(If condition, unsigned target) {
    put(static_cast<unsigned>(condition) | ((target - length_ - 2) & 0xFF));
  }
  consteval void call(unsigned target) {
    const unsigned halfwords = target - length_ - 2;
    put(0xF000U | (halfwords >> 11 & 0x7FF)), put(0xF800U | (halfwords & 0x7FF));
  }

  consteval unsigned here() const { return length_; }
  /// Returns the halfword at which constants can begin.
  consteval unsigned end_of_code() const { return (length_ + 1) / 2 * 2; }
  consteval std::array<std::uint8_t, kCheckedBytes> bytes() const {
    std::array<std::uint8_t, kCheckedBytes> all{};
    const auto put_at = [&all](std::size_t at, std::uint32_t value, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) all[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
    };
    for (unsigned i = 0; i < length_; ++i) put_at(std::size_t{2} * i, code_[i], 2);
    for (unsigned i = 0; i < constants_in_use_; ++i) {
      put_at(std::size_t{2} * first_constant_ + std::size_t{4} * i, constants_[i], 4);
    }
    return all;
  }

 private:
  consteval void put(unsigned halfword) { code_[length_++] = static_cast<std::uint16_t>(halfword); }

  std::array<std::uint16_t, kCheckedBytes / 2> code_{};
  std::array<std::uint32_t, 16> constants_{};
  unsigned length_ = 0, constants_in_use_ = 0;
  unsigned first_constant_;
};

constexpr std::uint32_t kPads = 0x40020000;  // pads of the flash, 2.19.6.4
constexpr unsigned kClockPad = 0x04, kFirstDataPad = 0x08, kLastDataPad = 0x14;
constexpr unsigned kFastBy8Milliamperes = 2U << 4 | 1, kSchmittTrigger = 2;

constexpr std::uint32_t kSsi = 0x18000000;  // 4.10.13
constexpr unsigned kControl0 = 0x00, kControl1 = 0x04, kEnable = 0x08, kBaudRate = 0x14, kStatus = 0x28, kData = 0x60;
constexpr std::uint32_t kSampleDelay = kSsi + 0xF0, kSpiControl0 = kSsi + 0xF4;
constexpr unsigned kBusy = 1, kAllSent = 4;
constexpr unsigned kClockBy2 = 2;  // 125 MHz divided to 62.5 MHz
constexpr std::uint32_t kBytesBothWays = 7U << 16;
// Frames of 32 bits over four lines, "EEPROM read": a command and an address, then data as long as the clock runs.
constexpr std::uint32_t kReadFrames = 2U << 21 | 31U << 16 | 3U << 8;
// 24 bits of address and 8 bits that the flash calls mode, over four lines; then 4 wait cycles. The first read has a
// command of 8 bits over one line before them.
constexpr std::uint32_t kAddressAndMode = 4U << 11 | (32U / 4) << 2;
constexpr std::uint32_t kCommandFirst = kAddressAndMode | 2U << 8 | 1;
constexpr unsigned kReadByFour = 0xEB, kReadOn = 0xA0;  // this mode: the next read has no command
constexpr std::uint32_t kNoCommand = kAddressAndMode | std::uint32_t{kReadOn} << 24 | 2;

// Commands and status bits of the flash.
constexpr unsigned kWriteStatus = 0x01, kReadStatus1 = 0x05, kReadStatus2 = 0x35, kEnableWrite = 0x06;
constexpr unsigned kWriting = 1, kFourLines = 2;  // bits of status 1 and 2

constexpr std::uint32_t kVectorTableOffset = 0xE000ED08;  // VTOR
constexpr std::uint32_t kProgram = 0x10000100;

/// Addresses that are known only after the whole code is written.
struct Places {
  unsigned read_status = 0, wait = 0, by_four_lines = 0, first_constant = 0;
};

/// Writes the stage. From its first use on r3 holds the SSI.
consteval Places write_stage(Assembler& a, const Places& places) {
  Places found;
  a.load_constant(r3, kPads);
  a.move(r0, kFastBy8Milliamperes);
  a.store(r0, r3, kClockPad);
  a.load(r0, r3, kFirstDataPad);
  a.move(r1, kSchmittTrigger);  // the Schmitt trigger's delay is too long for the fast clock
  a.clear_bits(r0, r1);
  for (unsigned pad = kFirstDataPad; pad <= kLastDataPad; pad += 4) a.store(r0, r3, pad);

  a.load_constant(r3, kSsi);
  a.move(r1, 0);
  a.store(r1, r3, kEnable);  // disabled during set-up
  a.move(r1, kClockBy2);
  a.store(r1, r3, kBaudRate);
  a.load_constant(r2, kSampleDelay);
  a.move(r1, 1);
  a.store(r1, r2, 0);
  a.load_constant(r1, kBytesBothWays);
  a.store(r1, r3, kControl0);
  a.move(r1, 1);
  a.store(r1, r3, kEnable);

  // Four lines must be enabled once: the flash keeps the setting.
  a.move(r0, kReadStatus2);
  a.call(places.read_status);
  static_assert(kFourLines == 1U << 1);
  a.shift_left(r0, r0, 30);
  a.branch(If::negative, places.by_four_lines);
  a.move(r1, kEnableWrite);
  a.store(r1, r3, kData);
  a.call(places.wait);
  a.load(r0, r3, kData);
  a.move(r1, kWriteStatus);
  a.store(r1, r3, kData);
  a.move(r0, 0);
  a.store(r0, r3, kData);
  a.move(r1, kFourLines);
  a.store(r1, r3, kData);
  a.call(places.wait);
  for (int i = 0; i < 3; ++i) a.load(r0, r3, kData);
  const unsigned still_writes = a.here();
  a.move(r0, kReadStatus1);
  a.call(places.read_status);
  a.move(r1, kWriting);
  a.test(r0, r1);
  a.branch(If::not_zero, still_writes);

  // One read with a command, whose mode says that no command follows.
  found.by_four_lines = a.here();
  a.move(r1, 0);
  a.store(r1, r3, kEnable);
  a.store(r1, r3, kControl1);  // one frame of data for each access
  a.load_constant(r1, kReadFrames);
  a.store(r1, r3, kControl0);
  a.load_constant(r0, kSpiControl0);
  a.load_constant(r1, kCommandFirst);
  a.store(r1, r0, 0);
  a.move(r1, 1);
  a.store(r1, r3, kEnable);
  a.move(r1, kReadByFour);
  a.store(r1, r3, kData);
  a.move(r1, kReadOn);
  a.store(r1, r3, kData);  // read from address 0
  a.call(places.wait);
  a.move(r1, 0);
  a.store(r1, r3, kEnable);
  a.load_constant(r1, kNoCommand);
  a.store(r1, r0, 0);
  a.move(r1, 1);
  a.store(r1, r3, kEnable);

  a.load_constant(r2, kProgram);  // vector table of the program
  a.load_constant(r1, kVectorTableOffset);
  a.store(r2, r1, 0);
  // Its first two entries are the stack pointer and the entry point.
  a.load(r0, r2, 0);
  a.load(r1, r2, 4);
  a.set_main_stack(r0);
  a.jump(r1);

  // Reads the status that the command in r0 selects into r0. Changes r1, r2 and r4.
  found.read_status = a.here();
  a.keep_caller(r4);
  a.store(r0, r3, kData);
  a.store(r0, r3, kData);  // any byte: its answer is the status
  a.call(places.wait);
  a.load(r0, r3, kData);
  a.load(r0, r3, kData);
  a.jump(r4);

  // Waits until all bits are sent and the flash is deselected. Changes r1 and r2.
  found.wait = a.here();
  a.load(r1, r3, kStatus);
  a.move(r2, kAllSent);
  a.test(r1, r2);
  a.branch(If::zero, found.wait);
  a.move(r2, kBusy);
  a.test(r1, r2);
  a.branch(If::not_zero, found.wait);
  a.return_to_caller();
  found.first_constant = a.end_of_code();
  return found;
}

consteval std::array<std::uint8_t, kCheckedBytes> code_and_constants() {
  Assembler first_pass(0);
  const Places places = write_stage(first_pass, {});
  Assembler second_pass(places.first_constant);
  write_stage(second_pass, places);
  return second_pass.bytes();
}

/// Returns the CRC-32 with the polynomial 04C11DB7, highest bit first, from all ones, not inverted (2.8.1.3.1).
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
