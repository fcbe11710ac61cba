// The SSD1306's command table, memory and glass.
#include "panel/ssd1306_model.hpp"

#include <random>

namespace zstrip::sim {
namespace {

constexpr SolomonCommand kSsd1306Commands[] = {
    {0x00, 0x1F, 0},                   // column in page addressing, low and high digit
    {0x20, 0x20, 1},                   // addressing mode
    {0x21, 0x22, 2},                   // columns, pages
    {0x26, 0x27, 6},                   // scroll to the right, to the left
    {0x29, 0x2A, 5},                   // and down
    {0x2E, 0x2F, 0},                   // stop, start scrolling
    {0x40, 0x7F, 0},                   // start line
    {0x81, 0x81, 1},                   // contrast
    {0x8D, 0x8D, 1},                   // charge pump
    {0xA0, 0xA1, 0},                   // segment remap
    {0xA3, 0xA3, 2},                   // vertical scroll area
    {0xA4, 0xA7, 0},                   // memory, all on, normal, inverse
    {0xA8, 0xA8, 1},                   // multiplex ratio
    {0xAE, 0xAF, 0},                   // off, on
    {0xB0, 0xB7, 0},                   // page in page addressing
    {0xC0, 0xC0, 0},                   // COM scan direction
    {0xC8, 0xC8, 0}, {0xD3, 0xD3, 1},  // display offset
    {0xD5, 0xD5, 1},                   // clock
    {0xD9, 0xD9, 1},                   // phase lengths
    {0xDA, 0xDA, 1},                   // COM pins
    {0xDB, 0xDB, 1},                   // VCOMH
    {0xE3, 0xE3, 0},                   // none
};

}  // namespace

Ssd1306Model::Ssd1306Model(const Ssd1306Glass& glass, Nanoseconds shortest_cycle)
    : SolomonModel("SSD1306", Wire::command, kSsd1306Commands), glass_(glass), cycle_(shortest_cycle) {
  std::mt19937 random;
  for (std::uint8_t& byte : memory_) byte = static_cast<std::uint8_t>(random());
  reset_registers();
}

void Ssd1306Model::reset_registers() {
  columns_ = {0, kColumns - 1, 0};
  pages_ = {0, kPages - 1, 0};
  addressing_ = Addressing::page;
  on_ = inverse_ = all_on_ = pump_ = segment_remap_ = scan_reversed_ = scrolling_ = false;
  start_line_ = offset_ = 0;
  multiplex_ = 63;
  com_pins_ = 0x12;
  contrast_ = 0x7F;
}

void Ssd1306Model::execute(std::uint8_t code, std::span<const std::uint8_t> parameters) {
  const unsigned first = parameters.empty() ? 0U : parameters[0];
  if (code <= 0x0F && addressing_ == Addressing::page) columns_.at = (columns_.at & 0xF0U) | code;
  if (code >= 0x10 && code <= 0x1F && addressing_ == Addressing::page) {
    columns_.at = (columns_.at & 0x0FU) | (code & 7U) << 4;
  }
  if (code >= 0xB0 && code <= 0xB7 && addressing_ == Addressing::page) pages_.at = code & 7U;
  if (code >= 0x40 && code <= 0x7F) start_line_ = code & 63U;
  switch (code) {
    case 0x20:
      require((first & 3U) != 3, "the addressing mode", first);
      addressing_ = static_cast<Addressing>(first & 3U);
      break;
    // The upper bits of both are ignored.
    case 0x21: {
      const std::uint8_t columns[] = {static_cast<std::uint8_t>(first & 127U),
                                      static_cast<std::uint8_t>(parameters[1] & 127U)};
      columns_ = range_of(columns, kColumns, "columns");
      break;
    }
    case 0x22: {
      const std::uint8_t pages[] = {static_cast<std::uint8_t>(first & 7U),
                                    static_cast<std::uint8_t>(parameters[1] & 7U)};
      pages_ = range_of(pages, kPages, "pages");
      break;
    }
    case 0x2E: scrolling_ = false; break;
    case 0x2F: scrolling_ = true; break;
    case 0x81: contrast_ = first; break;
    case 0x8D:
      require((first & 0x3BU) == 0x10, "the charge pump", first);
      pump_ = (first & 4U) != 0;
      break;
    case 0xA0:
    case 0xA1: segment_remap_ = code == 0xA1; break;
    case 0xA4:
    case 0xA5: all_on_ = code == 0xA5; break;
    case 0xA6:
    case 0xA7: inverse_ = code == 0xA7; break;
    case 0xA8:
      require(first >= 15 && first <= 63, "the multiplex ratio", first);
      multiplex_ = first;
      break;
    case 0xAE:
    case 0xAF: on_ = code == 0xAF; break;
    case 0xC0:
    case 0xC8: scan_reversed_ = code == 0xC8; break;
    case 0xD3: offset_ = first & 63U; break;
    case 0xDA:
      require((first & ~0x30U) == 2, "the COM pins", first);
      com_pins_ = first;
      break;
    default: break;  // timing and voltages: any value shows a picture
  }
}

void Ssd1306Model::store(std::uint8_t byte, std::uint8_t /*last_command*/) {
  const unsigned column = segment_remap_ ? kColumns - 1 - columns_.at : columns_.at;
  memory_[pages_.at * kColumns + column] = byte;
  if (addressing_ == Addressing::page) {
    columns_.at = (columns_.at + 1) % kColumns;
  } else if (addressing_ == Addressing::horizontal) {
    if (columns_.advance()) pages_.advance();
  } else if (pages_.advance()) {
    columns_.advance();
  }
}

std::string Ssd1306Model::darkness() const {
  if (!on_) return "the display is off";
  if (glass_.charge_pump && !pump_) return "the charge pump is off";
  if (all_on_) return "all pixels are on";
  if (scrolling_) return "the picture scrolls";
  if (com_pins_ != (glass_.com_alternating ? 0x12U : 0x02U)) return "the COM lines are not split as the glass is wired";
  if (multiplex_ != glass_.height - 1U) return "the multiplex ratio is not the glass's";
  return {};
}

RgbImage Ssd1306Model::seen() const {
  RgbImage image{glass_.width, glass_.height, {}};
  image.rgb.assign(std::size_t{glass_.width} * glass_.height * 3, 0);
  if (!darkness().empty()) return image;
  std::uint8_t* out = image.rgb.data();
  for (unsigned y = 0; y < glass_.height; ++y) {
    const unsigned com = glass_.rows_reversed ? glass_.height - 1U - y : y;
    const unsigned line = scan_reversed_ ? multiplex_ - com : com;
    const unsigned row = (line + start_line_ + offset_) % (8 * kPages);
    for (unsigned x = 0; x < glass_.width; ++x, out += 3) {
      const unsigned from_edge = glass_.column_offset + x;
      const unsigned segment = glass_.columns_reversed ? kColumns - 1 - from_edge : from_edge;
      const bool lit = (memory_[row / 8 * kColumns + segment] >> row % 8 & 1) != 0;
      out[0] = out[1] = out[2] = lit != inverse_ ? 255 : 0;
    }
  }
  return image;
}

}  // namespace zstrip::sim
