// Addresses of displays: what they say, and what is said of those that say nothing sensible.
#include "display_address.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zstrip::panel {
namespace {

TEST(LinuxDisplayAddress, DeviceAndKeys) {
  auto address = DisplayAddress::parse("drm:/dev/dri/by-path/pci-0:02.0,size=640x480,connector=HDMI-A-1,mirror");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->kind(), "drm");
  EXPECT_EQ(address->device(), "/dev/dri/by-path/pci-0:02.0");
  const auto size = address->take_size("size");
  ASSERT_TRUE(size);
  EXPECT_EQ(*size, (hal::ScreenSize{640, 480}));
  EXPECT_EQ(address->untaken()->message, "--display drm: connector is not known there; see --help");
  EXPECT_EQ(address->take("connector"), "HDMI-A-1");
  EXPECT_EQ(address->take("connector"), std::nullopt);
  EXPECT_TRUE(*address->take_flag("mirror"));
  EXPECT_FALSE(address->untaken());

  auto wired = DisplayAddress::parse("st7789:spidev=/dev/spidev0.0,speed=40M,dc=gpiochip0:25");
  ASSERT_TRUE(wired);
  EXPECT_EQ(wired->device(), "");
  EXPECT_EQ(wired->take("spidev"), "/dev/spidev0.0");
  EXPECT_EQ(wired->take("dc"), "gpiochip0:25");
  EXPECT_EQ(**wired->take_number("speed", 1000, 1'000'000'000), 40'000'000U);

  auto bare = DisplayAddress::parse("drm,size=1x1");
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->kind(), "drm");
  EXPECT_TRUE(**bare->take_size("size") == (hal::ScreenSize{1, 1}));
  auto window = DisplayAddress::parse("sdl:320x240@2,mirror");
  ASSERT_TRUE(window);
  EXPECT_EQ(window->device(), "");
  EXPECT_TRUE(**window->take_size("size") == (hal::ScreenSize{320, 240}));
  EXPECT_EQ(**window->take_number("scale", 1, 8), 2U);
  EXPECT_TRUE(*window->take_flag("mirror"));
  EXPECT_FALSE(window->untaken());
  auto scaled = DisplayAddress::parse("sdl:@2");
  ASSERT_TRUE(scaled);
  EXPECT_FALSE(*scaled->take_size("size"));
  EXPECT_EQ(**scaled->take_number("scale", 1, 8), 2U);
  EXPECT_FALSE(scaled->untaken());
  EXPECT_TRUE(DisplayAddress::parse("fbdev"));
  EXPECT_TRUE(DisplayAddress::parse(""));
}

TEST(LinuxDisplayAddress, WhatIsNone) {
  for (const char* text :
       {"drm:,size=1x1", "drm:size=1x1,,format=rgb565", "drm:=5", "drm:size=1x1,size=2x2", "sdl:1x1,size=2x2",
        "sdl:1x1@2,scale=2", "drm:", "drm,", "drm:size=1x1,", "drm:/dev/dri/card0,", "drm:,"}) {
    EXPECT_FALSE(DisplayAddress::parse(text)) << text;
  }
  for (const char* size : {"", "x", "1x", "x1", "0x1", "1x4097", "1x1x1", "-1x1", " 1x1", "99999999999x1"}) {
    auto address = DisplayAddress::parse(std::string("drm:size=") + size);
    ASSERT_TRUE(address) << size;
    EXPECT_FALSE(address->take_size("size")) << size;
  }
  for (const char* number : {"", "K", "-1", "1.5", "5G", "999", "1001K", "99999999999999999999"}) {
    auto address = DisplayAddress::parse(std::string("st7789:speed=") + number);
    ASSERT_TRUE(address) << number;
    EXPECT_FALSE(address->take_number("speed", 1000, 1'000'000)) << number;
  }
  for (const char* flag : {"maybe", "", "1", "true"}) {
    auto address = DisplayAddress::parse(std::string("st7789:bgr=") + flag);
    ASSERT_TRUE(address) << flag;
    EXPECT_FALSE(address->take_flag("bgr")) << flag;
  }
  for (const char* text : {"drm:connector", "drm:connector="}) {
    auto address = DisplayAddress::parse(text);
    ASSERT_TRUE(address) << text;
    const auto name = address->take_name("connector");
    ASSERT_FALSE(name) << text;
    EXPECT_EQ(name.fault().message, "--display drm: connector needs a value");
  }
}

}  // namespace
}  // namespace zstrip::panel
