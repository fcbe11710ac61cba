// The assembly of thumb/medium_textured.hpp. A pixel's values are in registers, its steps and texture on the stack.
#include "zstrip/kernels/thumb/medium_textured.hpp"

#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb2/medium_edges.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// A row: the edges; then cell, depth, light and texture at the row's first pixel, in registers, which are listed at
// .Ltextured_pixel; the exact position there and, if the row is longer, at the last pixel; both steps; at last the
// pixels.
[[gnu::naked]] void scan_textured_rows_thumb(TexturedScan&, const LitWordRunState&, std::int32_t, const std::int32_t*) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_NAMES(ZSTRIP_TEXTURED_SCAN)
          ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_MEDIUM_EDGES R"(
    @ On the stack, in the pairs that ldrd and strd take:
    .set .Lstack.scan, 0
    .set .Lstack.rows, 4              @ left
    .set .Lstack.row_mask, 8
    .set .Lstack.texels, 12
    .set .Lstack.to_column, 16        @ shift
    .set .Lstack.half, 20             @ 128, which rounds a channel
    .set .Lstack.step_z, 24
    .set .Lstack.step_red, 28
    .set .Lstack.step_green, 32
    .set .Lstack.step_blue, 36
    .set .Lstack.step_u, 40
    .set .Lstack.step_v, 44
    .set .Lstack.to_row, 48           @ shift
    .set .Lstack.base_u, 52
    .set .Lstack.base_v, 56
    .set .Lstack.to_fraction_u, 60
    .set .Lstack.to_fraction_v, 64
    .set .Lstack.right_shift, 68
    .set .Lstack.length, 72           @ of the row
    .set .Lstack.from_u, 72           @ later the position at its first pixel
    .set .Lstack.from_v, 76
    .set .Lstack.inverses, 80         @ for lengths
    .set .Lstack.size, 84

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
      ldr   r11, [sp, #.Lstack.right_shift]
      lsls  r0, r0, #1
      subs  r11, r11, r3
      smull lr, r3, r5, r0
      smull lr, r0, r6, r0
      bmi   .Ltextured_left_\name
      asr   r3, r3, r11               @ from 32 on it leaves the sign
      asr   r0, r0, r11
    .Ltextured_shifted_\name:
      ldrd  r11, lr, [sp, #.Lstack.base_u]
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
    sub   sp, sp, #.Lstack.size
    strd  r0, r2, [sp, #.Lstack.scan]
    subs  r3, r3, #4                  @ so that the index is a length
    str   r3, [sp, #.Lstack.inverses]
    add   r3, r1, #.Lrun.step_z
    ldm   r3, {r4-r8}                 @ step of depth, texels, shift to a column, to a row, mask
    mov   r9, r5
    mov   r5, #128
    strd  r8, r9, [sp, #.Lstack.row_mask]
    strd  r6, r5, [sp, #.Lstack.to_column]
    str   r7, [sp, #.Lstack.to_row]
    add   r3, r0, #.Lmedium.step_x_red
    ldm   r3, {r5-r7}                 @ steps of the channels
    add   r3, r0, #.Ltextured.base_u
    ldm   r3, {r8-r12}                @ both bases, both factors, right shift
    add   r3, sp, #.Lstack.step_z
    stm   r3, {r4-r7}
    add   r3, sp, #.Lstack.base_u
    stm   r3, {r8-r12}
  .Ltextured_row:
    ldr   r0, [sp, #.Lstack.scan]
    zstrip_medium_edges
    add   r3, r0, #.Lmedium.depth_row
    ldm   r3!, {r1, r2, r4, r5}       @ rows and strides
    add   r4, r4, r1
    add   r5, r5, r2
    strd  r4, r5, [r0, #.Lmedium.depth_row]
    ldr   r11, [r0, #.Ltextured.row]  @ this row
    cmp   r12, #0
    add   r4, r11, #1
    str   r4, [r0, #.Ltextured.row]
    ble   .Ltextured_next_row
    ldm   r3, {r7-r10}                @ starts of depth and light
    sub   r3, r3, #.Lmedium.start_depth
    ldrd  r4, r5, [r3, #.Ltextured.start_one_over_w] @ of texture coordinates
    ldr   r6, [r3, #.Ltextured.start_v_over_w]
    str   r12, [sp, #.Lstack.length]
    mov   r12, r11
    zstrip_textured_at r4, r5, .Ltextured.step_x_one_over_w, .Ltextured.step_y_one_over_w
    zstrip_textured_at r7, r8, .Lmedium.step_x_depth, .Lmedium.step_y_depth
    zstrip_textured_at r9, r10, .Lmedium.step_x_green, .Lmedium.step_y_green
    ldr   r0, [r3, #.Ltextured.step_x_v_over_w]
    ldr   r11, [r3, #.Ltextured.step_y_v_over_w]
    mla   r6, r0, lr, r6
    mla   r6, r11, r12, r6
    ldr   r12, [sp, #.Lstack.length]
    add   r1, r1, lr, lsl #1
    add   r2, r2, lr, lsl #1
    subs  r2, r2, r1
    subs  r2, r2, #.Lcell             @ from behind a cell of depth to its pixel
    zstrip_textured_position from
    cmp   r12, #1
    bne   .Ltextured_steps
    ldrd  r11, lr, [sp, #.Lstack.to_fraction_u]
    mul   r5, r3, r11
    mul   r6, r0, lr
    ldr   r12, [sp, #.Lstack.to_row]
  .Ltextured_pixel:
    @ r1 the cell, r2 from behind it to its pixel, r5, r6, r7 u, v and depth, r8, r9, r10 light, r12 the shift to a row
    @ and above its byte how many pixels follow
    ldrh  r0, [r1], #.Lcell
    cmp   r0, r7, lsr #16
    bhs   .Ltextured_hidden
    lsrs  r0, r7, #16
    strh  r0, [r1, #-.Lcell]
    ldrd  r3, lr, [sp, #.Lstack.to_column]
    lsr   r11, r5, r3
    ldrd  r3, r4, [sp, #.Lstack.row_mask]
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
    ldrd  r3, r4, [sp, #.Lstack.step_z]
    ldrd  r0, r11, [sp, #.Lstack.step_green]
    add   r7, r7, r3
    add   r8, r8, r4
    add   r9, r9, r0
    add   r10, r10, r11
    ldrd  r3, r4, [sp, #.Lstack.step_u]
    add   r5, r5, r3
    add   r6, r6, r4
    b     .Ltextured_pixel
  .Ltextured_next_row:
    ldr   r3, [sp, #.Lstack.rows]
    subs  r3, r3, #1
    str   r3, [sp, #.Lstack.rows]
    bne   .Ltextured_row
    add   sp, sp, #.Lstack.size
    pop   {r4-r11, pc}

    @ The position at the last pixel, and the steps from the first one to it.
  .Ltextured_steps:
    strd  r3, r0, [sp, #.Lstack.from_u]
    ldr   lr, [sp, #.Lstack.scan]
    sub   r11, r12, #1
    ldrd  r0, r3, [lr, #.Ltextured.step_x_one_over_w]
    mla   r4, r0, r11, r4
    mla   r5, r3, r11, r5
    ldr   r0, [lr, #.Ltextured.step_x_v_over_w]
    mla   r6, r0, r11, r6
    zstrip_textured_position to
    ldrd  r11, lr, [sp, #.Lstack.from_u]
    subs  r4, r3, r11
    sub   r5, r0, lr
    ldr   r0, [sp, #.Lstack.inverses]
    ldr   r0, [r0, r12, lsl #2]
    smull r3, r6, r4, r0
    smull r0, r4, r5, r0
    lsrs  r3, r3, #16
    orr   r3, r3, r6, lsl #16
    lsrs  r0, r0, #16
    orr   r0, r0, r4, lsl #16
    ldrd  r4, r5, [sp, #.Lstack.to_fraction_u]
    mul   r6, lr, r5
    mul   r3, r3, r4
    mul   r0, r0, r5
    mul   r5, r11, r4
    strd  r3, r0, [sp, #.Lstack.step_u]
    ldr   r0, [sp, #.Lstack.to_row]
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
