// The SSD1680's command table, its two memories, and refreshes of the glass. Of the data entry modes only that from the
// left to the right, then downwards, is modelled. The glass sees a wrong refresh as it would: pixels stay as they were.
#include "panel/ssd1680_model.hpp"

#include <fmt/format.h>

#include <random>
#include <utility>

namespace zstrip::sim {
namespace {

constexpr SolomonCommand kSsd1680Commands[] = {
    {0x01, 0x01, 3},    // driver output
    {0x03, 0x03, 1},    // gate voltage
    {0x04, 0x04, 3},    // source voltage
    {0x08, 0x08, 0},    // program the initial code
    {0x09, 0x09, 4},    // write its register
    {0x0A, 0x0A, 0},    // read it
    {0x0C, 0x0C, 4},    // booster soft start
    {0x10, 0x10, 1},    // deep sleep mode
    {0x11, 0x11, 1},    // data entry mode
    {0x12, 0x12, 0},    // software reset
    {0x14, 0x14, 1},    // HV ready detection
    {0x15, 0x15, 1},    // VCI detection
    {0x18, 0x18, 1},    // temperature sensor
    {0x1A, 0x1A, 2},    // write the temperature
    {0x1C, 0x1C, 3},    // write to an external sensor
    {0x20, 0x20, 0},    // master activation
    {0x21, 0x21, 2},    // update control 1
    {0x22, 0x22, 1},    // update control 2: the sequence
    {0x24, 0x24, 0},    // write RAM (black and white)
    {0x26, 0x26, 0},    // write RAM (red; the picture before, on black and white glasses)
    {0x28, 0x28, 0},    // VCOM sense
    {0x29, 0x29, 1},    // its duration
    {0x2A, 0x2A, 0},    // program VCOM
    {0x2B, 0x2B, 2},    // VCOM control
    {0x2C, 0x2C, 1},    // write VCOM
    {0x30, 0x31, 0},    // program, load the waveform
    {0x32, 0x32, 153},  // write the waveform
    {0x34, 0x34, 0},    // CRC
    {0x36, 0x36, 0},    // program the OTP selection
    {0x37, 0x37, 10},   // display option
    {0x38, 0x38, 10},   // user id
    {0x39, 0x39, 1},    // OTP program mode
    {0x3C, 0x3C, 1},    // border waveform
    {0x3F, 0x3F, 1},    // end option
    {0x41, 0x41, 1},    // read RAM option
    {0x44, 0x44, 2},    // columns of 8 pixels
    {0x45, 0x45, 4},    // rows
    {0x46, 0x47, 1},    // fill a RAM
    {0x4E, 0x4E, 1},    // column counter
    {0x4F, 0x4F, 2},    // row counter
    {0x7F, 0x7F, 0},    // none
};

constexpr unsigned kClockOn = 0x80, kSupplyOn = 0x40, kLoadTemperature = 0x20, kLoadWaveform = 0x10, kPartial = 0x08;
constexpr unsigned kDisplay = 0x04, kSupplyOff = 0x02, kClockOff = 0x01;
constexpr unsigned kRightThenDown = 3, kInternalSensor = 0x80;
constexpr Nanoseconds kResetTime = 10ms, kFullTime = 1700ms, kPartialTime = 500ms, kPowerTime = 100ms;

}  // namespace

Ssd1680Model::Ssd1680Model(const Ssd1680Glass& glass)
    : SolomonModel("SSD1680", Wire::data, kSsd1680Commands), glass_(glass) {
  std::mt19937 random;
  for (Memory* const memory : {&shown_, &picture_, &previous_}) {
    memory->resize(kRows * kColumnBytes);
    for (std::uint8_t& byte : *memory) byte = static_cast<std::uint8_t>(random());
  }
  reset_registers();
  ready_at_ = now();
}

void Ssd1680Model::reset_registers() {
  lines_ = kRows;
  entry_ = kRightThenDown;
  sequence_ = 0xFF;
  temperature_sensor_ = 0x48;
  sources_ = 0;
  columns_ = {0, kColumnBytes - 1, 0};
  rows_ = {0, kRows - 1, 0};
  clock_on_ = supply_on_ = has_waveform_ = asleep_ = full_ = false;
  be_busy(kResetTime);
}

void Ssd1680Model::be_busy(Nanoseconds time) { ready_at_ = now() + time; }

/// Complains about a command or data that the panel cannot take now.
bool Ssd1680Model::is_refused(std::uint8_t code) {
  if (asleep_) complain(fmt::format("command {:02X}h in deep sleep, which only the reset line ends", code));
  if (!asleep_ && is_busy()) complain(fmt::format("command {:02X}h while the panel is busy", code));
  return is_busy();
}

void Ssd1680Model::execute(std::uint8_t code, std::span<const std::uint8_t> parameters) {
  if (is_refused(code)) return;
  const unsigned first = parameters.empty() ? 0U : parameters[0];
  switch (code) {
    case 0x01: {
      const unsigned last = first | parameters[1] * 256U;
      require(last < kRows, "the last gate line", last);
      lines_ = last + 1;
      require(parameters[2] == 0, "the scan of gates in the model", parameters[2]);
      break;
    }
    case 0x10:
      require(first == 0 || first == 1 || first == 3, "the deep sleep mode", first);
      asleep_ = first != 0;
      break;
    case 0x11:
      require(first == kRightThenDown, "the data entry mode in the model", first);
      entry_ = first;
      break;
    case 0x12: reset_registers(); break;
    case 0x18: temperature_sensor_ = first; break;
    case 0x20: activate(); break;
    case 0x21:
      require(first == 0, "the memories' option in the model", first);
      sources_ = parameters[1];
      break;
    case 0x22: sequence_ = first; break;
    case 0x24:
    case 0x26: begin_write(); break;
    case 0x32: has_waveform_ = true; break;
    case 0x44:
    case 0x45:
    case 0x4E:
    case 0x4F: set_windows(code, parameters); break;
    default: break;  // voltages, border: any value shows a picture
  }
}

void Ssd1680Model::set_windows(std::uint8_t code, std::span<const std::uint8_t> parameters) {
  const auto word = [parameters](std::size_t at) { return parameters[at] | parameters[at + 1] * 256U; };
  const auto range = [this](unsigned first, unsigned last, unsigned limit, const char* what) {
    if (first <= last && last < limit) return SolomonRange{first, last, first};
    complain(fmt::format("{} {} to {} of {}", what, first, last, limit));
    return SolomonRange{0, limit - 1, 0};
  };
  switch (code) {
    case 0x44: columns_ = range(parameters[0], parameters[1], kColumnBytes, "columns of 8 pixels"); break;
    case 0x45: rows_ = range(word(0), word(2), kRows, "rows"); break;
    case 0x4E: columns_.at = parameters[0]; break;
    default: rows_.at = word(0); break;
  }
}

void Ssd1680Model::begin_write() {
  full_ = false;
  const auto holds = [](const SolomonRange& range) { return range.first <= range.at && range.at <= range.last; };
  if (holds(columns_) && holds(rows_)) return;
  complain(fmt::format("the counters {}, {} are outside of the window", columns_.at, rows_.at));
  columns_.at = columns_.first;
  rows_.at = rows_.first;
}

void Ssd1680Model::store(std::uint8_t byte, std::uint8_t last_command) {
  if (last_command != 0x24 && last_command != 0x26) return complain("data without the command to write");
  if (is_refused(last_command)) return;
  if (full_) complain("more pixels than the window has");
  (last_command == 0x24 ? picture_ : previous_)[rows_.at * kColumnBytes + columns_.at] = byte;
  if (columns_.advance()) full_ = rows_.advance();
}

void Ssd1680Model::activate() {
  if ((sequence_ & kClockOn) != 0) clock_on_ = true;
  if ((sequence_ & kSupplyOn) != 0) supply_on_ = true;
  if ((sequence_ & kLoadTemperature) != 0 && temperature_sensor_ != kInternalSensor)
    complain("the temperature is read from an external sensor, and there is none");
  if ((sequence_ & kLoadWaveform) != 0) has_waveform_ = true;
  const bool displays = (sequence_ & kDisplay) != 0, partial = (sequence_ & kPartial) != 0;
  if (displays) {
    if (!clock_on_ || !supply_on_) complain("a refresh without clock and supply");
    if (!has_waveform_) complain("a refresh without a waveform");
    if (clock_on_ && supply_on_ && has_waveform_) refresh(partial);
  }
  const Nanoseconds time = displays ? (partial ? kPartialTime : kFullTime) : kPowerTime;
  refreshing_ += time;
  be_busy(time);
  if ((sequence_ & kSupplyOff) != 0) supply_on_ = false;
  if ((sequence_ & kClockOff) != 0) clock_on_ = false;
}

void Ssd1680Model::refresh(bool partial) {
  fault_ = lines_ != glass_.height                             ? "the gate lines are not as many as the glass has"
           : ((sources_ & 0x80) != 0) != glass_.sources_from_8 ? "the glass is wired to other source lines"
                                                               : "";
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const unsigned moved = partial ? picture_[i] ^ previous_[i] : 0xFFU;
    shown_[i] = static_cast<std::uint8_t>((shown_[i] & ~moved) | (picture_[i] & moved));
  }
  ++(partial ? partial_refreshes_ : full_refreshes_);
  if (partial && glass_.swaps_memories) std::swap(picture_, previous_);
}

std::string Ssd1680Model::darkness() const { return !asleep_ && is_busy() ? "the panel is being refreshed" : fault_; }

RgbImage Ssd1680Model::seen() const {
  RgbImage image{glass_.width, glass_.height, {}};
  image.rgb.reserve(std::size_t{glass_.width} * glass_.height * 3);
  for (unsigned y = 0; y < glass_.height; ++y) {
    for (unsigned x = 0; x < glass_.width; ++x) {
      const unsigned column = glass_.column_offset + x;
      const bool white = (shown_[y * kColumnBytes + column / 8] >> (7 - column % 8) & 1) != 0;
      image.rgb.insert(image.rgb.end(), 3, white ? std::uint8_t{255} : std::uint8_t{0});
    }
  }
  return image;
}

}  // namespace zstrip::sim
