// Records of depth back to cells. Every offset is checked before it is used; arithmetic is modulo 2^16 as in the
// encoder.
#include <bit>
#include <cstddef>

#include "zstrip/store/code_stream.hpp"
#include "zstrip/store/depth_record.hpp"
#include "zstrip/store/depth_tile.hpp"

namespace zstrip {
namespace detail {
namespace {

using Tile = TileView<std::uint16_t>;

struct Bytes {
  const std::uint8_t* next;
  const std::uint8_t* end;

  std::size_t size() const { return static_cast<std::size_t>(end - next); }
};

/// For each cell of a row, `step(x)`; unrolled where the row is whole.
template <typename Step>
[[gnu::always_inline]] inline void for_row(std::uint32_t width, Step step) {
  if (width == kTileSide) {
    step(0), step(1), step(2), step(3), step(4), step(5), step(6), step(7);
  } else {
    for (std::uint32_t x = 0; x < width; ++x) step(x);
  }
}

/// Makes the compiler compute a chain of values one after the other. Left alone it computes them side by side, which
/// takes more registers than Thumb-1 has and twice the time.
[[gnu::always_inline]] inline void in_order(std::uint32_t& value) { asm("" : "+r"(value)); }

[[gnu::noinline]] void decode_cleared(const Tile& tile) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    for_row(tile.width, [row](std::uint32_t x) { row[x] = 0; });
  }
}

[[gnu::noinline]] void decode_raw(const std::uint8_t* bytes, const Tile& tile) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    for_row(tile.width, [row, bytes](std::uint32_t x) {
      row[x] = static_cast<std::uint16_t>(bytes[2 * x] | bytes[2 * x + 1] << 8);
    });
    bytes += 2 * tile.width;
  }
}

/// 16.16 and modulo 2^32: the fraction bits of all fields end above bit 0.
struct DecodedPlane {
  std::uint32_t start, step_x, step_y;
};

std::uint32_t little_endian(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
}

DecodedPlane read_plane(const std::uint8_t* bytes, const PlaneForm& form, std::uint32_t more_fraction) {
  const std::uint32_t low = little_endian(bytes), high = little_endian(bytes + form.bytes - 4);  // they may overlap
  // Each slope at the top of a word; in the longest form that along x begins in the low word.
  const std::uint32_t x = high << form.slope_bits | (form.bytes == 8 ? low >> 24 << 12 : 0);
  const std::uint32_t down = 32U - form.slope_bits, up = 16U - form.start_fraction - more_fraction;  // up >= 1
  const auto slope = [down, up](std::uint32_t top) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(top) >> down) << up;
  };
  return {low << (16 - form.start_fraction), slope(x), slope(high)};
}

void decode_plane(const DecodedPlane& plane, const Tile& tile) {
  const std::uint32_t step = plane.step_x, step_y = plane.step_y, stride = tile.stride;
  std::uint32_t row_start = plane.start;
  std::uint16_t* row = tile.cells;
  std::uint32_t rows = tile.height;
  if (tile.width < kTileSide) {
    for (; rows != 0; --rows, row_start += step_y, row += stride) {
      std::uint32_t value = row_start;
      for (std::uint32_t x = 0; x < tile.width; ++x, value += step) row[x] = static_cast<std::uint16_t>(value >> 16);
    }
    return;
  }
  for (; rows != 0; --rows, row_start += step_y, row += stride) {
    std::uint32_t value = row_start;
    for_row(kTileSide, [row, step, &value](std::uint32_t x) {
      row[x] = static_cast<std::uint16_t>(value >> 16);
      value += step;
      in_order(value);
    });
  }
}

/// A plane alone; it must fill the rest of the record.
[[gnu::noinline]] bool decode_plane_record(const std::uint8_t* bytes, std::size_t size, std::uint32_t more_fraction,
                                           const Tile& tile) {
  for (const PlaneForm& form : kPlaneForms) {
    if (form.bytes != size) continue;
    decode_plane(read_plane(bytes, form, more_fraction), tile);
    return true;
  }
  return false;
}

void clear_uncovered(const Cover& cover, const Tile& tile) {
  const std::uint8_t whole = whole_row(tile.width);
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    if (cover[y] == whole) continue;
    std::uint16_t* cell = tile.row(y);
    for (std::uint32_t uncovered = cover[y] ^ whole; uncovered != 0; uncovered >>= 1, ++cell) {
      if ((uncovered & 1) != 0) *cell = 0;
    }
  }
}

bool decode_offsets(const Bytes& bytes, std::uint32_t width, const Cover& cover, const Tile& tile) {
  if (bytes.size() < 2) return false;
  const auto least = static_cast<std::uint32_t>(bytes.next[0] | bytes.next[1] << 8);
  CodeReader codes(bytes.next + 2, bytes.end);
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    std::uint32_t covered = cover[y];
    for (std::uint32_t x = 0; x < tile.width; ++x, covered >>= 1) {
      if ((covered & 1) == 0) {
        row[x] = 0;
      } else {
        row[x] = static_cast<std::uint16_t>(least + (width == 0 ? 0 : codes.code(width)));
      }
    }
  }
  return codes.bytes_used() + 2 == bytes.size();
}

/// The residuals of all cells of a tile, modulo 2^16; 0 where a cell has no code. Row y starts at 8 y.
using ResidualCells = std::array<std::uint16_t, kTileCells>;

/// The codes of a tile, row by row, each from a byte on, and its literals, from the end backwards. What is missing is
/// 0.
struct ResidualCodes {
  const std::uint8_t* next;     ///< the next row's codes
  const std::uint8_t* end;      ///< of the record
  const std::uint8_t* literal;  ///< the last one taken
  bool missing;
};

/// 32 bits from a byte on.
inline std::uint32_t word_at(const std::uint8_t* next, const std::uint8_t* end) {
  if (end - next >= 4) {
    return std::uint32_t{next[0]} << 24 | std::uint32_t{next[1]} << 16 | std::uint32_t{next[2]} << 8 | next[3];
  }
  std::uint32_t word = 0;
  for (int shift = 24; next != end; shift -= 8) word |= std::uint32_t{*next++} << shift;
  return word;
}

[[gnu::noinline]] std::uint16_t take_literal(ResidualCodes& codes) {
  if (codes.literal - codes.next < 2) {
    codes.missing = true;
    return 0;
  }
  codes.literal -= 2;
  return static_cast<std::uint16_t>(codes.literal[0] | codes.literal[1] << 8);
}

/// Codes that have room in 32 bits behind at most 7 others, for any position in a row.
constexpr std::uint32_t codes_per_word(std::uint32_t width) { return width <= 4 ? 8 : width <= 8 ? 4 : 2; }

/// A row in which all 8 cells have a code; its bytes are there.
template <std::uint32_t per_word>
[[gnu::noinline]] void read_whole_row(ResidualCodes& codes, std::uint32_t width, std::int32_t escape,
                                      std::uint16_t* residuals) {
  std::uint32_t bits = 0;
  const std::uint32_t down = 32 - width;
  const auto step = [&](std::uint32_t x) __attribute__((always_inline)) {
    if (x % per_word == 0) bits = word_at(codes.next + x * width / 8, codes.end) << (x * width % 8);
    const std::int32_t code = static_cast<std::int32_t>(bits) >> down;
    bits <<= width;
    in_order(bits);
    residuals[x] = static_cast<std::uint16_t>(code);
    if (code == escape) residuals[x] = take_literal(codes);
  };
  step(0), step(1), step(2), step(3), step(4), step(5), step(6), step(7);
}

/// A row in which cell x has a code if bit x of `coded` is set; their bytes are there.
[[gnu::noinline]] void read_row(ResidualCodes& codes, std::uint32_t width, std::int32_t escape, std::uint32_t coded,
                                std::uint16_t* residuals) {
  const std::uint32_t per_word = codes_per_word(width), down = 32 - width;
  std::uint32_t bit = 0, bits = 0, left = 0;
  for (; coded != 0; coded >>= 1, ++residuals) {
    if ((coded & 1) == 0) continue;
    if (left == 0) {
      bits = word_at(codes.next + bit / 8, codes.end) << bit % 8;
      left = per_word;
    }
    const std::int32_t code = static_cast<std::int32_t>(bits) >> down;
    bits <<= width;
    bit += width;
    --left;
    *residuals = code == escape ? take_literal(codes) : static_cast<std::uint16_t>(code);
  }
}

/// `cover`: nullptr if all of 8 cells a row have codes. False if these are not all codes and literals of a tile.
[[gnu::noinline]] bool read_residuals(const Bytes& bytes, std::uint32_t widths, std::uint32_t height,
                                      const std::uint8_t* cover, std::uint16_t* residuals) {
  ResidualCodes codes{bytes.next, bytes.end, bytes.end, false};
  for (; height != 0; --height, residuals += kTileSide, widths >>= 4) {
    std::uint32_t width = widths & 0xF;
    const std::uint32_t coded = cover == nullptr ? 0xFF : *cover++;
    if (width == 0 || coded != 0xFF) for_row(kTileSide, [residuals](std::uint32_t x) { residuals[x] = 0; });
    if (width == 0 || coded == 0) continue;
    std::int32_t escape = INT32_MIN;
    if (width == kLiteralWidth) {
      width = 16;
    } else {
      escape = escape_code(width);
    }
    std::uint32_t row_bytes = width;
    if (coded != 0xFF) row_bytes = (static_cast<std::uint32_t>(std::popcount(coded)) * width + 7) / 8;
    if (row_bytes > static_cast<std::size_t>(codes.end - codes.next)) return false;
    if (coded != 0xFF) {
      read_row(codes, width, escape, coded, residuals);
    } else if (width <= 4) {
      read_whole_row<8>(codes, width, escape, residuals);
    } else if (width <= 8) {
      read_whole_row<4>(codes, width, escape, residuals);
    } else {
      read_whole_row<2>(codes, width, escape, residuals);
    }
    codes.next += row_bytes;
  }
  return codes.next == codes.literal && !codes.missing;
}

/// Cells 1.. of a row. `gradient` is what the last cell added to the one it was predicted from.
template <Opcode predictor>
[[gnu::always_inline]] inline void predict_row(std::uint16_t* row, std::uint32_t width, std::ptrdiff_t up,
                                               std::uint32_t gradient, const std::uint16_t* residuals) {
  const std::uint16_t *const above = row + up, *const above2 = above + up;
  std::uint32_t cell = row[0];
  const auto step = [&](std::uint32_t x) __attribute__((always_inline)) {
    if constexpr (predictor == kColumn) {
      cell = 2U * above[x] - above2[x] + residuals[x];
    } else {
      gradient += residuals[x];
      cell = (predictor == kAlong ? cell : above[x]) + gradient;
    }
    row[x] = static_cast<std::uint16_t>(cell);
  };
  if (width == kTileSide) {
    step(1), step(2), step(3), step(4), step(5), step(6), step(7);
  } else {
    for (std::uint32_t x = 1; x < width; ++x) step(x);
  }
}

/// Rows 1.. of a tile, of which the first is there.
template <Opcode predictor>
[[gnu::noinline]] void predict_rows(const std::uint16_t* residuals, const Tile& tile) {
  const std::ptrdiff_t up = -static_cast<std::ptrdiff_t>(tile.stride);
  const std::uint32_t width = tile.width;
  std::uint16_t* row = tile.cells;
  std::uint32_t rise = 0;  // of the first column
  for (std::uint32_t y = 1; y < tile.height; ++y) {
    row += tile.stride;
    residuals += kTileSide;
    rise += residuals[0];
    row[0] = static_cast<std::uint16_t>(row[up] + rise);
    if (predictor == kAlong) {
      predict_row<kAlong>(row, width, up, width > 1 ? static_cast<std::uint32_t>(row[up + 1] - row[up]) : 0, residuals);
    } else if (predictor == kDown || y == 1) {
      predict_row<kDown>(row, width, up, rise, residuals);
    } else {
      predict_row<kColumn>(row, width, up, 0, residuals);
    }
  }
}

/// Start, widths of the rows, codes row by row, literals. `cover`: nullptr if all of 8 cells a row have codes.
bool decode_residuals(const Bytes& bytes, Opcode predictor, const std::uint8_t* cover, const Tile& tile) {
  const std::uint32_t width_bytes = (tile.height + 1) / 2;
  if (bytes.size() < 2 + width_bytes) return false;
  const auto start = static_cast<std::uint32_t>(bytes.next[0] | bytes.next[1] << 8);
  std::uint32_t widths = 0;
  for (std::uint32_t i = 0; i < width_bytes; ++i) widths |= std::uint32_t{bytes.next[2 + i]} << (8 * i);
  ResidualCells residuals;
  if (!read_residuals({bytes.next + 2 + width_bytes, bytes.end}, widths, tile.height, cover, residuals.data())) {
    return false;
  }
  tile.cells[0] = static_cast<std::uint16_t>(start + residuals[0]);
  predict_row<kAlong>(tile.cells, tile.width, 0, 0, residuals.data());
  switch (predictor) {
    case kAlong: predict_rows<kAlong>(residuals.data(), tile); break;
    case kDown: predict_rows<kDown>(residuals.data(), tile); break;
    default: predict_rows<kColumn>(residuals.data(), tile); break;
  }
  return true;
}

/// Every record that has a first byte.
[[gnu::noinline]] bool decode_with_cover(const std::uint8_t* record, std::size_t size, const Tile& tile) {
  const auto kind = static_cast<CoverKind>(*record & 3U);
  const std::uint32_t opcode = *record >> 2;
  Bytes bytes{record + 1, record + size};
  const std::uint32_t cover_size = cover_bytes(kind, tile.height);
  if (bytes.size() < cover_size) return false;
  Cover cover{};
  // Residuals of a whole tile do without.
  const bool whole = kind == CoverKind::all && tile.width == kTileSide;
  if (!whole || opcode >= kOffset) cover = read_cover(kind, bytes.next, tile.width, tile.height);
  bytes.next += cover_size;
  bool decoded = false;
  if (opcode < kAlong) {
    decoded = decode_plane_record(bytes.next, bytes.size(), opcode - kPlane, tile);
  } else if (opcode <= kColumn) {
    decoded = decode_residuals(bytes, static_cast<Opcode>(opcode), whole ? nullptr : cover.data(), tile);
  } else if (opcode >= kOffset && opcode < kOffset + 16U) {
    return decode_offsets(bytes, opcode - kOffset, cover, tile);
  }
  if (decoded && kind != CoverKind::all) clear_uncovered(cover, tile);
  return decoded;
}

}  // namespace
}  // namespace detail

bool decode_depth_tile(std::span<const std::byte> record, const TileView<std::uint16_t>& tile) {
  using namespace detail;
  if (record.empty()) {
    decode_cleared(tile);
    return true;
  }
  // The same bytes as unsigned numbers.
  const auto* const first = reinterpret_cast<const std::uint8_t*>(record.data());
  if (record.size() >= 2 * tile.area()) {
    if (record.size() > 2 * tile.area()) return false;
    decode_raw(first, tile);
    return true;
  }
  // A plane without a cover, the most frequent record of rooms, has no need of more.
  if (*first < first_byte(kAlong, CoverKind::all) && (*first & 3) == 0) {
    return decode_plane_record(first + 1, record.size() - 1, *first >> 2, tile);
  }
  return decode_with_cover(first, record.size(), tile);
}

}  // namespace zstrip
