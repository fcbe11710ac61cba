// Bits of codes are stored from the record's end towards its head: the highest bit of the last byte comes first. A word
// read for the last codes then extends into the head, never outside the record, so that codes need no check each.
#include "zstrip/store/depth_codes.hpp"

#include <algorithm>
#include <array>

#include "zstrip/store/decode_steps.hpp"

namespace zstrip::detail {
namespace {

using Tile = TileView<std::uint16_t>;

/// The unread codes, in groups of eight: bits before `end`, low bytes from `low` on.
struct Groups {
  const std::uint8_t* low;
  const std::uint8_t* end;
};

/// Returns the `count` bytes before `end` (1..4) as bits in the order of the codes, from the highest bit on.
template <std::uint32_t count>
[[gnu::always_inline]] inline std::uint32_t bits_before(const std::uint8_t* end) {
  std::uint32_t bits = 0;
  for (std::uint32_t i = 1; i <= count; ++i) bits |= std::uint32_t{*(end - i)} << (32 - 8 * i);
  return bits;
}

/// Unpacks eight codes of `width` bits. One function for each width, so that every shift is a constant.
template <std::uint32_t width>
[[gnu::noinline]] void unpack_eight(const std::uint8_t* end, const std::uint8_t* low, std::uint16_t* codes) {
  constexpr bool kHasLowBytes = width > 8;
  constexpr std::uint32_t kBits = kHasLowBytes ? width - 8 : width;
  constexpr std::uint32_t kPerWord = kBits <= 4 ? 8 : 4;
  constexpr std::uint32_t kWordBytes = (kPerWord * kBits + 7) / 8;
  constexpr std::uint32_t kSkipped = kTileSide * kBits / 16;  // whole bytes before the second word
  std::uint32_t bits = bits_before<kWordBytes>(end);
  for_row(
      kTileSide, [&](std::uint32_t x) __attribute__((always_inline)) {
        if (x == kPerWord) bits = bits_before<kWordBytes>(end - kSkipped) << (kPerWord * kBits % 8);
        const std::uint32_t at_the_top = bits << x % kPerWord * kBits;
        const auto code = static_cast<std::uint32_t>(static_cast<std::int32_t>(at_the_top) >> (32 - kBits));
        codes[x] = static_cast<std::uint16_t>(kHasLowBytes ? code << 8 | low[x] : code);
      });
}

/// Unpacks a group of codes of a written width. The caller has checked that the group lies in the record.
[[gnu::always_inline]] inline void unpack_group(const Groups& groups, std::uint32_t written, std::uint16_t* codes) {
  const std::uint8_t *const end = groups.end, *const low = groups.low;
  switch (written) {
    case 0: return for_row(kTileSide, [codes](std::uint32_t x) { codes[x] = 0; });
    case 1: return unpack_eight<1>(end, low, codes);
    case 2: return unpack_eight<2>(end, low, codes);
    case 3: return unpack_eight<3>(end, low, codes);
    case 4: return unpack_eight<4>(end, low, codes);
    case 5: return unpack_eight<5>(end, low, codes);
    case 6: return unpack_eight<6>(end, low, codes);
    case 7: return unpack_eight<7>(end, low, codes);
    case 8: return unpack_eight<8>(end, low, codes);
    case 9: return unpack_eight<9>(end, low, codes);
    case 10: return unpack_eight<10>(end, low, codes);
    case 11: return unpack_eight<11>(end, low, codes);
    case 12: return unpack_eight<12>(end, low, codes);
    case 13: return unpack_eight<13>(end, low, codes);
    case 14: return unpack_eight<14>(end, low, codes);
    default: return unpack_eight<16>(end, low, codes);
  }
}

/// Unpacks less than eight codes.
void unpack_some(const Groups& groups, std::uint32_t width, std::uint32_t count, std::uint16_t* codes) {
  const bool has_low_bytes = width > 8;
  const std::uint32_t bits_each = has_low_bytes ? width - 8 : width;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t code = 0;
    if (width != 0) {
      const std::uint32_t bit = i * bits_each;
      const std::uint32_t bits = little_endian(groups.end - 4 - bit / 8) << bit % 8;
      code = static_cast<std::uint32_t>(static_cast<std::int32_t>(bits) >> (32 - bits_each));
    }
    codes[i] = static_cast<std::uint16_t>(has_low_bytes ? code << 8 | groups.low[i] : code);
  }
}

/// Unpacks the codes of one group after the other, `stride` cells apart; each group has room for eight codes. Codes
/// after the last of `count` codes may have any value. Returns false if the codes do not fill `groups` exactly. At
/// least 3 bytes must lie before `groups`.
[[gnu::noinline]] bool unpack(Groups groups, std::uint32_t widths, std::uint32_t count, std::uint16_t* codes,
                              std::uint32_t stride) {
  const Groups all = groups;
  for (; count >= kTileSide; count -= kTileSide, widths >>= 4, codes += stride) {
    const std::uint32_t written = widths & 0xF, width = code_bits(written);
    if (static_cast<std::size_t>(groups.end - groups.low) < width) return false;
    unpack_group(groups, written, codes);
    if (width > 8) {
      groups.low += kTileSide;
      groups.end += kTileSide;
    }
    groups.end -= width;
  }
  if (count == 0) return groups.end == groups.low;
  const std::uint32_t written = widths & 0xF, width = code_bits(written);
  const std::uint32_t low_bytes = width > 8 ? count : 0;
  const std::uint32_t bits = count * (width > 8 ? width - 8 : width);
  if (static_cast<std::size_t>(groups.end - groups.low) != low_bytes + (bits + 7) / 8) return false;
  // Eight codes are read: the surplus bytes are codes, too.
  if (all.end - groups.low >= 8 && groups.end - all.low >= 8) {
    unpack_group(groups, written, codes);
  } else {
    unpack_some(groups, width, count, codes);
  }
  return true;
}

struct Rows {
  std::uint16_t* row;
  const std::uint16_t* above;  ///< the row above, from which the first row is predicted
  std::uint32_t stride, width, count;
  std::uint32_t rise;  ///< of the first column's prediction: `above` minus the row above it
};

/// Sets cell = prediction + code for a row. `code_at(x)` returns the code at x; `for_each` calls its argument for each
/// x.
template <Opcode predictor, typename CodeAt, typename ForEach>
[[gnu::always_inline]] inline void predict_row(std::uint16_t* row, const std::uint16_t* above, std::uint32_t stride,
                                               std::uint32_t& rise, CodeAt code_at, ForEach for_each) {
  const std::uint16_t* const above2 = predictor == kColumn ? above - stride : nullptr;
  // The difference from the cell that predicts the next cell to the next cell.
  std::uint32_t gradient = 0;
  std::uint32_t cell = 0;
  for_each([&](std::uint32_t x) __attribute__((always_inline)) {
    const std::uint32_t code = code_at(x);
    if (x == 0) {
      rise += code;
      gradient = rise;
      cell = above[0] + rise;
    } else if constexpr (predictor == kColumn) {
      cell = 2U * above[x] - above2[x] + code;
    } else {
      if (predictor == kAlong && x == 1) gradient = static_cast<std::uint32_t>(above[1] - above[0]);
      gradient += code;
      in_order(gradient);
      cell = (predictor == kAlong ? cell : above[x]) + gradient;
    }
    row[x] = static_cast<std::uint16_t>(cell);
  });
}

/// Predicts in place: the cells hold their codes. 8 columns.
template <Opcode predictor>
[[gnu::noinline]] void predict_whole(const Rows& rows) {
  std::uint16_t* row = rows.row;
  const std::uint16_t* above = rows.above;
  const std::uint32_t stride = rows.stride;
  std::uint32_t rise = rows.rise;
  for (std::uint32_t count = rows.count; count != 0; --count) {
    predict_row<predictor>(
        row, above, stride, rise, [row](std::uint32_t x) __attribute__((always_inline)) { return row[x]; },
        [](auto step) __attribute__((always_inline)) { for_row(kTileSide, step); });
    above = row;
    row += stride;
  }
}

struct CoveredCodes {
  const std::uint16_t* next;
  const std::uint8_t* cover;  ///< the cover of the next row
};

template <Opcode predictor>
[[gnu::noinline]] void predict_covered(const Rows& rows, CoveredCodes& codes) {
  std::uint16_t* row = rows.row;
  const std::uint16_t* above = rows.above;
  const std::uint16_t* next = codes.next;
  const std::uint32_t stride = rows.stride, width = rows.width;
  std::uint32_t rise = rows.rise;
  const auto whole = [](auto step) __attribute__((always_inline)) { for_row(kTileSide, step); };
  for (std::uint32_t count = rows.count; count != 0; --count) {
    const std::uint32_t cover = *codes.cover++;
    const auto covered_code = [ cover, &next ](std::uint32_t x) __attribute__((always_inline)) {
      return covers(cover, x) ? *next++ : 0U;
    };
    if (cover == 0xFF) {
      const auto code = [next](std::uint32_t x) __attribute__((always_inline)) { return next[x]; };
      predict_row<predictor>(row, above, stride, rise, code, whole);
      next += kTileSide;
    } else if (width == kTileSide) {
      predict_row<predictor>(row, above, stride, rise, covered_code, whole);
    } else {
      predict_row<predictor>(row, above, stride, rise, covered_code, [width](auto step) {
        for (std::uint32_t x = 0; x < width; ++x) step(x);
      });
    }
    above = row;
    row += stride;
  }
  codes.next = next;
}

/// Calls `predict.operator()<predictor>(rows)` for all rows of a tile.
template <typename Predict>
[[gnu::always_inline]] inline void predict_tile(Opcode opcode, std::uint16_t start, const Tile& tile, Predict predict) {
  // The cells above the first row have the value `start`.
  const std::array<std::uint16_t, 2> start_cells{start, start};
  Rows rows{tile.cells, start_cells.data(), tile.stride, tile.width, 1, 0};
  predict.template operator()<kAlong>(rows);
  const auto go_on = [&](std::uint32_t count) {
    rows.above = rows.row;
    rows.row += rows.stride;
    rows.count = count;
  };
  std::uint32_t left = tile.height - 1;
  if (opcode == kColumn && left != 0) {  // a column's slope needs two rows
    go_on(1);
    --left;
    predict.template operator()<kDown>(rows);
    rows.rise = static_cast<std::uint32_t>(rows.row[0] - rows.above[0]);
  }
  go_on(left);
  switch (opcode) {
    case kAlong: return predict.template operator()<kAlong>(rows);
    case kDown: return predict.template operator()<kDown>(rows);
    default: return predict.template operator()<kColumn>(rows);
  }
}

/// Sets covered cells to start + code, and other cells to 0.
[[gnu::noinline]] void expand(const std::uint16_t* codes, const std::uint8_t* cover, std::uint32_t start,
                              const Tile& tile) {
  std::uint16_t* row = tile.cells;
  const std::uint32_t stride = tile.stride, width = tile.width;
  for (std::uint32_t rows = tile.height; rows != 0; --rows, row += stride) {
    const std::uint32_t covered = *cover++;
    for_row(
        width, [ row, covered, start, &codes ](std::uint32_t x) __attribute__((always_inline)) {
          row[x] = covers(covered, x) ? static_cast<std::uint16_t>(start + *codes++) : std::uint16_t{0};
        });
  }
}

}  // namespace

bool decode_codes(const std::uint8_t* bytes, std::size_t size, Opcode opcode, const Cover* cover,
                  const TileView<std::uint16_t>& tile) {
  const bool offsets = opcode >= kOffset;
  const std::uint32_t count = cover == nullptr ? kTileSide * tile.height : cells_in(*cover);
  const std::size_t head = code_head_bytes(opcode, count);
  if (size < head) return false;
  const Groups groups{bytes + head, bytes + size};
  const auto start = static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
  std::uint32_t widths = 0;
  if (offsets) {
    widths = (opcode - kOffset) * 0x11111111U;
  } else {
    for (const std::uint8_t* byte = groups.low; byte != bytes + 2;) widths = widths << 8 | *--byte;
  }
  if (cover == nullptr && !offsets) {
    if (!unpack(groups, widths, count, tile.cells, tile.stride)) return false;
    predict_tile(opcode, start, tile, []<Opcode predictor>(const Rows& rows) { predict_whole<predictor>(rows); });
    return true;
  }
  constexpr Cover kAll{{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}};
  if (cover == nullptr) cover = &kAll;
  std::array<std::uint16_t, kTileCells> codes;
  if (!unpack(groups, widths, count, codes.data(), kTileSide)) return false;
  if (offsets) {
    expand(codes.data(), cover->data(), start, tile);
    return true;
  }
  CoveredCodes covered{codes.data(), cover->data()};
  predict_tile(opcode, start, tile,
               [&covered]<Opcode predictor>(const Rows& rows) { predict_covered<predictor>(rows, covered); });
  return true;
}

}  // namespace zstrip::detail
