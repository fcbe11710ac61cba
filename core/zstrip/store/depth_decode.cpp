// Decodes records of depth. Every offset is checked before it is used; arithmetic is modulo 2^16 as in the encoder.
#include <cstddef>

#include "zstrip/store/decode_steps.hpp"
#include "zstrip/store/depth_codes.hpp"
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

/// A plane in 16.16, modulo 2^32: the fraction bits of all fields end above bit 0.
struct DecodedPlane {
  std::uint32_t start, step_x, step_y;
};

template <std::uint32_t form_index>
[[gnu::always_inline]] inline DecodedPlane read_plane(const std::uint8_t* bytes, std::uint32_t more_fraction) {
  constexpr PlaneForm kForm = kPlaneForms[form_index];
  const std::uint32_t low = little_endian(bytes), high = little_endian(bytes + kForm.bytes - 4);  // they may overlap
  // Each slope is at the top of a word. In the longest form the slope along x begins in the low word.
  const std::uint32_t x = high << kForm.slope_bits | (kForm.bytes == 8 ? low >> 24 << 12 : 0);
  constexpr std::uint32_t kSlopeShift = 32U - kForm.slope_bits;
  const std::uint32_t up = 16U - kForm.start_fraction - more_fraction;  // up >= 1
  const auto slope = [up](std::uint32_t top) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(top) >> kSlopeShift) << up;
  };
  return {low << (16 - kForm.start_fraction), slope(x), slope(high)};
}

/// Reads a plane. Returns false if no form has this size.
[[gnu::always_inline]] inline bool read_plane(const std::uint8_t* bytes, std::size_t size, std::uint32_t more_fraction,
                                              DecodedPlane& plane) {
  static_assert(kPlaneForms[0].bytes == 5 && kPlaneForms[1].bytes == 6 && kPlaneForms[2].bytes == 8);
  if (size == 6) {
    plane = read_plane<1>(bytes, more_fraction);
  } else if (size == 5) {
    plane = read_plane<0>(bytes, more_fraction);
  } else if (size == 8) {
    plane = read_plane<2>(bytes, more_fraction);
  } else {
    return false;
  }
  return true;
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

/// Decodes a plane without a cover, which must fill the rest of the record.
[[gnu::noinline]] bool decode_plane_record(const std::uint8_t* bytes, std::size_t size, std::uint32_t more_fraction,
                                           const Tile& tile) {
  DecodedPlane plane;
  if (!read_plane(bytes, size, more_fraction, plane)) return false;
  decode_plane(plane, tile);
  return true;
}

[[gnu::noinline]] void clear_uncovered(const Cover& cover, const Tile& tile) {
  const std::uint32_t width = tile.width, whole = whole_row(width), stride = tile.stride;
  std::uint16_t* row = tile.cells;
  const std::uint8_t* next = cover.data();
  for (std::uint32_t rows = tile.height; rows != 0; --rows, row += stride) {
    const std::uint32_t covered = *next++;
    if (covered == whole) continue;
    if (covered == 0) {
      for_row(
          width, [row](std::uint32_t x) __attribute__((always_inline)) { row[x] = 0; });
      continue;
    }
    for_row(
        width, [ row, covered ](std::uint32_t x) __attribute__((always_inline)) {
          if (!covers(covered, x)) row[x] = 0;
        });
  }
}

/// Writes a plane into the covered cells; the other cells do not change.
[[gnu::noinline]] void decode_plane_over(const DecodedPlane& plane, const Cover& cover, const Tile& tile) {
  const std::uint32_t step = plane.step_x, step_y = plane.step_y, stride = tile.stride, width = tile.width;
  std::uint32_t row_start = plane.start;
  std::uint16_t* row = tile.cells;
  const std::uint8_t* next = cover.data();
  for (std::uint32_t rows = tile.height; rows != 0; --rows, row_start += step_y, row += stride) {
    const std::uint32_t covered = *next++;
    if (covered == 0) continue;
    std::uint32_t value = row_start;
    if (covered == 0xFF) {
      for_row(
          kTileSide, [ row, step, &value ](std::uint32_t x) __attribute__((always_inline)) {
            row[x] = static_cast<std::uint16_t>(value >> 16);
            value += step;
            in_order(value);
          });
      continue;
    }
    for_row(
        width, [ row, covered, step, &value ](std::uint32_t x) __attribute__((always_inline)) {
          if (covers(covered, x)) row[x] = static_cast<std::uint16_t>(value >> 16);
          value += step;
          in_order(value);
        });
  }
}

/// Decodes two planes. One byte holds the number of the first plane's form and the additional fraction bits of both
/// planes' slopes; the planes follow.
bool decode_two_planes(const Bytes& bytes, const Cover& cover, const Tile& tile) {
  if (bytes.size() < 1) return false;
  const std::uint32_t forms = *bytes.next, form = forms >> 6;
  if (form >= kPlaneForms.size()) return false;
  const std::size_t first_bytes = kPlaneForms[form].bytes, planes_bytes = bytes.size() - 1;
  if (planes_bytes < first_bytes) return false;
  const std::uint8_t* const first = bytes.next + 1;
  DecodedPlane plane;
  if (!decode_plane_record(first + first_bytes, planes_bytes - first_bytes, forms >> 3 & 7, tile) ||
      !read_plane(first, first_bytes, forms & 7, plane)) {
    return false;
  }
  decode_plane_over(plane, cover, tile);
  return true;
}

constexpr bool has_codes(Opcode opcode) {
  return (opcode >= kAlong && opcode <= kColumn) || (opcode > kOffset && opcode < kOffset + 16U);
}

/// Decodes every record that is not empty.
[[gnu::noinline]] bool decode_with_cover(const std::uint8_t* record, std::size_t size, const Tile& tile) {
  const auto kind = static_cast<CoverKind>(*record & 3U);
  const Opcode opcode = *record >> 2;
  Bytes bytes{record + 1, record + size};
  const std::uint32_t cover_size = cover_bytes(kind, tile.height);
  if (bytes.size() < cover_size) return false;
  const Cover cover = read_cover(kind, bytes.next, tile.width, tile.height);
  bytes.next += cover_size;
  bool decoded = false;
  if (opcode < kAlong) {
    decoded = decode_plane_record(bytes.next, bytes.size(), opcode - kPlane, tile);
  } else if (opcode == kTwoPlanes) {
    return decode_two_planes(bytes, cover, tile);
  } else if (has_codes(opcode)) {
    decoded = decode_codes(bytes.next, bytes.size(), opcode, &cover, tile);
  }
  // Records of offsets have already cleared the other cells.
  if (decoded && kind != CoverKind::all && opcode < kOffset) clear_uncovered(cover, tile);
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
  // The record's bytes as unsigned numbers.
  const auto* const first = reinterpret_cast<const std::uint8_t*>(record.data());
  if (record.size() >= 2 * tile.area()) {
    if (record.size() > 2 * tile.area()) return false;
    decode_raw(first, tile);
    return true;
  }
  // A record without a cover has a shorter path.
  if ((*first & 3) == 0) {
    const Opcode opcode = *first >> 2;
    if (opcode < kAlong) return decode_plane_record(first + 1, record.size() - 1, opcode, tile);
    if (has_codes(opcode) && tile.width == kTileSide) {
      return decode_codes(first + 1, record.size() - 1, opcode, nullptr, tile);
    }
  }
  return decode_with_cover(first, record.size(), tile);
}

}  // namespace zstrip
