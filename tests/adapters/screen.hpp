// What the stand-ins for libraries draw to: a screen, the one transfer that is under way, and what was wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "zstrip_hal/display.hpp"

namespace zstrip::adapters_test {

inline constexpr std::uint16_t kWidth = 61, kHeight = 45;

/// What a stand-in is to do wrong.
enum class Fault { none, start, format, write, transfer };

/// Of the two bytes of a pixel, the one that lies first.
enum class First { low, high };

class Screen {
 public:
  /// Colours as RGB565, row by row.
  std::vector<std::uint16_t> colours = std::vector<std::uint16_t>(kWidth * kHeight, 0xDEAD);
  Fault fault = Fault::none;              ///< from now on
  hal::Error started = hal::Error::none;  ///< what start() of the adapter said
  std::function<void()> look = [] {};     ///< fetches the colours, where a library has them in a place of its own
  std::string complaint;                  ///< the first one

  void complain(const char* what) {
    if (complaint.empty()) complaint = what;
  }

  void draw(const hal::Area& area, const void* pixels, First first) {
    if (!hal::contains(kWidth, kHeight, area)) return complain("an area beyond the screen");
    const auto* byte = static_cast<const std::uint8_t*>(pixels);
    for (std::size_t i = 0; i < std::size_t{area.width} * area.height; ++i, byte += 2) {
      const int colour = first == First::low ? byte[1] << 8 | byte[0] : byte[0] << 8 | byte[1];
      colours[(area.top + i / area.width) * kWidth + area.left + i % area.width] = static_cast<std::uint16_t>(colour);
    }
  }

  /// A transfer begins; its bytes are taken when it ends, as late as DMA may.
  void begin(const void* bytes, std::size_t count, std::function<void(std::span<const std::byte>)> take) {
    if (busy()) complain("a transfer during another");
    sending_ = {static_cast<const std::byte*>(bytes), count};
    as_given_.assign(sending_.begin(), sending_.end());
    take_ = std::move(take);
  }
  void begin(const hal::Area& area, const void* pixels, First first) {
    begin(pixels, std::size_t{2} * area.width * area.height,
          [this, area, first](std::span<const std::byte> bytes) { draw(area, bytes.data(), first); });
  }
  bool busy() const { return !sending_.empty(); }
  void end() {
    if (!busy()) return;
    if (!std::equal(sending_.begin(), sending_.end(), as_given_.begin()))
      complain("bytes change during their transfer");
    take_(sending_);
    abandon();
  }
  void abandon() { sending_ = {}; }

 private:
  std::span<const std::byte> sending_;
  std::vector<std::byte> as_given_;
  std::function<void(std::span<const std::byte>)> take_;
};

/// The one that all stand-ins draw to; a test begins with a new one.
Screen& screen();

inline hal::Area area_of(int x, int y, int width, int height) {
  const auto number = [](int value) { return static_cast<std::uint16_t>(value); };
  return {number(x), number(y), number(width), number(height)};
}

}  // namespace zstrip::adapters_test
