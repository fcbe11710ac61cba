// RGB panels: the model complains about signals that the glass does not allow; the driver feeds its controller from two
// strips, says which strip came too late, and is right from the next refresh on.
#include "zstrip_hal/scanned_panel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "panel/rgb_model.hpp"
#include "panel/rgb_scanner.hpp"
#include "picture.hpp"
#include "provocation.hpp"

namespace zstrip::panels {
namespace {

using hal::Area;
using hal::Error;
using sim::RgbLimits;
using sim::RgbModel;
using sim::RgbScanner;
using sim::RgbTimings;
using std::chrono_literals::operator""ns;
using std::chrono_literals::operator""ms;

constexpr RgbLimits kSmallGlass{.width = 34,
                                .height = 22,
                                .shortest_pixel = 83ns,
                                .longest_pixel = 2000ns,
                                .column_pulse = {1, 9},
                                .column_back = {1, 9},
                                .column_front = {1, 9},
                                .row_pulse = {1, 9},
                                .row_back = {1, 9},
                                .row_front = {1, 9}};
/// A row takes 40 us.
constexpr RgbTimings kSmallTimings{.width = 34, .height = 22, .pixel = 1000ns, .columns = {1, 2, 3}, .rows = {1, 2, 3}};

/// A glass, its controller, the driver, and what is asked for.
struct Scanned {
  std::uint16_t rows;
  RgbModel panel{kSmallGlass};
  RgbScanner scanner;
  hal::ScannedPanel<RgbScanner> driver;
  bool copies = false;  // strips are drawn elsewhere
  int asked_for = -1;
  std::uint16_t strip_added = 0;   // to the strip that is asked for
  std::size_t bytes_left_out = 0;  // of the buffer

  explicit Scanned(std::uint16_t rows_of_strip, std::uint16_t rows_of_driver = 0)
      : rows(rows_of_strip),
        scanner(panel, kSmallTimings, rows,
                [this](std::span<std::byte> buffer, std::uint16_t strip) {
                  asked_for = strip;
                  driver.ask(buffer.first(buffer.size() - bytes_left_out),
                             static_cast<std::uint16_t>(strip + strip_added));
                }),
        driver(scanner, {.width = 34, .height = 22, .rows = rows_of_driver != 0 ? rows_of_driver : rows}) {}

  hal::StripLayout layout() const { return {static_cast<std::uint16_t>((22 + rows - 1) / rows), rows, 0}; }
  /// Says what is wrong on the glass when all of the frame was read.
  std::string fault(const Picture& expected) {
    for (int i = 0; i < 10'000 && asked_for != 0; ++i) scanner.wait(1);
    scanner.show_rest();
    if (!panel.complaints().empty()) return panel.complaints().front();
    if (!panel.darkness().empty()) return panel.darkness();
    return difference(picture_of(panel.seen()), expected);
  }
};

struct ScanStatus {
  bool is_right = true;
  explicit operator bool() const { return is_right; }
};

/// Strips of a picture in RGB565, low byte first, that take time.
struct SlowStrips {
  const Picture& picture;
  std::uint16_t rows;
  RgbScanner& clock;
  std::function<std::uint32_t(std::uint16_t)> microseconds;
  ScanStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) const {
    clock.wait(microseconds(strip));
    const unsigned top = strip * unsigned{rows}, bottom = std::min<unsigned>(top + rows, picture.height);
    std::size_t next = 0;
    for (unsigned y = top; y < bottom; ++y) {
      for (unsigned x = 0; x < picture.width; ++x) {
        const auto& [red, green, blue] = picture.at(x, y);
        const unsigned pixel = unsigned{red} >> 3 << 11 | unsigned{green} >> 2 << 5 | unsigned{blue} >> 3;
        pixels[next++] = static_cast<std::byte>(pixel);
        pixels[next++] = static_cast<std::byte>(pixel >> 8);
      }
    }
    return {};
  }
};

/// Random pixels; the glass repeats the upper bits of a channel below its lower ones.
Picture some(std::mt19937& random) {
  Picture picture = black(34, 22);
  for (auto& [red, green, blue] : picture.pixels) {
    const unsigned pixel = static_cast<unsigned>(random());
    const auto five = [](unsigned value) { return static_cast<std::uint8_t>(value % 32 * 8 + value % 32 / 4); };
    red = five(pixel), blue = five(pixel >> 8);
    green = static_cast<std::uint8_t>((pixel >> 16) % 64 * 4 + (pixel >> 16) % 64 / 16);
  }
  return picture;
}

/// A frame of noise, drawn in the controller's memory, or elsewhere and copied.
auto show(Scanned& scanned, const Picture& picture, const std::function<std::uint32_t(std::uint16_t)>& microseconds) {
  SlowStrips strips{picture, scanned.rows, scanned.scanner, microseconds};
  std::vector<std::byte> pixels(std::size_t{2} * 34 * scanned.rows);
  return scanned.copies ? hal::present(strips, scanned.driver, scanned.layout(), {pixels, {}})
                        : hal::present(strips, scanned.driver, scanned.layout());
}
std::uint32_t at_once(std::uint16_t /*strip*/) { return 0; }

TEST(PanelScanned, EveryFrameIsOnTheGlassInStripsOfAnyHeight) {
  std::mt19937 random(1);
  for (const std::uint16_t rows : {std::uint16_t{1}, std::uint16_t{4}, std::uint16_t{5}, std::uint16_t{11}}) {
    for (const bool copies : {false, true}) {
      Scanned scanned(rows);
      scanned.copies = copies;
      scanned.scanner.start();
      const sim::Nanoseconds before = scanned.panel.now();
      for (int frame = 0; frame < 5; ++frame) {
        const Picture picture = some(random);
        // Nearly as long as a strip is read: 40 us a row. The first one has the time of the last one.
        const std::uint32_t last = 22U - (scanned.layout().count - 1U) * rows;
        const auto slowly = [=](std::uint16_t strip) { return 36U * (strip == 0 ? last : rows); };
        ASSERT_TRUE(show(scanned, picture, slowly)) << rows;
        ASSERT_EQ(scanned.fault(picture), "") << rows << " rows, frame " << frame;
      }
      // The first frame waits for its first strip to be asked for again.
      EXPECT_LE(scanned.panel.now() - before, 6 * kSmallTimings.frame_time());
      EXPECT_GE(scanned.panel.now() - before, 5 * kSmallTimings.frame_time());
    }
  }
}

/// Whatever goes wrong is an error of the frame, and the next frame is right.
TEST(PanelScanned, FaultsAreReportedAndTheNextFrameIsRight) {
  struct Fault {
    const char* what;
    Error error;
    int strip;  // at which it is noticed; -1: at any
    std::function<void(Scanned&)> begin;
    std::function<std::uint32_t(Scanned&, std::uint16_t)> draw;
    std::function<void(Scanned&)> end;
  };
  const auto nothing = [](Scanned&) {};
  const auto quick = [](Scanned&, std::uint16_t) { return 0U; };
  // A strip of four rows is read in 160 us, the last one in 80 us. A strip that is copied has the time of another one.
  const auto late = [](std::uint16_t strip, std::uint32_t microseconds) {
    return [=](Scanned& scanned, std::uint16_t each) {
      return each != strip ? 0 : microseconds + (scanned.copies ? 160 : 0);
    };
  };
  const std::vector<Fault> faults{
      {"a late strip", Error::underrun, 3, nothing, late(3, 170), nothing},
      {"a strip that takes three", Error::underrun, 3, nothing, late(3, 500), nothing},
      {"a strip that takes a frame", Error::underrun, 3, nothing, late(3, 1'200), nothing},
      {"a late last strip", Error::underrun, 5, nothing, late(5, 170), nothing},
      {"a late first strip", Error::underrun, 0, nothing, late(0, 90), nothing},
      {"a frame that begins too late", Error::underrun, 0, [](Scanned& s) { s.scanner.wait(700); }, quick, nothing},
      {"a frame that is left out", Error::underrun, 0, [](Scanned& s) { s.scanner.wait(1'120); }, quick, nothing},
      {"a buffer that is too small", Error::pixels_too_small, -1, [](Scanned& s) { s.bytes_left_out = 1; }, quick,
       [](Scanned& s) { s.bytes_left_out = 0; }},
      {"a strip that the layout lacks", Error::strip_layout, -1, [](Scanned& s) { s.strip_added = 6; }, quick,
       [](Scanned& s) { s.strip_added = 0; }},
      {"a clock that stands still", Error::timeout, -1, [](Scanned& s) { s.scanner.stop(); }, quick,
       [](Scanned& s) { s.scanner.start(); }},
      {"a clock that stops in a frame", Error::timeout, -1, nothing,
       [](Scanned& s, std::uint16_t strip) {
         if (strip == 3) s.scanner.stop();
         return 0U;
       },
       [](Scanned& s) { s.scanner.start(); }},
  };
  std::mt19937 random(2);
  for (const Fault& fault : faults) {
    for (const bool copies : {false, true}) {
      SCOPED_TRACE(testing::Message() << fault.what << (copies ? ", copied" : ""));
      Scanned scanned(4);
      scanned.copies = copies;
      scanned.scanner.start();
      const Picture first = some(random);
      ASSERT_TRUE(show(scanned, first, at_once));
      ASSERT_EQ(scanned.fault(first), "");
      fault.begin(scanned);
      const auto result = show(scanned, some(random), [&](std::uint16_t strip) { return fault.draw(scanned, strip); });
      EXPECT_EQ(result.display, fault.error);
      if (fault.strip >= 0) {
        EXPECT_EQ(result.strip, fault.strip);
      }
      if (fault.error == Error::timeout) {
        scanned.scanner.wait(1000);
        EXPECT_EQ(scanned.panel.darkness(), "the pixel clock stands still");
      }
      fault.end(scanned);
      const Picture next = some(random);
      ASSERT_TRUE(show(scanned, next, at_once));
      EXPECT_EQ(scanned.fault(next), "");
    }
  }
}

/// A clock that tells after each microsecond.
struct WatchedClock {
  RgbScanner& scanner;
  std::function<void()> passed;
  void wait(std::uint32_t microseconds) {
    for (; microseconds > 0; --microseconds) scanner.wait(1), passed();
  }
};

TEST(PanelScanned, TheFirstStripHasTheBlankingIfTheSecondIsAskedForAtItsEnd) {
  struct FirstStrip {
    WatchedClock& clock;
    std::uint32_t microseconds;
    ScanStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) const {
      if (strip == 0) clock.wait(microseconds);
      std::ranges::fill(pixels, static_cast<std::byte>(0x21 + strip));
      return {};
    }
  };
  constexpr sim::Nanoseconds kBlanking = kSmallTimings.rows.total() * kSmallTimings.row_time();
  // A strip is read in 160 us, the last one in 80 us, and the blanking takes 240 us.
  for (const auto& [microseconds, error] : {std::pair{310U, Error::none}, {330U, Error::underrun}}) {
    RgbModel panel{kSmallGlass};
    std::span<std::byte> second;  // the buffer that is asked for late
    sim::Nanoseconds due{};
    std::function<void(std::span<std::byte>, std::uint16_t)> ask;
    RgbScanner scanner(panel, kSmallTimings, 4, [&](std::span<std::byte> buffer, std::uint16_t strip) {
      if (strip != 1) return ask(buffer, strip);
      second = buffer;
      due = panel.now() + kBlanking;
    });
    WatchedClock clock{scanner, [&] {
                         if (!second.empty() && panel.now() >= due) ask(std::exchange(second, {}), 1);
                       }};
    hal::ScannedPanel<WatchedClock> driver(clock, {.width = 34, .height = 22, .rows = 4});
    ask = [&driver](std::span<std::byte> buffer, std::uint16_t strip) { driver.ask(buffer, strip); };
    scanner.start();
    FirstStrip renderer{clock, 0};
    ASSERT_TRUE(hal::present(renderer, driver, hal::StripLayout{6, 4}));
    renderer.microseconds = microseconds;
    EXPECT_EQ(hal::present(renderer, driver, hal::StripLayout{6, 4}).display, error) << microseconds;
    EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  }
}

/// A clock whose controller asks for strips, one every 30 ms, of which the first is `first`.
struct SlowController {
  std::uint16_t first, strips;
  std::function<void(std::span<std::byte>, std::uint16_t)> ask{};
  std::vector<std::byte> buffers = std::vector<std::byte>(std::size_t{2} * 2 * 34 * 4);
  std::uint32_t passed = 0, asked = 0;
  void wait(std::uint32_t microseconds) {
    for (passed += microseconds; passed >= 30'000; passed -= 30'000) {
      const std::span<std::byte> half = std::span(buffers).subspan(asked % 2 * buffers.size() / 2, buffers.size() / 2);
      ask(half, static_cast<std::uint16_t>((first + asked++) % strips));
    }
  }
};
struct PlainStrips {
  ScanStatus draw_strip(std::uint16_t /*strip*/, std::span<std::byte> pixels) const {
    std::ranges::fill(pixels, std::byte{0x21});
    return {};
  }
};

/// The time-out was that of all requests until the one for the first strip, 150 ms here.
TEST(PanelScanned, ASlowRefreshIsNotATimeOut) {
  SlowController controller{1, 6};
  hal::ScannedPanel<SlowController> driver(controller, {.width = 34, .height = 22, .rows = 4});
  controller.ask = [&](std::span<std::byte> buffer, std::uint16_t strip) { driver.ask(buffer, strip); };
  PlainStrips strips;
  EXPECT_TRUE(hal::present(strips, driver, hal::StripLayout{6, 4}));
  EXPECT_EQ(controller.asked, 11U);
}

TEST(PanelScanned, AControllerThatNeverAsksForTheFirstStripHasAnotherLayout) {
  SlowController controller{0, 1};
  hal::ScannedPanel<SlowController> driver(controller, {.width = 34, .height = 22, .rows = 4});
  controller.ask = [&](std::span<std::byte> buffer, std::uint16_t strip) { driver.ask(buffer, strip); };
  std::vector<std::byte> pixels(std::size_t{2} * 34 * 4);
  EXPECT_EQ(driver.write({0, 4, 34, 4}, pixels), Error::strip_layout) << "only strip 0 is asked for";
}

/// A renderer's error does not stop the refreshes.
TEST(PanelScanned, AFrameThatCannotBeDrawnIsReportedAndTheNextIsRight) {
  struct Broken {
    ScanStatus draw_strip(std::uint16_t strip, std::span<std::byte>) const { return {strip != 3}; }
  };
  std::mt19937 random(3);
  Scanned scanned(4);
  scanned.scanner.start();
  Broken broken;
  const auto result = hal::present(broken, scanned.driver, scanned.layout());
  EXPECT_FALSE(result);
  EXPECT_FALSE(result.draw);
  EXPECT_EQ(result.display, Error::none);
  EXPECT_EQ(result.strip, 3);
  const Picture next = some(random);
  ASSERT_TRUE(show(scanned, next, at_once));
  EXPECT_EQ(scanned.fault(next), "");
}

TEST(PanelScanned, StripsThatAreNotThePanelsAreRefused) {
  std::mt19937 random(4);
  const Picture picture = some(random);
  Scanned scanned(4);
  scanned.scanner.start();
  SlowStrips strips{picture, 4, scanned.scanner, at_once};
  for (const hal::StripLayout& layout :
       {hal::StripLayout{5, 5, 0}, hal::StripLayout{5, 4, 0}, hal::StripLayout{12, 4, 17}, hal::StripLayout{}}) {
    EXPECT_EQ(hal::present(strips, scanned.driver, layout).display, Error::strip_layout);
  }
  std::vector<std::byte> pixels(std::size_t{2} * 34 * 22);
  for (const Area& area : {Area{0, 1, 34, 4}, Area{0, 0, 34, 8}, Area{0, 0, 33, 4}, Area{0, 20, 34, 1}}) {
    EXPECT_EQ(scanned.driver.write(area, pixels), Error::strip_layout);
  }
  EXPECT_EQ(scanned.driver.write({0, 20, 34, 4}, pixels), Error::area);
  EXPECT_EQ(scanned.driver.write({0, 0, 34, 4}, std::span(pixels).first(271)), Error::pixels_too_small);
  for (const std::uint16_t rows : {std::uint16_t{23}, std::uint16_t{0}}) {
    hal::ScannedPanel<RgbScanner> wrong(scanned.scanner, {.width = 34, .height = 22, .rows = rows});
    EXPECT_EQ(wrong.begin_frame(), Error::strip_layout);
    EXPECT_EQ(wrong.write({0, 0, 34, 4}, pixels), Error::strip_layout);
  }
  ASSERT_TRUE(show(scanned, picture, at_once));
  EXPECT_EQ(scanned.fault(picture), "");
}

TEST(PanelModel, RgbComplainsAboutSignalsThatTheGlassDoesNotAllow) {
  using sim::Lines;
  const auto rgb = [](Lines& l) -> RgbModel& { return static_cast<RgbModel&>(l.panel); };
  const auto with = [rgb](const std::function<void(RgbTimings&)>& change) {
    return [=](Lines& l) {
      RgbTimings timings = sim::kRgbTimings480x272;
      change(timings);
      rgb(l).start(timings);
    };
  };
  const std::vector<std::byte> row(2 * 480), longer(2 * 481);
  sim::expect_complaints<RgbModel>(
      {
          {"the signals have 480x270 pixels, the glass 480x272", with([](RgbTimings& t) { t.height = 270; })},
          {"the pixel clock has 82 ns, the panel needs 83 to 125 ns", with([](RgbTimings& t) { t.pixel = 82ns; })},
          {"the pixel clock has 126 ns", with([](RgbTimings& t) { t.pixel = 126ns; })},
          {"the pulse of HSYNC is 1", with([](RgbTimings& t) { t.columns.pulse = 1; })},
          {"the pulse and back porch of a row is 48", with([](RgbTimings& t) { t.columns.back = 44; })},
          {"the front porch of a row is 1", with([](RgbTimings& t) { t.columns.front = 1; })},
          {"the pulse of VSYNC is 1", with([](RgbTimings& t) { t.rows.pulse = 1; })},
          {"the pulse and back porch of a frame is 17", with([](RgbTimings& t) { t.rows.back = 13; })},
          {"the front porch of a frame is 38", with([](RgbTimings& t) { t.rows.front = 38; })},
          {"a row had 481 pixels, the glass has 480", [&](Lines& l) { rgb(l).receive_row(longer); }},
          {"a frame had 1 rows of pixels, the glass has 272",
           [&](Lines& l) { rgb(l).receive_row(row), rgb(l).begin_frame(); }},
          {"more rows of pixels than the glass has",
           [&](Lines& l) {
             for (int i = 0; i < 273; ++i) rgb(l).receive_row(row);
           }},
          {"a byte on a bus for commands", [](Lines& l) { l.command({0x2C}); }},
      },
      [] { return std::make_unique<RgbModel>(); },
      [rgb](Lines& l) { rgb(l).start(sim::kRgbTimings480x272), rgb(l).begin_frame(); });
  RgbModel panel;
  panel.receive_row(row);
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{"pixels before the first VSYNC"});
  EXPECT_EQ(panel.darkness(), "the panel has received no row yet");
  panel.begin_frame();
  panel.receive_row(row);
  EXPECT_EQ(panel.darkness(), "");
  panel.elapse(101ms);
  EXPECT_EQ(panel.darkness(), "the pixel clock stands still");
}

}  // namespace
}  // namespace zstrip::panels
