// E-paper: the SSD1680's model complains about what the part would not take; its driver shows every frame by full and
// partial refreshes, waits for BUSY no longer than it says, and is right after every fault.
#include "zstrip_hal/ssd1680.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bench.hpp"
#include "panel/ssd1680_model.hpp"
#include "picture_strips.hpp"
#include "provocation.hpp"
#include "zstrip_hal/output_pin.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::panels {
namespace {

using sim::Ssd1680Model;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

/// The BUSY line, which may be stuck.
struct BusyLine {
  const Ssd1680Model* panel;
  const bool* stuck;
  Error read(bool& high) {
    high = *stuck || panel->is_busy();
    return Error::none;
  }
};

/// A panel with its driver, started, and the picture that it should show.
struct Paper {
  hal::Ssd1680Config config;
  Ssd1680Model panel;
  sim::ModelBus bus{panel, kSlow};
  bool stuck = false;
  std::vector<std::byte> memory;
  hal::Ssd1680<sim::ModelBus, BusyLine, sim::ModelBus> display;
  Picture expected;

  explicit Paper(const hal::Ssd1680Config& wanted, bool swaps_memories = false)
      : config(wanted),
        panel({.width = wanted.width,
               .height = wanted.height,
               .column_offset = wanted.column_offset,
               .sources_from_8 = wanted.sources_from_8,
               .swaps_memories = swaps_memories}),
        memory(decltype(display)::memory_bytes(wanted)),
        display(bus, {&panel, &stuck}, bus, memory, wanted),
        expected(black(display.width(), display.height())) {
    bus.wait(120'000);
  }

  Area whole() const { return {0, 0, display.width(), display.height()}; }
  Error write(const Area& area, const Picture& picture) {
    std::vector<std::byte> bytes = bytes_of(picture, area, DisplayFormat::mono);
    bytes.push_back(std::byte{0xFF});
    const Error error = display.write(area, bytes);
    if (error == Error::none) copy(picture, area, expected);
    return error == Error::none ? display.wait() : error;
  }
  /// A frame of one rectangle.
  Error show(const Area& area, const Picture& picture) {
    if (const Error error = display.begin_frame(); error != Error::none) return error;
    if (const Error error = write(area, picture); error != Error::none) return error;
    return display.end_frame();
  }
  Error reset_and_start() {
    ResetLine reset{&panel};
    if (const Error error = hal::reset_panel(reset, bus); error != Error::none) return error;
    return display.start();
  }
  Picture some(std::mt19937& random) const {
    return noise(display.width(), display.height(), DisplayFormat::mono, random);
  }
  std::string fault() const {
    if (!panel.complaints().empty()) return panel.complaints().front();
    if (!panel.darkness().empty()) return panel.darkness();
    return difference(picture_of(panel.seen()), on_glass(expected, config.orientation));
  }
};

constexpr hal::Ssd1680Config kSmall{.width = 21, .height = 14, .column_offset = 16};

Area any_area(const Paper& paper, std::mt19937& random) {
  const auto range = [&random](unsigned size) {
    const auto first = static_cast<std::uint16_t>(random() % size);
    return std::pair(first, static_cast<std::uint16_t>(1 + random() % (size - first)));
  };
  const auto [left, width] = range(paper.display.width());
  const auto [top, height] = range(paper.display.height());
  return {left, top, width, height};
}

TEST(PanelPaper, EveryOrientationShowsEveryRectangleByPartialRefreshes) {
  std::mt19937 random(1);
  for (const Orientation& orientation : kOrientations) {
    for (const bool swaps : {false, true}) {
      for (hal::Ssd1680Config config :
           {kSmall, hal::Ssd1680Config{.width = 122, .height = 250, .sources_from_8 = false},
            hal::Ssd1680Config{.width = 176}}) {
        config.orientation = orientation;
        Paper paper(config, swaps);
        ASSERT_EQ(paper.display.start(), Error::none);
        ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
        ASSERT_EQ(paper.fault(), "");
        for (int i = 0; i < 4; ++i) {
          ASSERT_EQ(paper.show(any_area(paper, random), paper.some(random)), Error::none);
          ASSERT_EQ(paper.fault(), "") << "frame " << i;
        }
      }
    }
  }
}

TEST(PanelPaper, TheFirstFrameIsFullAndThenEveryEleventh) {
  std::mt19937 random(2);
  Paper paper(kSmall);
  ASSERT_EQ(paper.display.start(), Error::none);
  EXPECT_EQ(paper.panel.full_refreshes() + paper.panel.partial_refreshes(), 0) << "the start keeps what is shown";
  std::vector<int> full;
  for (int i = 0; i < 23; ++i) {
    ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
    ASSERT_EQ(paper.fault(), "");
    full.push_back(paper.panel.full_refreshes());
  }
  EXPECT_EQ(std::vector<int>(full.begin(), full.begin() + 11), std::vector<int>(11, 1));
  EXPECT_EQ(std::vector<int>(full.begin() + 11, full.begin() + 22), std::vector<int>(11, 2));
  EXPECT_EQ(full[22], 3);
  hal::Ssd1680Config never = kSmall;
  never.partials = 0;
  Paper flashing(never);
  ASSERT_EQ(flashing.display.start(), Error::none);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(flashing.show(flashing.whole(), flashing.some(random)), Error::none);
  EXPECT_EQ(flashing.panel.full_refreshes(), 3);
}

TEST(PanelPaper, OnlyRowsThatDifferAreSentAndNothingForTheSamePicture) {
  std::mt19937 random(3);
  Paper paper({});
  ASSERT_EQ(paper.display.start(), Error::none);
  const Picture picture = paper.some(random);
  ASSERT_EQ(paper.show(paper.whole(), picture), Error::none);
  std::uint64_t before = paper.bus.bytes();
  ASSERT_EQ(paper.show(paper.whole(), picture), Error::none);
  EXPECT_EQ(paper.bus.bytes(), before);
  EXPECT_EQ(paper.panel.partial_refreshes(), 0);
  Picture other = picture;
  for (const unsigned y : {100U, 103U}) {
    for (std::uint8_t& channel : other.at(5, y)) channel = static_cast<std::uint8_t>(~channel);
  }
  ASSERT_EQ(paper.show(paper.whole(), other), Error::none);
  constexpr std::uint64_t kWindow = 3 + 5 + 2 + 3 + 1, kRefresh = 2 + 2 + 1;
  EXPECT_EQ(paper.bus.bytes() - before, 3 * (kWindow + 4 * 16) + kRefresh);
  EXPECT_EQ(paper.fault(), "");
  paper.display.clean();
  ASSERT_EQ(paper.show(paper.whole(), other), Error::none);
  EXPECT_EQ(paper.panel.full_refreshes(), 2) << "asked for";
}

TEST(PanelPaper, StripsOfAnyHeightBecomeOneRefresh) {
  std::mt19937 random(4);
  for (const Rotation rotation : {Rotation::none, Rotation::by_90, Rotation::by_180, Rotation::by_270}) {
    Paper paper({.width = 122, .height = 250, .orientation = {rotation, false}});
    ASSERT_EQ(paper.display.start(), Error::none);
    for (const std::uint16_t rows : {std::uint16_t{7}, std::uint16_t{16}}) {
      const Picture picture = paper.some(random);
      PictureStrips renderer{picture, DisplayFormat::mono, rows};
      const std::uint32_t bytes = rows * bytes_per_row(paper.display.width(), DisplayFormat::mono);
      std::vector<std::byte> first(bytes), second(bytes);
      const auto count = static_cast<std::uint16_t>((paper.display.height() + rows - 1) / rows);
      ASSERT_TRUE(hal::present(renderer, paper.display, {count, rows}, {first, second}));
      paper.expected = picture;
      EXPECT_EQ(paper.fault(), "");
    }
    EXPECT_EQ(paper.panel.full_refreshes(), 1);
    EXPECT_EQ(paper.panel.partial_refreshes(), 1);
  }
}

TEST(PanelPaper, AStuckBusyLineEndsInTimeAndTheNextFrameIsRight) {
  std::mt19937 random(5);
  for (const bool first : {true, false}) {
    hal::Ssd1680Config config = kSmall;
    config.busy_limit = 3000;
    Paper paper(config);
    ASSERT_EQ(paper.display.start(), Error::none);
    if (!first) {
      ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
    }
    paper.stuck = true;
    const sim::Nanoseconds before = paper.panel.now();
    EXPECT_EQ(paper.show(paper.whole(), paper.some(random)), Error::timeout);
    EXPECT_GE(paper.panel.now() - before, 3s);
    EXPECT_LE(paper.panel.now() - before, 3100ms);
    EXPECT_EQ(paper.panel.complaints(), std::vector<std::string>{}) << "nothing was sent to a busy panel";
    paper.stuck = false;
    ASSERT_EQ(paper.show({0, 0, 1, 1}, paper.expected), Error::none);
    EXPECT_EQ(paper.fault(), "");
    EXPECT_EQ(paper.panel.partial_refreshes(), 0);
  }
  // A refresh that takes longer than the limit: nothing is sent before it has ended.
  hal::Ssd1680Config hasty = kSmall;
  hasty.busy_limit = 1000;
  Paper paper(hasty);
  ASSERT_EQ(paper.display.start(), Error::none);
  EXPECT_EQ(paper.show(paper.whole(), paper.some(random)), Error::timeout);
  EXPECT_EQ(paper.display.end_frame(), Error::timeout) << "ready again after 700 ms, then the same";
  EXPECT_EQ(paper.panel.complaints(), std::vector<std::string>{});
}

TEST(PanelPaper, AFrameThatBreaksOffAtAnyStepIsReportedAndTheNextIsRight) {
  std::mt19937 random(6);
  for (const bool swaps : {false, true}) {
    Paper paper(kSmall, swaps);
    ASSERT_EQ(paper.display.start(), Error::none);
    ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
    int at = 0, failures = 0;
    for (bool failed = true; failed; ++at) {
      for (const unsigned arriving : {0U, 1U, 2U, 3U, 4U}) {
        SCOPED_TRACE(testing::Message() << "transfer " << at << ", " << arriving << " quarters arrive");
        ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none) << "a full one, after an error";
        paper.bus.fail_at(paper.bus.transfers() + at, arriving);
        const Error error = paper.show(paper.whole(), paper.some(random));
        failed = error != Error::none;
        if (!failed) break;
        ASSERT_EQ(error, Error::bus);
        ++failures;
        ASSERT_EQ(paper.show({0, 0, 1, 1}, paper.expected), Error::none);
        ASSERT_EQ(paper.fault(), "");
      }
    }
    EXPECT_EQ(failures, 5 * (at - 1));
    EXPECT_GT(at, 30);
  }
}

TEST(PanelPaper, AStartThatBreaksOffAtAnyStepIsReportedAndCanBeRepeated) {
  std::mt19937 random(7);
  int transfers = 0;
  {
    Paper paper(kSmall);
    ASSERT_EQ(paper.display.start(), Error::none);
    transfers = paper.bus.transfers();
  }
  for (int at = 0; at < transfers; ++at) {
    Paper paper(kSmall);
    paper.bus.fail_at(at, 2);
    ASSERT_EQ(paper.display.start(), Error::bus) << "transfer " << at;
    ASSERT_EQ(paper.reset_and_start(), Error::none) << "transfer " << at;
    ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
    ASSERT_EQ(paper.fault(), "") << "transfer " << at;
  }
}

TEST(PanelPaper, DeepSleepKeepsThePictureUntilAReset) {
  std::mt19937 random(8);
  Paper paper(kSmall);
  ASSERT_EQ(paper.display.start(), Error::none);
  ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
  ASSERT_EQ(paper.display.sleep(), Error::none);
  EXPECT_EQ(paper.fault(), "");
  EXPECT_EQ(paper.display.start(), Error::timeout);
  EXPECT_EQ(paper.fault(), "") << "nothing was sent";
  ASSERT_EQ(paper.reset_and_start(), Error::none);
  EXPECT_EQ(paper.fault(), "");
  ASSERT_EQ(paper.show(paper.whole(), paper.some(random)), Error::none);
  EXPECT_EQ(paper.fault(), "");
  EXPECT_EQ(paper.panel.full_refreshes(), 2);
}

TEST(PanelPaper, WhatCannotBeIsRefusedAndNothingSent) {
  for (const hal::Ssd1680Config& wrong :
       {hal::Ssd1680Config{.width = 0}, hal::Ssd1680Config{.width = 177}, hal::Ssd1680Config{.height = 0},
        hal::Ssd1680Config{.height = 297}, hal::Ssd1680Config{.column_offset = 4},
        hal::Ssd1680Config{.column_offset = 56}}) {
    Paper paper(kSmall);
    hal::Ssd1680 display(paper.bus, BusyLine{&paper.panel, &paper.stuck}, paper.bus, paper.memory, wrong);
    EXPECT_EQ(display.start(), Error::configuration);
    EXPECT_EQ(paper.bus.transfers(), 0);
  }
  Paper paper(kSmall);
  std::vector<std::byte> less(paper.memory.size() - 1), pixels(3 * 14);
  hal::Ssd1680 display(paper.bus, BusyLine{&paper.panel, &paper.stuck}, paper.bus, std::span(less), kSmall);
  EXPECT_EQ(display.start(), Error::framebuffer);
  EXPECT_EQ(display.write({0, 0, 21, 14}, pixels), Error::framebuffer);
  ASSERT_EQ(paper.display.start(), Error::none);
  EXPECT_EQ(paper.display.write({0, 0, 22, 14}, pixels), Error::area);
  EXPECT_EQ(paper.display.write({0, 0, 21, 15}, pixels), Error::area);
  EXPECT_EQ(paper.display.write({1, 1, 0, 1}, pixels), Error::area);
  pixels.pop_back();
  EXPECT_EQ(paper.display.write({0, 0, 21, 14}, pixels), Error::pixels_too_small);
}

}  // namespace
}  // namespace zstrip::panels

namespace zstrip::sim {
namespace {

TEST(PanelModel, Ssd1680Complains) {
  const auto window = [](Lines& l) {
    l.dcs(0x44, {0, 0}), l.dcs(0x45, {0, 0, 1, 0}), l.dcs(0x4E, {0}), l.dcs(0x4F, {0, 0});
  };
  expect_complaints<Ssd1680Model>(
      {
          {"command 22h while the panel is busy", [](Lines& l) { l.dcs(0x20), l.wait(1699ms), l.dcs(0x22, {0xF7}); }},
          {"command 24h while the panel is busy", [](Lines& l) { l.dcs(0x12), l.wait(9ms), l.dcs(0x24); }},
          {"command 26h while the panel is busy",
           [](Lines& l) { l.dcs(0x22, {0xFF}), l.dcs(0x20), l.wait(499ms), l.dcs(0x26), l.wait(1ms), l.dcs(0x26); }},
          {"command 12h in deep sleep", [](Lines& l) { l.dcs(0x10, {1}), l.dcs(0x12); }},
          {"the deep sleep mode cannot be 2", [](Lines& l) { l.dcs(0x10, {2}); }},
          {"columns of 8 pixels 0 to 22 of 22",
           [](Lines& l) {
             l.dcs(0x44, {0, 22});
           }},
          {"columns of 8 pixels 5 to 4 of 22",
           [](Lines& l) {
             l.dcs(0x44, {5, 4});
           }},
          {"rows 0 to 296 of 296",
           [](Lines& l) {
             l.dcs(0x45, {0, 0, 0x28, 1});
           }},
          {"the counters 0, 9 are outside of the window",
           [window](Lines& l) {
             window(l), l.dcs(0x4F, {9, 0}), l.dcs(0x24);
           }},
          {"more pixels than the window has",
           [window](Lines& l) {
             window(l), l.dcs(0x24, {1, 2, 3});
           }},
          {"data without the command to write", [window](Lines& l) { window(l), l.data({1}); }},
          {"too few parameters, command 45h",
           [](Lines& l) {
             l.dcs(0x45, {0, 0, 1}), l.dcs(0x7F);
           }},
          {"the last gate line cannot be 296",
           [](Lines& l) {
             l.dcs(0x01, {0x28, 1, 0});
           }},
          {"the data entry mode in the model cannot be 1", [](Lines& l) { l.dcs(0x11, {1}); }},
          {"the temperature is read from an external sensor", [](Lines& l) { l.dcs(0x18, {0x48}), l.dcs(0x20); }},
          {"a refresh without clock and supply", [](Lines& l) { l.dcs(0x22, {0x34}), l.dcs(0x20); }},
          {"a refresh without a waveform", [](Lines& l) { l.dcs(0x22, {0xC7}), l.dcs(0x20); }},
          {"the SSD1680 has no command AFh", [](Lines& l) { l.command({0xAF}); }},
          {"the reset line was low for 9000 ns",
           [](Lines& l) { l.panel.set_reset(false), l.wait(9us), l.panel.set_reset(true); }},
          {"the bus sends a bit in 49 ns", [](Lines& l) { l.panel.clocked_at(49ns), l.panel.clocked_at(50ns); }},
      },
      [] { return std::make_unique<Ssd1680Model>(); },
      [](Lines& l) {
        l.dcs(0x12), l.wait(10ms), l.dcs(0x18, {0x80}), l.dcs(0x21, {0, 0x80}), l.dcs(0x22, {0xF7});
      });
}

/// One row of 16 pixels, from one byte each of both memories.
std::string row_of(const Ssd1680Model& panel) {
  const RgbImage seen = panel.seen();
  std::string row;
  for (std::uint32_t x = 0; x < seen.width; ++x) row += seen.pixel(x, 0)[0] != 0 ? '#' : '.';
  return row;
}

TEST(PanelModel, Ssd1680MovesOnlyPixelsThatDifferFromItsSecondMemory) {
  for (const bool swaps : {false, true}) {
    Ssd1680Model panel({.width = 8, .height = 1, .sources_from_8 = false, .swaps_memories = swaps});
    Lines lines{panel};
    const auto picture = [&lines](int command, int byte) {
      lines.dcs(0x4E, {0}), lines.dcs(0x4F, {0, 0}), lines.dcs(command, {byte});
    };
    const auto refresh = [&lines](int sequence) { lines.dcs(0x22, {sequence}), lines.dcs(0x20), lines.wait(2000ms); };
    lines.dcs(0x18, {0x80}), lines.dcs(0x44, {0, 0}), lines.dcs(0x45, {0, 0, 0, 0});
    EXPECT_EQ(panel.darkness(), "the panel was never refreshed");
    picture(0x24, 0xF0);
    lines.dcs(0x22, {0xF7}), lines.dcs(0x20);
    EXPECT_EQ(panel.darkness(), "the panel is being refreshed");
    lines.wait(1700ms);
    EXPECT_EQ(panel.darkness(), "the gate lines are not as many as the glass has");
    lines.dcs(0x01, {0, 0, 0}), lines.dcs(0x21, {0, 0x80});
    refresh(0xF7);
    EXPECT_EQ(panel.darkness(), "the glass is wired to other source lines");
    lines.dcs(0x21, {0, 0x00});
    refresh(0xF7);
    EXPECT_EQ(panel.darkness(), "");
    EXPECT_EQ(row_of(panel), "####....");
    picture(0x26, 0xCC), picture(0x24, 0x0F);
    refresh(0xFF);
    EXPECT_EQ(row_of(panel), "..##..##") << "only bits of C3 moved";
    refresh(0xFF);
    EXPECT_EQ(row_of(panel), swaps ? "####...." : "..##..##");
    EXPECT_EQ(panel.refreshing(), 3 * 1700ms + 2 * 500ms);
    EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace zstrip::sim
