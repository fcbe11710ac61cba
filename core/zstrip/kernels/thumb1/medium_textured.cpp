// The assembly behind thumb/medium_textured.hpp for Thumb-1 (Cortex-M0, M0+): a pixel's values in registers, its steps
// and texture on the stack.
#include "zstrip/kernels/thumb/medium_textured.hpp"

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb1/medium_edges.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// On the stack: 0 the scan, 4 how many rows, 8 the normalisation of the last 1/w, 12 the table of reciprocals for an
// index that begins at 256, 16 the inverses for lengths, 20 the shifts to a column and to a row, 28 the mask of rows,
// 32 the texels, 36 the steps of depth, red, green and blue, 52 those of u and v, 60 how long the row is, 64 its first
// cell, 68 from a cell to its pixel, 72 depth and light at the first pixel, 88 1/w, u/w and v/w there, 100 the exact
// position there.
[[gnu::naked]] static void scan_rows_of_texels(TexturedScan&, const LitWordRunState&, std::int32_t, const std::int32_t*,
                                               const std::uint16_t*) {
  asm(ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL ZSTRIP_THUMB1_MEDIUM_EDGES R"(
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

    sub   sp, sp, #108
    str   r0, [sp, #0]
    str   r2, [sp, #4]
    subs  r3, r3, #4
    str   r3, [sp, #16]
    movs  r2, #0
    str   r2, [sp, #8]
    ldr   r2, [sp, #144]
    movs  r3, #2
    lsls  r3, r3, #8
    subs  r2, r2, r3
    str   r2, [sp, #12]
    adds  r1, r1, #20
    ldm   r1!, {r2-r6}                @ step of depth, texels, shift to a column, to a row, mask
    str   r2, [sp, #36]
    str   r3, [sp, #32]
    add   r1, sp, #20
    stm   r1!, {r4-r6}
    adds  r0, r0, #92
    ldm   r0!, {r2-r4}                @ steps of light
    add   r1, sp, #40
    stm   r1!, {r2-r4}
  .Ltextured_row:
    ldr   r0, [sp, #0]
    zstrip_medium_edges
    subs  r1, r1, r7
    str   r1, [sp, #60]
    ldm   r6!, {r2-r5}                @ rows and strides
    adds  r4, r4, r2
    adds  r5, r5, r3
    str   r4, [r0, #40]
    str   r5, [r0, #44]
    adds  r0, r0, #160
    ldr   r4, [r0, #56]               @ this row
    adds  r5, r4, #1
    str   r5, [r0, #56]
    cmp   r1, #0
    bgt   .Ltextured_drawn
    b     .Ltextured_next_row
  .Ltextured_drawn:
    lsls  r1, r7, #1
    adds  r2, r2, r1
    adds  r3, r3, r1
    subs  r3, r3, r2
    str   r2, [sp, #64]
    str   r3, [sp, #68]
    ldm   r0!, {r1-r3}
    zstrip_textured_add r1, r4, r5
    zstrip_textured_add r2, r4, r5
    zstrip_textured_add r3, r4, r5
    zstrip_textured_add r1, r7, r5
    zstrip_textured_add r2, r7, r5
    zstrip_textured_add r3, r7, r5
    add   r5, sp, #88
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
    add   r6, sp, #72
    stm   r6!, {r1, r2, r3, r5}
    ldm   r6!, {r2, r4, r5}
    bl    .Ltextured_position
    ldr   r4, [r7, #8]                @ to fractions of the texture
    ldr   r5, [r7, #12]
    ldr   r6, [sp, #60]
    cmp   r6, #1
    beq   .Ltextured_one
    str   r1, [sp, #100]
    str   r0, [sp, #104]
    subs  r6, r6, #1
    subs  r7, r7, #12
    ldm   r7!, {r0, r3, r5}
    ldr   r2, [sp, #88]
    muls  r0, r6, r0
    adds  r2, r2, r0
    ldr   r4, [sp, #92]
    muls  r3, r6, r3
    adds  r4, r4, r3
    muls  r5, r6, r5
    ldr   r3, [sp, #96]
    adds  r5, r5, r3
    bl    .Ltextured_position
    ldr   r4, [r7, #8]
    ldr   r5, [r7, #12]
    ldr   r2, [sp, #100]
    ldr   r3, [sp, #104]
    subs  r1, r1, r2
    subs  r0, r0, r3
    muls  r2, r4, r2
    mov   r8, r2
    muls  r3, r5, r3
    mov   r9, r3
    ldr   r6, [sp, #60]
    cmp   r6, #2
    beq   .Ltextured_two
    ldr   r2, [sp, #16]
    lsls  r3, r6, #2
    ldr   r2, [r2, r3]
    zstrip_textured_step r1
    zstrip_textured_step r0
  .Ltextured_two:
    muls  r1, r4, r1
    muls  r0, r5, r0
    str   r1, [sp, #52]
    str   r0, [sp, #56]
    b     .Ltextured_pixels
  .Ltextured_one:
    muls  r1, r4, r1
    mov   r8, r1
    muls  r0, r5, r0
    mov   r9, r0
  .Ltextured_pixels:
    add   r4, sp, #64
    ldm   r4!, {r0, r1, r5}           @ cell, from it to its pixel, depth
    mov   lr, r1
    ldm   r4!, {r1-r3}
    mov   r10, r1
    mov   r11, r2
    mov   r12, r3
    movs  r4, r0
    lsls  r6, r6, #1
    adds  r6, r6, r4
    ldr   r7, [sp, #32]
  .Ltextured_pixel:
    @ r4 the cell, lr from there to its pixel, r6 behind the last cell, r5 depth, r7 texels, r8 u, r9 v, r10 to r12 light
    ldrh  r0, [r4]
    lsrs  r1, r5, #16
    cmp   r0, r1
    bhs   .Ltextured_hidden
    strh  r1, [r4]
    add   r3, sp, #20
    ldm   r3!, {r0-r2}
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
    adds  r4, r4, #2
    cmp   r4, r6
    beq   .Ltextured_next_row
    add   r3, sp, #36
    ldm   r3!, {r0-r2}
    adds  r5, r5, r0
    add   r10, r10, r1
    add   r11, r11, r2
    ldm   r3!, {r0-r2}
    add   r12, r12, r0
    add   r8, r8, r1
    add   r9, r9, r2
    b     .Ltextured_pixel
  .Ltextured_next_row:
    ldr   r0, [sp, #4]
    subs  r0, r0, #1
    beq   .Ltextured_end
    str   r0, [sp, #4]
    b     .Ltextured_row
  .Ltextured_end:
    add   sp, sp, #108
  )" ZSTRIP_THUMB1_POP R"(

    @ The exact position, 16.16 texels, of 1/w, u/w and v/w in r2, r4 and r5: u into r1, v into r0. Then r7 are the bases.
  .Ltextured_position:
    mov   r8, r4
    mov   r9, r5
    cmp   r2, #0
    bne   .Ltextured_divisor
    movs  r2, #1
  .Ltextured_divisor:
    ldr   r6, [sp, #8]
    ldr   r5, [sp, #12]
    zstrip_reciprocal
    str   r6, [sp, #8]
    uxth  r4, r3
    lsrs  r5, r3, #16
    mov   r0, r8
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    mov   r8, r0
    mov   r0, r9
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    mov   r1, r8
    ldr   r7, [sp, #0]
    adds  r7, r7, #196
    ldr   r2, [r7, #16]
    subs  r2, r2, r6
    bmi   .Ltextured_left
    asrs  r1, r1, r2                  @ from 32 on it leaves the sign
    asrs  r0, r0, r2
  .Ltextured_shifted:
    ldr   r2, [r7, #0]
    ldr   r3, [r7, #4]
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
