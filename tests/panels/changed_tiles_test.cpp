// Only what changed is sent: the glass shows the picture as if each frame were sent whole, and the bus carries less.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bench.hpp"
#include "zstrip_hal/changed_tiles.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::panels {
namespace {

/// A default-constructed status is success.
struct StripDrawn {
  explicit operator bool() const { return true; }
};
/// Strips of a picture instead of a renderer's.
struct Strips {
  const Picture& picture;
  hal::StripAreas areas;
  hal::DisplayFormat format;
  StripDrawn draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    const std::vector<std::byte> bytes = bytes_of(picture, areas.area(strip), format);
    std::copy(bytes.begin(), bytes.end(), pixels.begin());
    return {};
  }
};

/// The same with fingerprints; `drawn` counts the strips that were not left out.
struct KnownStrips : Strips {
  mutable std::vector<std::uint16_t> drawn{};
  StripDrawn draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    drawn.push_back(strip);
    return Strips::draw_strip(strip, pixels);
  }
  std::uint32_t fingerprint(std::uint16_t strip) const {
    std::uint32_t sum = 7;  // the area does not count
    for (const std::byte byte : bytes_of(picture, areas.area(strip), format)) {
      sum = (sum ^ std::to_integer<std::uint32_t>(byte)) * 16777619U;
    }
    return sum;
  }
};

std::uint16_t narrow(std::uint32_t value) { return static_cast<std::uint16_t>(value); }

hal::StripLayout layout_of(const Area& whole, std::uint16_t columns, std::uint16_t rows) {
  const auto parts = [](unsigned all, unsigned part) { return (all + part - 1) / part; };
  return {narrow(parts(whole.width, columns) * parts(whole.height, rows)), rows, columns};
}

/// Two buffers whose first bytes are at `misplaced` bytes behind a multiple of 4.
class Buffers {
 public:
  Buffers(std::size_t bytes, std::size_t misplaced)
      : bytes_(bytes), misplaced_(misplaced), words_(2 * (bytes / 4 + 2)) {}
  hal::StripBuffers both() {
    const std::span<std::byte> all = std::as_writable_bytes(std::span(words_));
    return {all.subspan(misplaced_, bytes_), all.subspan(all.size() / 2 + misplaced_, bytes_)};
  }

 private:
  std::size_t bytes_, misplaced_;
  std::vector<std::uint32_t> words_;
};

/// Returns the strips that were drawn; an error is a failure.
template <class B, class Panel>
std::vector<std::uint16_t> present_known(B& bench, Panel& display, const Picture& picture,
                                         const hal::StripLayout& layout) {
  const hal::StripAreas areas(layout, display.width(), display.height());
  Buffers buffers(areas.bytes(display.format()), 0);
  KnownStrips strips{{picture, areas, display.format()}};
  EXPECT_TRUE(hal::present(strips, display, layout, buffers.both()));
  bench.expected = picture;
  return strips.drawn;
}

template <class B, class Panel>
Error present_changes(B& bench, Panel& display, const Picture& picture, const hal::StripLayout& layout,
                      std::size_t misplaced = 0) {
  const hal::StripAreas areas(layout, display.width(), display.height());
  Buffers buffers(areas.bytes(display.format()), misplaced);
  Strips strips{picture, areas, display.format()};
  KnownStrips known{strips};
  // A frame with fingerprints and one without may follow each other.
  const auto shown = misplaced % 2 == 0 ? hal::present(known, display, layout, buffers.both())
                                        : hal::present(strips, display, layout, buffers.both());
  if (shown) bench.expected = picture;
  return shown.display;
}

template <class C>
class ChangedTiles : public testing::Test {};
using Controllers = testing::Types<St7789, Ssd1351, Ssd1306, Ssd0323>;
struct Names {
  template <class C>
  static std::string GetName(int /*index*/) {
    return C::name();
  }
};
TYPED_TEST_SUITE(ChangedTiles, Controllers, Names);

/// Frames that differ in nothing, in a rectangle, or everywhere, in strips that change their size now and then, through
/// a bus that fails now and then.
TYPED_TEST(ChangedTiles, TheGlassShowsWhatWholeFramesShow) {
  std::mt19937 random(5);
  const auto below = [&random](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
  for (const auto& config : TypeParam::configs()) {
    Bench<TypeParam> bench(config);
    ASSERT_EQ(bench.display.start(), Error::none);
    const Area whole = bench.whole();
    const hal::DisplayFormat format = bench.display.format();
    hal::ChangedTiles<decltype(bench.display), 256> display(bench.display);
    const Step step = TypeParam::step(config);
    Picture picture = bench.expected;
    hal::StripLayout layout = layout_of(whole, whole.width, 8);
    const int frames = whole.width * whole.height > 20000 ? 6 : 40;
    for (int frame = 0; frame < frames; ++frame) {
      if (below(4) == 0) {
        const std::uint32_t columns = 1 + below(whole.width), rows = 1 + below(whole.height);
        const std::uint32_t x = step.x * 8, y = step.y;
        layout = layout_of(whole, narrow(std::min<std::uint32_t>((columns + x - 1) / x * x, whole.width)),
                           narrow(std::min<std::uint32_t>((rows + y - 1) / y * y, whole.height)));
      }
      const std::uint32_t kind = below(3);
      if (kind == 1) picture = noise(whole.width, whole.height, format, random);
      if (kind == 2) {
        const Area part{narrow(below(whole.width)), narrow(below(whole.height)), 1, 1};
        const Picture other = noise(whole.width, whole.height, format, random);
        copy(other,
             {part.left, part.top, narrow(1 + below(whole.width - part.left)),
              narrow(1 + below(whole.height - part.top))},
             picture);
      }
      if (below(4) == 0) bench.bus.fail_at(bench.bus.transfers() + static_cast<int>(below(12)), below(5));
      const Error error = present_changes(bench, display, picture, layout, below(4));
      bench.bus.fail_at(-1, 0);
      if (error != Error::none) {
        ASSERT_EQ(error, Error::bus);
        ASSERT_EQ(present_changes(bench, display, picture, layout), Error::none);
      }
      ASSERT_EQ(bench.fault(), "") << "frame " << frame;
    }
  }
}

/// A single bit of any pixel is enough.
TEST(ChangedTilesOfSt7789, EachPixelThatChangesIsSentWithItsTileAlone) {
  Bench<St7789> bench({.width = 50, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), hal::changed_tiles({3, 8}, 50)> display(bench.display);
  std::mt19937 random(6);
  Picture picture = noise(50, 22, bench.display.format(), random);
  ASSERT_EQ(present_changes(bench, display, picture, {3, 8}), Error::none);
  for (unsigned y = 0; y < 22; ++y) {
    for (unsigned x = 0; x < 50; ++x) {
      const std::uint64_t before = bench.bus.bytes();
      picture.at(x, y)[(x + y) % 3] ^= 8;  // one bit of RGB565; bits below repeat higher ones
      ASSERT_EQ(present_changes(bench, display, picture, {3, 8}), Error::none);
      ASSERT_EQ(bench.fault(), "") << x << ',' << y;
      const std::uint64_t pixels = (x < 48 ? 16U : 2U) * (y < 16 ? 8U : 6U);
      EXPECT_EQ(bench.bus.bytes() - before, 2 * pixels + 11) << "two ranges of five bytes, one command, a tile";
    }
  }
}

TEST(ChangedTilesOfSt7789, ARectangleInATallStripIsSentWithoutTheRowsAboveAndBelow) {
  Bench<St7789> bench({.width = 50, .height = 100});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), hal::changed_tiles({1, 100}, 50)> display(bench.display);
  std::mt19937 random(6);
  Picture picture = noise(50, 100, bench.display.format(), random);
  ASSERT_EQ(present_changes(bench, display, picture, {1, 100}), Error::none);
  for (const Area& area : {Area{17, 33, 2, 20}, Area{0, 40, 50, 1}, Area{31, 96, 3, 4}}) {
    const std::uint64_t before = bench.bus.bytes();
    copy(noise(50, 100, bench.display.format(), random), area, picture);
    ASSERT_EQ(present_changes(bench, display, picture, {1, 100}), Error::none);
    ASSERT_EQ(bench.fault(), "");
    const auto tiles = [](unsigned from, unsigned size, unsigned all) {
      return std::min((from + size + 15) / 16 * 16, all) - from / 16 * 16;
    };
    EXPECT_EQ(bench.bus.bytes() - before,
              2 * tiles(area.left, area.width, 50) * tiles(area.top, area.height, 100) + 11);
  }
}

TEST(ChangedTilesOfSt7789, NothingIsSentWhereNothingChanged) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), hal::changed_tiles({6, 4}, 34)> display(bench.display);
  std::mt19937 random(7);
  const Picture picture = noise(34, 22, bench.display.format(), random);
  ASSERT_EQ(present_changes(bench, display, picture, {6, 4}), Error::none);
  const std::uint64_t sent = bench.bus.bytes();
  ASSERT_EQ(present_changes(bench, display, picture, {6, 4}), Error::none);
  EXPECT_EQ(bench.bus.bytes(), sent);
  EXPECT_EQ(bench.fault(), "");
}

TEST(ChangedTilesOfSt7789, APanelThatIsStartedAgainIsSentWhole) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), 32> display(bench.display);
  std::mt19937 random(8);
  const Picture picture = noise(34, 22, bench.display.format(), random);
  ASSERT_EQ(present_changes(bench, display, picture, {6, 4}), Error::none);
  ResetLine reset{bench.panel.get()};
  ASSERT_EQ(hal::reset_panel(reset, bench.bus), Error::none);
  ASSERT_EQ(display.start(), Error::none);
  ASSERT_EQ(present_changes(bench, display, picture, {6, 4}), Error::none);
  EXPECT_EQ(bench.fault(), "");
}

/// A part that is covered by another frame's strips, and then drawn again as before.
TEST(ChangedTilesOfSt7789, AnAreaThatAnotherFrameCoveredIsSentAgain) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), 32> display(bench.display);
  std::mt19937 random(9);
  const Picture first = noise(34, 22, bench.display.format(), random);
  ASSERT_EQ(present_changes(bench, display, first, {6, 4}), Error::none);
  ASSERT_EQ(present_changes(bench, display, noise(34, 22, bench.display.format(), random), {1, 22}), Error::none);
  ASSERT_EQ(present_changes(bench, display, first, {6, 4}), Error::none);
  EXPECT_EQ(bench.fault(), "");
}

using KnownDisplay = hal::ChangedTiles<St7789::Driver, 32>;
using Drawn = std::vector<std::uint16_t>;

TEST(ChangedTilesOfSt7789, AStripWithTheFingerprintOfTheLastFrameIsNeitherDrawnNorSent) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  KnownDisplay display(bench.display);
  std::mt19937 random(10);
  Picture picture = noise(34, 22, bench.display.format(), random);
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), (Drawn{0, 1, 2, 3, 4, 5}));
  const std::uint64_t sent = bench.bus.bytes();
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), Drawn{});
  EXPECT_EQ(bench.bus.bytes(), sent);
  picture.at(33, 9)[0] ^= 8;
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), Drawn{2});
  EXPECT_EQ(bench.bus.bytes() - sent, 2 * 2 * 4 + 11U);
  EXPECT_EQ(bench.fault(), "");
  picture.at(33, 9)[0] ^= 8;
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), Drawn{2}) << "only the last frame counts";
  EXPECT_EQ(bench.fault(), "");
}

TEST(ChangedTilesOfSt7789, AfterAnErrorAllStripsAreDrawnAgain) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  KnownDisplay display(bench.display);
  std::mt19937 random(11);
  Picture picture = noise(34, 22, bench.display.format(), random);
  const Drawn all{0, 1, 2, 3, 4, 5};
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), all);
  picture.at(0, 21)[0] ^= 8;
  bench.bus.fail_at(bench.bus.transfers(), 0);
  EXPECT_NE(present_changes(bench, display, picture, {6, 4}), Error::none);
  bench.bus.fail_at(-1, 0);
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), all);
  EXPECT_EQ(bench.fault(), "");
  display.forget();
  EXPECT_EQ(present_known(bench, display, picture, {6, 4}), all);
}

/// A frame of equal strips, and other frames between its repetitions.
TEST(ChangedTilesOfSt7789, AStripThatAnotherFrameCoveredIsDrawnAgain) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  KnownDisplay display(bench.display);
  std::mt19937 random(12);
  const Picture other = noise(34, 22, bench.display.format(), random), plain = black(34, 22);
  for (const hal::StripLayout& layout : {hal::StripLayout{6, 4}, {1, 22}, {12, 4, 17}, {11, 2}}) {
    EXPECT_EQ(present_known(bench, display, plain, {6, 4}).size(), 6U);
    EXPECT_EQ(present_changes(bench, display, other, layout, 1), Error::none) << "without fingerprints";
    EXPECT_EQ(present_known(bench, display, plain, {6, 4}).size(), 6U);
    EXPECT_EQ(bench.fault(), "");
    EXPECT_EQ(present_known(bench, display, other, layout).size(), layout.count);
    EXPECT_EQ(present_known(bench, display, plain, {6, 4}).size(), 6U);
    EXPECT_EQ(bench.fault(), "");
    EXPECT_EQ(present_known(bench, display, other, layout).size(), layout.count);
  }
}

/// Strips beyond those that it has memory for.
TEST(ChangedTilesOfSt7789, FurtherStripsAreAlwaysDrawn) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), 32, 16, 4> display(bench.display);
  const Picture plain = black(34, 22);
  EXPECT_EQ(present_known(bench, display, plain, {6, 4}).size(), 6U);
  EXPECT_EQ(present_known(bench, display, plain, {6, 4}), (Drawn{4, 5}));
}

TEST(ChangedTilesOfSt7789, AreasOutsideThePanelAndTooFewPixelsAreRefused) {
  Bench<St7789> bench({.width = 34, .height = 22});
  ASSERT_EQ(bench.display.start(), Error::none);
  hal::ChangedTiles<decltype(bench.display), 32> display(bench.display);
  std::vector<std::byte> pixels(std::size_t{34} * 22 * 2);
  EXPECT_EQ(display.write({0, 0, 35, 1}, pixels), Error::area);
  EXPECT_EQ(display.write({0, 0, 0, 1}, pixels), Error::area);
  EXPECT_EQ(display.write({0, 20, 34, 3}, pixels), Error::area);
  EXPECT_EQ(display.write({0, 0, 34, 22}, std::span(pixels).first(pixels.size() - 1)), Error::pixels_too_small);
}

}  // namespace
}  // namespace zstrip::panels
