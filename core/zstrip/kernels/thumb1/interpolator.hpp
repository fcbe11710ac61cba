// The interpolator of an RP2040 computes addresses of texels, in assembly for Thumb-1.
//
// Each core of the chip has two interpolators of its own; this code uses the first one of the core that executes it,
// and sets all of its registers. An interrupt handler that uses it, too, must save and restore them.
#pragma once

#include "zstrip/kernels/thumb/run_layout.hpp"

// Registers of interpolator 0 of the core that executes this, counted from its first accumulator. Lane 0 has u and lane
// 1 has v; their steps are the bases, which ADD_RAW adds to the accumulators themselves. Shifts are one less than those
// to indices, because texels have two bytes; masks begin at a column's and at a row's lowest bit.
#define ZSTRIP_INTERPOLATOR                                                                \
  ".set .Linterp.accum0, 0x00\n"                                                           \
  ".set .Linterp.base2, 0x10\n"                                                            \
  ".set .Linterp.pop, 0x1c\n"                                                              \
  ".set .Linterp.ctrl0, 0x2c\n"                                                            \
  ".set .Linterp.ctrl1, 0x30\n"                                                            \
  "@ Sets r7 to the interpolator.\n"                                                       \
  ".macro zstrip_interpolator\n"                                                           \
  "  movs  r7, #0xD0\n"                                                                    \
  "  lsls  r7, r7, #24\n"                                                                  \
  "  adds  r7, r7, #0x80\n"                                                                \
  ".endm\n"                                                                                \
  "@ Sets r7, and the interpolator's texture from that of the run r0. Changes r4 to r6.\n" \
  ".macro zstrip_interpolated_texture\n"                                                   \
  "  zstrip_interpolator\n"                                                                \
  "  ldr   r4, [r0, #.Lrun.texels]\n"                                                      \
  "  str   r4, [r7, #.Linterp.base2]\n"                                                    \
  "  movs  r6, #1\n"                                                                       \
  "  lsls  r6, r6, #18             @ ADD_RAW\n"                                            \
  "  movs  r5, #31\n"                                                                      \
  "  lsls  r5, r5, #10             @ to the highest bit\n"                                 \
  "  adds  r6, r6, r5\n"                                                                   \
  "  ldr   r4, [r0, #.Lrun.to_column]\n"                                                   \
  "  movs  r5, #32                 @ from bit 1\n"                                         \
  "  adds  r5, r5, r6\n"                                                                   \
  "  adds  r5, r5, r4\n"                                                                   \
  "  subs  r5, r5, #1\n"                                                                   \
  "  str   r5, [r7, #.Linterp.ctrl0]\n"                                                    \
  "  movs  r5, #33                 @ from the bit above the width's logarithm\n"           \
  "  subs  r4, r5, r4\n"                                                                   \
  "  ldr   r5, [r0, #.Lrun.row_mask]\n"                                                    \
  "  lsrs  r5, r5, #1              @ a texture of one column: to_column is 31, not 32\n"   \
  "  bcc   .Linterp_wide\\@\n"                                                             \
  "  movs  r4, #1\n"                                                                       \
  ".Linterp_wide\\@:\n"                                                                    \
  "  lsls  r4, r4, #5\n"                                                                   \
  "  adds  r4, r4, r6\n"                                                                   \
  "  ldr   r5, [r0, #.Lrun.to_row]\n"                                                      \
  "  adds  r4, r4, r5\n"                                                                   \
  "  subs  r4, r4, #1\n"                                                                   \
  "  str   r4, [r7, #.Linterp.ctrl1]\n"                                                    \
  ".endm\n"
