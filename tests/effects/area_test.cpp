// draw_area: rectangles of a frame have the pixels of the whole picture, with every effect, format and division into
// strips, and nothing around them is written.
#include "zstrip/area.hpp"

#include <limits>
#include <random>
#include <utility>

#include "combination.hpp"

namespace effects_test {
namespace {

constexpr std::byte kGuard{0x5A};

int bits_of_row(int width, PixelFormat format) {
  constexpr int kBits[] = {16, 16, 4, 1, 24, 12, 32};
  return width * kBits[static_cast<std::size_t>(format)];
}

/// The bits of a pixel. Every format is read as a row of bits, from the highest bit of each byte.
std::uint32_t pixel_at(const std::byte* row, PixelFormat format, int x) {
  std::uint32_t pixel = 0;
  for (int bit = bits_of_row(x, format); bit < bits_of_row(x + 1, format); ++bit) {
    pixel = pixel << 1 | (std::to_integer<std::uint32_t>(row[bit / 8]) >> (7 - bit % 8) & 1U);
  }
  return pixel;
}

/// A rectangle inside the view.
Rect random_area(std::mt19937& random, const View& view) {
  const auto side = [&](int length) {
    int a = static_cast<int>(random() % static_cast<unsigned>(length));
    int b = static_cast<int>(random() % static_cast<unsigned>(length));
    if (a > b) std::swap(a, b);
    return std::pair{a, b + 1};
  };
  const auto [left, right] = side(view.width);
  const auto [top, bottom] = side(view.height);
  return {left, top, right, bottom};
}

/// Draws an area into memory of exactly its size, and compares it with the whole picture bit by bit.
void expect_area(AnyRenderer& renderer, const View& view, const Rect& area, std::size_t gap, std::span<std::byte> strip,
                 const std::vector<std::byte>& whole) {
  const std::size_t row = bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format);
  const std::size_t stride = row + gap;
  const std::size_t bytes = stride * static_cast<std::size_t>(area.height() - 1) + row;
  constexpr std::size_t kAround = 16;
  std::vector<std::byte> memory(bytes + 2 * kAround, kGuard);
  const std::span<std::byte> pixels = std::span(memory).subspan(kAround, bytes);
  const Status status = draw_area(renderer, area, strip, pixels, stride);
  ASSERT_TRUE(status) << message(status.error);
  const std::size_t whole_row = bytes_per_row(view.width, view.format);
  for (int y = 0; y < area.height(); ++y) {
    const std::byte* const got = pixels.data() + static_cast<std::size_t>(y) * stride;
    const std::byte* const wanted = whole.data() + static_cast<std::size_t>(area.top + y) * whole_row;
    for (int x = 0; x < area.width(); ++x) {
      ASSERT_EQ(pixel_at(got, view.format, x), pixel_at(wanted, view.format, area.left + x))
          << "pixel " << area.left + x << ", " << area.top + y;
    }
    const int used = bits_of_row(area.width(), view.format);
    const int end = static_cast<int>(y + 1 < area.height() ? stride : row + kAround) * 8;
    for (int bit = used; bit < end; ++bit) {
      ASSERT_EQ(pixel_at(got, PixelFormat::mono, bit), pixel_at(&kGuard, PixelFormat::mono, bit % 8))
          << "bit " << bit << " of row " << y;
    }
  }
  for (std::size_t i = 0; i < kAround; ++i) ASSERT_EQ(memory[i], kGuard);
}

/// Draws random areas of a frame that `budget` divides.
void expect_areas(Effects set, const View& view, const Budget& budget, int areas) {
  SCOPED_TRACE(testing::Message() << std::hex << set.bits << ", format " << static_cast<int>(view.format) << ", rows "
                                  << std::dec << budget.strip_rows << ", columns " << budget.strip_columns);
  const Combination drawn(set);
  const picture::Picture whole = picture::draw(set, drawn.scene, drawn.camera, view);
  ASSERT_TRUE(whole.status);
  const Effects effects = budget.modes == Modes::binned ? set | effect::bins : set;
  const PlanResult planned = plan(count(drawn.scene), view, effects, budget);
  ASSERT_TRUE(planned.status);
  AnyRenderer renderer(effects);
  std::vector<std::byte> arena = lent(planned.plan.bytes());
  std::vector<std::byte> strip = lent(planned.plan.strip_pixel_bytes(view));
  ASSERT_TRUE(renderer.begin_frame(drawn.scene, drawn.camera, view, planned.plan, arena));
  std::mt19937 random(7);
  for (int i = 0; i < areas; ++i) {
    const Rect area = random_area(random, view);
    SCOPED_TRACE(testing::Message() << area.left << ',' << area.top << " to " << area.right << ',' << area.bottom);
    expect_area(renderer, view, area, random() % 4, strip, whole.pixels);
    if (testing::Test::HasFatalFailure()) return;
  }
}

constexpr Budget kStreamed{.strip_rows = 7, .modes = Modes::streamed};
constexpr Budget kTiles{.strip_rows = 5, .strip_columns = 16, .modes = Modes::streamed};
constexpr Budget kBinned{.strip_rows = 9, .strip_columns = 24, .modes = Modes::binned};

TEST(EffectsArea, AnAreaHasThePixelsOfThePictureWithEveryEffect) {
  std::vector<Effects> sets;
  constexpr Effects kNotWithEdges = effect::outlines | effect::supersampled | effect::skins;
  for (std::size_t i = 0; i < kRows; ++i) {
    sets.push_back(completed(row(i)));
    sets.push_back(completed(without(row(i), effect::shadows)) | effect::csg);
    sets.push_back(completed(without(row(i), kNotWithEdges)) | effect::edges);
  }
  for (const Effects set : sets) {
    for (const Budget& budget : {kStreamed, kTiles, kBinned}) expect_areas(set, view_of(set), budget, 12);
  }
}

TEST(EffectsArea, AnAreaHasThePixelsOfThePictureInEveryFormat) {
  const Effects set = completed(row(1));
  for (int format = 0; format <= static_cast<int>(kLastPixelFormat); ++format) {
    for (const bool dither : {false, true}) {
      const View view{45, 37, static_cast<PixelFormat>(format), dither};
      const Effects all =
          without(set, effect::dithered_format | effect::dithered_colours | effect::supersampled) | effects_of(view);
      for (const Budget& budget : {kStreamed, kTiles, kBinned}) expect_areas(all, view, budget, 60);
    }
  }
}

TEST(EffectsArea, AnAreaThatCannotBeDrawnIsAnErrorAndWritesNothing) {
  constexpr View kView{40, 32, PixelFormat::rgb565};
  const Effects set = completed(without(row(0), effect::supersampled));
  const Combination drawn(set);
  const Plan planned = plan(count(drawn.scene), kView, set, kStreamed).plan;
  std::vector<std::byte> arena = lent(planned.bytes()), strip = lent(planned.strip_pixel_bytes(kView));
  std::vector<std::byte> pixels(40 * 32 * 2, kGuard);
  AnyRenderer renderer(set);
  const auto draw = [&](const Rect& area, std::size_t bytes, std::size_t stride) {
    return draw_area(renderer, area, strip, std::span(pixels).first(bytes), stride);
  };
  EXPECT_EQ(draw({0, 0, 8, 8}, pixels.size(), 80).error, Error::not_begun);
  ASSERT_TRUE(renderer.begin_frame(drawn.scene, drawn.camera, kView, planned, arena));
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min(),
                         kMax = std::numeric_limits<std::int32_t>::max();
  for (const Rect& outside :
       {Rect{-1, 0, 8, 8}, Rect{0, -1, 8, 8}, Rect{0, 0, 41, 8}, Rect{0, 0, 8, 33}, Rect{3, 3, 3, 8}, Rect{5, 8, 9, 3},
        Rect{kMin, kMin, kMax, kMax}, Rect{kMax, kMax, kMin, kMin}}) {
    EXPECT_EQ(draw(outside, pixels.size(), 80).error, Error::view_size);
  }
  EXPECT_EQ(draw({1, 1, 9, 9}, pixels.size(), 15), (Status{Error::pixels_too_small, Purpose::none, 16, 15}));
  EXPECT_EQ(draw({1, 1, 9, 9}, 155, 20), (Status{Error::pixels_too_small, Purpose::none, 156, 155}));
  EXPECT_EQ(draw({1, 1, 9, 9}, 15, std::size_t{1} << 62).error, Error::pixels_too_small);
  EXPECT_EQ(draw_area(renderer, {1, 1, 9, 9}, std::span(strip).first(10), pixels, 80).error, Error::pixels_too_small);
  EXPECT_EQ(pixels, std::vector<std::byte>(pixels.size(), kGuard));
  EXPECT_TRUE(draw({1, 1, 9, 9}, 156, 20));
}

}  // namespace
}  // namespace effects_test
