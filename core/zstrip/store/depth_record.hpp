// What encoder and decoder of depth records agree on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip/store/cover.hpp"

namespace zstrip::detail {

/// Bits 2..7 of a record's first byte; bits 0..1 are the CoverKind.
enum Opcode : std::uint8_t {
  kPlane = 0,    ///< 0..7: + slope fraction bits beyond those of the start
  kAlong = 8,    ///< residuals of a row's linear continuation
  kDown = 9,     ///< residuals of left + up - upleft
  kColumn = 10,  ///< residuals of a column's linear continuation
  kOffset = 16,  ///< 16..31: + bits of a cell's offset from the least one
};
constexpr std::uint8_t first_byte(unsigned opcode, CoverKind kind) {
  return static_cast<std::uint8_t>(opcode << 2 | static_cast<unsigned>(kind));
}

/// A plane's fields in order: start (16.fraction), slope along x, slope along y (signed), lowest bits first.
struct PlaneForm {
  std::uint8_t bytes, start_fraction, slope_bits;
};
inline constexpr std::array<PlaneForm, 3> kPlaneForms{{{5, 2, 11}, {6, 4, 14}, {8, 8, 20}}};

/// Widths of a row's codes: 0..14, and the last one for codes of 16 bits. In rows of 1 to 14 bits the most negative
/// code means that the residual stands among the literals.
inline constexpr std::uint32_t kLiteralWidth = 15;
constexpr std::int32_t escape_code(std::uint32_t width) { return -(std::int32_t{1} << (width - 1)); }

}  // namespace zstrip::detail
