// Divides texture coordinates by w, in assembly for Thumb-1 (Cortex-M0, M0+).
#pragma once

#include <cstdint>

#include "zstrip/base/division.hpp"

namespace zstrip::detail {

/// Returns u in the lower word and v in the upper one, without their bases, as TextureCoordinates<false>::position
/// computes them. `one_over_w` may be 0. `table`: the table of reciprocals, for an index that begins at 256.
std::uint64_t divide_texels_thumb1(std::uint32_t one_over_w, std::uint32_t u_over_w, std::uint32_t v_over_w,
                                   std::int32_t right_shift, std::uintptr_t table);

inline std::uint64_t divide_texels_thumb1(std::uint32_t one_over_w, std::uint32_t u_over_w, std::uint32_t v_over_w,
                                          std::int32_t right_shift) {
  const auto table = reinterpret_cast<std::uintptr_t>(kReciprocalTable.data());
  return divide_texels_thumb1(one_over_w, u_over_w, v_over_w, right_shift, table - 256 * sizeof(std::uint16_t));
}

}  // namespace zstrip::detail
