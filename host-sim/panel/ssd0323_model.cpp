// The SSD0323's command table, memory and glass.
#include "panel/ssd0323_model.hpp"

#include <random>

namespace zstrip::sim {
namespace {

constexpr SolomonCommand kSsd0323Commands[] = {
    {0x15, 0x15, 2},  // columns
    {0x75, 0x75, 2},  // rows
    {0x81, 0x81, 1},  // contrast
    {0x84, 0x86, 0},  // current range: quarter, half, full
    {0xA0, 0xA2, 1},  // remap, start line, offset
    {0xA4, 0xA7, 0},  // normal, all on, all off, inverse
    {0xA8, 0xA8, 1},  // multiplex ratio
    {0xAD, 0xAD, 1},  // master configuration
    {0xAE, 0xAF, 0},  // off, on
    {0xB0, 0xB4, 1},  // precharge compensation, phase lengths, row period, clock, precharge compensation level
    {0xB8, 0xB8, 8},  // grey table
    {0xBC, 0xBC, 1},  // precharge voltage
    {0xBE, 0xBF, 1},  // VCOMH, VSL
    {0xE3, 0xE3, 0},  // none
};

constexpr unsigned kColumnRemap = 0x01, kNibbleRemap = 0x02, kDownwardsFirst = 0x04, kComRemap = 0x10, kSplit = 0x40;

}  // namespace

Ssd0323Model::Ssd0323Model(const Ssd0323Glass& glass)
    : SolomonModel("SSD0323", Wire::command, kSsd0323Commands), glass_(glass) {
  std::mt19937 random;
  for (std::uint8_t& byte : memory_) byte = static_cast<std::uint8_t>(random());
  reset_registers();
}

void Ssd0323Model::reset_registers() {
  columns_ = {0, kColumns - 1, 0};
  rows_ = {0, kRows - 1, 0};
  contrast_ = 0x40;
  remap_ = start_line_ = offset_ = 0;
  multiplex_ = 79;
  normal_ = true;
  on_ = supplied_ = grey_table_ = false;
}

void Ssd0323Model::execute(std::uint8_t code, std::span<const std::uint8_t> parameters) {
  const unsigned first = parameters.empty() ? 0U : parameters[0];
  switch (code) {
    // The upper bits of both are ignored.
    case 0x15: {
      const std::uint8_t columns[] = {static_cast<std::uint8_t>(first & 63U),
                                      static_cast<std::uint8_t>(parameters[1] & 63U)};
      columns_ = range_of(columns, kColumns, "columns");
      break;
    }
    case 0x75: {
      const std::uint8_t rows[] = {static_cast<std::uint8_t>(first & 127U),
                                   static_cast<std::uint8_t>(parameters[1] & 127U)};
      rows_ = range_of(rows, kRows, "rows");
      break;
    }
    case 0x81: contrast_ = first & 127U; break;
    case 0xA0: remap_ = first; break;
    case 0xA1:
      require(first < kRows, "the start line", first);
      start_line_ = first;
      break;
    case 0xA2:
      require(first < kRows, "the offset", first);
      offset_ = first;
      break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7: normal_ = code == 0xA4; break;
    case 0xA8:
      require(first >= 15 && first < kRows, "the multiplex ratio", first);
      multiplex_ = first;
      break;
    case 0xAD:
      require((first & 0xFEU) == 0x02, "the master configuration", first);
      supplied_ = true;
      break;
    case 0xAE:
    case 0xAF: on_ = code == 0xAF; break;
    case 0xB8:
      // Pulse lengths are increments over the level below: level 1 has its own byte, then two levels a byte. No
      // increment may be 0.
      grey_table_ = true;
      for (std::size_t index = 0; index < parameters.size(); ++index) {
        const unsigned low = parameters[index] & 7U, high = parameters[index] >> 4 & 7U;
        require(low != 0 && (index == 0 || high != 0), "an increase of the grey table", 0);
      }
      break;
    default: break;  // timing and voltages: any value shows a picture
  }
}

void Ssd0323Model::store(std::uint8_t byte, std::uint8_t /*last_command*/) {
  memory_[rows_.at * kColumns + columns_.at] = byte;
  const bool downwards = (remap_ & kDownwardsFirst) != 0;
  SolomonRange& inner = downwards ? rows_ : columns_;
  SolomonRange& outer = downwards ? columns_ : rows_;
  if (inner.advance()) outer.advance();
}

std::string Ssd0323Model::darkness() const {
  if (!on_) return "the display is off";
  if (!normal_) return "all pixels are off, or on, or inverse";
  if (!supplied_) return "the master configuration is missing";
  if (!grey_table_) return "the grey table is missing";
  if (contrast_ == 0) return "the contrast is 0";
  if (((remap_ & kSplit) != 0) != glass_.com_split) return "the COM lines are not split as the glass is wired";
  if (multiplex_ != kGlassRows - 1) return "the multiplex ratio is not the glass's";
  if (start_line_ != 0 || offset_ != glass_.display_offset) return "start line or offset are not the glass's";
  return {};
}

RgbImage Ssd0323Model::seen() const {
  RgbImage image{2 * kColumns, kGlassRows, {}};
  image.rgb.assign(std::size_t{2} * kColumns * kGlassRows * 3, 0);
  if (!darkness().empty()) return image;
  std::uint8_t* out = image.rgb.data();
  for (unsigned y = 0; y < kGlassRows; ++y) {
    const bool upwards = ((remap_ & kComRemap) != 0) != glass_.rows_reversed;
    const unsigned row = upwards ? kGlassRows - 1 - y : y;
    for (unsigned x = 0; x < 2 * kColumns; ++x, out += 3) {
      // SEG 2n and 2n + 1 are the low and the high nibble of column n, or, with remapped nibbles, the high and the low
      // one.
      const unsigned segment = glass_.columns_reversed ? 2 * kColumns - 1 - x : x;
      const unsigned pair = segment / 2;
      const unsigned column = (remap_ & kColumnRemap) != 0 ? kColumns - 1 - pair : pair;
      const bool high = (segment % 2 == 1) != ((remap_ & kNibbleRemap) != 0);
      const unsigned byte = memory_[row * kColumns + column];
      out[0] = out[1] = out[2] = static_cast<std::uint8_t>((high ? byte >> 4 : byte & 15U) * 17);
    }
  }
  return image;
}

}  // namespace zstrip::sim
