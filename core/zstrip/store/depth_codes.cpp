// Bits of codes run from the record's end towards its head: the last byte's highest bit comes first. So a word read for
// the last codes reaches into the head, never outside the record, and codes need no check one by one.
#include "zstrip/store/depth_codes.hpp"

#include <algorithm>
#include <array>

#include "zstrip/store/decode_steps.hpp"

namespace zstrip::detail {
namespace {

using Tile = TileView<std::uint16_t>;

/// One row to decode, and what it takes from those above.
struct Row {
  std::uint16_t* cells;
  const std::uint16_t* above;
  std::ptrdiff_t up;    ///< from there to the row above that
  std::uint32_t width;  ///< cells
  std::uint32_t rise;   ///< of the first column, from the row above to this one
};

/// Eight codes, their bits from a byte on. `per_word` codes have room in 32 bits behind at most 4 others.
template <std::uint32_t per_word, bool has_low_bytes>
class PackedCodes {
 public:
  PackedCodes(const std::uint8_t* end, std::uint32_t bits_each, const std::uint8_t* low)
      : end_(end), low_(low), bits_each_(bits_each) {}
  [[gnu::always_inline]] std::uint32_t at(std::uint32_t x) {
    if (x == 0) {
      bits_ = little_endian(end_ - 4);
    } else if (x % per_word == 0) {
      bits_ = little_endian(end_ - 4 - x * bits_each_ / 8) << (x * bits_each_ % 8);
    }
    const auto code = static_cast<std::uint32_t>(static_cast<std::int32_t>(bits_) >> (32 - bits_each_));
    bits_ <<= bits_each_;
    in_order(bits_);
    return has_low_bytes ? code << 8 | low_[x] : code;
  }

 private:
  const std::uint8_t* end_;
  const std::uint8_t* low_;
  std::uint32_t bits_each_;
  std::uint32_t bits_ = 0;
};

/// Codes of the covered cells of a row.
struct CoveredCodes {
  const std::uint16_t* next;
  std::uint32_t cover;
  [[gnu::always_inline]] std::uint32_t at(std::uint32_t x) { return (cover >> x & 1) != 0 ? *next++ : 0U; }
};

template <Opcode predictor, typename Codes>
[[gnu::always_inline]] inline void decode_row(Codes& codes, Row& row) {
  std::uint16_t* const cells = row.cells;
  const std::uint16_t* const above = row.above;
  const std::uint16_t* const above2 = predictor == kColumn ? above + row.up : nullptr;
  const std::uint32_t rise = row.rise + codes.at(0);
  row.rise = rise;
  std::uint32_t cell = above[0] + rise;
  cells[0] = static_cast<std::uint16_t>(cell);
  // From the cell that the next one is predicted from to that.
  std::uint32_t gradient = rise;
  if (predictor == kAlong) gradient = row.width > 1 ? static_cast<std::uint32_t>(above[1] - above[0]) : 0;
  const auto step = [&](std::uint32_t x) __attribute__((always_inline)) {
    const std::uint32_t code = codes.at(x);
    if constexpr (predictor == kColumn) {
      cell = 2U * above[x] - above2[x] + code;
    } else {
      gradient += code;
      cell = (predictor == kAlong ? cell : above[x]) + gradient;
    }
    cells[x] = static_cast<std::uint16_t>(cell);
  };
  if (row.width == kTileSide) {
    step(1), step(2), step(3), step(4), step(5), step(6), step(7);
  } else {
    for (std::uint32_t x = 1; x < row.width; ++x) step(x);
  }
}

/// What is left of codes in groups of eight: bits up to `end`, low bytes from `low` on.
struct Groups {
  const std::uint8_t* low;
  const std::uint8_t* end;
};

/// Takes a group with codes of `width` bits, 1..16, that must be there, and calls for its kind of codes
/// `use.operator()<per_word, has_low_bytes>(end, bits_each, low)`.
template <typename Use>
[[gnu::always_inline]] inline void take_group(Groups& groups, std::uint32_t width, Use use) {
  const std::uint8_t *const end = groups.end, *const low = groups.low;
  if (width <= 8) {
    groups.end = end - width;
    if (width <= 4) {
      use.template operator()<8, false>(end, width, low);
    } else {
      use.template operator()<4, false>(end, width, low);
    }
    return;
  }
  width -= 8;
  groups.end = end - width;
  groups.low = low + kTileSide;
  if (width <= 4) {
    use.template operator()<8, true>(end, width, low);
  } else {
    use.template operator()<4, true>(end, width, low);
  }
}

template <Opcode predictor, std::uint32_t per_word, bool has_low_bytes>
[[gnu::noinline]] void decode_packed(const std::uint8_t* end, std::uint32_t bits_each, const std::uint8_t* low,
                                     Row& row) {
  if (row.width != kTileSide) __builtin_unreachable();
  PackedCodes<per_word, has_low_bytes> codes(end, bits_each, low);
  decode_row<predictor>(codes, row);
}

/// Returns the next row's codes.
template <Opcode predictor>
[[gnu::noinline]] const std::uint16_t* decode_covered(const std::uint16_t* codes, std::uint32_t cover, Row& row) {
  CoveredCodes covered{codes, cover};
  decode_row<predictor>(covered, row);
  return covered.next;
}

/// Row by row, `decode.operator()<predictor>(row)`; until that says false.
template <typename Decode>
[[gnu::always_inline]] inline bool decode_rows(Opcode opcode, std::uint32_t start, const Tile& tile, Decode decode) {
  // Above the first row all cells are the start.
  const std::array<std::uint16_t, 2> start_cells{static_cast<std::uint16_t>(start), static_cast<std::uint16_t>(start)};
  Row row{tile.cells, start_cells.data(), -static_cast<std::ptrdiff_t>(tile.stride), tile.width, 0};
  if (!decode.template operator()<kAlong>(row)) return false;
  row.rise = 0;
  Opcode predictor = opcode == kColumn ? kDown : opcode;  // two rows make a column's slope
  for (std::uint32_t rows = tile.height - 1; rows != 0; --rows, predictor = opcode) {
    row.above = row.cells;
    row.cells -= row.up;
    const bool decoded = predictor == kAlong  ? decode.template operator()<kAlong>(row)
                         : predictor == kDown ? decode.template operator()<kDown>(row)
                                              : decode.template operator()<kColumn>(row);
    if (!decoded) return false;
  }
  return true;
}

/// What stands for the codes of a row of width 0: codes of one bit.
constexpr std::array<std::uint8_t, 4> kZeros{};

/// All cells of a tile with 8 columns have codes: each row is a group.
[[gnu::noinline]] bool decode_whole(Groups groups, Opcode opcode, std::uint32_t start, std::uint32_t widths,
                                    const Tile& tile) {
  const bool all = decode_rows(opcode, start, tile, [&]<Opcode predictor>(Row& row) {
    const std::uint32_t width = code_bits(widths & 0xF);
    widths >>= 4;
    if (static_cast<std::size_t>(groups.end - groups.low) < width) return false;
    if (width == 0) {
      decode_packed<predictor, 8, false>(kZeros.end(), 1, nullptr, row);
      return true;
    }
    take_group(groups, width,
               [&row]<std::uint32_t per_word, bool has_low_bytes>(const std::uint8_t* end, std::uint32_t bits_each,
                                                                  const std::uint8_t* low) {
                 decode_packed<predictor, per_word, has_low_bytes>(end, bits_each, low, row);
               });
    return true;
  });
  return all && groups.end == groups.low;
}

template <std::uint32_t per_word, bool has_low_bytes>
[[gnu::noinline]] void unpack_eight(const std::uint8_t* end, std::uint32_t bits_each, const std::uint8_t* low,
                                    std::uint16_t* codes) {
  PackedCodes<per_word, has_low_bytes> packed(end, bits_each, low);
  for_row(kTileSide, [&](std::uint32_t x) { codes[x] = static_cast<std::uint16_t>(packed.at(x)); });
}

/// Less than eight codes; false if they are not all that lies there.
bool unpack_last(const Groups& groups, std::uint32_t width, std::uint32_t count, std::uint16_t* codes) {
  const std::uint8_t *low = groups.low, *const end = groups.end;
  const bool has_low_bytes = width > 8;
  const std::uint32_t bits_each = has_low_bytes ? width - 8 : width;
  if (static_cast<std::size_t>(end - low) != (has_low_bytes ? count : 0) + (count * bits_each + 7) / 8) return false;
  for (std::uint32_t bit = 0; count != 0; --count, bit += bits_each) {
    std::uint32_t code = 0;
    if (width != 0) {
      const std::uint32_t bits = little_endian(end - 4 - bit / 8) << bit % 8;
      code = static_cast<std::uint32_t>(static_cast<std::int32_t>(bits) >> (32 - bits_each));
    }
    if (has_low_bytes) code = code << 8 | *low++;
    *codes++ = static_cast<std::uint16_t>(code);
  }
  return true;
}

/// `count` codes one after the other. False if they are not all that lies there.
[[gnu::noinline]] bool unpack(Groups groups, std::uint32_t widths, std::uint32_t count, std::uint16_t* codes) {
  for (; count >= kTileSide; count -= kTileSide, widths >>= 4, codes += kTileSide) {
    const std::uint32_t width = code_bits(widths & 0xF);
    if (static_cast<std::size_t>(groups.end - groups.low) < width) return false;
    if (width == 0) {
      for_row(kTileSide, [codes](std::uint32_t x) { codes[x] = 0; });
      continue;
    }
    take_group(groups, width,
               [codes]<std::uint32_t per_word, bool has_low_bytes>(const std::uint8_t* end, std::uint32_t bits_each,
                                                                   const std::uint8_t* low) {
                 unpack_eight<per_word, has_low_bytes>(end, bits_each, low, codes);
               });
  }
  return count == 0 ? groups.end == groups.low : unpack_last(groups, code_bits(widths & 0xF), count, codes);
}

/// start + code in covered cells, 0 in others.
void expand(const std::uint16_t* codes, const std::uint8_t* cover, std::uint32_t start, const Tile& tile) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    const std::uint32_t covered = cover[y];
    for_row(tile.width, [row, covered, start, &codes](std::uint32_t x) {
      row[x] = (covered >> x & 1) != 0 ? static_cast<std::uint16_t>(start + *codes++) : std::uint16_t{0};
    });
  }
}

/// Bits set in 0..15.
constexpr std::array<std::uint8_t, 16> kBitsSet{0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

std::uint32_t cells_in(const std::uint8_t* cover, std::uint32_t height) {
  std::uint32_t cells = 0;
  for (; height != 0; --height, ++cover) cells += std::uint32_t{kBitsSet[*cover & 0xF]} + kBitsSet[*cover >> 4];
  return cells;
}

}  // namespace

bool decode_codes(const std::uint8_t* bytes, std::size_t size, Opcode opcode, const std::uint8_t* cover,
                  const TileView<std::uint16_t>& tile) {
  const bool offsets = opcode >= kOffset;
  const std::uint32_t count = cover == nullptr ? kTileSide * tile.height : cells_in(cover, tile.height);
  const std::size_t head = code_head_bytes(opcode, count);
  if (size < head) return false;
  const Groups groups{bytes + head, bytes + size};
  const auto start = static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
  std::uint32_t widths = 0;
  if (offsets) {
    widths = (opcode - kOffset) * 0x11111111U;
  } else {
    for (const std::uint8_t* byte = groups.low; byte != bytes + 2;) widths = widths << 8 | *--byte;
  }
  if (cover == nullptr && !offsets) return decode_whole(groups, opcode, start, widths, tile);
  constexpr Cover kAll{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  if (cover == nullptr) cover = kAll.data();
  std::array<std::uint16_t, kTileCells> codes;
  if (!unpack(groups, widths, count, codes.data())) return false;
  const std::uint16_t* next = codes.data();
  if (offsets) {
    expand(next, cover, start, tile);
    return true;
  }
  return decode_rows(opcode, start, tile, [&]<Opcode predictor>(Row& row) {
    next = decode_covered<predictor>(next, *cover++, row);
    return true;
  });
}

}  // namespace zstrip::detail
