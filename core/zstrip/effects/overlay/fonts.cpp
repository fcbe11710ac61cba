// The letters of the two fonts as readable rows, and the tables that are computed from them.
#include "zstrip/overlay.hpp"

#include <utility>

namespace zstrip::detail {
namespace {

constexpr int kCellWidth = 6, kCellHeight = 8;
constexpr std::size_t kLettersOfBand = 16;

/// Sixteen letters in each band.
constexpr const char* kBands[kFontGlyphs / kLettersOfBand][kCellHeight] = {
    //       !     "     #     $     %     &     '     (     )     *     +     ,     -     .     /
    {
        "........#....#.#...#.#....#...##.....##.....#......#...#......................................#.",
        "........#....#.#...#.#...####.##..#.#..#....#.....#.....#.....#.....#.........................#.",
        "........#....#.#..#####.#.#......#..#.#.....#....#.......#..#.#.#...#........................#..",
        "........#..........#.#...###....#....#...........#.......#...###..#####.......#####.........#...",
        "........#.........#####...#.#..#....#.#.#........#.......#..#.#.#...#......................#....",
        "...................#.#..####..#..##.#..#..........#.....#.....#.....#.....##.........##...#.....",
        "........#..........#.#....#......##..##.#..........#...#..................##.........##...#.....",
        ".........................................................................##.....................",
    },
    // 0     1     2     3     4     5     6     7     8     9     :     ;     <     =     >     ?
    {
        ".###....#....###..####.....#..#####...##..#####..###...###..................#.......#......###..",
        "#...#..##...#...#.....#...##..#......#........#.#...#.#...#..##.....##.....#.........#....#...#.",
        "#..##.#.#.......#.....#..#.#..####..#........#..#...#.#...#..##.....##....#...#####...#.......#.",
        "#.#.#...#......#...###..#..#......#.####.....#...###...####..............#.............#.....#..",
        "##..#...#.....#.......#.#####.....#.#...#...#...#...#.....#..##.....##....#...#####...#.....#...",
        "#...#...#....#........#....#..#...#.#...#...#...#...#....#...##.....##.....#.........#..........",
        ".###..#####.#####.####.....#...###...###....#....###...##..........##.......#.......#.......#...",
        "................................................................................................",
    },
    // @     A     B     C     D     E     F     G     H     I     J     K     L     M     N     O
    {
        ".###...###..####...###..####..#####.#####..###..#...#..###....###.#...#.#.....#...#.#...#..###..",
        "#...#.#...#.#...#.#...#.#...#.#.....#.....#...#.#...#...#......#..#..#..#.....##.##.##..#.#...#.",
        "#.###.#...#.#...#.#.....#...#.#.....#.....#.....#...#...#......#..#.#...#.....#.#.#.##..#.#...#.",
        "#.#.#.#####.####..#.....#...#.####..####..#..##.#####...#......#..##....#.....#.#.#.#.#.#.#...#.",
        "#.###.#...#.#...#.#.....#...#.#.....#.....#...#.#...#...#......#..#.#...#.....#...#.#..##.#...#.",
        "#.....#...#.#...#.#...#.#...#.#.....#.....#...#.#...#...#...#..#..#..#..#.....#...#.#..##.#...#.",
        ".###..#...#.####...###..####..#####.#......####.#...#..###...##...#...#.#####.#...#.#...#..###..",
        "................................................................................................",
    },
    // P     Q     R     S     T     U     V     W     X     Y     Z     [     \     ]     ^     _
    {
        "####...###..####...####.#####.#...#.#...#.#...#.#...#.#...#.#####..###..#......###....#.........",
        "#...#.#...#.#...#.#.......#...#...#.#...#.#...#.#...#.#...#.....#..#....#........#...#.#........",
        "#...#.#...#.#...#.#.......#...#...#.#...#.#...#..#.#...#.#.....#...#.....#.......#..#...#.......",
        "####..#...#.####...###....#...#...#.#...#.#.#.#...#.....#.....#....#......#......#..............",
        "#.....#.#.#.#.#.......#...#...#...#..#.#..#.#.#..#.#....#....#.....#.......#.....#..............",
        "#.....#..#..#..#......#...#...#...#..#.#..##.##.#...#...#...#......#........#....#..............",
        "#......##.#.#...#.####....#....###....#...#...#.#...#...#...#####..###......#..###..............",
        "..........................................................................................#####.",
    },
    // `     a     b     c     d     e     f     g     h     i     j     k     l     m     n     o
    {
        ".#..........#...............#.........##........#.......#......#..#......##.....................",
        "..#.........#...............#........#..........#.................#.......#.....................",
        "...#...###..####...####..####..###..####...####.####...##.....##..#..#....#...##.#..####...###..",
        "..........#.#...#.#.....#...#.#...#..#....#...#.#...#...#......#..#.#.....#...#.#.#.#...#.#...#.",
        ".......####.#...#.#.....#...#.#####..#....#...#.#...#...#......#..##......#...#.#.#.#...#.#...#.",
        "......#...#.#...#.#.....#...#.#......#.....####.#...#...#......#..#.#.....#...#.#.#.#...#.#...#.",
        ".......####.####...####..####..####..#........#.#...#..###..#..#..#..#...###..#.#.#.#...#..###..",
        "...........................................###...............##.................................",
    },
    // p     q     r     s     t     u     v     w     x     y     z     {     |     }     ~
    {
        ".........................#..........................................##....#....##.........#####.",
        ".........................#.........................................#......#......#........#...#.",
        "####...####.#.##...####.####..#...#.#...#.#...#.#...#.#...#.#####..#......#......#...#..#.#...#.",
        "#...#.#...#.##..#.#......#....#...#.#...#.#.#.#..#.#..#...#....#..#.......#.......#.#.#.#.#...#.",
        "#...#.#...#.#......###...#....#...#..#.#..#.#.#...#...#...#...#....#......#......#..#..#..#...#.",
        "####...####.#.........#..#....#..##..#.#..#.#.#..#.#...####..#.....#......#......#........#...#.",
        "#.........#.#.....####....##...##.#...#....#.#..#...#.....#.#####...##....#....##.........#####.",
        "#.........#............................................###......................................",
    },
};

constexpr bool is_set(std::size_t letter, int x, int y) {
  if (x < 0 || x >= kCellWidth || y < 0 || y >= kCellHeight) return false;
  const char* const row = kBands[letter / kLettersOfBand][y];
  return row[letter % kLettersOfBand * kCellWidth + static_cast<std::size_t>(x)] == '#';
}

constexpr std::uint32_t code_point_of(std::size_t letter) {
  return letter + 1 == kFontGlyphs ? 0xFFFD : static_cast<std::uint32_t>(letter) + U' ';
}

/// The pixels of a letter at `scale` times its size.
template <int scale>
struct Cell {
  static constexpr int kWidth = scale * kCellWidth, kHeight = scale * kCellHeight;
  bool pixels[std::size_t{kHeight}][std::size_t{kWidth}] = {};
  constexpr bool at(int x, int y) const { return x >= 0 && x < kWidth && y >= 0 && y < kHeight && pixels[y][x]; }
};

constexpr Cell<1> cell_of(std::size_t letter) {
  Cell<1> cell;
  for (int y = 0; y < kCellHeight; ++y) {
    for (int x = 0; x < kCellWidth; ++x) cell.pixels[y][x] = is_set(letter, x, y);
  }
  return cell;
}

/// Returns the cell twice as large. A quarter of a pixel takes the colour of the two neighbours that it touches, if
/// these agree and the other two differ from them (Scale2x).
template <int scale>
constexpr Cell<2 * scale> doubled(const Cell<scale>& cell) {
  Cell<2 * scale> result;
  for (int y = 0; y < cell.kHeight; ++y) {
    for (int x = 0; x < cell.kWidth; ++x) {
      const bool own = cell.pixels[y][x];
      const bool besides[] = {cell.at(x - 1, y), cell.at(x + 1, y)}, stacked[] = {cell.at(x, y - 1), cell.at(x, y + 1)};
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int right = quarter % 2, down = quarter / 2;
        const bool beside = besides[right], across = besides[1 - right];
        const bool above = stacked[down], below = stacked[1 - down];
        const bool takes = beside == above && beside != below && above != across;
        result.pixels[2 * y + down][2 * x + right] = takes ? beside : own;
      }
    }
  }
  return result;
}

/// The font of 12x16 pixels, 4 bits each, is computed from one with four times as many pixels.
constexpr int kLargeWidth = 2 * kCellWidth, kLargeHeight = 2 * kCellHeight;
struct LargeLetter {
  std::uint8_t coverage[std::size_t{kLargeHeight}][std::size_t{kLargeWidth}] = {};
  int left = kLargeWidth, top = kLargeHeight, right = 0, bottom = 0;  ///< bounds of the covered pixels
  constexpr int width() const { return right > left ? right - left : 0; }
  constexpr int height() const { return right > left ? bottom - top : 0; }
  constexpr int row_bytes() const { return (width() + 1) / 2; }
};

constexpr LargeLetter enlarged(std::size_t letter) {
  const Cell<4> fine = doubled(doubled(cell_of(letter)));
  LargeLetter result;
  for (int y = 0; y < kLargeHeight; ++y) {
    for (int x = 0; x < kLargeWidth; ++x) {
      const int set =
          fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y) + fine.at(2 * x, 2 * y + 1) + fine.at(2 * x + 1, 2 * y + 1);
      result.coverage[y][x] = static_cast<std::uint8_t>((15 * set + 2) / 4);
      if (set == 0) continue;
      result.left = x < result.left ? x : result.left;
      result.right = x + 1 > result.right ? x + 1 : result.right;
      result.top = y < result.top ? y : result.top;
      result.bottom = y + 1;
    }
  }
  return result;
}

/// A constant for each letter, because compilers limit the steps of one evaluation.
template <std::size_t letter>
constexpr LargeLetter kEnlarged = enlarged(letter);
template <std::size_t... letters>
constexpr std::array<LargeLetter, sizeof...(letters)> all_enlarged(std::index_sequence<letters...>) {
  return {kEnlarged<letters>...};
}
constexpr std::array<LargeLetter, kFontGlyphs> kLarge = all_enlarged(std::make_index_sequence<kFontGlyphs>());

consteval std::array<Glyph, kFontGlyphs> small_glyphs() {
  std::array<Glyph, kFontGlyphs> glyphs{};
  for (std::size_t i = 0; i < kFontGlyphs; ++i) {
    glyphs[i] = {.code_point = code_point_of(i),
                 .offset = static_cast<std::uint32_t>(i * kCellHeight),
                 .width = kCellWidth,
                 .height = kCellHeight,
                 .left = 0,
                 .top = static_cast<std::int16_t>(kSmallFont.baseline),
                 .advance = kCellWidth};
  }
  return glyphs;
}

consteval std::array<std::uint8_t, kSmallFontBytes> small_coverage() {
  std::array<std::uint8_t, kSmallFontBytes> bytes{};
  for (std::size_t i = 0; i < kFontGlyphs; ++i) {
    for (int y = 0; y < kCellHeight; ++y) {
      std::uint32_t row = 0;
      for (int x = 0; x < kCellWidth; ++x) row |= is_set(i, x, y) ? 0x80U >> x : 0;
      bytes[i * kCellHeight + static_cast<std::size_t>(y)] = static_cast<std::uint8_t>(row);
    }
  }
  return bytes;
}

consteval std::array<Glyph, kFontGlyphs> large_glyphs() {
  std::array<Glyph, kFontGlyphs> glyphs{};
  std::uint32_t offset = 0;
  for (std::size_t i = 0; i < kFontGlyphs; ++i) {
    const LargeLetter& letter = kLarge[i];
    const bool empty = letter.width() == 0;
    glyphs[i] = {.code_point = code_point_of(i),
                 .offset = offset,
                 .width = static_cast<std::uint8_t>(letter.width()),
                 .height = static_cast<std::uint8_t>(letter.height()),
                 .left = static_cast<std::int16_t>(empty ? 0 : letter.left),
                 .top = static_cast<std::int16_t>(empty ? 0 : kLargeFont.baseline - letter.top),
                 .advance = kLargeWidth};
    offset += static_cast<std::uint32_t>(letter.row_bytes() * letter.height());
  }
  return glyphs;
}

consteval std::size_t large_bytes() {
  std::size_t bytes = 0;
  for (const LargeLetter& letter : kLarge) bytes += static_cast<std::size_t>(letter.row_bytes() * letter.height());
  return bytes;
}
static_assert(large_bytes() == kLargeFontBytes);

consteval std::array<std::uint8_t, kLargeFontBytes> large_coverage() {
  std::array<std::uint8_t, kLargeFontBytes> bytes{};
  std::size_t next = 0;
  for (const LargeLetter& letter : kLarge) {
    for (int y = letter.top; y < letter.bottom; ++y) {
      for (int x = letter.left; x < letter.right; x += 2) {
        const std::uint32_t second = x + 1 < letter.right ? letter.coverage[y][x + 1] : 0U;
        bytes[next++] = static_cast<std::uint8_t>(std::uint32_t{letter.coverage[y][x]} << 4 | second);
      }
    }
  }
  return bytes;
}

}  // namespace

constexpr std::array<Glyph, kFontGlyphs> kSmallFontGlyphs = small_glyphs();
constexpr std::array<Glyph, kFontGlyphs> kLargeFontGlyphs = large_glyphs();
constexpr std::array<std::uint8_t, kSmallFontBytes> kSmallFontCoverage = small_coverage();
constexpr std::array<std::uint8_t, kLargeFontBytes> kLargeFontCoverage = large_coverage();

}  // namespace zstrip::detail
