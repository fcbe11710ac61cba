// The table of boards. Cores without published timings of their instructions have ranges instead of a model: the
// Cortex-M7, which executes in pairs, and those that are not Arm's.
#include "bench/board_model.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zstrip::sim {
namespace {

constexpr CyclesPerEstimate kCortexM4{1.5, 2.3}, kXtensa{1.6, 3.6}, kRiscV{1.7, 2.7};

constexpr std::array kBoards{
    // nRF51822 product specification: flash without wait states at 16 MHz; SPI master up to 8 MHz, without DMA.
    BoardModel{.name = "microbit",
               .description = "BBC micro:bit V1, nRF51822",
               .core = "m0",
               .target = "m0",
               .core_mhz = 16,
               .flash = {.description = "flash without wait states", .wait_states = 0, .cache = {.line_bytes = 4}},
               .ram_bytes = 16 * 1024,
               .flash_bytes = 256 * 1024,
               .spi_mhz = 8,
               .dma = false,
               .cycles_per_estimate = {2.9, 2.9}},
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
               .flash_bytes = 2048 * 1024,
               .spi_mhz = 62.5,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = {3.0, 3.0}},
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
               .flash_bytes = 4096 * 1024,
               .spi_mhz = 75,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = {1.4, 1.4}},
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
               .flash_bytes = 64 * 1024,
               .spi_mhz = 18,
               .dma = true,
               .cycles_per_estimate = {1.65, 1.65}},
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
        .flash_bytes = 512 * 1024,
        .spi_mhz = 50,
        .dma = true,
        .cycles_per_estimate = {1.5, 1.5}},
    // From here on: rounded memory, clock and bus, and cycles that are assumed. A Cortex-M4 takes between a
    // Black Pill's cycles and half as many again, for slower flash.
    BoardModel{.name = "nrf52840",
               .description = "nRF52840, Cortex-M4F",
               .core_mhz = 64,
               .ram_bytes = 256 * 1024,
               .flash_bytes = 1024 * 1024,
               .spi_mhz = 32,
               .dma = true,
               .cycles_per_estimate = kCortexM4},
    BoardModel{.name = "stm32f4",
               .description = "STM32F407, Cortex-M4F; without the 64 KB that DMA does not reach",
               .core_mhz = 168,
               .ram_bytes = 128 * 1024,
               .flash_bytes = 1024 * 1024,
               .spi_mhz = 42,
               .dma = true,
               .cycles_per_estimate = kCortexM4},
    BoardModel{.name = "samd51",
               .description = "SAMD51J19, Cortex-M4F",
               .core_mhz = 120,
               .ram_bytes = 192 * 1024,
               .flash_bytes = 512 * 1024,
               .spi_mhz = 24,
               .dma = true,
               .cycles_per_estimate = kCortexM4},
    // A Cortex-M7 executes up to two instructions a cycle.
    BoardModel{.name = "stm32h7",
               .description = "STM32H743, Cortex-M7; its largest block of RAM",
               .core_mhz = 480,
               .ram_bytes = 512 * 1024,
               .flash_bytes = 2048 * 1024,
               .spi_mhz = 75,
               .dma = true,
               .cycles_per_estimate = {0.8, 1.5}},
    // Xtensa is assumed to execute 1.3 to 2 times an M3's instructions, in 1.2 to 1.8 cycles each.
    BoardModel{.name = "esp32",
               .description = "ESP32, Xtensa LX6; data RAM",
               .core_mhz = 240,
               .ram_bytes = 320 * 1024,
               .spi_mhz = 80,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = kXtensa},
    BoardModel{.name = "esp32s3",
               .description = "ESP32-S3, Xtensa LX7; RAM for code and data",
               .core_mhz = 240,
               .ram_bytes = 416 * 1024,
               .spi_mhz = 80,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = kXtensa},
    // RISC-V: 1.45 times an M3's instructions (K5, CT, K5T on RV32IMAC, counted), 1.2 to 1.8 cycles each.
    BoardModel{.name = "esp32c3",
               .description = "ESP32-C3, RISC-V; RAM without the cache",
               .core_mhz = 160,
               .ram_bytes = 384 * 1024,
               .spi_mhz = 80,
               .dma = true,
               .cycles_per_estimate = kRiscV},
    BoardModel{.name = "esp32c6",
               .description = "ESP32-C6, RISC-V",
               .core_mhz = 160,
               .ram_bytes = 512 * 1024,
               .spi_mhz = 80,
               .dma = true,
               .cycles_per_estimate = kRiscV},
    BoardModel{.name = "esp32p4",
               .description = "ESP32-P4, RISC-V",
               .core_mhz = 360,
               .ram_bytes = 768 * 1024,
               .spi_mhz = 80,
               .dma = true,
               .cores = 2,
               .cycles_per_estimate = kRiscV},
    // This Xtensa has no instruction for the upper half of a product.
    BoardModel{.name = "esp8266",
               .description = "ESP8266, Xtensa LX106; data RAM",
               .core_mhz = 80,
               .ram_bytes = 80 * 1024,
               .spi_mhz = 40,
               .dma = false,
               .cycles_per_estimate = {2.5, 6}},
};

}  // namespace

std::span<const BoardModel> board_models() { return kBoards; }

std::span<const BoardModel> boards_with_core_model() {
  return std::span(kBoards).first(
      static_cast<std::size_t>(std::ranges::find(kBoards, std::string_view(), &BoardModel::core) - kBoards.begin()));
}

const BoardModel* find_board(std::string_view name) {
  const auto* found = std::ranges::find(kBoards, name, &BoardModel::name);
  return found == kBoards.end() ? nullptr : found;
}

}  // namespace zstrip::sim
