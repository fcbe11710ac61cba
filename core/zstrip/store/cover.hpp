// The cells of a tile that a record describes: all, the first or last cells of each row, or any cells, as a bitmap.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "zstrip/store/tile.hpp"

namespace zstrip::detail {

/// The values are stored in the record.
enum class CoverKind : std::uint8_t {
  all = 0,
  leading = 1,   ///< four bits a row: cells x < n
  trailing = 2,  ///< four bits a row: cells x >= n
  bitmap = 3,    ///< a byte a row: bit x
};

/// Bit x of byte y is cell (x, y). Rows beyond the tile's height are 0.
struct alignas(std::uint32_t) Cover : std::array<std::uint8_t, kTileSide> {};

constexpr std::uint32_t cover_bytes(CoverKind kind, std::uint32_t height) {
  switch (kind) {
    case CoverKind::leading:
    case CoverKind::trailing: return (height + 1) / 2;
    case CoverKind::bitmap: return height;
    default: return 0;
  }
}

/// Returns a row with its `width` low bits set.
constexpr std::uint8_t whole_row(std::uint32_t width) { return static_cast<std::uint8_t>((1U << width) - 1); }

/// Returns the cheapest kind that can encode `cover`. Empty and full rows also count as leading or trailing.
CoverKind cover_kind(const Cover& cover, std::uint32_t width, std::uint32_t height);

/// Writes cover_bytes(kind, height) bytes; `kind` must be able to encode `cover`.
void write_cover(CoverKind kind, const Cover& cover, std::uint32_t width, std::uint32_t height, std::uint8_t* bytes);

/// Reads cover_bytes(kind, height) bytes. For any contents, bits outside `width` and `height` are 0 in the result.
Cover read_cover(CoverKind kind, const std::uint8_t* bytes, std::uint32_t width, std::uint32_t height);

inline std::uint32_t cells_in(const Cover& cover) {
  const auto halves = std::bit_cast<std::array<std::uint32_t, 2>>(cover);
  return static_cast<std::uint32_t>(std::popcount(halves[0]) + std::popcount(halves[1]));
}

}  // namespace zstrip::detail
