// spidev where a kernel misbehaves as no emulated one does: what the HAL makes of it.
#include <gtest/gtest.h>
#include <linux/spi/spidev.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "mocked_devices.hpp"
#include "zstrip_hal_linux/gpio.hpp"
#include "zstrip_hal_linux/spidev.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::Error;
using hal::GpioPin;
using hal::SpidevBus;

/// A driver of spidev: what it was set to, and what arrived.
struct MockedSpi {
  std::uint8_t mode = 0, bits = 0;
  std::uint32_t hertz = 0;
  bool keeps_mode = false;  ///< says yes and changes nothing
  unsigned long refused = 0;
  int error = EINVAL;
  int messages_until_failure = -1;
  std::vector<std::vector<std::uint8_t>> messages;

  int control(unsigned long request, void* argument) {
    if (request == refused) return error;
    switch (request) {
      case SPI_IOC_RD_MODE: std::memcpy(argument, &mode, sizeof mode); return 0;
      case SPI_IOC_WR_MODE:
        if (!keeps_mode) std::memcpy(&mode, argument, sizeof mode);
        return 0;
      case SPI_IOC_RD_BITS_PER_WORD: std::memcpy(argument, &bits, sizeof bits); return 0;
      case SPI_IOC_WR_BITS_PER_WORD: std::memcpy(&bits, argument, sizeof bits); return 0;
      case SPI_IOC_WR_MAX_SPEED_HZ: std::memcpy(&hertz, argument, sizeof hertz); return 0;
      case SPI_IOC_MESSAGE(1): break;
      default: return ENOTTY;
    }
    spi_ioc_transfer transfer{};
    std::memcpy(&transfer, argument, sizeof transfer);
    if (transfer.len > 4096) return EMSGSIZE;
    if (messages_until_failure-- == 0) return EIO;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(transfer.tx_buf);
    messages.emplace_back(bytes, bytes + transfer.len);
    return 0;
  }
};

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
