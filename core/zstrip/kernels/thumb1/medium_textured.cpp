// The assembly of thumb/medium_textured.hpp for Thumb-1 (Cortex-M0, M0+). A pixel's values are in registers, its steps
// and texture on the stack.
#include "zstrip/kernels/thumb/medium_textured.hpp"

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb1/medium_edges.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// A row: the edges, in the low registers; then cell, depth, light and texture at the row's first pixel, which go to the
// stack; the exact positions there and at the last pixel, by .Ltextured_position; both steps; at last the pixels.
// Divisions need every low register, so that all values of a row wait on the stack, in the order of ldm and stm.
[[gnu::naked]] static void scan_rows_of_texels(TexturedScan&, const LitWordRunState&, std::int32_t, const std::int32_t*,
                                               const std::uint16_t*) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_NAMES(ZSTRIP_TEXTURED_SCAN)
          ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL ZSTRIP_THUMB1_MEDIUM_EDGES R"(
    @ On the stack:
    .set .Lstack.scan, 0
    .set .Lstack.rows, 4              @ left
    .set .Lstack.normalisation, 8     @ of the last 1/w
    .set .Lstack.reciprocals, 12      @ the table for an index that begins at 256
    .set .Lstack.inverses, 16         @ for lengths
    .set .Lstack.to_column, 20        @ shifts
    .set .Lstack.to_row, 24
    .set .Lstack.row_mask, 28
    .set .Lstack.texels, 32
    .set .Lstack.step_z, 36
    .set .Lstack.step_red, 40         @ and of green and blue
    .set .Lstack.step_u, 52
    .set .Lstack.step_v, 56
    .set .Lstack.length, 60           @ of the row
    .set .Lstack.cell, 64             @ its first one
    .set .Lstack.to_pixel, 68         @ from a cell
    .set .Lstack.z, 72                @ and light at the first pixel
    .set .Lstack.one_over_w, 88       @ there
    .set .Lstack.u_over_w, 92
    .set .Lstack.v_over_w, 96
    .set .Lstack.from_u, 100          @ the exact position there
    .set .Lstack.from_v, 104
    .set .Lstack.size, 108

    @ The value \to plus the step at r0 times \by. Moves r0 behind that. Uses \with.
    .macro zstrip_textured_add to by with
      ldm   r0!, {\with}
      muls  \with, \by, \with
      adds  \to, \to, \with
    .endm
    @ A step a pixel to \to from the way that it is so far, for the inverse in r2. Uses r3.
    .macro zstrip_textured_step to
      uxth  r3, \to
      asrs  \to, \to, #16
      muls  \to, r2, \to
      muls  r3, r2, r3
      lsrs  r3, r3, #16
      adds  \to, \to, r3
    .endm

    sub   sp, sp, #.Lstack.size
    str   r0, [sp, #.Lstack.scan]
    str   r2, [sp, #.Lstack.rows]
    subs  r3, r3, #4                  @ so that the index is a length
    str   r3, [sp, #.Lstack.inverses]
    movs  r2, #0
    str   r2, [sp, #.Lstack.normalisation]
    ldr   r2, [sp, #.Lstack.size + .Lsaved]
    movs  r3, #2
    lsls  r3, r3, #8
    subs  r2, r2, r3
    str   r2, [sp, #.Lstack.reciprocals]
    adds  r1, r1, #.Lrun.step_z
    ldm   r1!, {r2-r6}                @ step of depth, texels, shift to a column, to a row, mask
    str   r2, [sp, #.Lstack.step_z]
    str   r3, [sp, #.Lstack.texels]
    add   r1, sp, #.Lstack.to_column
    stm   r1!, {r4-r6}
    adds  r0, r0, #.Lmedium.step_x_red
    ldm   r0!, {r2-r4}                @ steps of light
    add   r1, sp, #.Lstack.step_red
    stm   r1!, {r2-r4}
  .Ltextured_row:
    ldr   r0, [sp, #.Lstack.scan]
    zstrip_medium_edges
    subs  r1, r1, r7
    str   r1, [sp, #.Lstack.length]
    ldm   r6!, {r2-r5}                @ rows and strides
    adds  r4, r4, r2
    adds  r5, r5, r3
    str   r4, [r0, #.Lmedium.depth_row]
    str   r5, [r0, #.Lmedium.colour_row]
    adds  r0, r0, #.Ltextured.start_one_over_w
    ldr   r4, [r0, #.Ltextured.row - .Ltextured.start_one_over_w] @ this row
    adds  r5, r4, #1
    str   r5, [r0, #.Ltextured.row - .Ltextured.start_one_over_w]
    cmp   r1, #0
    bgt   .Ltextured_drawn
    b     .Ltextured_next_row
  .Ltextured_drawn:
    lsls  r1, r7, #1
    adds  r2, r2, r1
    adds  r3, r3, r1
    subs  r3, r3, r2
    str   r2, [sp, #.Lstack.cell]
    str   r3, [sp, #.Lstack.to_pixel]
    @ Texture, from its starts in r1 to r3, then depth and light, from theirs in r1, r2, r3 and r5: r4 steps down, r7 to
    @ the right.
    ldm   r0!, {r1-r3}
    zstrip_textured_add r1, r4, r5
    zstrip_textured_add r2, r4, r5
    zstrip_textured_add r3, r4, r5
    zstrip_textured_add r1, r7, r5
    zstrip_textured_add r2, r7, r5
    zstrip_textured_add r3, r7, r5
    add   r5, sp, #.Lstack.one_over_w
    stm   r5!, {r1-r3}
    movs  r0, r6
    ldm   r0!, {r1, r2, r3, r5}
    zstrip_textured_add r1, r4, r6
    zstrip_textured_add r2, r4, r6
    zstrip_textured_add r3, r4, r6
    zstrip_textured_add r5, r4, r6
    zstrip_textured_add r1, r7, r6
    zstrip_textured_add r2, r7, r6
    zstrip_textured_add r3, r7, r6
    zstrip_textured_add r5, r7, r6
    add   r6, sp, #.Lstack.z
    stm   r6!, {r1, r2, r3, r5}
    ldm   r6!, {r2, r4, r5}           @ 1/w, u/w, v/w
    bl    .Ltextured_position
    ldr   r4, [r7, #.Ltextured.to_fraction_u - .Ltextured.base_u] @ to fractions of the texture
    ldr   r5, [r7, #.Ltextured.to_fraction_v - .Ltextured.base_u]
    ldr   r6, [sp, #.Lstack.length]
    cmp   r6, #1
    beq   .Ltextured_one
    str   r1, [sp, #.Lstack.from_u]
    str   r0, [sp, #.Lstack.from_v]
    subs  r6, r6, #1
    subs  r7, r7, #.Ltextured.base_u - .Ltextured.step_x_one_over_w
    ldm   r7!, {r0, r3, r5}           @ the position at the last pixel, r6 steps to the right
    ldr   r2, [sp, #.Lstack.one_over_w]
    muls  r0, r6, r0
    adds  r2, r2, r0
    ldr   r4, [sp, #.Lstack.u_over_w]
    muls  r3, r6, r3
    adds  r4, r4, r3
    muls  r5, r6, r5
    ldr   r3, [sp, #.Lstack.v_over_w]
    adds  r5, r5, r3
    bl    .Ltextured_position
    ldr   r4, [r7, #.Ltextured.to_fraction_u - .Ltextured.base_u]
    ldr   r5, [r7, #.Ltextured.to_fraction_v - .Ltextured.base_u]
    ldr   r2, [sp, #.Lstack.from_u]
    ldr   r3, [sp, #.Lstack.from_v]
    subs  r1, r1, r2
    subs  r0, r0, r3
    muls  r2, r4, r2
    mov   r8, r2
    muls  r3, r5, r3
    mov   r9, r3
    ldr   r6, [sp, #.Lstack.length]
    cmp   r6, #2
    beq   .Ltextured_two
    ldr   r2, [sp, #.Lstack.inverses]
    lsls  r3, r6, #2
    ldr   r2, [r2, r3]
    zstrip_textured_step r1
    zstrip_textured_step r0
  .Ltextured_two:
    muls  r1, r4, r1
    muls  r0, r5, r0
    str   r1, [sp, #.Lstack.step_u]
    str   r0, [sp, #.Lstack.step_v]
    b     .Ltextured_pixels
  .Ltextured_one:
    muls  r1, r4, r1
    mov   r8, r1
    muls  r0, r5, r0
    mov   r9, r0
  .Ltextured_pixels:
    add   r4, sp, #.Lstack.cell
    ldm   r4!, {r0, r1, r5}           @ cell, from it to its pixel, depth
    mov   lr, r1
    ldm   r4!, {r1-r3}                @ light
    mov   r10, r1
    mov   r11, r2
    mov   r12, r3
    movs  r4, r0
    lsls  r6, r6, #1
    adds  r6, r6, r4
    ldr   r7, [sp, #.Lstack.texels]
  .Ltextured_pixel:
    @ r4 the cell, lr from there to its pixel, r6 behind the last cell, r5 depth, r7 texels, r8 u, r9 v, r10 to r12 light
    ldrh  r0, [r4]
    lsrs  r1, r5, #16
    cmp   r0, r1
    bhs   .Ltextured_hidden
    strh  r1, [r4]
    add   r3, sp, #.Lstack.to_column
    ldm   r3!, {r0-r2}                @ shifts to a column and to a row, mask
    mov   r3, r8
    lsrs  r3, r3, r0
    mov   r0, r9
    lsrs  r0, r0, r1
    ands  r0, r0, r2
    adds  r0, r0, r3
    lsls  r0, r0, #1
    ldrh  r0, [r7, r0]
    mov   r1, r10                     @ light_factor, then multiplied()
    lsrs  r2, r1, #23
    lsrs  r1, r1, #16
    adds  r1, r1, r2
    lsrs  r2, r0, #11
    muls  r1, r2, r1
    adds  r1, r1, #128
    lsrs  r1, r1, #8
    lsls  r1, r1, #6
    mov   r2, r11
    lsrs  r3, r2, #23
    lsrs  r2, r2, #16
    adds  r2, r2, r3
    lsls  r3, r0, #21
    lsrs  r3, r3, #26
    muls  r2, r3, r2
    adds  r2, r2, #128
    lsrs  r2, r2, #8
    orrs  r1, r1, r2
    lsls  r1, r1, #5
    mov   r2, r12
    lsrs  r3, r2, #23
    lsrs  r2, r2, #16
    adds  r2, r2, r3
    lsls  r0, r0, #27
    lsrs  r0, r0, #27
    muls  r2, r0, r2
    adds  r2, r2, #128
    lsrs  r2, r2, #8
    orrs  r1, r1, r2
    mov   r2, lr
    strh  r1, [r4, r2]
  .Ltextured_hidden:
    adds  r4, r4, #.Lcell
    cmp   r4, r6
    beq   .Ltextured_next_row
    add   r3, sp, #.Lstack.step_z
    ldm   r3!, {r0-r2}                @ steps of depth and light, then of u and v
    adds  r5, r5, r0
    add   r10, r10, r1
    add   r11, r11, r2
    ldm   r3!, {r0-r2}
    add   r12, r12, r0
    add   r8, r8, r1
    add   r9, r9, r2
    b     .Ltextured_pixel
  .Ltextured_next_row:
    ldr   r0, [sp, #.Lstack.rows]
    subs  r0, r0, #1
    beq   .Ltextured_end
    str   r0, [sp, #.Lstack.rows]
    b     .Ltextured_row
  .Ltextured_end:
    add   sp, sp, #.Lstack.size
  )" ZSTRIP_THUMB1_POP R"(

    @ The exact position, 16.16 texels, of 1/w, u/w and v/w in r2, r4 and r5: u into r1, v into r0. Then r7 are the bases.
  .Ltextured_position:
    mov   r8, r4
    mov   r9, r5
    cmp   r2, #0
    bne   .Ltextured_divisor
    movs  r2, #1
  .Ltextured_divisor:
    ldr   r6, [sp, #.Lstack.normalisation]
    ldr   r5, [sp, #.Lstack.reciprocals]
    zstrip_reciprocal
    str   r6, [sp, #.Lstack.normalisation]
    uxth  r4, r3
    lsrs  r5, r3, #16
    mov   r0, r8
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    mov   r8, r0
    mov   r0, r9
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    mov   r1, r8
    ldr   r7, [sp, #.Lstack.scan]
    adds  r7, r7, #.Ltextured.base_u
    ldr   r2, [r7, #.Ltextured.right_shift - .Ltextured.base_u]
    subs  r2, r2, r6
    bmi   .Ltextured_left
    asrs  r1, r1, r2                  @ from 32 on it leaves the sign
    asrs  r0, r0, r2
  .Ltextured_shifted:
    ldr   r2, [r7]                    @ base_u
    ldr   r3, [r7, #.Ltextured.base_v - .Ltextured.base_u]
    adds  r1, r1, r2
    adds  r0, r0, r3
    bx    lr
  .Ltextured_left:
    rsbs  r2, r2, #0
    cmp   r2, #31
    ble   .Ltextured_limited
    movs  r2, #31
  .Ltextured_limited:
    lsls  r1, r1, r2
    lsls  r0, r0, r2
    b     .Ltextured_shifted
    .purgem zstrip_textured_add
    .purgem zstrip_textured_step
  )" ZSTRIP_THUMB1_PURGE_MEDIUM_EDGES ZSTRIP_THUMB1_PURGE_RECIPROCAL);
}

void scan_textured_rows_thumb(TexturedScan& scan, const LitWordRunState& run, std::int32_t count,
                              const std::int32_t* inverse) {
  scan_rows_of_texels(scan, run, count, inverse, kReciprocalTable.data());
}

#endif

}  // namespace zstrip::detail
