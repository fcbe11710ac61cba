// A stand-in for the HAL of STM32Cube, with a panel at its SPI that knows windows and pixels.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "libraries.hpp"
#include "stm32_hal_spi.hpp"
#include "wires.hpp"

namespace {

using namespace zstrip::adapters_test;

constexpr std::uint16_t kDataCommand = GPIO_PIN_0, kSelect = GPIO_PIN_1;

struct Stm32Wires : Wires {
  SPI_HandleTypeDef spi{HAL_SPI_STATE_READY, HAL_SPI_ERROR_NONE};
  GPIO_TypeDef port{};
  std::vector<std::size_t> blocks;  // by DMA
};
Stm32Wires wires;

template <class Bus>
struct Stm32Parts {
  adapters::Stm32Clock clock;
  Bus bus{wires.spi, {&wires.port, kDataCommand}, {&wires.port, kSelect}};
  zstrip::hal::St7789<Bus, adapters::Stm32Clock> adapter{bus, clock, {.width = kWidth, .height = kHeight}};
};

std::span<const std::byte> bytes_of(const std::uint8_t* data, std::uint16_t count) {
  return {reinterpret_cast<const std::byte*>(data), count};
}

}  // namespace

void HAL_GPIO_WritePin(GPIO_TypeDef* port, std::uint16_t mask, GPIO_PinState state) {
  if (screen().busy()) screen().complain("a pin changes during a transfer");
  if (port != &wires.port) screen().complain("a pin of another port");
  if (mask == kDataCommand) wires.data = state == GPIO_PIN_SET;
  if (mask == kSelect) wires.selected = state == GPIO_PIN_RESET;
}
void HAL_Delay(std::uint32_t) {}
std::uint32_t HAL_GetTick() { return ++wires.time; }

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef* spi, const std::uint8_t* data, std::uint16_t count,
                                   std::uint32_t) {
  if (spi->State != HAL_SPI_STATE_READY) return HAL_BUSY;
  if (screen().fault == Fault::start) return HAL_TIMEOUT;
  if (count == 0 || screen().fault == Fault::write) return HAL_ERROR;
  wires.send(bytes_of(data, count));
  return HAL_OK;
}
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef* spi, const std::uint8_t* data, std::uint16_t count) {
  if (spi->State != HAL_SPI_STATE_READY) return HAL_BUSY;
  if (count == 0) return HAL_ERROR;
  wires.blocks.push_back(count);
  spi->State = HAL_SPI_STATE_BUSY_TX;
  spi->ErrorCode = HAL_SPI_ERROR_NONE;
  screen().begin(data, count, [](std::span<const std::byte> bytes) { wires.send(bytes); });
  return HAL_OK;
}
HAL_SPI_StateTypeDef HAL_SPI_GetState(const SPI_HandleTypeDef*) {
  const HAL_SPI_StateTypeDef was = wires.spi.State;
  if (screen().fault == Fault::transfer) return was;
  if (screen().busy() && screen().fault == Fault::format) wires.spi.ErrorCode = HAL_SPI_ERROR_DMA;
  screen().end();
  wires.spi.State = HAL_SPI_STATE_READY;  // the interrupt comes after this answer
  return was;
}
std::uint32_t HAL_SPI_GetError(const SPI_HandleTypeDef* spi) { return spi->ErrorCode; }
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef* spi) {
  screen().abandon();
  spi->State = HAL_SPI_STATE_READY;
  return HAL_OK;
}

namespace zstrip::adapters_test {
namespace {

// The HAL counts in 16 bits.
TEST(Stm32HalSpiDma, SendsLongDataInBlocks) {
  screen() = {};
  wires = {};
  Stm32Parts<adapters::Stm32HalSpiDma> parts;
  const std::vector<std::byte> pixels(2 * 65535 + 70);
  EXPECT_EQ(parts.bus.write_data(pixels), hal::Error::none);
  EXPECT_EQ(parts.bus.wait(), hal::Error::none);
  EXPECT_EQ(wires.blocks, (std::vector<std::size_t>{65535, 65535, 70}));
  EXPECT_FALSE(wires.selected);
  EXPECT_EQ(screen().complaint, "");
}

TEST(Stm32HalSpi, SendsNothingForNoBytes) {
  screen() = {};
  wires = {};
  Stm32Parts<adapters::Stm32HalSpi> blocking;
  Stm32Parts<adapters::Stm32HalSpiDma> by_dma;
  EXPECT_EQ(blocking.bus.write_data({}), hal::Error::none);
  EXPECT_EQ(by_dma.bus.write_data({}), hal::Error::none);
  EXPECT_EQ(by_dma.bus.wait(), hal::Error::none);
}

}  // namespace

std::unique_ptr<panel::AnyDisplay> open_stm32() {
  wires = {};
  return std::make_unique<Opened<Stm32Parts<adapters::Stm32HalSpi>>>();
}
std::unique_ptr<panel::AnyDisplay> open_stm32_dma() {
  wires = {};
  return std::make_unique<Opened<Stm32Parts<adapters::Stm32HalSpiDma>>>();
}
}  // namespace zstrip::adapters_test
