// Panels as zstrip-panel opens them, on mocked lines and spidev: who answers there, and what is said of another one.
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "mocked_devices.hpp"
#include "mocked_gpio_chip.hpp"
#include "mocked_spi.hpp"
#include "open_display.hpp"
#include "panel/dcs_model.hpp"

namespace zstrip::linux_mock {
namespace {

using panel::ExitStatus;
using panel::Failure;

class LinuxMockedPanel : public testing::Test {
 protected:
  LinuxMockedPanel() {
    add(devices_, chip_);
    devices_.add("spidev", "spidev0.0", 153, 0,
                 [this](auto request, void* argument) { return spi_.control(request, argument); });
    st7789_.elapse(std::chrono::seconds(1));
  }

  struct Said {
    ExitStatus status = ExitStatus::ok;
    std::string words;
  };
  static Said open(const std::string& display) {
    const auto opened = panel::open_display(display, {});
    if (const Failure* failure = std::get_if<Failure>(&opened)) return {failure->status, failure->message};
    return {};
  }
  Said open_on_spidev(const std::string& more) {
    spi_.messages.clear();
    return open("st7789:spidev=/dev/spidev0.0,dc=0:3,size=4x4" + more);
  }

  sim::DcsModel st7789_{sim::kSt7789Part, {.width = 4, .height = 4}};
  MockedSpi spi_;
  MockedChip chip_;
  MockedDevices devices_;
};

TEST_F(LinuxMockedPanel, TheRightOneIsStarted) {
  spi_.panel = &st7789_;
  for (const char* id : {"", ",id=no", ",id", ",id=yes", ",id=858552", ",id=0x858552"}) {
    const Said said = open_on_spidev(id);
    EXPECT_EQ(said.words, "") << id;
    EXPECT_GT(spi_.messages.size(), 10U) << "nothing was started";
  }
  EXPECT_EQ(st7789_.complaints(), std::vector<std::string>{});
}

/// It was ignored: another device could be opened than the one that was named.
TEST_F(LinuxMockedPanel, ADeviceWithoutAKeyIsRefused) {
  for (const char* display : {"st7789:/dev/spidev0.1,spidev=/dev/spidev0.0,dc=0:3", "ssd1306:/dev/i2c-1,i2c=/dev/i2c-0",
                              "sdl:/dev/dri/card0,size=64x64"}) {
    const Said said = open(display);
    EXPECT_EQ(said.status, ExitStatus::usage) << display;
    EXPECT_NE(said.words.find("is no KEY=VALUE"), std::string::npos) << said.words;
  }
}

/// Its window was that of a memory of 162 rows: 31 to 158.
TEST_F(LinuxMockedPanel, AnSt7735Of128x128IsStartedInEveryOrientation) {
  for (const char* orientation : {"", ",rotate=90", ",rotate=180", ",rotate=270", ",mirror"}) {
    sim::DcsModel st7735{sim::kSt7735Rows132Part,
                         {.width = 128,
                          .height = 128,
                          .column_offset = 2,
                          .row_offset = 3,
                          .columns_reversed = true,
                          .rows_reversed = true,
                          .bgr = true}};
    st7735.elapse(std::chrono::seconds(1));
    spi_.panel = &st7735;
    const std::string display = "st7735:spidev=/dev/spidev0.0,dc=0:3,size=128x128,row=3,bgr";
    EXPECT_EQ(open(display + orientation).words, "") << orientation;
    EXPECT_EQ(st7735.complaints(), std::vector<std::string>{}) << orientation;
  }
}

TEST_F(LinuxMockedPanel, OddWidthsOfRgb444AreRefusedBeforeALineIsOpened) {
  for (const auto& [keys, remedy] : {std::pair("size=135x240", " (or rotate=90, 270)"),
                                     {"size=135x240,rotate=180", " (or rotate=90, 270)"},
                                     {"size=134x239,rotate=90", " (or rotate=0, 180)"},
                                     {"size=135x239", ""}}) {
    const Said said = open(std::string("st7789:spidev=/dev/nowhere,dc=9:3,format=rgb444,") + keys);
    EXPECT_EQ(said.status, ExitStatus::usage) << keys;
    EXPECT_EQ(said.words, std::string("--display st7789: format rgb444 needs an even width") + remedy);
  }
  const Said sideways = open("st7789:spidev=/dev/nowhere,dc=9:3,format=rgb444,size=135x240,rotate=90");
  EXPECT_EQ(sideways.status, ExitStatus::device) << sideways.words;
}

TEST_F(LinuxMockedPanel, AnotherOneIsNamedAndSentNothing) {
  spi_.panel = &st7789_;
  const Said said = open_on_spidev(",id=7c89f0");
  EXPECT_EQ(said.status, ExitStatus::device);
  EXPECT_EQ(
      said.words,
      "another panel answers: its id is 85 85 52, not 7c 89 f0; name its controller, or give its id as id=0x... if "
      "the module's maker has set one");
  EXPECT_TRUE(spi_.messages.empty());
}

TEST_F(LinuxMockedPanel, NobodyAnswers) {
  for (const auto& [level, read] : {std::pair(0x00, "00 00 00"), {0xFF, "ff ff ff"}}) {
    spi_.floating = level;
    const Said said = open_on_spidev(",id");
    EXPECT_EQ(said.status, ExitStatus::device);
    EXPECT_EQ(said.words, std::string("the panel does not answer: its id reads ") + read +
                              ", not 85 85 52; check its supply and the wire from its data output, or leave id out "
                              "where there is none");
    EXPECT_TRUE(spi_.messages.empty());
    EXPECT_EQ(open_on_spidev("").words, "") << "without id no wire is needed";
  }
}

TEST_F(LinuxMockedPanel, ABusThatFailsWhenItIsAskedIsSaid) {
  spi_.panel = &st7789_;
  spi_.messages_until_failure = 0;
  const Said said = open_on_spidev(",id");
  EXPECT_EQ(said.status, ExitStatus::output);
  EXPECT_EQ(said.words, "the panel cannot be started: the bus reports a fault");
}

TEST_F(LinuxMockedPanel, IdsThatAreNone) {
  for (const char* id : {"", "0", "ffffff", "1000000", "85 85 52", "0x", "-1", "id", "858552 "}) {
    const Said said = open_on_spidev(std::string(",id=") + id);
    EXPECT_EQ(said.status, ExitStatus::usage);
    EXPECT_EQ(said.words, std::string("--display st7789: id is three bytes, as 0x858552, not '") + id + "'");
  }
  EXPECT_EQ(open("st7789:clock=0:0,data=0:1,dc=0:3,id").words,
            "--display st7789: id needs miso, the line on which the panel answers");
  for (const char* kind : {"ssd1351", "ssd1306", "ssd0323"}) {
    const Said said = open(std::string(kind) + ":spidev=/dev/spidev0.0,dc=0:3,id");
    EXPECT_EQ(said.status, ExitStatus::usage);
    EXPECT_EQ(said.words, std::string("--display ") + kind + ": id cannot be read: this controller has none");
  }
}

}  // namespace
}  // namespace zstrip::linux_mock
