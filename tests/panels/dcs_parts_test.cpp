// Controllers with MIPI's commands differ in some things: locked commands, round glasses, sizes and ids.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "panel/dcs_model.hpp"
#include "panel/model_bus.hpp"
#include "provocation.hpp"
#include "zstrip_hal/ili9488.hpp"
#include "zstrip_hal/st7735.hpp"
#include "zstrip_hal/st7796.hpp"

namespace zstrip::sim {
namespace {

struct NoClock {
  void wait(std::uint32_t /*microseconds*/) {}
};

/// Keeps the window that was set last.
struct WindowBus {
  using Range = std::vector<int>;  // the four parameters of the command
  Range columns, rows;
  std::byte command{};
  hal::Error write_command(std::span<const std::byte> bytes) {
    command = bytes.front();
    return hal::Error::none;
  }
  hal::Error write_data(std::span<const std::byte> bytes) {
    Range* const to = command == std::byte{0x2A} ? &columns : command == std::byte{0x2B} ? &rows : nullptr;
    if (to == nullptr) return hal::Error::none;
    to->clear();
    for (const std::byte byte : bytes) to->push_back(std::to_integer<int>(byte));
    return hal::Error::none;
  }
  hal::Error wait() { return hal::Error::none; }
};

std::function<std::unique_ptr<DcsModel>()> maker_of(const DcsPart& part) {
  return [&part] { return std::make_unique<DcsModel>(part, Glass{.width = 4, .height = 3}); };
}

/// Public drivers agree on the windows of 128x128 modules: rows 3 to 130 upright and on one side, 1 to 128 turned by
/// 180 degrees and on the other side. Rows were 31 to 158 there, as if the memory had 162.
TEST(PanelParts, St7735Of128x128BeginsAtRow1WhereRowsAreReversed) {
  for (const hal::Rotation by :
       {hal::Rotation::none, hal::Rotation::by_90, hal::Rotation::by_180, hal::Rotation::by_270}) {
    SCOPED_TRACE(static_cast<int>(by));
    WindowBus bus;
    NoClock clock;
    hal::St7735<WindowBus, NoClock, hal::St7735Rows132Controller> panel(bus, clock,
                                                                        turned(hal::kSt7735Module128x128, by));
    ASSERT_EQ(panel.start(), hal::Error::none);
    const bool reversed = by == hal::Rotation::by_180 || by == hal::Rotation::by_270;
    const WindowBus::Range rows = reversed ? WindowBus::Range{0, 1, 0, 128} : WindowBus::Range{0, 3, 0, 130};
    const WindowBus::Range columns{0, 2, 0, 129};
    const bool sideways = by == hal::Rotation::by_90 || by == hal::Rotation::by_270;
    EXPECT_EQ(bus.columns, sideways ? rows : columns);
    EXPECT_EQ(bus.rows, sideways ? columns : rows);
  }
}

void wake(Lines& lines) {
  lines.wait(120ms);
  lines.dcs(0x11);
  lines.wait(120ms);
  lines.dcs(0x3A, {0x55});
  lines.dcs(0x29);
}

TEST(PanelParts, Gc9a01Complains) {
  expect_complaints<DcsModel>(
      {
          {"a command that is locked, command EBh", [](Lines& l) { l.dcs(0xEB, {0x14}); }},
          {"a command that is locked, command EBh", [](Lines& l) { l.dcs(0xFE), l.dcs(0xEB, {0x14}); }},
          {"a command that is locked, command EBh", [](Lines& l) { l.dcs(0xEF), l.dcs(0xFE), l.dcs(0xEB, {0x14}); }},
          {"a command that is locked, command F0h",
           [](Lines& l) {
             l.dcs(0xFE), l.dcs(0xEF), l.dcs(0x01), l.wait(120ms), l.dcs(0xF0, {1, 2, 3, 4, 5, 6});
           }},
          {"too few parameters, command F0h",
           [](Lines& l) {
             l.dcs(0xFE), l.dcs(0xEF), l.dcs(0xF0, {1, 2, 3, 4, 5}), l.dcs(0x00);
           }},
          {"columns 0 to 240 of 240",
           [](Lines& l) {
             l.dcs(0x2A, {0, 0, 0, 240});
           }},
          {"rows 0 to 240 of 240",
           [](Lines& l) {
             l.dcs(0x2B, {0, 0, 0, 240});
           }},
          {"the GC9A01 has no command C0h", [](Lines& l) { l.command({0xC0}); }},
          {"the GC9A01 has no pixel format 53h", [](Lines& l) { l.dcs(0x3A, {0x53}); }},
          {"the bus sends a bit in 9 ns", [](Lines& l) { l.panel.clocked_at(9ns), l.panel.clocked_at(10ns); }},
      },
      maker_of(kGc9a01Part), wake);
}

TEST(PanelParts, St7796Complains) {
  expect_complaints<DcsModel>(
      {
          {"a command that is locked, command B4h", [](Lines& l) { l.dcs(0xB4, {1}); }},
          {"a command that is locked, command B4h", [](Lines& l) { l.dcs(0xF0, {0x96}), l.dcs(0xB4, {1}); }},
          {"a command that is locked, command B4h",
           [](Lines& l) {
             l.dcs(0xF0, {0xC3}), l.dcs(0xF0, {0x96}), l.dcs(0xB4, {1}), l.dcs(0xF0, {0x3C}), l.dcs(0xB4, {1});
           }},
          {"columns 0 to 320 of 320",
           [](Lines& l) {
             l.dcs(0x2A, {0, 0, 1, 64});
           }},
          {"rows 0 to 480 of 480",
           [](Lines& l) {
             l.dcs(0x2B, {0, 0, 1, 0xE0});
           }},
          {"rows 0 to 479 of 320",
           [](Lines& l) {
             l.dcs(0x36, {0x20}), l.dcs(0x2B, {0, 0, 1, 0xDF});
           }},
          {"the ST7796 has no command B9h", [](Lines& l) { l.command({0xB9}); }},
          {"the bus sends a bit in 65 ns", [](Lines& l) { l.panel.clocked_at(65ns), l.panel.clocked_at(66ns); }},
      },
      maker_of(kSt7796Part), wake);
}

TEST(PanelParts, Ili9342Complains) {
  expect_complaints<DcsModel>(
      {
          {"a command that is locked, command C1h", [](Lines& l) { l.dcs(0xC1, {3}); }},
          {"a command that is locked, command C1h",
           [](Lines& l) {
             l.dcs(0xC8, {0xFF, 0x93, 0x41}), l.dcs(0xC1, {3});
           }},
          {"columns 0 to 320 of 320",
           [](Lines& l) {
             l.dcs(0x2A, {0, 0, 1, 64});
           }},
          {"rows 0 to 240 of 240",
           [](Lines& l) {
             l.dcs(0x2B, {0, 0, 0, 240});
           }},
          {"columns 0 to 319 of 240",  // upright it is wide
           [](Lines& l) {
             l.dcs(0x36, {0x20}), l.dcs(0x2A, {0, 0, 1, 63});
           }},
          {"the ILI9342 has no command CBh", [](Lines& l) { l.command({0xCB}); }},
          {"the bus sends a bit in 99 ns", [](Lines& l) { l.panel.clocked_at(99ns), l.panel.clocked_at(100ns); }},
      },
      maker_of(kIli9342Part), wake);
}

TEST(PanelParts, Ili9488Complains) {
  expect_complaints<DcsModel>(
      {
          {"the ILI9488 has no pixel format 55h", [](Lines& l) { l.dcs(0x3A, {0x55}); }},
          {"the ILI9488 has no pixel format 53h", [](Lines& l) { l.dcs(0x3A, {0x53}); }},
          {"the last pixel is not whole",
           [](Lines& l) {
             l.dcs(0x2C, {1, 2}), l.dcs(0x00);
           }},
          {"more pixels than the window has",
           [](Lines& l) {
             l.dcs(0x2A, {0, 0, 0, 0}), l.dcs(0x2B, {0, 0, 0, 0}), l.dcs(0x2C, {1, 2, 3, 4, 5, 6});
           }},
          {"too few parameters, command C5h",
           [](Lines& l) {
             l.dcs(0xC5, {0, 0x12}), l.dcs(0x00);
           }},
          {"the ILI9488 has no command F0h", [](Lines& l) { l.command({0xF0}); }},
          {"the bus sends a bit in 49 ns", [](Lines& l) { l.panel.clocked_at(49ns), l.panel.clocked_at(50ns); }},
      },
      maker_of(kIli9488Part), [](Lines& l) {
        l.wait(120ms);
        l.dcs(0x11);
        l.wait(120ms);
        l.dcs(0x29);
      });
}

// Each colour of 16 bits, as the driver widens it, against the panel's own 16 bits of another part.
TEST(PanelParts, PixelsOf16BitsAreWidenedAsAControllerThatTakesThemWould) {
  constexpr std::uint16_t kSide = 256;
  const hal::DcsConfig glass{.width = kSide, .height = kSide};
  DcsModel wide(kIli9488Part, {.width = kSide, .height = kSide});
  DcsModel narrow(kSt7796Part, {.width = kSide, .height = kSide});
  ModelBus wide_bus(wide, {.byte = 400ns, .cycle = 50ns}), narrow_bus(narrow, {.byte = 800ns, .cycle = 100ns});
  hal::Ili9488 widening(wide_bus, wide_bus, glass);
  hal::St7796 plain(narrow_bus, narrow_bus, glass);
  wide_bus.wait(120'000), narrow_bus.wait(120'000);
  ASSERT_EQ(widening.start(), hal::Error::none);
  ASSERT_EQ(plain.start(), hal::Error::none);
  std::vector<std::byte> all;
  for (unsigned colour = 0; colour < 65536; ++colour) {
    all.push_back(static_cast<std::byte>(colour >> 8));
    all.push_back(static_cast<std::byte>(colour));
  }
  const std::uint64_t before = wide_bus.bytes();
  ASSERT_EQ(widening.write({0, 0, kSide, kSide}, all), hal::Error::none);
  ASSERT_EQ(widening.wait(), hal::Error::none);
  EXPECT_EQ(wide_bus.bytes() - before, 5U + 5U + 1U + 3U * 65536U);
  ASSERT_EQ(plain.write({0, 0, kSide, kSide}, all), hal::Error::none);
  ASSERT_EQ(plain.wait(), hal::Error::none);
  EXPECT_EQ(wide.seen().rgb, narrow.seen().rgb);
  EXPECT_EQ(wide.complaints(), std::vector<std::string>{});
  EXPECT_EQ(narrow.complaints(), std::vector<std::string>{});
}

TEST(PanelParts, EachAnswersWithItsId) {
  DcsModel gc9a01(kGc9a01Part, {.width = 1, .height = 1});
  Lines(gc9a01).wait(120ms);
  EXPECT_EQ(answer_of(gc9a01, 0x04, 1, 3), (std::vector<int>{0x00, 0x9A, 0x01}));
  DcsModel st7796(kSt7796Part, {.width = 1, .height = 1});
  Lines(st7796).wait(120ms);
  EXPECT_EQ(answer_of(st7796, 0xD3, 1, 3), (std::vector<int>{0x00, 0x77, 0x96}));
  DcsModel ili9342(kIli9342Part, {.width = 1, .height = 1});
  Lines(ili9342).wait(120ms);
  Lines(ili9342).dcs(0xD9, {0x13});
  EXPECT_EQ(answer_of(ili9342, 0xD3, 0, 1), std::vector<int>{0x42});
  DcsModel ili9488(kIli9488Part, {.width = 1, .height = 1});
  Lines(ili9488).wait(120ms);
  Lines(ili9488).dcs(0xFB, {0x12});
  EXPECT_EQ(answer_of(ili9488, 0xD3, 0, 1), std::vector<int>{0x94});
  for (const DcsModel* panel : {&gc9a01, &st7796, &ili9342, &ili9488})
    EXPECT_EQ(panel->complaints(), std::vector<std::string>{});
}

// A disc of diameter 5: the corners are not there, and neither do they show the memory's noise.
TEST(PanelParts, ARoundGlassHasNoCorners) {
  DcsModel panel(kGc9a01Part, {.width = 5, .height = 5, .is_round = true});
  Lines lines{panel};
  wake(lines);
  lines.dcs(0x2A, {0, 0, 0, 4});
  lines.dcs(0x2B, {0, 0, 0, 4});
  lines.dcs(0x2C);
  for (int i = 0; i < 50; ++i) lines.data({0xFF});
  const RgbImage seen = panel.seen();
  std::string rows;
  for (std::uint32_t y = 0; y < 5; ++y) {
    for (std::uint32_t x = 0; x < 5; ++x) rows += seen.pixel(x, y)[0] == 255 ? '#' : '.';
    rows += '\n';
  }
  EXPECT_EQ(rows, ".###.\n#####\n#####\n#####\n.###.\n");
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
}

}  // namespace
}  // namespace zstrip::sim
