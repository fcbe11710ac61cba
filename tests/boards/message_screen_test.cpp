// Words on a display: the shapes of letters, lines, every format, every error.
#include "zstrip_hal/message_screen.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "zstrip_hal/framebuffer.hpp"

namespace zstrip::hal {
namespace {

/// What a picture shows, a character for each pixel: '#' white, '.' black, '!' anything else.
std::string drawn(const std::vector<std::byte>& memory, std::uint16_t width, std::uint16_t height,
                  DisplayFormat format) {
  std::string text;
  const std::uint32_t row_bytes = bytes_per_row(width, format), bits = bytes_per_row(8, format);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      unsigned ones = 0, counted = 0;
      for (std::uint32_t bit = x * bits; bit < (x + 1) * bits; ++bit) {
        const bool unused = (format == DisplayFormat::xrgb8888 && bit / 8 % 4 == 3) ||
                            (format == DisplayFormat::rgb666 && bit % 8 >= 6);
        const bool one = (std::to_integer<unsigned>(memory[y * row_bytes + bit / 8]) >> (7 - bit % 8) & 1U) != 0;
        if (unused && one) ones = 1000;
        if (unused) continue;
        ones += one;
        ++counted;
      }
      text += ones == 0 ? '.' : ones == counted ? '#' : '!';
    }
    text += '\n';
  }
  return text;
}

/// Each character of a small drawing twice as wide and three times as high.
std::string enlarged(const std::vector<std::string>& rows) {
  std::string text;
  for (const std::string& row : rows) {
    std::string line;
    for (const char pixel : row) line += std::string(2, pixel);
    for (int copy = 0; copy < 3; ++copy) text += line + "\n";
  }
  return text;
}

constexpr DisplayFormat kFormats[] = {DisplayFormat::rgb565,  DisplayFormat::rgb565_swapped, DisplayFormat::gray4,
                                      DisplayFormat::mono,    DisplayFormat::rgb666,         DisplayFormat::rgb444,
                                      DisplayFormat::xrgb8888};

TEST(MessageScreen, LettersInEveryFormat) {
  const std::string expected = enlarged({
                                   ".#..##..###.###.",
                                   "#.#.#.#.#.....#.",
                                   "###.##..##...#..",
                                   "#.#.#.#.#....#..",
                                   "#.#.##..###..#..",
                               }) +
                               std::string(32, '.') + "\n";
  for (const DisplayFormat format : kFormats) {
    std::vector<std::byte> memory(bytes_per_row(32, format) * 16U, std::byte{0x5A});
    Framebuffer display(memory, {32, 16, format});
    ASSERT_EQ(show_message(display, "aBe7"), Error::none);
    EXPECT_EQ(drawn(memory, 32, 16, format), expected) << static_cast<int>(format);
  }
}

TEST(MessageScreen, LinesBreakAtTheEdgeAndTheRestIsBlack) {
  const auto picture = [](const char* text, std::uint16_t width, std::uint16_t height) {
    std::vector<std::byte> memory(bytes_per_row(width, DisplayFormat::mono) * height, std::byte{0xFF});
    Framebuffer display(memory, {width, height, DisplayFormat::mono});
    EXPECT_EQ(show_message(display, text), Error::none);
    return drawn(memory, width, height, DisplayFormat::mono);
  };
  const std::string two_lines = picture("ABC", 16, 32);
  EXPECT_EQ(two_lines.substr(0, 16 * 17), picture("AB", 16, 16));
  EXPECT_EQ(two_lines.substr(16 * 17), picture("C", 16, 16));
  EXPECT_EQ(picture("ABCDE", 16, 32), picture("ABCD", 16, 32)) << "what does not fit is not shown";
  EXPECT_EQ(picture("", 16, 16).find('#'), std::string::npos);
  EXPECT_EQ(picture("\xFF", 8, 16), picture("?", 8, 16));
}

TEST(MessageScreen, NoTwoCharactersLookTheSame) {
  const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:;-'?";
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      EXPECT_NE(detail::glyph(all[a]), detail::glyph(all[b])) << all[a] << ' ' << all[b];
    }
  }
}

/// A display on which the step of this number fails, and all after it otherwise.
struct FailingDisplay {
  int left;
  bool failed = false;
  int ended = 0;
  Error use() {
    if (left-- > 0) return Error::none;
    return std::exchange(failed, true) ? Error::bus : Error::timeout;
  }
  std::uint16_t width() const { return 16; }
  std::uint16_t height() const { return 16; }
  DisplayFormat format() const { return DisplayFormat::mono; }
  Error begin_frame() { return use(); }
  Error write(const Area&, std::span<const std::byte>) { return use(); }
  Error wait() { return use(); }
  Error end_frame() {
    ++ended;
    return use();
  }
};

TEST(MessageScreen, ReportsADisplayThatFailsAtAnyStep) {
  constexpr int kSteps = 1 + 2 * 2 + 1;
  for (int step = 0; step < kSteps; ++step) {
    FailingDisplay display{step};
    EXPECT_EQ(show_message(display, "AB"), Error::timeout) << step;
    EXPECT_EQ(display.ended, step == 0 ? 0 : 1) << "end_frame() belongs to a frame that began, also after an error";
  }
  FailingDisplay display{kSteps};
  EXPECT_EQ(show_message(display, "AB"), Error::none);
}

}  // namespace
}  // namespace zstrip::hal
