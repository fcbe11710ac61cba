// A panel at an SPI bus with a D/C line, for stand-ins of SDKs: it knows windows and pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "screen.hpp"

namespace zstrip::adapters_test {

class Wires {
 public:
  bool data = false, selected = false;
  std::uint32_t time = 0;

  void send(std::span<const std::byte> bytes) {
    if (!selected) screen().complain("a transfer while the panel is not selected");
    for (const std::byte byte : bytes) {
      if (data) {
        take(std::to_integer<std::uint8_t>(byte));
      } else {
        command_ = std::to_integer<std::uint8_t>(byte);
        taken_ = 0;
      }
    }
  }

 private:
  // Of the column and row addresses only the window; all other commands but pixels do not matter here.
  void take(std::uint8_t byte) {
    const std::size_t place = taken_++;
    if (command_ == 0x2A && place < 4) columns_[place] = byte;
    if (command_ == 0x2B && place < 4) rows_[place] = byte;
    if (command_ != 0x2C) return;
    pixel_[place % 2] = byte;
    if (place % 2 == 0) return;
    const int left = columns_[0] << 8 | columns_[1], width = (columns_[2] << 8 | columns_[3]) - left + 1;
    const int top = rows_[0] << 8 | rows_[1];
    const int i = static_cast<int>(place / 2);
    screen().draw(area_of(left + i % width, top + i / width, 1, 1), pixel_, First::high);
  }

  std::uint8_t command_ = 0, columns_[4]{}, rows_[4]{}, pixel_[2]{};
  std::size_t taken_ = 0;
};

}  // namespace zstrip::adapters_test
