// A stand-in for the Raspberry Pi Pico SDK, with a panel at its SPI that knows windows and pixels.
#include "libraries.hpp"
#include "pico_spi_dma.hpp"

struct spi_inst_t {
  spi_hw_t registers;
};

namespace {

using namespace zstrip::adapters_test;

constexpr uint kDataCommand = 8, kSelect = 9, kChannel = 3, kRequest = 16;

class Wires {
 public:
  spi_inst_t spi{};
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
Wires wires;

struct PicoParts {
  adapters::PicoClock clock;
  adapters::PicoSpiDma bus{&wires.spi, kDataCommand, kSelect};
  adapters::PicoPanel adapter{bus, clock, {.width = kWidth, .height = kHeight}};
  PicoParts() { (void)bus.start(); }  // or the panel does not start either
};

}  // namespace

void gpio_put(uint pin, bool high) {
  if (screen().busy()) screen().complain("a pin changes during a transfer");
  if (pin == kDataCommand) wires.data = high;
  if (pin == kSelect) wires.selected = !high;
}
void sleep_us(std::uint64_t) {}
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
