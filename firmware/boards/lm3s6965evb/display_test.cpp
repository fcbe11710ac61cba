// Shows all 16 greys as vertical bars, brighter to the right, in a white frame one pixel wide, to test the panel's
// wiring and driver. Needs no renderer.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cortex_m/console.hpp"
#include "lm3s6965evb/oled_bus.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_hal/ssd0323.hpp"

namespace {

using zstrip::hal::Error;
using Panel = zstrip::hal::Ssd0323<zstrip::board::OledBus>;

constexpr std::uint16_t kStripRows = 12;  // six strips, the last one with fewer rows
constexpr std::uint32_t kRowBytes = Panel::kWidth / 2;

unsigned level(std::uint32_t x, std::uint32_t y) {
  const bool frame = x == 0 || y == 0 || x == Panel::kWidth - 1 || y == Panel::kHeight - 1;
  return frame ? 15 : x / 8;
}

struct DrawStatus {
  explicit operator bool() const { return true; }
};

struct Bars {
  DrawStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) const {
    std::size_t next = 0;
    for (std::uint32_t y = strip * kStripRows; y < (strip + 1U) * kStripRows; ++y) {
      for (std::uint32_t x = 0; x < Panel::kWidth; x += 2) {
        pixels[next++] = static_cast<std::byte>(level(x, y) << 4 | level(x + 1, y));
      }
    }
    return {};
  }
};

}  // namespace

int main() {
  static std::array<std::byte, kStripRows * kRowBytes> pixels;
  static zstrip::board::OledBus bus;
  bus.start();
  Panel panel(bus);
  Error error = panel.start();
  if (error == Error::none) {
    Bars bars;
    error =
        zstrip::hal::present(bars, panel, {(Panel::kHeight + kStripRows - 1) / kStripRows, kStripRows}, {pixels, {}})
            .display;
  }
  zstrip::board::print("display test: ");
  zstrip::board::print(zstrip::hal::message(error));
  zstrip::board::print("\n");
  return error == Error::none ? 0 : 1;
}
