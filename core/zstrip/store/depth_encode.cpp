// Encodes cells as a short record: one plane or two if they fit, else the best of offsets and three kinds of residuals.
#include <algorithm>
#include <bit>

#include "zstrip/store/code_stream.hpp"
#include "zstrip/store/depth_record.hpp"
#include "zstrip/store/depth_tile.hpp"
#include "zstrip/store/plane_fit.hpp"
#include "zstrip/store/two_planes.hpp"

namespace zstrip {
namespace detail {
namespace {

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

std::uint32_t raw_bytes(const CoveredCells& tile) { return 2 * tile.width * tile.height; }

void write_raw(const CoveredCells& tile, std::uint8_t* next) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      const std::uint16_t cell = tile.cells[y * kTileSide + x];
      *next++ = static_cast<std::uint8_t>(cell);
      *next++ = static_cast<std::uint8_t>(cell >> 8);
    }
  }
}

/// Writes bit fields, lowest bits first.
class FieldWriter {
 public:
  explicit FieldWriter(std::uint8_t* next) : next_(next) {}
  /// Appends the low `width` bits; 1 <= width <= 24.
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

void write_two_planes(const TwoPlanes& planes, std::uint8_t* next) {
  *next++ = static_cast<std::uint8_t>(planes.first.more_fraction | planes.others.more_fraction << 3 |
                                      static_cast<std::uint32_t>(planes.first.form - kPlaneForms.data()) << 6);
  write_plane(planes.first, next);
  write_plane(planes.others, next + planes.first.form->bytes);
}

/// The covered cells as codes, row by row, in groups of eight. Each group has a width.
struct Coded {
  Opcode opcode = 0;
  std::uint16_t start = 0;
  std::array<std::int16_t, kTileCells> codes{};
  std::uint32_t count = 0;
  std::array<std::uint8_t, kTileSide> widths{};  ///< as encoded in the record
  std::uint32_t bytes = 0;                       ///< number of bytes after the cover

  std::uint32_t width_at(std::uint32_t code) const { return code_bits(widths[code / kTileSide]); }
};

/// Returns the encoded width that is enough for all codes of a group in two's complement.
std::uint8_t group_width(const std::int16_t* codes, std::uint32_t count) {
  std::uint32_t magnitudes = 0;  // the bits of all codes, negative ones inverted
  bool any = false;
  for (; count != 0; --count, ++codes) {
    magnitudes |= static_cast<std::uint32_t>(*codes < 0 ? ~*codes : *codes);
    any = any || *codes != 0;
  }
  if (!any) return 0;
  return static_cast<std::uint8_t>(std::min(static_cast<std::uint32_t>(std::bit_width(magnitudes)) + 1, kWidthOf16));
}

void count_bytes(Coded& coded) {
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < coded.count; i += kTileSide) {
    bits += coded.width_at(i) * std::min(coded.count - i, kTileSide);
  }
  coded.bytes = code_head_bytes(coded.opcode, coded.count) + (bits + 7) / 8;
}

/// Encodes the covered cells as offsets from the middle between the least and the greatest of them.
Coded code_offsets(const CoveredCells& tile) {
  Coded coded;
  std::uint32_t least = 0xFFFF, greatest = 0;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    const std::uint16_t* cell = tile.cells.data() + y * kTileSide;
    for (std::uint32_t row = tile.cover[y]; row != 0; row >>= 1, ++cell) {
      if ((row & 1) == 0) continue;
      least = std::min<std::uint32_t>(least, *cell);
      greatest = std::max<std::uint32_t>(greatest, *cell);
      coded.codes[coded.count++] = static_cast<std::int16_t>(*cell);
    }
  }
  const std::uint32_t written =
      std::clamp<std::uint32_t>(static_cast<std::uint32_t>(std::bit_width(greatest - least)), 1U, kWidthOf16);
  coded.opcode = kOffset + written;
  coded.start = static_cast<std::uint16_t>(least + (1U << (code_bits(written) - 1)));
  for (std::uint32_t i = 0; i < coded.count; ++i) {
    coded.codes[i] = static_cast<std::int16_t>(coded.codes[i] - coded.start);
  }
  coded.widths.fill(static_cast<std::uint8_t>(written));
  count_bytes(coded);
  return coded;
}

/// Cells that are not covered get the predicted value, as in the decoder.
Coded code_residuals(const CoveredCells& tile, Opcode predictor) {
  Coded coded;
  coded.opcode = predictor;
  std::array<std::uint16_t, kTileCells> cells = tile.cells;
  for (std::uint32_t y = 0; y < tile.height && coded.start == 0; ++y) {
    for (std::uint32_t x = 0; x < tile.width && coded.start == 0; ++x) coded.start = cells[y * kTileSide + x];
  }
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = cells.data() + y * kTileSide;
    const std::uint16_t* const above = y > 0 ? row - kTileSide : row;
    const std::uint16_t* const above2 = y > 1 ? above - kTileSide : above;
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      std::int32_t predicted;
      if (x == 0) {
        predicted = y == 0 ? coded.start : 2 * above[0] - above2[0];
      } else if (y == 0 || (predictor == kAlong && x > 1)) {
        predicted = x == 1 ? row[0] : 2 * row[x - 1] - row[x - 2];
      } else if (predictor == kColumn && y > 1) {
        predicted = 2 * above[x] - above2[x];
      } else {
        predicted = above[x] + row[x - 1] - above[x - 1];
      }
      if ((tile.cover[y] >> x & 1) == 0) {
        row[x] = static_cast<std::uint16_t>(predicted);
      } else {
        coded.codes[coded.count++] = static_cast<std::int16_t>(row[x] - predicted);
      }
    }
  }
  for (std::uint32_t i = 0; i < coded.count; i += kTileSide) {
    coded.widths[i / kTileSide] = group_width(coded.codes.data() + i, std::min(coded.count - i, kTileSide));
  }
  count_bytes(coded);
  return coded;
}

void write_codes(const Coded& coded, std::uint8_t* next) {
  *next++ = static_cast<std::uint8_t>(coded.start);
  *next++ = static_cast<std::uint8_t>(coded.start >> 8);
  const std::uint32_t width_bytes = code_head_bytes(coded.opcode, coded.count) - 2;
  for (std::uint32_t i = 0; i < width_bytes; ++i) {
    *next++ = static_cast<std::uint8_t>(coded.widths[2 * i] | coded.widths[2 * i + 1] << 4);
  }
  for (std::uint32_t i = 0; i < coded.count; ++i) {
    if (coded.width_at(i) > 8) *next++ = static_cast<std::uint8_t>(coded.codes[i]);
  }
  CodeWriter writer(next);
  for (std::uint32_t i = 0; i < coded.count; ++i) {
    const auto code = static_cast<std::uint32_t>(coded.codes[i]);
    if (coded.width_at(i) > 8) {
      writer.append(code >> 8, coded.width_at(i) - 8);
    } else {
      writer.append(code, coded.width_at(i));
    }
  }
  std::reverse(next, writer.finish());
}

/// Writes the record's first byte and the cover; returns the address after them.
std::uint8_t* write_head(Opcode opcode, CoverKind kind, const Cover& cover, const CoveredCells& tile,
                         std::uint8_t* next) {
  *next++ = first_byte(opcode, kind);
  write_cover(kind, cover, tile.width, tile.height, next);
  return next + cover_bytes(kind, tile.height);
}

// Each of these functions writes a record that is shorter than the raw cells and returns its size, or 0 if it cannot.
// They are not inlined, so that the stack holds the data of one of them, not of all.

[[gnu::noinline]] std::uint32_t write_as_plane(const CoveredCells& tile, CoverKind kind, std::uint8_t* record) {
  const auto plane = fit_plane(tile);
  if (!plane) return 0;
  const std::uint32_t bytes = 1 + cover_bytes(kind, tile.height) + plane->form->bytes;
  if (bytes >= raw_bytes(tile)) return 0;
  write_plane(*plane, write_head(kPlane + plane->more_fraction, kind, tile.cover, tile, record));
  return bytes;
}

[[gnu::noinline]] std::uint32_t write_as_two_planes(const CoveredCells& tile, std::uint8_t* record) {
  const auto planes = fit_two_planes(tile);
  if (!planes) return 0;
  const CoverKind split = cover_kind(planes->cover, tile.width, tile.height);
  const std::uint32_t bytes = 1 + cover_bytes(split, tile.height) + planes->bytes();
  if (bytes >= raw_bytes(tile)) return 0;
  write_two_planes(*planes, write_head(kTwoPlanes, split, planes->cover, tile, record));
  return bytes;
}

[[gnu::noinline]] std::uint32_t write_as_codes(const CoveredCells& tile, CoverKind kind, std::uint8_t* record) {
  Coded best = code_offsets(tile);
  for (const Opcode predictor : {kDown, kAlong, kColumn}) {
    const Coded other = code_residuals(tile, predictor);
    if (other.bytes < best.bytes) best = other;
  }
  const std::uint32_t bytes = 1 + cover_bytes(kind, tile.height) + best.bytes;
  if (bytes >= raw_bytes(tile)) return 0;
  write_codes(best, write_head(best.opcode, kind, tile.cover, tile, record));
  return bytes;
}

}  // namespace
}  // namespace detail

std::uint32_t encode_depth_tile(const TileView<const std::uint16_t>& view,
                                std::span<std::byte, kMaxTileRecord> record) {
  using namespace detail;
  const CoveredCells tile = load(view);
  bool any = false;
  for (const std::uint8_t row : tile.cover) any = any || row != 0;
  if (!any) return 0;
  auto* const bytes = reinterpret_cast<std::uint8_t*>(record.data());
  const CoverKind kind = cover_kind(tile.cover, tile.width, tile.height);
  if (const std::uint32_t size = write_as_plane(tile, kind, bytes)) return size;
  if (kind == CoverKind::all) {
    if (const std::uint32_t size = write_as_two_planes(tile, bytes)) return size;
  }
  if (const std::uint32_t size = write_as_codes(tile, kind, bytes)) return size;
  write_raw(tile, bytes);
  return raw_bytes(tile);
}

}  // namespace zstrip
