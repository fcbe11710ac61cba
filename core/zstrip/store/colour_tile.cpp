// Records of colour: one colour, a palette with 1, 2 or 4 bits a pixel, differences from pixel to pixel, or raw pixels.
#include "zstrip/store/colour_tile.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "zstrip/store/code_stream.hpp"
#include "zstrip/store/decode_steps.hpp"

namespace zstrip {
namespace {

constexpr std::uint32_t kMaxColours = 16;
constexpr std::uint8_t kDifferences = 0x80;   // bit of the first byte; without it: number of a palette's colours
constexpr std::uint32_t kDifferenceHead = 4;  // first byte, width of blue, first pixel

constexpr std::uint32_t index_bits(std::uint32_t colours) { return colours <= 2 ? 1 : colours <= 4 ? 2 : 4; }
constexpr std::uint32_t palette_bytes(std::uint32_t colours, std::uint32_t pixels) {
  return 1 + 2 * colours + (pixels * index_bits(colours) + 7) / 8;
}

std::uint16_t load(const std::uint8_t* bytes) { return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8); }
void store(std::uint16_t value, std::uint8_t* bytes) {
  bytes[0] = static_cast<std::uint8_t>(value);
  bytes[1] = static_cast<std::uint8_t>(value >> 8);
}

/// The colours of a tile, in the order in which they first appear.
struct Palette {
  std::array<std::uint16_t, kMaxColours> colours{};
  std::uint32_t count = 0;  ///< kMaxColours + 1: there are more colours

  std::uint32_t find(std::uint16_t colour) const {
    std::uint32_t index = 0;
    while (index < count && colours[index] != colour) ++index;
    return index;
  }
  explicit Palette(const TileView<const std::uint16_t>& tile) {
    for (std::uint32_t y = 0; y < tile.height; ++y) {
      for (std::uint32_t x = 0; x < tile.width; ++x) {
        const std::uint16_t colour = tile.row(y)[x];
        if (find(colour) < count) continue;
        if (count == kMaxColours) {
          ++count;
          return;
        }
        colours[count++] = colour;
      }
    }
  }
};

/// The channels of a pixel, separated. A difference is modulo the channel's bits: 5, 6, 5.
struct Channels {
  std::uint32_t r, g, b;

  static constexpr Channels of(std::uint32_t pixel) { return {pixel >> 11 & 0x1F, pixel >> 5 & 0x3F, pixel & 0x1F}; }
  constexpr std::uint16_t pixel() const {
    return static_cast<std::uint16_t>((r & 0x1F) << 11 | (g & 0x3F) << 5 | (b & 0x1F));
  }
};

constexpr std::int32_t signed_from(std::uint32_t value, std::uint32_t bits) {
  return static_cast<std::int32_t>(value << (32 - bits)) >> (32 - bits);
}
/// Returns the bits of a difference in two's complement, without the most negative code; at least 1.
constexpr std::uint32_t bits_of(std::int32_t difference) {
  return static_cast<std::uint32_t>(
             std::bit_width(static_cast<std::uint32_t>(difference < 0 ? -difference : difference))) +
         1;
}

/// Returns the difference from the pixel on the left; in the first column, from the pixel above.
Channels difference_at(const TileView<const std::uint16_t>& tile, std::uint32_t x, std::uint32_t y) {
  const std::uint16_t* const row = tile.row(y);
  const Channels now = Channels::of(row[x]);
  const Channels before = Channels::of(x > 0 ? row[x - 1] : y > 0 ? tile.row(y - 1)[0] : row[0]);
  return {(now.r - before.r) & 0x1F, (now.g - before.g) & 0x3F, (now.b - before.b) & 0x1F};
}

/// Bits for the differences of each channel: 1..5, 1..6, 1..5. The most negative code of red marks a literal: a pixel
/// whose differences do not fit.
struct Widths {
  std::uint32_t r = 1, g = 1, b = 1;

  std::uint32_t sum() const { return r + g + b; }
  bool possible() const { return r - 1 < 5 && g - 1 < 6 && b - 1 < 5; }
  bool hold(const Channels& difference) const {
    return bits_of(signed_from(difference.r, 5)) <= r && bits_of(signed_from(difference.g, 6)) <= g &&
           bits_of(signed_from(difference.b, 5)) <= b;
  }
  std::uint32_t escape() const { return 1U << (r - 1); }
};

/// The widths with the shortest record among the widths that are tried.
struct Differences {
  Widths widths;
  std::uint32_t bytes = UINT32_MAX;

  explicit Differences(const TileView<const std::uint16_t>& tile) {
    for (std::uint32_t width = 1; width <= 5; ++width) {
      for (std::uint32_t more_green = 0; more_green < 2; ++more_green)
        consider({width, width + more_green, width}, tile);
    }
  }

 private:
  void consider(const Widths& tried, const TileView<const std::uint16_t>& tile) {
    std::uint32_t bits = 0, literals = 0;
    for (std::uint32_t y = 0; y < tile.height; ++y) {
      for (std::uint32_t x = 0; x < tile.width; ++x) {
        const bool held = tried.hold(difference_at(tile, x, y));
        bits += held ? tried.sum() : tried.r;
        literals += held ? 0 : 1;
      }
    }
    const std::uint32_t needed = kDifferenceHead + (bits + 7) / 8 + 2 * literals;
    if (needed >= bytes) return;
    bytes = needed;
    widths = tried;
  }
};

void write_palette(const Palette& palette, const TileView<const std::uint16_t>& tile, std::uint8_t* next) {
  *next++ = static_cast<std::uint8_t>(palette.count);
  for (std::uint32_t i = 0; i < palette.count; ++i, next += 2) store(palette.colours[i], next);
  detail::CodeWriter codes(next);
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x)
      codes.append(palette.find(tile.row(y)[x]), index_bits(palette.count));
  }
  codes.finish();
}

void write_differences(const Differences& chosen, const TileView<const std::uint16_t>& tile, std::uint8_t* next) {
  const Widths& widths = chosen.widths;
  std::uint8_t* literal = next + chosen.bytes;
  *next++ = static_cast<std::uint8_t>(kDifferences | widths.r << 3 | widths.g);
  *next++ = static_cast<std::uint8_t>(widths.b);
  store(tile.cells[0], next);
  detail::CodeWriter codes(next + 2);
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      const Channels difference = difference_at(tile, x, y);
      if (!widths.hold(difference)) {
        codes.append(widths.escape(), widths.r);
        store(tile.row(y)[x], literal -= 2);
        continue;
      }
      codes.append(difference.r, widths.r);
      codes.append(difference.g, widths.g);
      codes.append(difference.b, widths.b);
    }
  }
  codes.finish();
}

/// Sets each pixel to `pixel(x, y)`, row by row.
template <typename Pixel>
void fill(const TileView<std::uint16_t>& tile, Pixel pixel) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    for (std::uint32_t x = 0; x < tile.width; ++x) row[x] = pixel(x, y);
  }
}

bool decode_palette(const std::uint8_t* bytes, std::uint32_t size, const TileView<std::uint16_t>& tile) {
  const std::uint32_t count = *bytes;
  if (count < 2 || count > kMaxColours || palette_bytes(count, tile.area()) != size) return false;
  std::array<std::uint16_t, kMaxColours> colours{};  // indices after the last colour read 0
  for (std::uint32_t i = 0; i < count; ++i) colours[i] = load(bytes + 1 + 2 * i);
  detail::CodeReader codes(bytes + 1 + 2 * count, bytes + size);
  const std::uint32_t bits = index_bits(count);
  fill(tile, [&](std::uint32_t, std::uint32_t) { return colours[codes.code(bits)]; });
  return true;
}

bool decode_differences(const std::uint8_t* bytes, std::uint32_t size, const TileView<std::uint16_t>& tile) {
  if (size < kDifferenceHead) return false;
  const Widths widths{bytes[0] >> 3 & 0xFU, bytes[0] & 7U, bytes[1]};
  if (!widths.possible()) return false;
  detail::CodeReader codes(bytes + kDifferenceHead, bytes + size);
  std::uint32_t room = size - kDifferenceHead, literals = 0;  // bytes
  const std::int32_t escape = -static_cast<std::int32_t>(widths.escape());
  std::uint16_t before = load(bytes + 2), above = before;
  fill(tile, [&](std::uint32_t x, std::uint32_t) {
    const std::int32_t red = codes.signed_code(widths.r);
    if (red == escape) {
      literals += 2;
      before = literals <= room ? load(bytes + size - literals) : std::uint16_t{0};
    } else {
      Channels now = Channels::of(x == 0 ? above : before);
      now.r += static_cast<std::uint32_t>(red);
      now.g += static_cast<std::uint32_t>(codes.signed_code(widths.g));
      now.b += static_cast<std::uint32_t>(codes.signed_code(widths.b));
      before = now.pixel();
    }
    if (x == 0) above = before;
    return before;
  });
  return codes.bytes_used() + literals == room;
}

}  // namespace

std::uint32_t encode_colour_tile(const TileView<const std::uint16_t>& tile,
                                 std::span<std::byte, kMaxTileRecord> record) {
  auto* const bytes = reinterpret_cast<std::uint8_t*>(record.data());
  const std::uint32_t raw_bytes = 2 * tile.area();
  const Palette palette(tile);
  if (palette.count == 1) {
    store(palette.colours[0], bytes);
    return 2;
  }
  const Differences differences(tile);
  const std::uint32_t with_palette =
      palette.count <= kMaxColours ? palette_bytes(palette.count, tile.area()) : kMaxTileRecord;
  if (with_palette < raw_bytes && with_palette <= differences.bytes) {
    write_palette(palette, tile, bytes);
    return with_palette;
  }
  if (differences.bytes < raw_bytes) {
    write_differences(differences, tile, bytes);
    return differences.bytes;
  }
  std::uint8_t* next = bytes;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x, next += 2) store(tile.row(y)[x], next);
  }
  return raw_bytes;
}

bool decode_colour_tile(std::span<const std::byte> record, const TileView<std::uint16_t>& tile) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(record.data());
  const auto size = static_cast<std::uint32_t>(std::min<std::size_t>(record.size(), kMaxTileRecord + 1));
  const std::uint32_t raw_bytes = 2 * tile.area();
  if (size == 0 || size == 2) {
    const std::uint16_t colour = size == 0 ? std::uint16_t{0} : load(bytes);
    for (std::uint32_t y = 0; y < tile.height; ++y) {
      std::uint16_t* const row = tile.row(y);
      detail::for_row(tile.width, [row, colour](std::uint32_t x) { row[x] = colour; });
    }
    return true;
  }
  if (size >= raw_bytes) {
    if (size > raw_bytes) return false;
    for (std::uint32_t y = 0; y < tile.height; ++y, bytes += 2 * tile.width) {
      std::uint16_t* const row = tile.row(y);
      detail::for_row(tile.width, [row, bytes](std::uint32_t x) { row[x] = load(bytes + 2 * x); });
    }
    return true;
  }
  return (*bytes & kDifferences) != 0 ? decode_differences(bytes, size, tile) : decode_palette(bytes, size, tile);
}

}  // namespace zstrip
