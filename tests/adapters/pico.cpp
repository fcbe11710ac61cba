// A stand-in for the Raspberry Pi Pico SDK, with a panel at its SPI that knows windows and pixels.
#include <chrono>
#include <thread>

#include "libraries.hpp"
#include "pico_spi_dma.hpp"
#include "wires.hpp"

struct spi_inst_t {
  spi_hw_t registers;
};

namespace {

using namespace zstrip::adapters_test;

// Those of the program that `zstrip bake` writes.
constexpr uint kDataCommand = 20, kSelect = 17, kChannel = 3, kRequest = 16;

struct PicoWires : Wires {
  spi_inst_t spi{};
  bool clocked = false;
};
PicoWires wires;

struct PicoParts {
  adapters::PicoClock clock;
  adapters::PicoSpiDma bus{&wires.spi, kDataCommand, kSelect};
  adapters::PicoPanel adapter{bus, clock, {.width = kWidth, .height = kHeight}};
  PicoParts() { (void)bus.start(); }  // or the panel does not start either
};

}  // namespace

spi_inst_t* const spi0 = &wires.spi;
uint spi_init(spi_inst_t*, uint hertz) {
  wires.clocked = true;
  return hertz;
}
void gpio_init(uint) {}
void gpio_set_dir(uint, bool) {}
void gpio_set_function(uint, gpio_function_t) {
  if (!wires.clocked) screen().complain("a pin goes to the SPI before spi_init()");
}
bool stdio_init_all() { return true; }
void gpio_put(uint pin, bool high) {
  if (screen().busy()) screen().complain("a pin changes during a transfer");
  if (pin == kDataCommand) wires.data = high;
  if (pin == kSelect) wires.selected = !high;
}
// A short wait is one for the other core, which runs meanwhile.
void sleep_us(std::uint64_t microseconds) {
  if (microseconds < 1000) std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
}
std::uint32_t time_us_32() { return wires.time += 1000; }

spi_hw_t* spi_get_hw(spi_inst_t* spi) { return &spi->registers; }
uint spi_get_dreq(spi_inst_t*, bool is_tx) { return kRequest + (is_tx ? 0 : 1); }
bool spi_is_busy(const spi_inst_t*) {
  if (screen().fault == Fault::transfer) return screen().busy();
  const bool was = screen().busy();
  screen().end();  // the last bits leave after the DMA has ended
  return was;
}
int spi_write_blocking(spi_inst_t*, const std::uint8_t* bytes, std::size_t count) {
  wires.send({reinterpret_cast<const std::byte*>(bytes), count});
  return static_cast<int>(count);
}

int dma_claim_unused_channel(bool) { return screen().fault == Fault::start ? -1 : static_cast<int>(kChannel); }
dma_channel_config dma_channel_get_default_config(uint) { return {DMA_SIZE_32, 0}; }
void channel_config_set_transfer_data_size(dma_channel_config* config, dma_channel_transfer_size size) {
  config->size = size;
}
void channel_config_set_dreq(dma_channel_config* config, uint dreq) { config->dreq = dreq; }
void dma_channel_configure(uint channel, const dma_channel_config* config, volatile void* to, const volatile void* from,
                           uint count, bool trigger) {
  if (channel != kChannel || config->size != DMA_SIZE_8 || config->dreq != kRequest || !trigger ||
      to != &wires.spi.registers.dr) {
    screen().complain("DMA is set up for something else");
  }
  screen().begin(const_cast<const void*>(from), count, [](std::span<const std::byte> bytes) { wires.send(bytes); });
}
bool dma_channel_is_busy(uint) { return screen().fault == Fault::transfer && screen().busy(); }
void dma_channel_abort(uint) { screen().abandon(); }

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_pico() {
  wires = {};
  return std::make_unique<Opened<PicoParts>>();
}
}  // namespace zstrip::adapters_test
