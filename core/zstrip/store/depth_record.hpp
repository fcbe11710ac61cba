// Constants and types that encoder and decoder of depth records share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip/store/cover.hpp"

namespace zstrip::detail {

/// Bits 2..7 of a record's first byte; bits 0..1 are the CoverKind.
using Opcode = std::uint32_t;
inline constexpr Opcode kPlane = 0;       ///< 0..7: + fraction bits of the slopes, in addition to those of the start
inline constexpr Opcode kAlong = 8;       ///< residuals of the linear continuation of a row
inline constexpr Opcode kDown = 9;        ///< residuals of left + up - upleft
inline constexpr Opcode kColumn = 10;     ///< residuals of the linear continuation of a column
inline constexpr Opcode kTwoPlanes = 11;  ///< one plane for the cover, one for all other cells
inline constexpr Opcode kOffset = 16;     ///< 17..31: + encoded width of the cells' offsets from one value
constexpr std::uint8_t first_byte(Opcode opcode, CoverKind kind) {
  return static_cast<std::uint8_t>(opcode << 2 | static_cast<unsigned>(kind));
}

/// A plane's fields in order: start (16.fraction), slope along x, slope along y (signed), lowest bits first.
struct PlaneForm {
  std::uint8_t bytes, start_fraction, slope_bits;
};
inline constexpr std::array<PlaneForm, 3> kPlaneForms{{{5, 2, 11}, {6, 4, 14}, {8, 8, 20}}};

/// Widths of codes are encoded in four bits: 0..14 unchanged, 16 as 15.
inline constexpr std::uint32_t kWidthOf16 = 15;
constexpr std::uint32_t code_bits(std::uint32_t written) { return written == kWidthOf16 ? 16 : written; }

/// Returns the bytes before `codes` codes: the start and a width for each eight codes. Offsets have only one width.
constexpr std::uint32_t code_head_bytes(Opcode opcode, std::uint32_t codes) {
  return 2 + (opcode < kOffset ? (codes + 15) / 16 : 0);
}

}  // namespace zstrip::detail
