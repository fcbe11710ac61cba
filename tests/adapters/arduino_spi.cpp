// ArduinoSpi on stand-ins for the SPI classes of cores: what goes over, in how many calls, and that it stays as it was.
#include <gtest/gtest.h>

#define ARDUINO_ARCH_RP2040
#include <SPI.h>
#include <zstrip_arduino.h>
#undef abs
#undef max
#undef min
#undef round

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

void pinMode(pin_size_t, PinMode) {}
void digitalWrite(pin_size_t, PinStatus) {}
void delay(unsigned long) {}
void delayMicroseconds(unsigned int) {}
unsigned long millis() {
  static unsigned long now = 0;
  return now += 100;
}

namespace zstrip::adapters_test {
namespace {

class Core {
 public:
  void begin() {}
  void beginTransaction(SPISettings) {}
  void endTransaction() {}

  std::vector<std::uint8_t> sent;
  int calls = 0;  ///< each of which waits for the controller

 protected:
  void send(const void* bytes, std::size_t count) {
    ++calls;
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    sent.insert(sent.end(), first, first + count);
  }
  /// `received` may be `sent`.
  void exchange(const void* bytes, void* received, std::size_t count) {
    send(bytes, count);
    std::memset(received, 0xA5, count);
  }
};

/// Arduino's own interface: AVR, SAMD, Renesas.
struct InPlaceCore : Core {
  std::uint8_t transfer(std::uint8_t byte) {
    exchange(&byte, &byte, 1);
    return byte;
  }
  void transfer(void* bytes, std::size_t count) { exchange(bytes, bytes, count); }
};

/// arduino-pico, whose transfer() of one buffer is a loop over bytes.
struct PicoCore : Core {
  std::uint8_t transfer(std::uint8_t byte) {
    exchange(&byte, &byte, 1);
    return byte;
  }
  void transfer(void* bytes, std::size_t count) {
    for (auto* byte = static_cast<std::uint8_t*>(bytes); count-- > 0; ++byte) *byte = transfer(*byte);
  }
  void transfer(const void* bytes, void* received, std::size_t count) {
    EXPECT_EQ(received, nullptr) << "which takes half of the time again";
    send(bytes, count);
  }
  /// The bytes are read as late as DMA may read them.
  bool transferAsync(const void* bytes, void* received, std::size_t count) {
    EXPECT_EQ(received, nullptr);
    EXPECT_EQ(under_way.size(), 0U);
    if (!has_channel) return false;
    under_way = {static_cast<const std::uint8_t*>(bytes), count};
    return true;
  }
  bool finishedAsync() {
    if (hangs) return false;
    send(under_way.data(), under_way.size());
    under_way = {};
    return true;
  }
  void abortAsync() { under_way = {}; }

  std::span<const std::uint8_t> under_way;
  bool has_channel = true, hangs = false;
};

/// Its bus by PIO, SoftwareSPI, does not ask whether there is a place for what it receives.
struct PioCore : Core {
  void transfer(void* bytes, std::size_t count) { transfer(bytes, bytes, count); }
  void transfer(const void* bytes, void* received, std::size_t count) {
    ASSERT_NE(received, nullptr);
    exchange(bytes, received, count);
  }
};

/// stm32duino 2.12: counts in 16 bits inside, and has a third function of this name.
struct Stm32Core : Core {
  std::uint8_t transfer(std::uint8_t byte, bool = false) { return byte; }
  void transfer(void* bytes, std::size_t count, bool) { exchange(bytes, bytes, std::uint16_t(count)); }
  void transfer(void* bytes, std::size_t count) { transfer(bytes, count, false); }
  void transfer(const void* bytes, void* received, std::size_t count) {
    exchange(bytes, received, std::uint16_t(count));
  }
};

/// stm32duino 1.x: a pin comes first.
struct OldStm32Core : Core {
  enum Mode { last };
  void transfer(std::uint8_t, void*, void*, std::size_t, Mode = last) { FAIL() << "a pin that is no pin"; }
  void transfer(void* bytes, std::size_t count, Mode = last) { exchange(bytes, bytes, count); }
};

/// esp32.
struct Esp32Core : Core {
  void transfer(void* bytes, std::uint32_t count) {
    for (auto* byte = static_cast<std::uint8_t*>(bytes); count-- > 0; ++byte) exchange(byte, byte, 1);
  }
  void writeBytes(const std::uint8_t* bytes, std::uint32_t count) { send(bytes, count); }
};

/// esp8266 reads whole words from where the bytes begin, which on that chip must be a word's address.
struct Esp8266Core : Core {
  void transfer(void* bytes, std::uint16_t count) {
    for (auto* byte = static_cast<std::uint8_t*>(bytes); count-- > 0; ++byte) exchange(byte, byte, 1);
  }
  void writeBytes(const std::uint8_t* bytes, std::uint32_t count) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes) % 4, 0U);
    send(bytes, count);
  }
};

template <class Spi>
class ArduinoSpi : public testing::Test {};
using Cores = testing::Types<InPlaceCore, PicoCore, PioCore, Stm32Core, OldStm32Core, Esp32Core, Esp8266Core>;
struct CoreNames {
  template <class Spi>
  static std::string GetName(int number) {
    const char* const names[] = {"InPlace", "Pico", "Pio", "Stm32", "OldStm32", "Esp32", "Esp8266"};
    return names[number];
  }
};
TYPED_TEST_SUITE(ArduinoSpi, Cores, CoreNames);

// A frame of 240x240 in one strip is more than 16 bits count; odd places and counts are commands' parameters.
TYPED_TEST(ArduinoSpi, SendsBlocksAndLeavesThemAsTheyAre) {
  std::vector<std::uint8_t> bytes(2 * 240 * 240 + 1);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  const std::vector<std::uint8_t> original = bytes;
  for (const std::size_t count :
       {std::size_t{1}, std::size_t{3}, std::size_t{63}, std::size_t{257}, bytes.size() - 1}) {
    TypeParam spi;
    hal::ArduinoSpi bus(spi, {.data_command = 8, .select = 10}, 40'000'000);
    bus.start();
    const std::span part = std::span<const std::uint8_t>(bytes).subspan(1, count);
    ASSERT_EQ(bus.write_data(std::as_bytes(part)), hal::Error::none);
    ASSERT_EQ(bus.wait(), hal::Error::none);
    EXPECT_EQ(bytes, original) << count;
    EXPECT_TRUE(std::ranges::equal(spi.sent, part)) << count;
    EXPECT_LE(spi.calls, static_cast<int>((count + 255) / 256)) << "calls for " << count << " bytes";
  }
}

// arduino-pico: data go by DMA, commands before the function returns.
TEST(ArduinoSpiByDma, SendsUntilWaitEnds) {
  PicoCore spi;
  hal::ArduinoSpi bus(spi, {.data_command = 8}, 40'000'000);
  bus.start();
  const std::byte bytes[] = {std::byte{1}, std::byte{2}};
  EXPECT_EQ(bus.write_command(bytes), hal::Error::none);
  EXPECT_EQ(spi.sent.size(), 2U);
  EXPECT_EQ(bus.write_data(bytes), hal::Error::none);
  EXPECT_EQ(spi.sent.size(), 2U);
  EXPECT_EQ(bus.wait(), hal::Error::none);
  EXPECT_EQ(spi.sent, (std::vector<std::uint8_t>{1, 2, 1, 2}));
  EXPECT_EQ(bus.wait(), hal::Error::none);
  EXPECT_EQ(spi.calls, 2);
}

TEST(ArduinoSpiByDma, SendsWithoutAChannelAndTellsThatItDoesNotEnd) {
  PicoCore spi;
  hal::ArduinoSpi bus(spi, {.data_command = 8}, 40'000'000);
  bus.start();
  const std::byte bytes[] = {std::byte{1}, std::byte{2}};
  spi.has_channel = false;
  EXPECT_EQ(bus.write_data(bytes), hal::Error::none);
  EXPECT_EQ(spi.sent.size(), 2U);
  EXPECT_EQ(bus.wait(), hal::Error::none);
  spi.has_channel = spi.hangs = true;
  EXPECT_EQ(bus.write_data(bytes), hal::Error::none);
  EXPECT_EQ(bus.wait(), hal::Error::timeout);
  EXPECT_EQ(spi.under_way.size(), 0U);
  spi.hangs = false;
  EXPECT_EQ(bus.write_data(bytes), hal::Error::none);
  EXPECT_EQ(bus.wait(), hal::Error::none);
  EXPECT_EQ(spi.sent.size(), 4U);
}

}  // namespace
}  // namespace zstrip::adapters_test
