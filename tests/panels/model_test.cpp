// The models complain about what the real parts would not take, each complaint provoked with bytes written by hand, and
// show what the data sheets say.
#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "panel/dcs_model.hpp"
#include "panel/model_bus.hpp"
#include "panel/ssd0323_model.hpp"
#include "panel/ssd1306_model.hpp"
#include "panel/ssd1351_model.hpp"
#include "provocation.hpp"

namespace zstrip::sim {
namespace {

std::unique_ptr<DcsModel> st7789() { return std::make_unique<DcsModel>(kSt7789Part, Glass{.width = 4, .height = 3}); }

void start_dcs(Lines& lines) {
  lines.wait(120ms);
  lines.dcs(0x11);
  lines.wait(120ms);
  lines.dcs(0x3A, {0x55});
  lines.dcs(0x29);
}

void pixels(Lines& lines, std::initializer_list<int> bytes) { lines.dcs(0x2C, bytes); }

TEST(PanelModel, DcsComplains) {
  expect_complaints<DcsModel>(
      {
          {"more data than the command takes",
           [](Lines& l) {
             l.dcs(0x36, {0, 0});
           }},
          {"more data than the command takes", [](Lines& l) { l.dcs(0x29, {1}); }},
          {"too few parameters, command 2Ah",
           [](Lines& l) {
             l.dcs(0x2A, {0, 1, 0}), l.dcs(0x00);
           }},
          {"the ST7789 has no command 03h", [](Lines& l) { l.dcs(0x03); }},
          {"the ST7789 has no command FFh", [](Lines& l) { l.command({0xFF}); }},
          {"columns 0 to 240 of 240",
           [](Lines& l) {
             l.dcs(0x2A, {0, 0, 0, 240});
           }},
          {"columns 5 to 4 of 240",
           [](Lines& l) {
             l.dcs(0x2A, {0, 5, 0, 4});
           }},
          {"columns 256 to 319 of 240",
           [](Lines& l) {
             l.dcs(0x2A, {1, 0, 1, 63});
           }},
          {"rows 0 to 320 of 320",
           [](Lines& l) {
             l.dcs(0x2B, {0, 0, 1, 64});
           }},
          {"rows 0 to 319 of 240",
           [](Lines& l) {
             l.dcs(0x36, {0x20}), l.dcs(0x2B, {0, 0, 1, 63});
           }},
          {"the ST7789 has no pixel format 07h", [](Lines& l) { l.dcs(0x3A, {7}); }},
          {"the last pixel is not whole",
           [](Lines& l) {
             pixels(l, {1, 2, 3}), l.dcs(0x00);
           }},
          {"more pixels than the window has",
           [](Lines& l) {
             l.dcs(0x2A, {0, 0, 0, 1}), l.dcs(0x2B, {0, 0, 0, 0}), pixels(l, {1, 2, 3, 4, 5, 6});
           }},
          {"a pixel outside of the memory",  // the window was set in the other direction
           [](Lines& l) {
             l.dcs(0x2B, {1, 0, 1, 0}), l.dcs(0x36, {0x20}), pixels(l, {1, 2});
           }},
          {"pixels before sleep-out", [](Lines& l) { l.dcs(0x10), l.wait(5ms), pixels(l, {}); }},
          {"command 29h comes 4000 us too early", [](Lines& l) { l.dcs(0x10), l.wait(1ms), l.dcs(0x29); }},
          {"command 29h comes 1 us too early", [](Lines& l) { l.dcs(0x01), l.wait(5ms - 1ns), l.dcs(0x29); }},
          {"sleep-out too soon", [](Lines& l) { l.dcs(0x01), l.wait(119ms), l.dcs(0x11); }},
          {"sleep-out too soon", [](Lines& l) { l.dcs(0x10), l.wait(119ms), l.dcs(0x11); }},
          {"sleep-in too soon", [](Lines& l) { l.dcs(0x10), l.wait(120ms), l.dcs(0x11), l.wait(100ms), l.dcs(0x10); }},
          {"the reset line was low for 9000 ns",
           [](Lines& l) { l.panel.set_reset(false), l.wait(9us), l.panel.set_reset(true); }},
          {"bytes while the reset line is low", [](Lines& l) { l.panel.set_reset(false), l.dcs(0x00); }},
          {"sleep-out too soon",
           [](Lines& l) { l.panel.set_reset(false), l.wait(10us), l.panel.set_reset(true), l.wait(5ms), l.dcs(0x11); }},
          {"the bus sends a bit in 65 ns", [](Lines& l) { l.panel.clocked_at(65ns), l.panel.clocked_at(66ns); }},
      },
      st7789, start_dcs);
  const auto panel = st7789();
  Lines lines{*panel};
  lines.data({1});
  EXPECT_EQ(panel->complaints(), std::vector<std::string>{"data without a command, command 00h"});
}

TEST(PanelModel, DcsAnswers) {
  DcsModel panel(kSt7789Part, {.width = 1, .height = 1});
  Lines lines{panel};
  lines.wait(120ms);
  EXPECT_EQ(answer_of(panel, 0x04, 1, 3), (std::vector<int>{0x85, 0x85, 0x52}));
  EXPECT_EQ(answer_of(panel, 0x04, 0, 3), (std::vector<int>{0x42, 0xC2, 0xA9})) << "a dummy clock comes first";
  EXPECT_EQ(answer_of(panel, 0x04, 1, 4), (std::vector<int>{0x85, 0x85, 0x52, 0xFF})) << "then the line is not driven";
  EXPECT_EQ(answer_of(panel, 0xDA, 0, 1), std::vector<int>{0x85});
  EXPECT_EQ(answer_of(panel, 0xDB, 0, 1), std::vector<int>{0x85});
  EXPECT_EQ(answer_of(panel, 0xDC, 0, 1), std::vector<int>{0x52});
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  EXPECT_EQ(answer_of(panel, 0xD3, 0, 1), std::vector<int>{0xFF});
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{"the ST7789 does not answer command D3h"});
  panel.forgive();
  panel.ask(0x04, 25, 149ns);
  EXPECT_EQ(
      panel.complaints(),
      std::vector<std::string>{"the bus reads a bit in 149 ns, the controller's data sheet requires at least 150 ns"});
  panel.forgive();
  lines.command({0x01});
  answer_of(panel, 0x04, 1, 3);
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{"command 04h comes 5000 us too early"});
}

TEST(PanelModel, Ili9341AnswersByIndex) {
  DcsModel panel(kIli9341Part, {.width = 1, .height = 1});
  Lines lines{panel};
  lines.wait(120ms);
  EXPECT_EQ(answer_of(panel, 0xD3, 0, 1), std::vector<int>{0x00}) << "no index";
  std::vector<int> id;
  for (const int index : {1, 2, 3}) {
    lines.dcs(0xD9, {0x10 | index});
    id.push_back(answer_of(panel, 0xD3, 0, 1)[0]);
  }
  EXPECT_EQ(id, (std::vector<int>{0x00, 0x93, 0x41}));
  EXPECT_EQ(answer_of(panel, 0xD3, 0, 1), std::vector<int>{0x00}) << "an index is for one reading";
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
}

TEST(PanelModel, OledsDoNotAnswerOnASerialBus) {
  Ssd1306Model ssd1306;
  Ssd1351Model ssd1351;
  Ssd0323Model ssd0323;
  for (PanelModel* panel :
       {static_cast<PanelModel*>(&ssd1306), static_cast<PanelModel*>(&ssd1351), static_cast<PanelModel*>(&ssd0323)}) {
    EXPECT_EQ(answer_of(*panel, 0x04, 0, 1), std::vector<int>{0xFF});
    EXPECT_EQ(panel->complaints(),
              std::vector<std::string>{"command 04h is to be answered, which this part does not do on a serial bus"});
  }
}

TEST(PanelModel, DcsDiffers) {
  DcsModel ili9341(kIli9341Part, {.width = 1, .height = 1});
  Lines(ili9341).wait(120ms);
  Lines(ili9341).dcs(0x3A, {0x53});
  EXPECT_EQ(ili9341.complaints(), std::vector<std::string>{"the ILI9341 has no pixel format 53h"});
  DcsModel st7735(kSt7735Part, {.width = 1, .height = 1});
  Lines(st7735).wait(120ms);
  Lines(st7735).dcs(0x51, {255});
  EXPECT_EQ(st7735.complaints().at(0), "the ST7735 has no command 51h");
  DcsModel early(kSt7735Part, {.width = 1, .height = 1});
  Lines(early).wait(119ms);
  Lines(early).dcs(0x00);
  EXPECT_EQ(early.complaints().at(0), "command 00h comes 1000 us too early");
}

std::vector<int> colours(const RgbImage& image) { return {image.rgb.begin(), image.rgb.end()}; }

TEST(PanelModel, DcsShowsItsMemoryOnlyAwakeAndOn) {
  DcsModel panel(kSt7789Part, {.width = 2, .height = 1, .column_offset = 3, .row_offset = 5});
  Lines lines{panel};
  lines.wait(120ms);
  EXPECT_EQ(panel.darkness(), "the panel is asleep");
  lines.dcs(0x11);
  lines.wait(120ms);
  EXPECT_EQ(panel.darkness(), "the display is off");
  lines.dcs(0x3A, {0x55});
  lines.dcs(0x2A, {0, 3, 0, 4});
  lines.dcs(0x2B, {0, 5, 0, 5});
  lines.dcs(0x2C, {0xF8, 0x00, 0x07, 0xFF});
  EXPECT_EQ(colours(panel.seen()), (std::vector<int>{0, 0, 0, 0, 0, 0}));
  lines.dcs(0x29);
  EXPECT_EQ(colours(panel.seen()), (std::vector<int>{255, 0, 0, 0, 255, 255}));
  lines.dcs(0x21);
  EXPECT_EQ(colours(panel.seen()), (std::vector<int>{0, 255, 255, 255, 0, 0}));
  lines.dcs(0x20);
  lines.dcs(0x36, {0x08});
  EXPECT_EQ(colours(panel.seen()), (std::vector<int>{0, 0, 255, 255, 255, 0}));
  lines.dcs(0x36, {0x00});
  lines.dcs(0x2A, {0, 3, 0, 4});
  lines.dcs(0x3A, {0x53});
  lines.dcs(0x2C, {0x12, 0x34, 0x56});  // 4 bits abcd become abcdab, then abcdabab
  EXPECT_EQ(colours(panel.seen()), (std::vector<int>{0x10, 0x20, 0x30, 0x45, 0x55, 0x65}));
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
}

TEST(PanelModel, Ssd1351Complains) {
  expect_complaints<Ssd1351Model>(
      {
          {"a command that is locked", [](Lines& l) { l.dcs(0xA2, {0}); }},
          {"a command that is locked", [](Lines& l) { l.dcs(0xFD, {0x16}), l.dcs(0xAF); }},
          {"the command lock cannot be 1", [](Lines& l) { l.dcs(0xFD, {1}); }},
          {"too few parameters, command 15h", [](Lines& l) { l.command({0x15}), l.data({1}), l.command({0xB0}); }},
          {"the SSD1351 has no command 81h", [](Lines& l) { l.dcs(0x81); }},
          {"columns 0 to 128 of 128",
           [](Lines& l) {
             l.dcs(0x15, {0, 128});
           }},
          {"rows 9 to 8 of 128",
           [](Lines& l) {
             l.dcs(0x75, {9, 8});
           }},
          {"data without the command to write",
           [](Lines& l) {
             l.dcs(0x15, {0, 127}), l.data({1});
           }},
          {"the last pixel is not whole", [](Lines& l) { l.dcs(0x5C, {1}), l.dcs(0xAF); }},
          {"more pixels than the window has",
           [](Lines& l) {
             l.dcs(0x15, {0, 0}), l.dcs(0x75, {0, 0}), l.dcs(0x5C, {1, 2, 3, 4});
           }},
          {"the colour depth in the model cannot be 128", [](Lines& l) { l.dcs(0xA0, {0x80}); }},
          {"the start line cannot be 128", [](Lines& l) { l.dcs(0xA1, {128}); }},
          {"the offset cannot be 128", [](Lines& l) { l.dcs(0xFD, {0xB1}), l.dcs(0xA2, {128}); }},
          {"the master current cannot be 16", [](Lines& l) { l.dcs(0xC7, {16}); }},
          {"the multiplex ratio cannot be 14", [](Lines& l) { l.dcs(0xCA, {14}); }},
          {"the reset line was low for 1999 ns",
           [](Lines& l) { l.panel.set_reset(false), l.wait(1999ns), l.panel.set_reset(true); }},
          {"the bus sends a bit in 49 ns", [](Lines& l) { l.panel.clocked_at(49ns); }},
      },
      [] { return std::make_unique<Ssd1351Model>(); }, [](Lines& l) { l.dcs(0xAF); });
}

TEST(PanelModel, Ssd1306Complains) {
  expect_complaints<Ssd1306Model>(
      {
          {"data among the parameters of command 21h",
           [](Lines& l) {
             l.command({0x21, 0}), l.data({1});
           }},
          {"the SSD1306 has no command B8h", [](Lines& l) { l.command({0xB8}); }},
          {"columns 5 to 4 of 128",
           [](Lines& l) {
             l.command({0x21, 5, 4});
           }},
          {"pages 7 to 6 of 8",
           [](Lines& l) {
             l.command({0x22, 7, 6});
           }},
          {"the addressing mode cannot be 3",
           [](Lines& l) {
             l.command({0x20, 3});
           }},
          {"the charge pump cannot be 4",
           [](Lines& l) {
             l.command({0x8D, 4});
           }},
          {"the multiplex ratio cannot be 64",
           [](Lines& l) {
             l.command({0xA8, 64});
           }},
          {"the COM pins cannot be 64",
           [](Lines& l) {
             l.command({0xDA, 64});
           }},
          {"the bus sends a bit in 99 ns", [](Lines& l) { l.panel.clocked_at(99ns); }},
      },
      [] { return std::make_unique<Ssd1306Model>(); }, [](Lines& l) { l.command({0xAF}); });
}

TEST(PanelModel, Ssd1306ShowsWhyItIsDark) {
  Ssd1306Model panel({.height = 32, .com_alternating = false});
  Lines lines{panel};
  EXPECT_EQ(panel.darkness(), "the display is off");
  lines.command({0xAF});
  EXPECT_EQ(panel.darkness(), "the charge pump is off");
  lines.command({0x8D, 0x14, 0xA5, 0x2F});
  EXPECT_EQ(panel.darkness(), "all pixels are on");
  lines.command({0xA4});
  EXPECT_EQ(panel.darkness(), "the picture scrolls");
  lines.command({0x2E});
  EXPECT_EQ(panel.darkness(), "the COM lines are not split as the glass is wired");
  lines.command({0xDA, 0x02});
  EXPECT_EQ(panel.darkness(), "the multiplex ratio is not the glass's");
  lines.command({0xA8, 31});
  EXPECT_EQ(panel.darkness(), "");
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
}

TEST(PanelModel, Ssd0323Complains) {
  expect_complaints<Ssd0323Model>(
      {
          {"data among the parameters of command 15h",
           [](Lines& l) {
             l.command({0x15, 0}), l.data({1});
           }},
          {"the SSD0323 has no command 00h", [](Lines& l) { l.command({0x00}); }},
          {"columns 5 to 4 of 64",
           [](Lines& l) {
             l.command({0x15, 5, 4});
           }},
          {"rows 0 to 80 of 80",
           [](Lines& l) {
             l.command({0x75, 0, 80});
           }},
          {"the start line cannot be 80",
           [](Lines& l) {
             l.command({0xA1, 80});
           }},
          {"the offset cannot be 80",
           [](Lines& l) {
             l.command({0xA2, 80});
           }},
          {"the multiplex ratio cannot be 80",
           [](Lines& l) {
             l.command({0xA8, 80});
           }},
          {"the master configuration cannot be 1",
           [](Lines& l) {
             l.command({0xAD, 1});
           }},
          {"an increase of the grey table",
           [](Lines& l) {
             l.command({0xB8, 1, 0x11, 0x11, 0x01, 0x11, 0x11, 0x11, 0x11});
           }},
          {"the bus sends a bit in 249 ns", [](Lines& l) { l.panel.clocked_at(249ns); }},
      },
      [] { return std::make_unique<Ssd0323Model>(); }, [](Lines& l) { l.command({0xAF}); });
}

TEST(PanelModel, TheBusTakesTimeAndWatchesItsContract) {
  Ssd1306Model panel;
  ModelBus bus(panel, {.byte = 800ns, .transfer = 20us, .cycle = 100ns});
  constexpr std::byte kBytes[] = {std::byte{0xE3}, std::byte{0xE3}};
  EXPECT_EQ(bus.write_command(kBytes), hal::Error::none);
  EXPECT_EQ(bus.busy(), 21'600ns);
  EXPECT_EQ(bus.write_data(kBytes), hal::Error::none);
  EXPECT_EQ(bus.bytes(), 2U) << "data is taken late";
  EXPECT_EQ(bus.wait(), hal::Error::none);
  EXPECT_EQ(bus.bytes(), 4U);
  EXPECT_EQ(bus.busy(), 43'200ns);
  bus.wait(1000);
  EXPECT_EQ(panel.now(), 1'043'200ns);
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  EXPECT_EQ(bus.write_data(kBytes), hal::Error::none);
  EXPECT_EQ(bus.write_data(kBytes), hal::Error::none);
  EXPECT_EQ(bus.write_command(kBytes), hal::Error::none);
  EXPECT_EQ(panel.complaints(),
            (std::vector<std::string>{"data while other data is being sent", "a command while data is being sent"}));
}

}  // namespace
}  // namespace zstrip::sim
