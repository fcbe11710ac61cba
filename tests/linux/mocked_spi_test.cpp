// spidev where a kernel misbehaves as no emulated one does: what the HAL makes of it.
#include <gtest/gtest.h>
#include <linux/spi/spidev.h>

#include <array>
#include <string>
#include <vector>

#include "mocked_devices.hpp"
#include "mocked_spi.hpp"
#include "panel/dcs_model.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal_linux/gpio.hpp"
#include "zstrip_hal_linux/spidev.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::Error;
using hal::GpioPin;
using hal::SpidevBus;

class LinuxMockedSpi : public testing::Test {
 protected:
  LinuxMockedSpi() {
    devices_.add("spidev", "spidev0.0", 153, 0,
                 [this](auto request, void* argument) { return spi_.control(request, argument); });
  }
  hal::Outcome<SpidevBus> open() { return SpidevBus::open("/dev/spidev0.0", 1'000'000, GpioPin()); }

  MockedSpi spi_;
  MockedDevices devices_;
};

TEST_F(LinuxMockedSpi, LongTransfersAreSplit) {
  spi_.mode = SPI_CS_HIGH | SPI_CPHA;
  auto bus = open();
  ASSERT_TRUE(bus) << bus.fault().message;
  EXPECT_EQ(spi_.mode, SPI_CS_HIGH) << "chip select's polarity is the device tree's, the rest is not";
  EXPECT_EQ(spi_.bits, 8);
  EXPECT_EQ(spi_.hertz, 1'000'000U);
  std::vector<std::uint8_t> bytes(10'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  EXPECT_EQ(bus->write_data(std::as_bytes(std::span(bytes))), Error::none);
  ASSERT_EQ(spi_.messages.size(), 3U);
  std::vector<std::uint8_t> arrived;
  for (const auto& message : spi_.messages) arrived.insert(arrived.end(), message.begin(), message.end());
  EXPECT_EQ(arrived, bytes);
  EXPECT_EQ(bus->write_command({}), Error::none);
  EXPECT_EQ(spi_.messages.size(), 3U) << "nothing is sent for nothing";
}

TEST_F(LinuxMockedSpi, EveryMessageMayFail) {
  const std::vector<std::byte> bytes(10'000);
  for (int failing = 0; failing < 3; ++failing) {
    auto bus = open();
    ASSERT_TRUE(bus);
    spi_.messages.clear();
    spi_.messages_until_failure = failing;
    EXPECT_EQ(bus->write_data(bytes), Error::bus);
    EXPECT_EQ(spi_.messages.size(), static_cast<std::size_t>(failing));
    EXPECT_EQ(bus->write_data(bytes), Error::none) << "the next one starts clean";
  }
}

TEST_F(LinuxMockedSpi, ATransferThatTheKernelGivesUpIsATimeout) {
  auto bus = open();
  ASSERT_TRUE(bus);
  spi_.failure = ETIMEDOUT;
  spi_.messages_until_failure = 0;
  const std::vector<std::byte> bytes(10);
  EXPECT_EQ(bus->write_data(bytes), Error::timeout);
  spi_.messages_until_failure = 0;
  std::array<std::byte, 3> answer{};
  EXPECT_EQ(bus->read(std::byte{0x04}, 1, answer), Error::timeout);
}

TEST_F(LinuxMockedSpi, AnswersAreShiftedByTheirDummyClocks) {
  sim::DcsModel panel(sim::kSt7789Part, {.width = 4, .height = 4});
  panel.elapse(std::chrono::seconds(1));
  spi_.panel = &panel;
  auto bus = SpidevBus::open("/dev/spidev0.0", 40'000'000, GpioPin());
  ASSERT_TRUE(bus);
  std::array<std::byte, 3> id{};
  ASSERT_EQ(bus->read(std::byte{0x04}, 1, id), Error::none);
  EXPECT_EQ(id, (std::array{std::byte{0x85}, std::byte{0x85}, std::byte{0x52}}));
  EXPECT_EQ(spi_.read_hertz, SpidevBus::kReadHertz) << "not as fast as it is written to";
  ASSERT_EQ(bus->read(std::byte{0xDC}, 0, std::span(id).first(1)), Error::none);
  EXPECT_EQ(id[0], std::byte{0x52});
  auto slow = open();
  ASSERT_TRUE(slow);
  ASSERT_EQ(slow->read(std::byte{0x04}, 1, id), Error::none);
  EXPECT_EQ(spi_.read_hertz, 1'000'000U);
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  spi_.messages_until_failure = 0;
  EXPECT_EQ(slow->read(std::byte{0x04}, 1, id), Error::bus);
}

// From the driver over spidev to the model of the panel that answers, or does not.
TEST_F(LinuxMockedSpi, APanelIsAskedWhoItIs) {
  struct NoTime {
    void wait(std::uint32_t) {}
  };
  NoTime clock;
  const hal::DcsConfig glass{.width = 4, .height = 4, .id = hal::Ili9341Controller::kId};
  auto bus = open();
  ASSERT_TRUE(bus);
  hal::Ili9341 display(*bus, clock, glass);
  for (const int level : {0x00, 0xFF}) {
    spi_.floating = level;
    spi_.messages.clear();
    EXPECT_EQ(display.start(), Error::wrong_id) << level;
    EXPECT_LE(spi_.messages.size(), 6U) << "a start sequence was sent, although none answers";
  }
  sim::DcsModel st7789(sim::kSt7789Part, {.width = 4, .height = 4});
  st7789.elapse(std::chrono::seconds(1));
  spi_.panel = &st7789;
  hal::DcsConfig other = glass;
  other.id = hal::St7789Controller::kId;
  hal::St7789 right(*bus, clock, other);
  EXPECT_EQ(right.start(), Error::none);
  other.id = 0x123456;
  hal::St7789 wrong(*bus, clock, other);
  EXPECT_EQ(wrong.start(), Error::wrong_id);
}

TEST_F(LinuxMockedSpi, EverySettingMayBeRefused) {
  for (const auto& [request, words] : {std::pair(SPI_IOC_RD_MODE, "cannot tell its mode"),
                                       {SPI_IOC_WR_MODE, "cannot be set to mode 0"},
                                       {SPI_IOC_WR_BITS_PER_WORD, "cannot be set to 8 bits"},
                                       {SPI_IOC_WR_MAX_SPEED_HZ, "cannot be set to 1000000 Hz"},
                                       {SPI_IOC_RD_BITS_PER_WORD, "cannot tell its bits"}}) {
    spi_.refused = static_cast<unsigned long>(request);
    const auto bus = open();
    ASSERT_FALSE(bus) << words;
    EXPECT_NE(bus.fault().message.find(words), std::string::npos) << bus.fault().message;
    EXPECT_NE(bus.fault().message.find("Invalid argument"), std::string::npos) << bus.fault().message;
  }
  spi_.refused = 0;
  spi_.mode = SPI_CPOL;
  spi_.keeps_mode = true;
  const auto bus = open();
  ASSERT_FALSE(bus);
  EXPECT_NE(bus.fault().message.find("but has another one"), std::string::npos) << bus.fault().message;
}

}  // namespace
}  // namespace zstrip::linux_mock
