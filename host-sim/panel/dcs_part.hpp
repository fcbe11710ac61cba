// The differences between the controllers with MIPI's command set, from their data sheets; from GC9A01 on
// from public drivers.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>

namespace zstrip::sim {

/// A command and its least and greatest number of parameter bytes.
struct DcsCommand {
  std::uint8_t code;
  std::uint8_t fewest;
  std::uint8_t most;
  bool is_locked = false;  ///< ignored until all keys of its part were given
};

/// A command with these parameters, one of those that unlock others.
struct DcsKey {
  std::uint8_t code;
  std::uint8_t count;
  std::array<std::uint8_t, 3> parameters;
};

/// The answer to a read command on a serial bus: clocks before the answer, and the first bytes of the answer.
struct DcsAnswer {
  std::uint8_t code;
  std::uint8_t dummy_clocks;
  std::uint8_t count;
  std::array<std::uint8_t, 3> bytes;
};

struct DcsPart {
  const char* name;
  std::uint16_t columns;  ///< of the memory
  std::uint16_t rows;
  std::chrono::nanoseconds shortest_cycle;  ///< of the serial clock, writing
  std::chrono::nanoseconds shortest_reset;  ///< low pulse of the reset line
  std::chrono::nanoseconds reset_to_command;
  std::chrono::nanoseconds reset_to_sleep_out;
  std::chrono::nanoseconds sleep_to_command;  ///< after sleep-in and after sleep-out
  std::chrono::nanoseconds between_sleeps;    ///< from sleep-in to sleep-out and back
  std::uint8_t format_after_reset;            ///< COLMOD's parameter
  bool has_12_bits;                           ///< pixels of 12 bits on a serial bus; 18 bits all parts have
  std::span<const DcsCommand> own_commands;   ///< in addition to the user commands of all parts
  std::span<const DcsAnswer> answers;
  std::chrono::nanoseconds shortest_read_cycle;  ///< of the serial clock
  std::uint8_t read_index;                       ///< this command selects the byte of ID4, D3h, that is read next; or 0
  /// Unlock commands, in this order. Once unlocked, a key's command with other parameters locks them again.
  std::span<const DcsKey> keys{};
  bool has_16_bits = true;
  bool has_qspi = false;  ///< instead of a bus with D/C
  bool has_even_windows = false;
  std::uint8_t access = 0xFF;           ///< bits of the memory access control that it has
  std::uint8_t brightness_bits = 0x24;  ///< of the control, which let a command set the brightness
  bool is_lit_by_brightness = false;    ///< dark as long as the brightness is 0, as AMOLED
};

extern const DcsPart kSt7789Part;
extern const DcsPart kIli9341Part;
extern const DcsPart kSt7735Part;
extern const DcsPart kSt7735Gm11Part;     ///< pins GM1 and GM0 high: a smaller memory
extern const DcsPart kSt7735Rows132Part;  ///< as in modules with 128x128 pixels: fewer rows
extern const DcsPart kGc9a01Part;
extern const DcsPart kSt7796Part;
extern const DcsPart kIli9342Part;
extern const DcsPart kIli9488Part;
extern const DcsPart kCo5300Part;
extern const DcsPart kSh8601Part;
extern const DcsPart kSt77916Part;

/// Returns the command with this code, or nullptr.
const DcsCommand* find_command(const DcsPart& part, std::uint8_t code);
/// Returns the answer to this command, or nullptr.
const DcsAnswer* find_answer(const DcsPart& part, std::uint8_t code);

}  // namespace zstrip::sim
