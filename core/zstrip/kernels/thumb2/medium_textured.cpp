// The assembly behind thumb/medium_textured.hpp: a pixel's values in registers, its steps and texture on the stack.
#include "zstrip/kernels/thumb/medium_textured.hpp"

#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb2/medium_edges.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// On the stack: 0 the scan, 4 how many rows, 8 the mask of rows and the texels, 16 the shift to a column and 128, 24
// the steps of depth, red, green and blue, 40 those of u and v, 48 the shift to a row, 52 the bases, 60 the factors to
// fractions, 68 the right shift, 72 how long a row is, then where it begins, 80 the inverses, from that of length 1 on.
[[gnu::naked]] void scan_textured_rows_thumb(TexturedScan&, const LitWordRunState&, std::int32_t, const std::int32_t*) {
  asm(ZSTRIP_MEDIUM_EDGES R"(
    @ The exact position, 16.16 texels, of 1/w, u/w and v/w in r4, r5 and r6: u into r3, v into r0. Takes r11 and lr.
    .macro zstrip_textured_position name
      mov   r0, r4
      cmp   r0, #1
      it    lo
      movlo r0, #1
      clz   r3, r0
      lsl   r0, r0, r3
      lsr   r11, r0, #16              @ as reciprocal()
      mvn   lr, #0
      udiv  r11, lr, r11
      lsl   r11, r11, #14
      umull lr, r0, r11, r0
      rsb   r0, r0, #0x80000000
      lsls  r0, r0, #1
      umull lr, r0, r11, r0
      ldr   r11, [sp, #68]
      lsls  r0, r0, #1
      subs  r11, r11, r3
      smull lr, r3, r5, r0
      smull lr, r0, r6, r0
      bmi   .Ltextured_left_\name
      asr   r3, r3, r11               @ from 32 on it leaves the sign
      asr   r0, r0, r11
    .Ltextured_shifted_\name:
      ldrd  r11, lr, [sp, #52]
      add   r3, r3, r11
      add   r0, r0, lr
    .endm
    @ What that does where it shifts to the left.
    .macro zstrip_textured_left name
    .Ltextured_left_\name:
      rsb   r11, r11, #0
      cmp   r11, #31
      it    gt
      movgt r11, #31
      lsl   r3, r3, r11
      lsl   r0, r0, r11
      b     .Ltextured_shifted_\name
    .endm
    @ Two values of the scan in r3 at column lr and row r12, from their starts. Takes r0 and r11.
    .macro zstrip_textured_at first second step_x step_y
      ldrd  r0, r11, [r3, #\step_x]
      mla   \first, r0, lr, \first
      mla   \second, r11, lr, \second
      ldrd  r0, r11, [r3, #\step_y]
      mla   \first, r0, r12, \first
      mla   \second, r11, r12, \second
    .endm

    push  {r4-r11, lr}
    sub   sp, sp, #84
    strd  r0, r2, [sp]
    subs  r3, r3, #4
    str   r3, [sp, #80]
    add   r3, r1, #20
    ldm   r3, {r4-r8}                 @ step of depth, texels, shift to a column, to a row, mask
    mov   r9, r5
    mov   r5, #128
    strd  r8, r9, [sp, #8]
    strd  r6, r5, [sp, #16]
    str   r7, [sp, #48]
    add   r3, r0, #92
    ldm   r3, {r5-r7}                 @ steps of the channels
    add   r3, r0, #196
    ldm   r3, {r8-r12}                @ both bases, both factors, right shift
    add   r3, sp, #24
    stm   r3, {r4-r7}
    add   r3, sp, #52
    stm   r3, {r8-r12}
  .Ltextured_row:
    ldr   r0, [sp]
    zstrip_medium_edges
    add   r3, r0, #40
    ldm   r3!, {r1, r2, r4, r5}       @ rows and strides
    add   r4, r4, r1
    add   r5, r5, r2
    strd  r4, r5, [r0, #40]
    ldr   r11, [r0, #216]             @ this row
    cmp   r12, #0
    add   r4, r11, #1
    str   r4, [r0, #216]
    ble   .Ltextured_next_row
    ldm   r3, {r7-r10}                @ starts of depth and light
    sub   r3, r3, #56
    ldrd  r4, r5, [r3, #160]          @ of texture coordinates
    ldr   r6, [r3, #168]
    str   r12, [sp, #72]
    mov   r12, r11
    zstrip_textured_at r4, r5, 184, 172
    zstrip_textured_at r7, r8, 88, 72
    zstrip_textured_at r9, r10, 96, 80
    ldr   r0, [r3, #192]
    ldr   r11, [r3, #180]
    mla   r6, r0, lr, r6
    mla   r6, r11, r12, r6
    ldr   r12, [sp, #72]
    add   r1, r1, lr, lsl #1
    add   r2, r2, lr, lsl #1
    subs  r2, r2, r1
    subs  r2, r2, #2                  @ from behind a cell of depth to its pixel
    zstrip_textured_position from
    cmp   r12, #1
    bne   .Ltextured_steps
    ldrd  r11, lr, [sp, #60]
    mul   r5, r3, r11
    mul   r6, r0, lr
    ldr   r12, [sp, #48]
  .Ltextured_pixel:
    @ r1 the cell, r2 from behind it to its pixel, r5, r6, r7 u, v and depth, r8, r9, r10 light, r12 the shift to a row
    @ and above its byte how many pixels follow
    ldrh  r0, [r1], #2
    cmp   r0, r7, lsr #16
    bhs   .Ltextured_hidden
    lsrs  r0, r7, #16
    strh  r0, [r1, #-2]
    ldrd  r3, lr, [sp, #16]
    lsr   r11, r5, r3
    ldrd  r3, r4, [sp, #8]
    lsr   r0, r6, r12
    ands  r0, r0, r3
    add   r0, r0, r11
    ldrh  r0, [r4, r0, lsl #1]
    lsrs  r3, r8, #16                 @ light_factor, then multiplied()
    add   r3, r3, r8, lsr #23
    lsrs  r4, r0, #11
    mla   r4, r3, r4, lr
    lsrs  r4, r4, #8
    lsr   r3, r9, #16
    add   r3, r3, r9, lsr #23
    ubfx  r11, r0, #5, #6
    mla   r11, r3, r11, lr
    lsr   r11, r11, #8
    orr   r4, r11, r4, lsl #6
    lsr   r3, r10, #16
    add   r3, r3, r10, lsr #23
    and   r0, r0, #31
    mla   r0, r3, r0, lr
    lsrs  r0, r0, #8
    orr   r0, r0, r4, lsl #5
    strh  r0, [r1, r2]
  .Ltextured_hidden:
    subs  r12, r12, #256
    blo   .Ltextured_next_row
    ldrd  r3, r4, [sp, #24]
    ldrd  r0, r11, [sp, #32]
    add   r7, r7, r3
    add   r8, r8, r4
    add   r9, r9, r0
    add   r10, r10, r11
    ldrd  r3, r4, [sp, #40]
    add   r5, r5, r3
    add   r6, r6, r4
    b     .Ltextured_pixel
  .Ltextured_next_row:
    ldr   r3, [sp, #4]
    subs  r3, r3, #1
    str   r3, [sp, #4]
    bne   .Ltextured_row
    add   sp, sp, #84
    pop   {r4-r11, pc}

    @ The position at the last pixel, and the steps from the first one to it.
  .Ltextured_steps:
    strd  r3, r0, [sp, #72]
    ldr   lr, [sp]
    sub   r11, r12, #1
    ldrd  r0, r3, [lr, #184]
    mla   r4, r0, r11, r4
    mla   r5, r3, r11, r5
    ldr   r0, [lr, #192]
    mla   r6, r0, r11, r6
    zstrip_textured_position to
    ldrd  r11, lr, [sp, #72]
    subs  r4, r3, r11
    sub   r5, r0, lr
    ldr   r0, [sp, #80]
    ldr   r0, [r0, r12, lsl #2]
    smull r3, r6, r4, r0
    smull r0, r4, r5, r0
    lsrs  r3, r3, #16
    orr   r3, r3, r6, lsl #16
    lsrs  r0, r0, #16
    orr   r0, r0, r4, lsl #16
    ldrd  r4, r5, [sp, #60]
    mul   r6, lr, r5
    mul   r3, r3, r4
    mul   r0, r0, r5
    mul   r5, r11, r4
    strd  r3, r0, [sp, #40]
    ldr   r0, [sp, #48]
    sub   r12, r12, #1
    add   r12, r0, r12, lsl #8
    b     .Ltextured_pixel
    zstrip_textured_left from
    zstrip_textured_left to
    .purgem zstrip_textured_position
    .purgem zstrip_textured_left
    .purgem zstrip_textured_at
    .purgem zstrip_medium_edges
  )");
}

#endif

}  // namespace zstrip::detail
