// The table of boards. It has no Cortex-M7, because Arm publishes no timings of its instructions, which execute in
// pairs.
#include "bench/board_model.hpp"

#include <algorithm>
#include <array>

namespace zstrip::sim {
namespace {

constexpr std::array kBoards{
    // nRF51822 product specification: flash without wait states at 16 MHz; SPI master up to 8 MHz, without DMA.
    BoardModel{.name = "microbit",
               .description = "BBC micro:bit V1, nRF51822",
               .core = "m0",
               .target = "m0",
               .core_mhz = 16,
               .flash = {.description = "flash without wait states", .wait_states = 0, .cache = {.line_bytes = 4}},
               .ram_bytes = 16 * 1024,
               .spi_mhz = 8,
               .dma = false,
               .cycles_per_estimate = 2.9},
    // RP2040 data sheet: XIP cache of 16 KB, 2 ways, 8 bytes a line; SPI up to half of 125 MHz. A line from quad flash
    // in continuous read mode: 8 clocks of address, 4 idle, 16 of data, at half the core's clock.
    BoardModel{.name = "pico",
               .description = "Raspberry Pi Pico, RP2040",
               .core = "m0+",
               .target = "m0",
               .core_mhz = 125,
               .flash = {.description = "quad SPI flash behind a cache of 16 KB",
                         .wait_states = 56,
                         .cache = {.line_bytes = 8, .code_lines = 2048, .code_ways = 2, .shared = true}},
               .ram_bytes = 264 * 1024,
               .spi_mhz = 62.5,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = 3.0},
    // RP2350 data sheet: XIP cache of 16 KB, 2 ways, 8 bytes a line; SPI up to half of 150 MHz. A line with the quad
    // read that the boot ROM sets up: 8 clocks of command, 6 of address, 2 of mode, 4 idle, 16 of data, at a third of
    // the core's clock.
    BoardModel{.name = "pico2",
               .description = "Raspberry Pi Pico 2, RP2350",
               .core = "m33",
               .target = "m33",
               .core_mhz = 150,
               .flash = {.description = "quad SPI flash behind a cache of 16 KB",
                         .wait_states = 108,
                         .cache = {.line_bytes = 8, .code_lines = 2048, .code_ways = 2, .shared = true}},
               .ram_bytes = 520 * 1024,
               .spi_mhz = 75,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = 1.4},
    // STM32F103 data sheet and flash programming manual: 2 wait states above 48 MHz, a prefetch buffer of two lines of
    // 64 bits; SPI up to 18 MHz.
    BoardModel{.name = "bluepill",
               .description = "Blue Pill, STM32F103C8",
               .core = "m3",
               .target = "m3",
               .core_mhz = 72,
               .flash = {.description = "flash of 64 bits with a prefetch buffer",
                         .wait_states = 2,
                         .cache = {.line_bytes = 8, .code_lines = 2, .code_ways = 2},
                         .prefetch = true},
               .ram_bytes = 20 * 1024,
               .spi_mhz = 18,
               .dma = true,
               .cycles_per_estimate = 1.65},
    // STM32F411 data sheet and reference manual: 3 wait states at 100 MHz; the accelerator keeps 64 lines of code and 8
    // of data, 128 bits each, replaces the least recently used one, and prefetches; SPI1 up to 50 MHz.
    BoardModel{
        .name = "blackpill",
        .description = "Black Pill, STM32F411CE",
        .core = "m4",
        .target = "m4f",
        .core_mhz = 100,
        .flash = {.description = "flash of 128 bits with caches and prefetching",
                  .wait_states = 3,
                  .cache = {.line_bytes = 16, .code_lines = 64, .code_ways = 64, .data_lines = 8, .data_ways = 8},
                  .prefetch = true},
        .ram_bytes = 128 * 1024,
        .spi_mhz = 50,
        .dma = true,
        .cycles_per_estimate = 1.5},
};

}  // namespace

std::span<const BoardModel> board_models() { return kBoards; }

const BoardModel* find_board(std::string_view name) {
  const auto* found = std::ranges::find(kBoards, name, &BoardModel::name);
  return found == kBoards.end() ? nullptr : found;
}

}  // namespace zstrip::sim
