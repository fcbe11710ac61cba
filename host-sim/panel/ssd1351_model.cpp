// The SSD1351's command table, memory and glass. Only the pixel format with 65,536 colours is modelled.
#include "panel/ssd1351_model.hpp"

#include <random>

namespace zstrip::sim {
namespace {

constexpr SolomonCommand kSsd1351Commands[] = {
    {0x15, 0x15, 2},   // columns
    {0x75, 0x75, 2},   // rows
    {0x5C, 0x5C, 0},   // write
    {0x96, 0x96, 5},   // horizontal scroll
    {0x9E, 0x9F, 0},   // stop, start moving
    {0xA0, 0xA2, 1},   // remap and colour depth, start line, offset
    {0xA4, 0xA7, 0},   // all off, all on, normal, inverse
    {0xAB, 0xAB, 1},   // function selection
    {0xAE, 0xAF, 0},   // sleep on, off
    {0xB0, 0xB0, 0},   // none
    {0xB1, 0xB1, 1},   // phase lengths
    {0xB2, 0xB2, 3},   // enhancement
    {0xB3, 0xB3, 1},   // clock
    {0xB4, 0xB4, 3},   // VSL
    {0xB5, 0xB6, 1},   // GPIO, second precharge
    {0xB8, 0xB8, 63},  // grey table
    {0xB9, 0xB9, 0},   // linear greys
    {0xBB, 0xBB, 1},   // precharge voltage
    {0xBE, 0xBE, 1},   // VCOMH
    {0xC1, 0xC1, 3},   // contrast
    {0xC7, 0xC7, 1},   // master current
    {0xCA, 0xCA, 1},   // multiplex ratio
    {0xD1, 0xD1, 0},   // none
    {0xE3, 0xE3, 0},   // none
    {0xFD, 0xFD, 1},   // command lock
};

constexpr unsigned kDownwardsFirst = 0x01, kColumnRemap = 0x02, kSequenceCBA = 0x04, kScanReversed = 0x10;
constexpr unsigned kSplit = 0x20, kDepth = 0xC0, k65536Colours = 0x40;

std::uint8_t widened(unsigned value, unsigned bits) {
  const unsigned six = bits == 5 ? value << 1 | value >> 4 : value;  // the memory has 6 bits a channel
  return static_cast<std::uint8_t>(six << 2 | six >> 4);
}

}  // namespace

Ssd1351Model::Ssd1351Model(const Ssd1351Glass& glass)
    : SolomonModel("SSD1351", Wire::data, kSsd1351Commands), glass_(glass), memory_(kSide * kSide) {
  std::mt19937 random;
  for (std::uint16_t& pixel : memory_) pixel = static_cast<std::uint16_t>(random());
  reset_registers();
}

void Ssd1351Model::reset_registers() {
  columns_ = rows_ = {0, kSide - 1, 0};
  on_ = inverse_ = second_unlocked_ = false;
  unlocked_ = showing_memory_ = true;
  remap_ = k65536Colours | kSplit;
  start_line_ = offset_ = 0;
  multiplex_ = 127;
  master_ = 15;
  held_ = -1;
}

void Ssd1351Model::execute(std::uint8_t code, std::span<const std::uint8_t> parameters) {
  const unsigned first = parameters.empty() ? 0U : parameters[0];
  end_of_pixels();
  if (code == 0xFD) {
    require(first == 0x12 || first == 0x16 || first == 0xB0 || first == 0xB1, "the command lock", first);
    if (first == 0x12 || first == 0x16) unlocked_ = first == 0x12;
    if (first == 0xB0 || first == 0xB1) second_unlocked_ = first == 0xB1;
    return;
  }
  const bool behind_second =
      code == 0xA2 || code == 0xB1 || code == 0xB3 || code == 0xBB || code == 0xBE || code == 0xC1;
  if (!unlocked_ || (behind_second && !second_unlocked_)) return complain("a command that is locked");
  switch (code) {
    case 0x15: columns_ = range_of(parameters, kSide, "columns"); break;
    case 0x75: rows_ = range_of(parameters, kSide, "rows"); break;
    case 0x5C:
      columns_.at = columns_.first;
      rows_.at = rows_.first;
      full_ = false;
      break;
    case 0xA0:
      remap_ = parameters[0];
      require((first & kDepth) == 0 || (first & kDepth) == k65536Colours, "the colour depth in the model", first);
      break;
    case 0xA1:
      require(first < kSide, "the start line", first);
      start_line_ = parameters[0];
      break;
    case 0xA2:
      require(first < kSide, "the offset", first);
      offset_ = parameters[0];
      break;
    case 0xA4:
    case 0xA5: showing_memory_ = false; break;
    case 0xA6:
    case 0xA7:
      showing_memory_ = true;
      inverse_ = code == 0xA7;
      break;
    case 0xAE: on_ = false; break;
    case 0xAF: on_ = true; break;
    case 0xC7:
      require(first < 16, "the master current", first);
      master_ = first;
      break;
    case 0xCA:
      require(first >= 15 && first < kSide, "the multiplex ratio", first);
      multiplex_ = parameters[0];
      break;
    default: break;  // timing and voltages: any value shows a picture
  }
}

void Ssd1351Model::end_of_pixels() {
  if (held_ >= 0) complain("the last pixel is not whole");
  held_ = -1;
}

void Ssd1351Model::store(std::uint8_t byte, std::uint8_t last_command) {
  if (last_command != 0x5C) return complain("data without the command to write");
  if (held_ < 0) {
    held_ = byte;
    return;
  }
  if (full_) complain("more pixels than the window has");
  const unsigned column = (remap_ & kColumnRemap) != 0 ? kSide - 1 - columns_.at : columns_.at;
  memory_[rows_.at * kSide + column] = static_cast<std::uint16_t>(held_ << 8 | byte);
  held_ = -1;
  const bool downwards = (remap_ & kDownwardsFirst) != 0;
  SolomonRange& inner = downwards ? rows_ : columns_;
  SolomonRange& outer = downwards ? columns_ : rows_;
  if (inner.advance()) full_ = outer.advance();
}

std::string Ssd1351Model::darkness() const {
  if (!on_) return "the panel is asleep";
  if (!showing_memory_) return "all pixels are off, or on";
  if ((remap_ & kSplit) == 0) return "the COM lines are not split as the glass is wired";
  if (multiplex_ != glass_.height - 1) return "the multiplex ratio is not the glass's";
  return {};
}

RgbImage Ssd1351Model::seen() const {
  RgbImage image{kSide, glass_.height, {}};
  image.rgb.assign(std::size_t{kSide} * glass_.height * 3, 0);
  if (!darkness().empty()) return image;
  std::uint8_t* out = image.rgb.data();
  for (unsigned y = 0; y < glass_.height; ++y) {
    // Line 0 is scanned to COM 0, or to the last COM line.
    const unsigned com = glass_.rows_reversed ? glass_.height - 1U - y : y;
    const unsigned line = (remap_ & kScanReversed) != 0 ? multiplex_ - com : com;
    const unsigned row = (line + start_line_ + offset_) % kSide;
    for (unsigned x = 0; x < kSide; ++x, out += 3) {
      unsigned pixel = memory_[row * kSide + (glass_.columns_reversed ? kSide - 1 - x : x)];
      if (inverse_) pixel = ~pixel & 0xFFFFU;
      const bool swapped = glass_.bgr != ((remap_ & kSequenceCBA) != 0);
      const std::uint8_t red = widened(pixel >> 11, 5), blue = widened(pixel & 31, 5);
      out[0] = swapped ? blue : red;
      out[1] = widened(pixel >> 5 & 63, 6);
      out[2] = swapped ? red : blue;
    }
  }
  return image;
}

}  // namespace zstrip::sim
