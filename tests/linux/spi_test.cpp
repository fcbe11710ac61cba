// zstrip-panel on panels at the SPI and the GPIO lines of a real kernel: the traced lines go to a model of the panel,
// which shows the picture of the host, or complains.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "guest.hpp"
#include "panel/dcs_model.hpp"
#include "spi_trace.hpp"

namespace zstrip::linux_guest {
namespace {

constexpr int kWidth = 64, kHeight = 48;  // more than one message of spidev, and a trace of some megabytes
constexpr sim::Glass kGlass{
    .width = kWidth, .height = kHeight, .column_offset = 10, .row_offset = 20, .inverted = true};
constexpr const char* kPanel = ",size=64x48,column=10,row=20,dc=DC,reset=RESET,backlight=BACKLIGHT";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// An armhf machine whose GPIO chip is traced.
class LinuxSpi : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = missing(Machine::armhf); !why.empty()) GTEST_SKIP() << why;
    std::string name = std::filesystem::temp_directory_path() / "zstrip-trace-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  std::filesystem::path trace() const { return folder_ / "lines"; }
  Guest::Options traced() const {
    return {.machine = Machine::armhf,
            .devices = {"-trace", "pl061_set_output", "-D", trace().string(), "-msg", "timestamp=on"}};
  }

  /// Frame 2 of 64 on the panel, its backlight on; dark and asleep after the end.
  void expect_shown_and_put_to_rest(const std::string& display, const PanelLines& lines,
                                    const std::string& program = "zstrip-panel") {
    constexpr int kBacklight = 5;
    Guest guest(traced());
    guest.run("panel=" + program);
    const Guest::Answer shown = guest.run("shows /scene.zsc --frames 3 --display " + display);
    EXPECT_TRUE(contains(shown.text, "3 frames of 64x48")) << shown.text;
    {
      sim::DcsModel panel(sim::kSt7789Part, kGlass);
      EXPECT_EQ(replay(trace(), lines, panel), "");
      EXPECT_EQ(panel.darkness(), "");
      EXPECT_EQ(testing::PrintToString(panel.complaints()), "{}");
      expect_picture(panel.seen(), host_frame(2, kWidth, kHeight));
    }
    EXPECT_EQ(last_level(trace(), kBacklight), 1);

    EXPECT_EQ(guest.run("ends TERM").status, 0);
    sim::DcsModel panel(sim::kSt7789Part, kGlass);
    EXPECT_EQ(replay(trace(), lines, panel), "");
    EXPECT_NE(panel.darkness(), "");
    EXPECT_EQ(testing::PrintToString(panel.complaints()), "{}");
    EXPECT_EQ(last_level(trace(), kBacklight), 0);
  }

  /// In the bits that the panel has of each channel.
  static void expect_picture(const sim::RgbImage& seen, const boards::ColourPicture& expected) {
    ASSERT_EQ(seen.width, kWidth);
    ASSERT_EQ(seen.height, kHeight);
    int wrong = 0;
    int lit = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y) {
      for (std::uint32_t x = 0; x < kWidth; ++x) {
        const std::uint8_t* pixel = seen.pixel(x, y);
        const auto& other = expected.at(static_cast<int>(x), static_cast<int>(y));
        lit += other[1] != 0 ? 1 : 0;
        wrong +=
            pixel[0] >> 3 != other[0] >> 3 || pixel[1] >> 2 != other[1] >> 2 || pixel[2] >> 3 != other[2] >> 3 ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << "pixels";
    EXPECT_GT(lit, 100);
  }

  std::filesystem::path folder_;
};

TEST_F(LinuxSpi, Spidev) {
  expect_shown_and_put_to_rest(std::string("st7789:spidev=/dev/spidev0.0,speed=1M") + kPanel,
                               {.clock = 0, .data = 1, .data_command = 3, .select = 2, .reset = 4});
}

TEST_F(LinuxSpi, SpidevWithLibgpiod2) {
  if (const std::string why = missing_gpiod2(); !why.empty()) GTEST_SKIP() << why;
  expect_shown_and_put_to_rest(std::string("st7789:spidev=/dev/spidev0.0,speed=1M") + kPanel,
                               {.clock = 0, .data = 1, .data_command = 3, .select = 2, .reset = 4},
                               "zstrip-panel-gpiod2");
}

TEST_F(LinuxSpi, BitByBit) {
  expect_shown_and_put_to_rest(std::string("st7789:clock=0:6,data=/dev/gpiochip0:7") + kPanel,
                               {.clock = 6, .data = 7, .data_command = 3, .select = -1, .reset = 4});
}

/// The same words with both releases of libgpiod.
void expect_refusals(Guest& guest, const std::string& program) {
  SCOPED_TRACE(program);
  const std::string list = guest.run(program + " --list").text;
  for (const char* part : {"spidev=/dev/spidev0.0", "/dev/gpiochip0  8 lines", "gpiochip0:3  DC\n",
                           "gpiochip0:0  SCLK  in use by 'sck'"}) {
    EXPECT_TRUE(contains(list, part)) << list;
  }
  struct Refusal {
    const char* display;
    int status;
    const char* words;
  };
  for (const Refusal& refusal : {
           Refusal{"spidev=/dev/spidev0.0,dc=SCLK", 3,
                   "dc: /dev/gpiochip0 line 0 (SCLK) is busy: 'sck' has it; choose"},
           {"clock=gpiochip0:1,data=0:7,dc=DC", 3, "clock: /dev/gpiochip0 line 1 (MOSI) is busy: 'mosi' has it"},
           {"clock=0:7,data=0:7,dc=DC", 3, "data: /dev/gpiochip0 line 7 is busy: 'zstrip' has it"},
           {"spidev=/dev/spidev0.0,dc=gpiochip7:1", 3, "dc: /dev/gpiochip7 cannot be opened: there is no such device"},
           {"spidev=/dev/spidev0.0,dc=0:8", 3, "dc: /dev/gpiochip0 has no line 8, only 8 lines from 0 on"},
           {"spidev=/dev/spidev0.0,dc=DC,reset=RST", 3, "reset: no GPIO chip has a line with the name 'RST'"},
           {"spidev=/dev/spidev0.0,dc=/dev/null:1", 3, "dc: /dev/null is not a GPIO chip"},
           {"spidev=/dev/spidev1.0,dc=DC", 3, "/dev/spidev1.0 cannot be opened: there is no such device; enable SPI"},
           {"spidev=/dev/null,dc=DC", 3, "/dev/null cannot tell its mode"},
           {"spidev=/dev/spidev0.0,dc=DC,size=300x300", 2, "the display's controller cannot do what its configuration"},
           // Nobody drives the line that is read.
           {"clock=0:6,data=0:7,miso=BACKLIGHT,dc=DC,id", 3, "the panel does not answer: its id reads "},
           {"clock=0:6,data=0:7,miso=SCLK,dc=DC,id", 3, "miso: /dev/gpiochip0 line 0 (SCLK) is busy: 'sck' has it"},
       }) {
    const Guest::Answer answer = guest.run(program + " /scene.zsc --frames 1 --display st7789:" + refusal.display);
    EXPECT_EQ(answer.status, refusal.status) << refusal.display << "\n" << answer.text;
    EXPECT_TRUE(contains(answer.text, refusal.words)) << refusal.display << "\n" << answer.text;
  }
  // For a user without groups.
  const Guest::Answer answer =
      guest.run("su user -c '" + program + " /scene.zsc --display st7789:spidev=/dev/spidev0.0,dc=DC'");
  EXPECT_EQ(answer.status, 3);
  EXPECT_TRUE(contains(answer.text, "dc: /dev/gpiochip0 cannot be opened: no permission; join the group 'gpio'"))
      << answer.text;
}

TEST_F(LinuxSpi, WhatIsRefused) {
  Guest guest(traced());
  guest.run("chmod 755 /; echo user:x:1000:1000::/:/bin/sh >/etc/passwd");
  expect_refusals(guest, "zstrip-panel");
  if (missing_gpiod2().empty()) expect_refusals(guest, "zstrip-panel-gpiod2");
}

}  // namespace
}  // namespace zstrip::linux_guest
