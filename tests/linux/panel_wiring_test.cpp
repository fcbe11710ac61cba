// Which words of an address make a wiring, and what is said of those that do not go together.
#include "panel_wiring.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zstrip::panel {
namespace {

/// The wiring's fault; empty if it is one.
std::string fault_of(const std::string& text) {
  auto address = DisplayAddress::parse(text);
  if (!address) return "no address";
  const auto wiring = PanelWiring::take(*address);
  if (!wiring) return wiring.fault().message;
  const auto untaken = address->untaken();
  return untaken ? untaken->message : "";
}

TEST(LinuxPanelWiring, I2c) {
  auto address = DisplayAddress::parse("ssd1306:i2c=/dev/i2c-1,address=0x3D,reset=RESET");
  ASSERT_TRUE(address);
  const auto wiring = PanelWiring::take(*address);
  ASSERT_TRUE(wiring) << wiring.fault().message;
  EXPECT_EQ(wiring->i2c, "/dev/i2c-1");
  EXPECT_EQ(wiring->address, 0x3D);
  EXPECT_EQ(wiring->reset, "RESET");
  auto usual = DisplayAddress::parse("ssd1306:i2c=/dev/i2c-1");
  ASSERT_TRUE(usual);
  EXPECT_EQ(PanelWiring::take(*usual)->address, 0x3C);
  EXPECT_EQ(fault_of("ssd1306:i2c=/dev/i2c-1,address=60"), "");
  for (const char* number : {"", "0x", "0x3", "0x78", "3C", "0x3C0", "-1", "0x3D "}) {
    EXPECT_EQ(fault_of(std::string("ssd1306:i2c=/dev/i2c-1,address=") + number),
              std::string("--display ssd1306: address must be 0x08 to 0x77, as 0x3c, not '") + number + "'");
  }
  for (const char* other : {"dc=0:1", "spidev=/dev/spidev0.0", "clock=0:1", "speed=1M", "miso=0:1"}) {
    EXPECT_EQ(fault_of(std::string("ssd1306:i2c=/dev/i2c-1,") + other),
              "--display ssd1306: i2c does without spidev, speed, clock, data, select, miso and dc: it has two wires "
              "of its own");
  }
  EXPECT_EQ(fault_of("st7789:i2c=/dev/i2c-1"),
            "--display st7789: i2c is only for ssd1306: other controllers have none");
}

TEST(LinuxPanelWiring, Spi) {
  EXPECT_EQ(fault_of("st7789:spidev=/dev/spidev0.0,speed=40M,dc=0:1,reset=0:2,backlight=0:3"), "");
  EXPECT_EQ(fault_of("st7789:clock=0:1,data=0:2,select=0:3,dc=0:4"), "");
  EXPECT_EQ(fault_of("st7789:spidev=/dev/spidev0.0"),
            "--display st7789: dc is missing: the line that tells commands from data");
  EXPECT_EQ(fault_of("st7789:dc=0:4,clock=0:1"),
            "--display st7789: spidev is missing, or clock and data for a bus that is driven bit by bit");
  for (const char* other : {"clock", "data", "select", "miso"}) {
    EXPECT_EQ(fault_of(std::string("st7789:dc=0:4,spidev=/dev/spidev0.0,") + other + "=0:1"),
              "--display st7789: spidev does without clock, data, select and miso: they are those of its controller");
  }
  EXPECT_EQ(fault_of("st7789:dc=0:4,clock=0:1,data=0:2,speed=1M"),
            "--display st7789: speed is only for spidev: other lines are slower");
  EXPECT_EQ(fault_of("ssd1306:spidev=/dev/spidev0.0,dc=0:1,address=0x3C"),
            "--display ssd1306: address is not known there; see --help");
}

// An empty value was taken for a device or a line without a name.
TEST(LinuxPanelWiring, EmptyNames) {
  EXPECT_EQ(fault_of("ssd1306:i2c="), "--display ssd1306: i2c needs a value");
  EXPECT_EQ(fault_of("st7789:spidev=/dev/spidev0.0,dc"), "--display st7789: dc needs a value");
  EXPECT_EQ(fault_of("st7789:spidev=,dc=0:1"), "--display st7789: spidev needs a value");
  for (const char* key : {"clock", "data", "select", "miso", "dc", "reset", "backlight"}) {
    std::string text = "st7789";
    char separator = ':';
    for (const char* each : {"clock", "data", "select", "miso", "dc", "reset", "backlight"}) {
      text += separator;
      text += each;
      text += std::string(each) == key ? "=" : "=0:1";
      separator = ',';
    }
    EXPECT_EQ(fault_of(text), std::string("--display st7789: ") + key + " needs a value");
  }
}

TEST(LinuxPanelWiring, WhoCanBeAsked) {
  for (const auto& [text, can_read] : {std::pair("st7789:spidev=/dev/spidev0.0,dc=0:1", true),
                                       {"st7789:clock=0:1,data=0:2,dc=0:3,miso=0:4", true},
                                       {"st7789:clock=0:1,data=0:2,dc=0:3", false},
                                       {"ssd1306:i2c=/dev/i2c-1", false}}) {
    auto address = DisplayAddress::parse(text);
    ASSERT_TRUE(address);
    const auto wiring = PanelWiring::take(*address);
    ASSERT_TRUE(wiring) << wiring.fault().message;
    EXPECT_EQ(wiring->can_read(), can_read) << text;
  }
}

}  // namespace
}  // namespace zstrip::panel
