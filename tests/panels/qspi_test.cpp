// QSPI: the bytes of its transfers, what models refuse of them, and orientations that AMOLED controllers do not have.
#include "zstrip_hal/qspi.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"
#include "provocation.hpp"

namespace zstrip::panels {
namespace {

using sim::DcsModel;
using sim::ModelBus;

/// The transfers of a bus, one text each: header, lines, data.
struct Wires {
  std::vector<std::string> transfers;
  Error write(std::span<const std::byte, 4> header, std::span<const std::byte> data, unsigned lines) {
    std::string text;
    const auto add = [&text](std::byte byte) {
      constexpr const char* kDigits = "0123456789ABCDEF";
      text += kDigits[std::to_integer<unsigned>(byte) >> 4];
      text += kDigits[std::to_integer<unsigned>(byte) & 15U];
    };
    for (const std::byte byte : header) add(byte);
    text += '/' + std::to_string(lines) + '/';
    for (const std::byte byte : data) add(byte);
    transfers.push_back(text);
    return Error::none;
  }
  Error wait() { return Error::none; }
};
struct NoTime {
  void wait(std::uint32_t /*microseconds*/) {}
};

TEST(PanelQspi, ACommandHasItsParametersAndPixelsTheirs) {
  Wires wires;
  NoTime clock;
  hal::QspiBus bus(wires);
  static_assert(hal::CommandDataBus<hal::QspiBus<Wires>>);
  hal::Co5300 panel(bus, clock);
  ASSERT_EQ(panel.sleep(), Error::none);
  const std::vector<std::byte> pixels(2 * 2 * 2, std::byte{0xA5});
  ASSERT_EQ(panel.write({2, 256, 2, 2}, pixels), Error::none);
  EXPECT_EQ(wires.transfers, (std::vector<std::string>{"02002800/1/", "02001000/1/", "02002A00/1/00080009",
                                                       "02002B00/1/01000101", "32002C00/4/A5A5A5A5A5A5A5A5"}));
  wires.transfers.clear();
  ASSERT_EQ(hal::send_zeros(bus, 66), Error::none);
  EXPECT_EQ(wires.transfers.back(), "32003C00/4/0000") << "goes on";
}

TEST(PanelQspi, OrientationsAndEdgesThatAControllerDoesNotHaveAreRefused) {
  for (const Orientation& orientation : kOrientations) {
    const hal::Scan scan = scan_of(orientation);
    Bench<Co5300> co5300({.width = 34, .height = 22, .orientation = orientation});
    EXPECT_EQ(co5300.display.start(), scan.exchanged ? Error::configuration : Error::none);
    Bench<Sh8601> sh8601({.width = 34, .height = 22, .orientation = orientation});
    EXPECT_EQ(sh8601.display.start(), scan.exchanged || scan.rows_reversed ? Error::configuration : Error::none);
    Bench<St77916> st77916({.width = 34, .height = 22, .orientation = orientation});
    EXPECT_EQ(st77916.display.start(), Error::none);
  }
  for (const hal::DcsConfig& odd :
       {hal::DcsConfig{.width = 33, .height = 22}, hal::DcsConfig{.width = 34, .height = 21},
        hal::DcsConfig{.width = 34, .height = 22, .column_offset = 1},
        hal::DcsConfig{.width = 34, .height = 22, .row_offset = 1}}) {
    Bench<Co5300> bench(odd);
    EXPECT_EQ(bench.display.start(), Error::configuration);
    EXPECT_EQ(bench.bus.transfers(), 0);
  }
  Bench<Co5300> wide({.width = 34, .height = 22, .format = DisplayFormat::rgb666});
  EXPECT_EQ(wide.display.start(), Error::configuration);
}

// Eight bits on four lines take two cycles, a header 32.
TEST(PanelQspi, PixelsTakeAQuarterOfTheTime) {
  Bench<St77916> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  const sim::Nanoseconds before = bench.bus.busy();
  const std::vector<std::byte> pixels(2 * 34 * 22);
  ASSERT_EQ(bench.display.write(bench.whole(), pixels), Error::none);
  ASSERT_EQ(bench.display.wait(), Error::none);
  EXPECT_EQ(bench.bus.busy() - before, (2 * (32 + 4 * 8) + 32 + 2 * 34 * 22 * 2) * kSlow.cycle);
}

/// Sends a transfer to a model by hand.
void transfer(sim::Lines& lines, std::initializer_list<int> header, std::initializer_list<int> data, unsigned wires) {
  const auto bytes = [](std::initializer_list<int> values) {
    std::vector<std::byte> result;
    for (const int value : values) result.push_back(static_cast<std::byte>(value));
    return result;
  };
  lines.panel.receive_phases(bytes(header), bytes(data), wires);
}
void command(sim::Lines& lines, int code, std::initializer_list<int> parameters = {}) {
  transfer(lines, {0x02, 0, code, 0}, parameters, 1);
}

TEST(PanelQspi, TheModelComplains) {
  using sim::Lines;
  sim::expect_complaints<DcsModel>(
      {
          {"a byte with D/C, which is not on QSPI", [](Lines& l) { l.command({0x00}); }},
          {"the CO5300 has no opcode 12h",
           [](Lines& l) {
             transfer(l, {0x12, 0, 0x2C, 0}, {1, 2}, 4);
           }},
          {"command 00h is not between two zeros",
           [](Lines& l) {
             transfer(l, {0x02, 0x2A, 0, 0}, {}, 1);
           }},
          {"command 29h is not between two zeros",
           [](Lines& l) {
             transfer(l, {0x02, 0, 0x29, 1}, {}, 1);
           }},
          {"command 2Ah by opcode 32h",
           [](Lines& l) {
             transfer(l, {0x32, 0, 0x2A, 0}, {0, 0, 0, 1}, 4);
           }},
          {"opcode 32h with data on 1 lines",
           [](Lines& l) {
             transfer(l, {0x32, 0, 0x2C, 0}, {1, 2}, 1);
           }},
          {"opcode 02h with data on 4 lines",
           [](Lines& l) {
             transfer(l, {0x02, 0, 0x36, 0}, {0}, 4);
           }},
          {"pixels go on that never began",
           [](Lines& l) {
             transfer(l, {0x32, 0, 0x3C, 0}, {1, 2}, 4);
           }},
          {"more data than the command takes",
           [](Lines& l) {
             command(l, 0x36, {0, 0});
           }},
          {"too few parameters, command 2Ah",
           [](Lines& l) {
             command(l, 0x2A, {0, 0}), command(l, 0x00);
           }},
          {"columns 1 to 4 do not begin at an even one",
           [](Lines& l) {
             command(l, 0x2A, {0, 1, 0, 4});
           }},
          {"rows 2 to 4 do not begin at an even one",
           [](Lines& l) {
             command(l, 0x2B, {0, 2, 0, 4});
           }},
          {"columns 0 to 480 of 480",
           [](Lines& l) {
             command(l, 0x2A, {0, 0, 1, 0xE0});
           }},
          {"the CO5300 has no memory access 20h", [](Lines& l) { command(l, 0x36, {0x20}); }},
          {"the CO5300 has no command C0h", [](Lines& l) { command(l, 0xC0); }},
          {"bytes while the reset line is low", [](Lines& l) { l.panel.set_reset(false), command(l, 0x00); }},
          {"the bus sends a bit in 19 ns", [](Lines& l) { l.panel.clocked_at(sim::Nanoseconds(19)); }},
      },
      [] { return std::make_unique<DcsModel>(sim::kCo5300Part, sim::Glass{.width = 4, .height = 4}); },
      [](Lines& l) {
        l.wait(std::chrono::milliseconds(120));
        command(l, 0x11);
        l.wait(std::chrono::milliseconds(120));
        command(l, 0x3A, {0x55});
      });
}

TEST(PanelQspi, AnAmoledIsDarkWithoutBrightness) {
  DcsModel panel(sim::kCo5300Part, {.width = 2, .height = 2});
  sim::Lines lines{panel};
  lines.wait(std::chrono::milliseconds(120));
  command(lines, 0x11);
  lines.wait(std::chrono::milliseconds(120));
  command(lines, 0x29);
  EXPECT_EQ(panel.darkness(), "the brightness is 0");
  command(lines, 0x51, {200});
  EXPECT_EQ(panel.darkness(), "the brightness is 0");
  command(lines, 0x53, {0x20});
  EXPECT_EQ(panel.darkness(), "");
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
}

TEST(PanelQspi, APartWithoutItComplains) {
  DcsModel panel(sim::kSt7789Part, {.width = 2, .height = 2});
  sim::Lines lines{panel};
  lines.wait(std::chrono::milliseconds(120));
  command(lines, 0x11);
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{"a transfer on QSPI, which this part does not have"});
}

}  // namespace
}  // namespace zstrip::panels
