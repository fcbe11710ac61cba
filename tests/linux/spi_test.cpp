// zstrip-panel on panels at the SPI and the GPIO lines of a real kernel: the traced lines go to a model of the panel,
// which shows the picture of the host, or complains.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "guest.hpp"
#include "panel/dcs_model.hpp"
#include "spi_trace.hpp"

namespace zstrip::linux_guest {
namespace {

constexpr int kWidth = 64, kHeight = 48;  // more than one message of spidev, and a trace of some megabytes
constexpr const char* kPanel = ",size=64x48,column=10,row=20,dc=DC,reset=RESET,backlight=BACKLIGHT";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A machine whose GPIO chip is traced.
class LinuxSpi : public testing::Test {
 protected:
  explicit LinuxSpi(Machine machine = Machine::armhf) : machine_(machine) {}
  void SetUp() override {
    if (const std::string why = missing(machine_); !why.empty()) GTEST_SKIP() << why;
    std::string name = std::filesystem::temp_directory_path() / "zstrip-trace-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  std::filesystem::path trace() const { return folder_ / "lines"; }
  Guest::Options traced() const {
    return {.machine = machine_,
            .modules = machine_ == Machine::arm64 ? "spi_gpio" : "",  // built into the kernel for armhf
            .devices = {"-trace", "pl061_set_output", "-D", trace().string(), "-msg", "timestamp=on"}};
  }

  /// Frame 2 on the panel, its backlight on; dark and asleep after the end.
  void expect_shown_and_put_to_rest(Guest& guest, const std::string& display, const PanelLines& lines,
                                    std::uint16_t width = kWidth, std::uint16_t height = kHeight) {
    SCOPED_TRACE(display);
    constexpr int kBacklight = 5;
    const sim::Glass glass{.width = width, .height = height, .column_offset = 10, .row_offset = 20, .inverted = true};
    const std::size_t before = changes_of(trace());
    const Guest::Answer shown =
        guest.run("shows /scene.zsc --turn " + kTurn + " --frames 3 --display st7789:" + display);
    EXPECT_TRUE(contains(shown.text, "3 frames of " + std::to_string(width) + "x" + std::to_string(height)))
        << shown.text;
    {
      sim::DcsModel panel(sim::kSt7789Part, glass);
      EXPECT_EQ(replay(trace(), lines, panel, before), "");
      EXPECT_EQ(panel.darkness(), "");
      EXPECT_EQ(testing::PrintToString(panel.complaints()), "{}");
      expect_picture(panel.seen(), host_frame(2, width, height));
    }
    EXPECT_EQ(last_level(trace(), kBacklight), 1);

    EXPECT_EQ(guest.run("ends TERM").status, 0);
    sim::DcsModel panel(sim::kSt7789Part, glass);
    EXPECT_EQ(replay(trace(), lines, panel, before), "");
    EXPECT_NE(panel.darkness(), "");
    EXPECT_EQ(testing::PrintToString(panel.complaints()), "{}");
    EXPECT_EQ(last_level(trace(), kBacklight), 0);
  }

  /// In the bits that the panel has of each channel.
  static void expect_picture(const sim::RgbImage& seen, const boards::ColourPicture& expected) {
    ASSERT_EQ(seen.width, static_cast<std::uint32_t>(expected.width));
    ASSERT_EQ(seen.height, static_cast<std::uint32_t>(expected.height));
    int wrong = 0;
    int lit = 0;
    for (std::uint32_t y = 0; y < seen.height; ++y) {
      for (std::uint32_t x = 0; x < seen.width; ++x) {
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

  Machine machine_;
  std::filesystem::path folder_;
};

class LinuxSpiArm64 : public LinuxSpi {
 protected:
  LinuxSpiArm64() : LinuxSpi(Machine::arm64) {}
};

constexpr PanelLines kSpidevLines{.clock = 0, .data = 1, .data_command = 3, .select = 2, .reset = 4};

std::string spidev() { return std::string("spidev=/dev/spidev0.0,speed=1M") + kPanel; }

TEST_F(LinuxSpiArm64, Spidev) {
  Guest guest(traced());
  expect_shown_and_put_to_rest(guest, spidev(), kSpidevLines);
}

/// spidev takes few names of a device tree by itself, its own not among them; any other one by hand.
void expect_spidev_is_bound_to_any_name(Guest& guest) {
  EXPECT_EQ(guest.run("ls /dev/spidev*").text, "/dev/spidev0.0\n");
  for (const auto& [device, name] : {std::pair("0.1", "spidev"), {"0.2", "sitronix,st7789v"}}) {
    const std::string of_device = std::string("/sys/bus/spi/devices/spi") + device;
    EXPECT_EQ(guest.run("tr '\\0' '\\n' <" + of_device + "/of_node/compatible").text, std::string(name) + "\n");
    const std::string display =
        std::string("zstrip-panel /scene.zsc --frames 1 --display st7789:spidev=/dev/spidev") + device + kPanel;
    EXPECT_TRUE(contains(guest.run(display).text, "there is no such device; enable SPI and spidev for this")) << device;
    guest.run("echo spidev >" + of_device + "/driver_override");
    EXPECT_EQ(guest.run(std::string("echo spi") + device + " >/sys/bus/spi/drivers/spidev/bind").status, 0) << device;
    const Guest::Answer shown = guest.run(display);
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_TRUE(contains(shown.text, "1 frames of 64x48")) << shown.text;
  }
}

/// What arrived at the flash memory of the machine between two edges of its chip select.
std::vector<std::vector<std::uint8_t>> flash_transfers(const std::filesystem::path& trace) {
  std::ifstream stream(trace);
  std::vector<std::vector<std::uint8_t>> transfers;
  for (std::string line; std::getline(stream, line);) {
    if (contains(line, "] select")) transfers.emplace_back();
    const std::size_t sent = line.find(" tx 0x");
    if (sent == std::string::npos) continue;
    if (transfers.empty()) throw std::runtime_error("bytes without chip select: " + line);
    transfers.back().push_back(static_cast<std::uint8_t>(std::stoul(line.substr(sent + 6), nullptr, 16)));
  }
  return transfers;
}

// A controller of SPI and a chip select of a board's own device tree, whose flash memory is in a panel's place: it
// keeps no picture and knows no such id, but what arrives there is traced.
TEST_F(LinuxSpi, ControllerOfABoard) {
  if (const std::string why = missing(Machine::sabrelite); !why.empty()) GTEST_SKIP() << why;
  Guest guest({.machine = Machine::sabrelite,
               .modules = "gpio_mxc,spi_imx",
               .devices = {"-trace", "m25p80_transfer", "-trace", "m25p80_select", "-D", trace().string()}});
  guest.run("echo spidev >/sys/bus/spi/devices/spi0.0/driver_override");
  ASSERT_EQ(guest.run("echo spi0.0 >/sys/bus/spi/drivers/spidev/bind").status, 0);
  const std::string panel =
      "zstrip-panel /scene.zsc --frames 1 --display st7789:spidev=/dev/spidev0.0,dc=4:0,size=64x48";
  const Guest::Answer asked = guest.run(panel + ",id");
  EXPECT_EQ(asked.status, 3);
  EXPECT_TRUE(contains(asked.text, "the panel does not answer: its id reads 00 00 00, not 85 85 52")) << asked.text;
  // A bit comes before the answer of three bytes.
  const std::vector<std::uint8_t> question{0x04, 0, 0, 0, 0};
  const auto questions = flash_transfers(trace());
  ASSERT_FALSE(questions.empty());
  for (const auto& transfer : questions) EXPECT_EQ(transfer, question) << "and nothing is sent to a stranger";

  const Guest::Answer shown = guest.run(panel);
  EXPECT_EQ(shown.status, 0) << shown.text;
  const boards::ColourPicture picture = host_frame(0, kWidth, kHeight);
  std::vector<std::uint8_t> expected, arrived;
  for (const auto& [red, green, blue] : picture.pixels) {
    const unsigned pixel = red >> 3U << 11U | green >> 2U << 5U | blue >> 3U;
    expected.push_back(static_cast<std::uint8_t>(pixel >> 8U));
    expected.push_back(static_cast<std::uint8_t>(pixel));
  }
  constexpr std::size_t kLongest = 16;  // of commands and their parameters
  for (const auto& transfer : flash_transfers(trace())) {
    EXPECT_LE(transfer.size(), 4096U) << "what spidev takes";
    if (transfer.size() > kLongest) arrived.insert(arrived.end(), transfer.begin(), transfer.end());
  }
  ASSERT_GE(arrived.size(), expected.size());
  arrived.erase(arrived.begin(), arrived.end() - static_cast<std::ptrdiff_t>(expected.size()));  // the black one
  EXPECT_TRUE(arrived == expected);
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

// All on one machine, because its start takes longest.
TEST_F(LinuxSpi, LinesOfAGpioChip) {
  Guest guest(traced());
  expect_shown_and_put_to_rest(guest, spidev(), kSpidevLines);
  // Bit by bit, which takes the emulator long: a smaller picture.
  expect_shown_and_put_to_rest(
      guest, "clock=0:6,data=/dev/gpiochip0:7,size=32x24,column=10,row=20,dc=DC,reset=RESET,backlight=BACKLIGHT",
      {.clock = 6, .data = 7, .data_command = 3, .select = -1, .reset = 4}, 32, 24);
  guest.run("chmod 755 /; echo user:x:1000:1000::/:/bin/sh >/etc/passwd");
  expect_refusals(guest, "zstrip-panel");
  expect_spidev_is_bound_to_any_name(guest);

  if (const std::string why = missing_gpiod2(); !why.empty()) GTEST_SKIP() << why;
  guest.run("panel=zstrip-panel-gpiod2");
  expect_shown_and_put_to_rest(guest, spidev(), kSpidevLines);
  expect_refusals(guest, "zstrip-panel-gpiod2");
}

}  // namespace
}  // namespace zstrip::linux_guest
