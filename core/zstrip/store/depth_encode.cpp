// Cells to the shortest record: a plane where one fits, else the best of offsets and the three kinds of residuals.
#include <bit>

#include "zstrip/store/code_stream.hpp"
#include "zstrip/store/depth_record.hpp"
#include "zstrip/store/depth_tile.hpp"
#include "zstrip/store/plane_fit.hpp"

namespace zstrip {
namespace detail {
namespace {

constexpr std::uint32_t kLiteralBits = 16;

CoveredCells load(const TileView<const std::uint16_t>& tile) {
  CoveredCells loaded;
  loaded.width = tile.width;
  loaded.height = tile.height;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      const std::uint16_t cell = tile.row(y)[x];
      loaded.cells[y * kTileSide + x] = cell;
      if (cell != 0) loaded.cover[y] = static_cast<std::uint8_t>(loaded.cover[y] | 1U << x);
    }
  }
  return loaded;
}

std::uint8_t* write_raw(const CoveredCells& tile, std::uint8_t* next) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      const std::uint16_t cell = tile.cells[y * kTileSide + x];
      *next++ = static_cast<std::uint8_t>(cell);
      *next++ = static_cast<std::uint8_t>(cell >> 8);
    }
  }
  return next;
}

/// Bit fields, lowest bits first.
class FieldWriter {
 public:
  explicit FieldWriter(std::uint8_t* next) : next_(next) {}
  /// 1 <= width <= 24.
  void append(std::uint32_t field, std::uint32_t width) {
    bits_ |= (field & ((1U << width) - 1)) << pending_;
    for (pending_ += width; pending_ >= 8; pending_ -= 8, bits_ >>= 8) *next_++ = static_cast<std::uint8_t>(bits_);
  }

 private:
  std::uint8_t* next_;
  std::uint32_t bits_ = 0;
  std::uint32_t pending_ = 0;
};

void write_plane(const FittedPlane& plane, std::uint8_t* next) {
  FieldWriter fields(next);
  fields.append(plane.start, 16U + plane.form->start_fraction);
  fields.append(static_cast<std::uint32_t>(plane.slope_x), plane.form->slope_bits);
  fields.append(static_cast<std::uint32_t>(plane.slope_y), plane.form->slope_bits);
}

/// All cells as offsets from the least one.
struct Offsets {
  std::uint16_t least = 0xFFFF;
  std::uint32_t width = 0;  ///< bits
  std::uint32_t bytes = 0;  ///< beyond the cover
};

Offsets measure_offsets(const CoveredCells& tile) {
  Offsets offsets;
  std::uint16_t greatest = 0;
  std::uint32_t count = 0;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      if ((tile.cover[y] >> x & 1) == 0) continue;
      const std::uint16_t cell = tile.cells[y * kTileSide + x];
      offsets.least = std::min(offsets.least, cell);
      greatest = std::max(greatest, cell);
      ++count;
    }
  }
  offsets.width = static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(greatest - offsets.least)));
  // 16 bits have no opcode.
  offsets.bytes = offsets.width < kLiteralBits ? 2 + (count * offsets.width + 7) / 8 : kLargestTileRecord;
  return offsets;
}

void write_offsets(const CoveredCells& tile, const Offsets& offsets, std::uint8_t* next) {
  *next++ = static_cast<std::uint8_t>(offsets.least);
  *next++ = static_cast<std::uint8_t>(offsets.least >> 8);
  CodeWriter codes(next);
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      if ((tile.cover[y] >> x & 1) == 0) continue;
      codes.append(static_cast<std::uint32_t>(tile.cells[y * kTileSide + x] - offsets.least), offsets.width);
    }
  }
  codes.finish();
}

/// What one predictor leaves.
struct Residuals {
  Opcode predictor = kAlong;
  std::array<std::int16_t, kTileCells> residuals{};
  Cover coded{};                                 ///< rows of width 0 have no codes, the start neither
  std::array<std::uint8_t, kTileSide> widths{};  ///< as in the record
  std::uint16_t start = 0;
  std::uint32_t bytes = 0;  ///< beyond the cover
};

/// Bits of a residual in two's complement; one more where the code would be the escape.
std::uint32_t code_width(std::int32_t residual) {
  if (residual == 0) return 0;
  const std::uint32_t magnitude = static_cast<std::uint32_t>(residual < 0 ? -residual : residual);
  return static_cast<std::uint32_t>(std::bit_width(magnitude)) + 1;
}

/// The width with the fewest bits for a row, and these bits.
struct RowChoice {
  std::uint32_t width, bits;
};

RowChoice choose_width(const std::int16_t* residuals, std::uint32_t coded) {
  std::array<std::uint8_t, kLiteralBits + 2> needing{};  // residuals that need exactly i bits
  std::uint32_t count = 0, most = 0;
  for (; coded != 0; coded >>= 1, ++residuals) {
    if ((coded & 1) == 0) continue;
    const std::uint32_t needed = code_width(*residuals);
    ++needing[needed];
    ++count;
    most = std::max(most, needed);
  }
  if (most == 0) return {0, 0};
  RowChoice best{kLiteralWidth, count * kLiteralBits};
  std::uint32_t literals = count - needing[0];
  for (std::uint32_t width = 1; width < kLiteralWidth && width <= most; ++width) {
    literals -= needing[width];
    const std::uint32_t bits = count * width + literals * kLiteralBits;
    if (bits < best.bits) best = {width, bits};
  }
  return best;
}

/// Cells that are not covered take what is predicted, as in the decoder.
Residuals measure_residuals(const CoveredCells& tile, Opcode predictor) {
  Residuals result;
  result.predictor = predictor;
  std::array<std::uint16_t, kTileCells> cells = tile.cells;
  for (std::uint32_t y = 0; y < tile.height && result.start == 0; ++y) {
    for (std::uint32_t x = 0; x < tile.width && result.start == 0; ++x) result.start = cells[y * kTileSide + x];
  }
  std::uint32_t bytes = 2 + (tile.height + 1) / 2;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = cells.data() + y * kTileSide;
    const std::uint16_t* const above = y > 0 ? row - kTileSide : row;
    const std::uint16_t* const above2 = y > 1 ? above - kTileSide : above;
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      std::int32_t predicted;
      if (x == 0) {
        predicted = y == 0 ? result.start : 2 * above[0] - above2[0];
      } else if (y == 0 || (predictor == kAlong && x > 1)) {
        predicted = x == 1 ? row[0] : 2 * row[x - 1] - row[x - 2];
      } else if (predictor == kColumn && y > 1) {
        predicted = 2 * above[x] - above2[x];
      } else {
        predicted = above[x] + row[x - 1] - above[x - 1];
      }
      if ((tile.cover[y] >> x & 1) == 0) row[x] = static_cast<std::uint16_t>(predicted);
      result.residuals[y * kTileSide + x] = static_cast<std::int16_t>(row[x] - predicted);
    }
    result.coded[y] = tile.cover[y];
    const RowChoice choice = choose_width(result.residuals.data() + y * kTileSide, result.coded[y]);
    result.widths[y] = static_cast<std::uint8_t>(choice.width);
    if (choice.width == 0) result.coded[y] = 0;
    bytes += (choice.bits + 7) / 8;
  }
  result.bytes = bytes;
  return result;
}

void write_residuals(const CoveredCells& tile, const Residuals& chosen, std::uint8_t* next, std::uint8_t* end) {
  *next++ = static_cast<std::uint8_t>(chosen.start);
  *next++ = static_cast<std::uint8_t>(chosen.start >> 8);
  for (std::uint32_t y = 0; y < tile.height; y += 2) {
    *next++ = static_cast<std::uint8_t>(chosen.widths[y] | (y + 1 < tile.height ? chosen.widths[y + 1] << 4 : 0));
  }
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    const std::uint32_t width = chosen.widths[y];
    CodeWriter codes(next);
    for (std::uint32_t coded = chosen.coded[y]; coded != 0; coded &= coded - 1) {
      const std::int32_t residual =
          chosen.residuals[y * kTileSide + static_cast<std::uint32_t>(std::countr_zero(coded))];
      const auto bits = static_cast<std::uint32_t>(residual);
      if (width == kLiteralWidth) {
        codes.append(bits, kLiteralBits);
      } else if (code_width(residual) <= width) {
        codes.append(bits, width);
      } else {
        codes.append(static_cast<std::uint32_t>(escape_code(width)), width);
        *--end = static_cast<std::uint8_t>(bits >> 8);
        *--end = static_cast<std::uint8_t>(bits);
      }
    }
    next = codes.finish();
  }
}

/// The record's first byte and the cover; returns what follows.
std::uint8_t* write_head(unsigned opcode, CoverKind kind, const CoveredCells& tile, std::uint8_t* next) {
  *next++ = first_byte(opcode, kind);
  write_cover(kind, tile.cover, tile.width, tile.height, next);
  return next + cover_bytes(kind, tile.height);
}

}  // namespace
}  // namespace detail

std::uint32_t encode_depth_tile(const TileView<const std::uint16_t>& view,
                                std::span<std::byte, kLargestTileRecord> record) {
  using namespace detail;
  const CoveredCells tile = load(view);
  bool any = false;
  for (const std::uint8_t row : tile.cover) any = any || row != 0;
  if (!any) return 0;
  auto* const first = reinterpret_cast<std::uint8_t*>(record.data());
  const std::uint32_t raw_bytes = 2 * view.area();
  const CoverKind kind = cover_kind(tile.cover, tile.width, tile.height);
  const std::uint32_t head_bytes = 1 + cover_bytes(kind, tile.height);

  if (const auto plane = fit_plane(tile); plane && head_bytes + plane->form->bytes < raw_bytes) {
    write_plane(*plane, write_head(kPlane + plane->more_fraction, kind, tile, first));
    return head_bytes + plane->form->bytes;
  }
  const Offsets offsets = measure_offsets(tile);
  Residuals best = measure_residuals(tile, kDown);
  for (const Opcode predictor : {kAlong, kColumn}) {
    const Residuals other = measure_residuals(tile, predictor);
    if (other.bytes < best.bytes) best = other;
  }
  if (head_bytes + std::min(best.bytes, offsets.bytes) >= raw_bytes) {
    write_raw(tile, first);
    return raw_bytes;
  }
  if (offsets.bytes <= best.bytes) {
    write_offsets(tile, offsets, write_head(kOffset + offsets.width, kind, tile, first));
    return head_bytes + offsets.bytes;
  }
  write_residuals(tile, best, write_head(best.predictor, kind, tile, first), first + head_bytes + best.bytes);
  return head_bytes + best.bytes;
}

}  // namespace zstrip
