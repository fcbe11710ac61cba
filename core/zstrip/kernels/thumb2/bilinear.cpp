// The assembly of thumb2/bilinear.hpp. Green, or alpha, of both rows lies in the halves of a word, and so do red and
// blue of one row: three products give the means of all channels along both rows.
#include "zstrip/kernels/thumb2/bilinear.hpp"

#include <cstddef>

#include "zstrip/kernels/thumb/layout.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// clang-format off
#define ZSTRIP_BILINEAR_RUN(field, number)                                          \
  field(bilinear, BilinearRun, step_x, 0)                                           \
  field(bilinear, BilinearRun, step_y, 4)                                           \
  field(bilinear, BilinearRun, end, 8)                                              \
  field(bilinear, BilinearRun, colours, 12)                                         \
  field(bilinear, BilinearRun, green, 16)                                           \
  field(bilinear, BilinearRun, step_green, 20)                                      \
  field(bilinear, BilinearRun, alpha, 24)                                           \
  field(bilinear, BilinearRun, step_alpha, 28)                                      \
  field(bilinear, BilinearRun, u, 32)                                               \
  field(bilinear, BilinearRun, step_u, 36)                                          \
  field(bilinear, BilinearRun, v, 40)                                               \
  field(bilinear, BilinearRun, step_v, 44)                                          \
  field(bilinear, BilinearRun, log2_width, 48)                                      \
  field(bilinear, BilinearRun, log2_height, 52)                                     \
  field(bilinear, BilinearRun, to_column, 56)                                       \
  field(bilinear, BilinearRun, to_row, 60)                                          \
  field(bilinear, BilinearRun, column_mask, 64)                                     \
  field(bilinear, BilinearRun, index_mask, 68)                                      \
  field(bilinear, BilinearRun, texels, 72)                                          \
  field(bilinear, BilinearRun, palette, 76)                                         \
  field(bilinear, BilinearRun, format, 80)                                          \
  number(bilinear.colour, sizeof(std::uint32_t), 4)                                 \
  number(palette8, static_cast<std::uint32_t>(TextureFormat::palette8), 2)          \
  number(palette4, static_cast<std::uint32_t>(TextureFormat::palette4), 3)
// clang-format on
ZSTRIP_CHECK_LAYOUT(ZSTRIP_BILINEAR_RUN)

[[gnu::naked]] void fetch_bilinear_thumb2(BilinearRun&) {
  asm(ZSTRIP_NAMES(ZSTRIP_BILINEAR_RUN) ".set .Lbilinear_alpha, 0\n"
#include "zstrip/kernels/thumb2/bilinear.inc"
  );
}

[[gnu::naked]] void fetch_bilinear_alpha_thumb2(BilinearRun&) {
  asm(ZSTRIP_NAMES(ZSTRIP_BILINEAR_RUN) ".set .Lbilinear_alpha, 1\n"
#include "zstrip/kernels/thumb2/bilinear.inc"
  );
}

#endif

}  // namespace zstrip::detail
