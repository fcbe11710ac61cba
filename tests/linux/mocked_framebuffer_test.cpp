// A framebuffer whose driver goes wrong after it has taken a mode: what is said, and that it has its former mode then.
#include <gtest/gtest.h>
#include <linux/fb.h>

#include <cerrno>
#include <cstdint>
#include <string>

#include "mocked_devices.hpp"
#include "zstrip_hal_linux/framebuffer_display.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::FramebufferDisplay;
using hal::FramebufferOptions;
using hal::ScreenSize;

constexpr std::uint32_t kMemory = 64 * 64 * 4;

/// A driver's state; its modes are true colours without padding.
struct MockedFramebuffer {
  static fb_var_screeninfo mode_of(std::uint32_t width, std::uint32_t height, std::uint32_t depth) {
    fb_var_screeninfo mode{};
    mode.xres = mode.xres_virtual = width;
    mode.yres = mode.yres_virtual = height;
    mode.bits_per_pixel = depth;
    const bool is_16 = depth == 16;
    mode.red = {.offset = is_16 ? 11U : 16U, .length = is_16 ? 5U : 8U, .msb_right = 0};
    mode.green = {.offset = is_16 ? 5U : 8U, .length = is_16 ? 6U : 8U, .msb_right = 0};
    mode.blue = {.offset = 0, .length = is_16 ? 5U : 8U, .msb_right = 0};
    return mode;
  }

  fb_var_screeninfo mode = mode_of(64, 64, 32);
  std::uint32_t memory = kMemory;
  std::uint32_t kept_depth = 0;       ///< not 0: what a mode with another depth gets
  std::uint32_t direct_colour = 0;    ///< the depth whose pixels are no true colour
  int memory_error = 0;               ///< of the question where the memory is
  int answers_until_error = 1 << 30;  ///< of questions for the mode

  int control(unsigned long request, void* argument) {
    switch (request) {
      case FBIOGET_VSCREENINFO:
        if (answers_until_error-- <= 0) return EIO;
        *static_cast<fb_var_screeninfo*>(argument) = mode;
        return 0;
      case FBIOPUT_VSCREENINFO: {
        const auto& wanted = *static_cast<const fb_var_screeninfo*>(argument);
        const bool keeps = kept_depth != 0 && wanted.bits_per_pixel != 32;
        mode = mode_of(wanted.xres, wanted.yres, keeps ? kept_depth : wanted.bits_per_pixel);
        return 0;
      }
      case FBIOGET_FSCREENINFO: {
        if (memory_error != 0) return memory_error;
        auto& device = *static_cast<fb_fix_screeninfo*>(argument);
        device = {};
        device.smem_len = memory;
        device.line_length = mode.xres * mode.bits_per_pixel / 8;
        device.type = FB_TYPE_PACKED_PIXELS;
        device.visual = mode.bits_per_pixel == direct_colour ? FB_VISUAL_DIRECTCOLOR : FB_VISUAL_TRUECOLOR;
        return 0;
      }
      case FBIOBLANK: return 0;
      default: return ENOTTY;
    }
  }
};

class LinuxMockedFramebuffer : public testing::Test {
 protected:
  LinuxMockedFramebuffer() {
    devices_.add(
        "graphics", "fb0", 29, 0, [this](auto request, void* argument) { return driver_.control(request, argument); },
        kMemory);
  }

  static auto open(std::uint32_t depth) {
    return FramebufferDisplay::open("/dev/fb0", {.size = ScreenSize{32, 16}, .depth = depth});
  }
  void expect_former_mode() const {
    EXPECT_EQ(driver_.mode.xres, 64U);
    EXPECT_EQ(driver_.mode.yres, 64U);
    EXPECT_EQ(driver_.mode.bits_per_pixel, 32U);
  }
  /// The words of the refusal.
  std::string refused(std::uint32_t depth) {
    const auto display = open(depth);
    expect_former_mode();
    return display ? "it was opened" : display.fault().message;
  }

  MockedFramebuffer driver_;
  MockedDevices devices_;
};

TEST_F(LinuxMockedFramebuffer, TheFormerModeComesBackWhenTheDisplayEnds) {
  {
    const auto display = open(16);
    ASSERT_TRUE(display) << display.fault().message;
    EXPECT_EQ(driver_.mode.xres, 32U);
    EXPECT_EQ(driver_.mode.bits_per_pixel, 16U);
  }
  expect_former_mode();
}

TEST_F(LinuxMockedFramebuffer, ADriverThatKeepsTheDepthGetsItsFormerSizeBack) {
  driver_.kept_depth = 24;
  EXPECT_EQ(refused(16),
            "/dev/fb0 does not take 32x16 with 16 bits a pixel, although it reports success; it has 32x16 with 24 bits "
            "a pixel");
}

TEST_F(LinuxMockedFramebuffer, NoTrueColourIsRefusedWithTheOtherDepthsAndTheFormerModeComesBack) {
  driver_.direct_colour = 16;
  EXPECT_EQ(refused(16),
            "/dev/fb0 has 16 bits a pixel that are no true colour; another depth may be: depth=24 or depth=32");
  driver_.direct_colour = 24;
  EXPECT_EQ(refused(24),
            "/dev/fb0 has 24 bits a pixel that are no true colour; another depth may be: depth=16 or depth=32");
}

TEST_F(LinuxMockedFramebuffer, MemoryThatIsNotThereBringsTheFormerModeBack) {
  driver_.memory = 0;
  EXPECT_EQ(refused(16), "/dev/fb0 reports that it has no memory");
  driver_.memory = 32;
  EXPECT_NE(refused(16).find("lies beyond its memory"), std::string::npos);
  driver_.memory_error = EIO;
  EXPECT_NE(refused(16).find("tell where its memory is"), std::string::npos);
}

TEST_F(LinuxMockedFramebuffer, AModeThatCannotBeReadBringsTheFormerModeBack) {
  driver_.answers_until_error = 1;
  EXPECT_NE(refused(16).find("tell its mode"), std::string::npos);
}

}  // namespace
}  // namespace zstrip::linux_mock
