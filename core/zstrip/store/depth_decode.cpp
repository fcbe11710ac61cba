// Records of depth back to cells. Every offset is checked before it is used; arithmetic is modulo 2^16 as in the
// encoder.
#include <cstddef>
#include <cstring>

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

/// For each cell of a row, `step(x)`, unrolled where the row is whole.
template <typename Step>
[[gnu::always_inline]] inline void for_row(std::uint32_t width, Step step) {
  if (width == kTileSide) {
    step(0), step(1), step(2), step(3), step(4), step(5), step(6), step(7);
  } else {
    for (std::uint32_t x = 0; x < width; ++x) step(x);
  }
}

void decode_cleared(const Tile& tile) {
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    for_row(tile.width, [row](std::uint32_t x) { row[x] = 0; });
  }
}

void decode_raw(const std::uint8_t* bytes, const Tile& tile) {
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

/// Bit fields, lowest bits first.
class FieldReader {
 public:
  explicit FieldReader(const std::uint8_t* next) : next_(next) {}
  /// 1 <= width <= 24. Moved to the top of the word.
  std::uint32_t field(std::uint32_t width) {
    for (; available_ < width; available_ += 8) bits_ |= std::uint32_t{*next_++} << available_;
    const std::uint32_t value = bits_ << (32 - width);
    bits_ >>= width;
    available_ -= width;
    return value;
  }

 private:
  const std::uint8_t* next_;
  std::uint32_t bits_ = 0;
  std::uint32_t available_ = 0;
};

DecodedPlane read_plane(const std::uint8_t* bytes, const PlaneForm& form, std::uint32_t more_fraction) {
  FieldReader fields(bytes);
  const std::uint32_t start = fields.field(16U + form.start_fraction);  // 16.16 at once: 16 bits stand above the point
  // A signed field at the top of the word has 32 - slope_bits fraction bits too many.
  const std::uint32_t slope_fraction = form.start_fraction + more_fraction;  // at most 15
  const std::uint32_t down = 32U - form.slope_bits + slope_fraction - 16U;
  const auto slope = [&](std::uint32_t top) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(top) >> down);
  };
  const std::uint32_t step_x = slope(fields.field(form.slope_bits));
  return {start, step_x, slope(fields.field(form.slope_bits))};
}

void decode_plane(const DecodedPlane& plane, const Tile& tile) {
  std::uint32_t row_start = plane.start;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    std::uint16_t* const row = tile.row(y);
    std::uint32_t value = row_start;
    for_row(tile.width, [row, &value, step = plane.step_x](std::uint32_t x) {
      row[x] = static_cast<std::uint16_t>(value >> 16);
      value += step;
    });
    row_start += plane.step_y;
  }
}

void clear_uncovered(const Cover& cover, const Tile& tile) {
  const std::uint8_t whole = whole_row(tile.width);
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    if (cover[y] == whole) continue;
    std::uint16_t* const row = tile.row(y);
    for (std::uint32_t x = 0; x < tile.width; ++x) {
      if ((cover[y] >> x & 1) == 0) row[x] = 0;
    }
  }
}

/// The form of a plane that fills the rest of the record; nullptr if none does.
const PlaneForm* plane_form(std::size_t bytes) {
  for (const PlaneForm& form : kPlaneForms) {
    if (form.bytes == bytes) return &form;
  }
  return nullptr;
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

/// Residual tiles: start, widths of the rows, codes; literals from the end backwards.
class ResidualDecoder {
 public:
  ResidualDecoder(const Bytes& bytes, std::uint32_t height)
      : widths_(bytes.next + 2),
        codes_(bytes.next + 2 + (height + 1) / 2, bytes.end),
        first_literal_(bytes.end),
        size_(static_cast<std::size_t>(bytes.end - bytes.next) - 2 - (height + 1) / 2),
        start_(static_cast<std::uint16_t>(bytes.next[0] | bytes.next[1] << 8)) {}

  bool decode(Opcode predictor, const Cover& cover, const Tile& tile) {
    for (std::uint32_t y = 0; y < tile.height; ++y) {
      begin_row(y, cover[y]);
      std::uint16_t* const row = tile.row(y);
      const std::ptrdiff_t up = -static_cast<std::ptrdiff_t>(tile.stride);
      if (y == 0) {
        coded_ &= ~1U;  // the start needs no code
        row[0] = start_;
        continue_row(row, tile.width, -1, 0);
      } else {
        const std::int32_t above = row[up];
        const std::int32_t rise = y == 1 ? 0 : above - row[2 * up];
        row[0] = static_cast<std::uint16_t>(above + rise + residual(0));
        if (predictor == kColumn && y > 1) {
          continue_columns(row, tile.width, up);
        } else if (predictor == kAlong) {
          continue_row(row, tile.width, -1, tile.width > 1 ? row[up + 1] - above : 0);
        } else {
          continue_row(row, tile.width, up, row[0] - above);
        }
      }
    }
    return literals_ * 2 + codes_.bytes_used() == size_;
  }

 private:
  void begin_row(std::uint32_t y, std::uint8_t covered) {
    const std::uint32_t width = widths_[y / 2] >> (y % 2 * 4) & 0xFU;
    coded_ = width == 0 ? 0 : covered;
    width_ = width == kLiteralWidth ? 16 : width;
    escape_ = width == 0 || width == kLiteralWidth ? INT32_MIN : escape_code(width);
  }

  [[gnu::always_inline]] std::int32_t residual(std::uint32_t x) {
    if ((coded_ >> x & 1) == 0) return 0;
    const std::int32_t code = codes_.signed_code(width_);
    return code == escape_ ? literal() : code;
  }

  /// cell = cell at `base` + gradient, which the residual changes.
  void continue_row(std::uint16_t* row, std::uint32_t width, std::ptrdiff_t base, std::int32_t gradient) {
    for (std::uint32_t x = 1; x < width; ++x) {
      gradient += residual(x);
      row[x] = static_cast<std::uint16_t>(row[static_cast<std::ptrdiff_t>(x) + base] + gradient);
    }
  }

  void continue_columns(std::uint16_t* row, std::uint32_t width, std::ptrdiff_t up) {
    for (std::uint32_t x = 1; x < width; ++x) {
      const std::uint16_t* const above = row + x + up;
      row[x] = static_cast<std::uint16_t>(2 * above[0] - above[up] + residual(x));
    }
  }

  std::int32_t literal() {
    ++literals_;
    if (2 * literals_ > size_) return 0;
    first_literal_ -= 2;
    return first_literal_[0] | first_literal_[1] << 8;
  }

  const std::uint8_t* widths_;
  CodeReader codes_;
  const std::uint8_t* first_literal_;
  std::size_t size_;  ///< of codes and literals
  std::size_t literals_ = 0;
  std::uint32_t coded_ = 0;  ///< bit x: cell x of the row has a code
  std::uint32_t width_ = 0;
  std::int32_t escape_ = 0;
  std::uint16_t start_;
};

bool decode_residuals(const Bytes& bytes, Opcode predictor, CoverKind kind, const Cover& cover, const Tile& tile) {
  if (bytes.size() < 2 + (tile.height + 1) / 2) return false;
  ResidualDecoder decoder(bytes, tile.height);
  if (!decoder.decode(predictor, cover, tile)) return false;
  if (kind != CoverKind::all) clear_uncovered(cover, tile);
  return true;
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
  Bytes bytes{reinterpret_cast<const std::uint8_t*>(record.data()), nullptr};
  bytes.end = bytes.next + record.size();
  if (record.size() == 2 * tile.area()) {
    decode_raw(bytes.next, tile);
    return true;
  }
  const auto kind = static_cast<CoverKind>(*bytes.next & 3U);
  const std::uint32_t opcode = *bytes.next++ >> 2;
  const std::uint32_t cover_size = cover_bytes(kind, tile.height);
  if (record.size() > 2 * tile.area() || bytes.size() < cover_size) return false;
  if (opcode < kAlong && kind == CoverKind::all) {
    const PlaneForm* const form = plane_form(bytes.size());
    if (form == nullptr) return false;
    decode_plane(read_plane(bytes.next, *form, opcode - kPlane), tile);
    return true;
  }
  const Cover cover = read_cover(kind, bytes.next, tile.width, tile.height);
  bytes.next += cover_size;
  if (opcode < kAlong) {
    const PlaneForm* const form = plane_form(bytes.size());
    if (form == nullptr) return false;
    decode_plane(read_plane(bytes.next, *form, opcode - kPlane), tile);
    clear_uncovered(cover, tile);
    return true;
  }
  if (opcode <= kColumn) return decode_residuals(bytes, static_cast<Opcode>(opcode), kind, cover, tile);
  if (opcode >= kOffset && opcode < kOffset + 16U) return decode_offsets(bytes, opcode - kOffset, cover, tile);
  return false;
}

}  // namespace zstrip
