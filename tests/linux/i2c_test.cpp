// zstrip-panel on the I2C of a real kernel, on an i.MX6 in the emulator: what its bus carries goes to a model of the
// panel, which shows the picture of the host, or complains. At the panel's address is a memory that takes every byte.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "guest.hpp"
#include "panel/ssd1306_model.hpp"

namespace zstrip::linux_guest {
namespace {

constexpr int kWidth = 128, kHeight = 64;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// What the trace has for the panel. The first byte of a transfer is the control byte: what follows is commands, or
/// data. The emulator's lines are "i2c_event start(addr:0x3c)" and "i2c_send send(addr:0x3c) data:0xae". Returns how
/// many transfers there were.
int replay(const std::filesystem::path& trace, sim::PanelModel& panel) {
  std::ifstream stream(trace);
  if (!stream) throw std::runtime_error("there is no trace " + trace.string());
  int transfers = 0, at = 0;
  unsigned control = 0;
  for (std::string line; std::getline(stream, line);) {
    unsigned address = 0, byte = 0;
    if (contains(line, "i2c_event start")) {
      ++transfers;
      at = 0;
    }
    const std::size_t send = line.find("send(addr:");
    if (send == std::string::npos ||
        std::sscanf(line.c_str() + send, "send(addr:0x%x) data:0x%x", &address, &byte) != 2 || address != 0x3C)
      continue;
    if (at++ == 0) {
      control = byte;
      EXPECT_TRUE(control == 0x00 || control == 0x40) << line;
      continue;
    }
    const auto arrived = static_cast<std::byte>(byte);
    panel.receive(control == 0x40 ? sim::Wire::data : sim::Wire::command, std::span(&arrived, 1));
  }
  return transfers;
}

class LinuxI2c : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = missing(Machine::sabrelite); !why.empty()) GTEST_SKIP() << why;
    std::string name = std::filesystem::temp_directory_path() / "zstrip-trace-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }
  std::filesystem::path trace() const { return folder_ / "bus"; }

  std::filesystem::path folder_;
};

TEST_F(LinuxI2c, Ssd1306) {
  Guest guest({.machine = Machine::sabrelite,
               .modules = "i2c_imx,i2c_dev",
               .devices = {"-device", "at24c-eeprom,bus=i2c-bus.0,address=0x3c,rom-size=256", "-trace", "i2c_send",
                           "-trace", "i2c_event", "-D", trace().string()}});
  const std::string list = guest.run("zstrip-panel --list").text;
  EXPECT_TRUE(contains(list, "i2c=/dev/i2c-0\n")) << list;

  struct Refusal {
    const char* arguments;
    const char* words;
  };
  guest.run("chmod 755 /; echo user:x:1000:1000::/:/bin/sh >/etc/passwd");
  for (const Refusal& refusal :
       {Refusal{"i2c=/dev/i2c-0,address=0x3d", "/dev/i2c-0: no device answers at the address 0x3d; check wires"},
        {"i2c=/dev/i2c-9", "/dev/i2c-9 cannot be opened: there is no such device; enable I2C"},
        {"i2c=/dev/null", "/dev/null is not an I2C bus"}}) {
    const Guest::Answer answer =
        guest.run(std::string("zstrip-panel /scene.zsc --frames 1 --display ssd1306:") + refusal.arguments);
    EXPECT_EQ(answer.status, 3) << answer.text;
    EXPECT_TRUE(contains(answer.text, refusal.words)) << answer.text;
  }
  const Guest::Answer denied = guest.run("su user -c 'zstrip-panel /scene.zsc --display ssd1306:i2c=/dev/i2c-0'");
  EXPECT_EQ(denied.status, 3) << denied.text;
  EXPECT_TRUE(contains(denied.text, "/dev/i2c-0 cannot be opened: no permission; join the group 'i2c'")) << denied.text;

  const Guest::Answer shown =
      guest.run("shows /scene.zsc --turn " + kTurn + " --frames 3 --display ssd1306:i2c=/dev/i2c-0,address=60");
  EXPECT_TRUE(contains(shown.text, "3 frames of 128x64")) << shown.text;
  {
    sim::Ssd1306Model panel;
    EXPECT_GT(replay(trace(), panel), 100);
    EXPECT_EQ(panel.darkness(), "");
    EXPECT_EQ(testing::PrintToString(panel.complaints()), "{}");
    const sim::RgbImage seen = panel.seen();
    const std::vector<std::byte> expected = host_frame_mono(2, kWidth, kHeight);
    ASSERT_EQ(seen.width, static_cast<std::uint32_t>(kWidth));
    ASSERT_EQ(seen.height, static_cast<std::uint32_t>(kHeight));
    int wrong = 0, lit = 0;
    for (unsigned y = 0; y < kHeight; ++y) {
      for (unsigned x = 0; x < kWidth; ++x) {
        const bool is_lit = (expected[y * kWidth / 8 + x / 8] & (std::byte{0x80} >> (x % 8))) != std::byte{0};
        lit += is_lit ? 1 : 0;
        wrong += (seen.pixel(x, y)[0] != 0) != is_lit ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << "pixels";
    EXPECT_GT(lit, 100);
    EXPECT_LT(lit, kWidth * kHeight - 100);
  }
  EXPECT_EQ(guest.run("ends TERM").status, 0);
  sim::Ssd1306Model panel;
  replay(trace(), panel);
  EXPECT_NE(panel.darkness(), "");
  EXPECT_EQ(testing::PrintToString(panel.complaints()), "{}");
}

// A device, or a short circuit, holds SCL low. The kernel's driver notices it within its 100 ms a try.
TEST(LinuxI2cStuck, SclThatIsHeldLowIsSaidSoon) {
  if (const std::string why = missing(Machine::armhf); !why.empty()) GTEST_SKIP() << why;
  Guest guest({.machine = Machine::armhf, .tree = "stuck-bus", .modules = "i2c_dev"});
  const Guest::Answer answer = guest.run("time zstrip-panel /scene.zsc --display ssd1306:i2c=/dev/i2c-0");
  EXPECT_EQ(answer.status, 3) << answer.text;
  EXPECT_TRUE(contains(answer.text, "/dev/i2c-0: no device answers at the address 0x3c; check wires")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "that nothing holds SCL or SDA low")) << answer.text;
  const std::size_t real = answer.text.find("real\t0m ");
  ASSERT_NE(real, std::string::npos) << answer.text;
  EXPECT_GE(std::stod(answer.text.substr(real + 8)), 0.1) << "the kernel waited for the line";
  EXPECT_LE(std::stod(answer.text.substr(real + 8)), 3.0);
}

}  // namespace
}  // namespace zstrip::linux_guest
