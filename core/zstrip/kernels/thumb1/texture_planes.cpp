// The planes of texture coordinates in assembly: TextureCoordinates<false> with ThumbPlanes, and its start_rows().
#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb1/medium_planes.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// r8, r9 and r10: the vertices; r11 and r12: the bases of u and v. First 1/w of each vertex, scaled to 29 bits, and its
// plane; then the six products of 1/w with u and v in 64 bits, the largest of which determines the shift that makes all
// fit words; then the planes of u/w and v/w. .Ltexture_plane, .Ltexture_product and .Ltexture_zeros are functions
// because copies would be large. The first keeps its return address in r11, because zstrip_set_plane_thumb uses lr and
// saves r11.
[[gnu::naked]] void ThumbPlanes::set_texture(TexturedScan&, const TexturedVertex* const (&)[3], std::int64_t) const {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXTURED_SCAN) ZSTRIP_THUMB1_PUSH R"(
    @ On the stack:
    .set .Lstack.argument, 0          @ the fifth one of a call
    .set .Lstack.scan, 4
    .set .Lstack.planes, 8
    .set .Lstack.plane, 12            @ a result
    .set .Lstack.one_over_w_0, 24     @ at each vertex
    .set .Lstack.one_over_w_1, 28
    .set .Lstack.one_over_w_2, 32
    .set .Lstack.u_0, 36              @ u/w and v/w at each vertex, 64 bits
    .set .Lstack.v_0, 44
    .set .Lstack.u_1, 52
    .set .Lstack.v_1, 60
    .set .Lstack.u_2, 68
    .set .Lstack.v_2, 76
    .set .Lstack.size, 84
    .set .Lhigh_word, 4               @ of 64 bits

    @ u/w and v/w of the vertex \vertex, whose 1/w is at \at, to r7, and what zstrip_texture_product does.
    .macro zstrip_texture_vertex vertex at
      ldr   r5, [sp, #\at]
      lsrs  r6, r5, #16
      uxth  r5, r5
      mov   r0, \vertex
      ldr   r1, [r0, #.Lcorner.v]
      mov   \vertex, r1
      ldr   r0, [r0, #.Lcorner.u]
      mov   r1, r11
      subs  r0, r0, r1
      bl    .Ltexture_product
      mov   r0, \vertex
      mov   r1, r12
      subs  r0, r0, r1
      bl    .Ltexture_product
    .endm
    @ r0: the product at \at, shifted by r5. Uses r1.
    .macro zstrip_texture_word at
      ldr   r1, [sp, #\at]
      ldr   r0, [sp, #\at + .Lhigh_word]
      lsls  r0, r0, #1
      lsls  r0, r0, r6
      lsrs  r1, r1, r5
      orrs  r0, r0, r1
    .endm
    @ The plane of a vertex's product at \at, and of the others'.
    .macro zstrip_texture_plane at
      zstrip_texture_word \at
      movs  r2, r0
      zstrip_texture_word \at+.Lstack.u_1-.Lstack.u_0
      subs  r3, r0, r2
      zstrip_texture_word \at+.Lstack.u_2-.Lstack.u_0
      subs  r0, r0, r2
      str   r0, [sp, #.Lstack.argument]
      bl    .Ltexture_plane
    .endm

    sub   sp, sp, #.Lstack.size
    str   r1, [sp, #.Lstack.scan]
    str   r0, [sp, #.Lstack.planes]
    ldr   r0, [sp, #.Lstack.size + .Lsaved]
    ldr   r1, [sp, #.Lstack.size + .Lsaved + .Lhigh_word]
    ldm   r2!, {r4-r6}
    mov   r8, r4
    mov   r9, r5
    mov   r10, r6
    @ 1/w of each vertex in two words: r2 and r4, r3 and r5, r7 and r6; then in one, r4, r5 and r6, with 3 zeros before
    @ the largest.
    ldr   r4, [r4, #.Lcorner.depth]
    adds  r4, r4, r0
    movs  r2, #0
    adcs  r2, r2, r1
    ldr   r5, [r5, #.Lcorner.depth]
    adds  r5, r5, r0
    movs  r3, #0
    adcs  r3, r3, r1
    ldr   r6, [r6, #.Lcorner.depth]
    adds  r6, r6, r0
    movs  r7, #0
    adcs  r7, r7, r1
    mov   r11, r2
    movs  r0, r2
    orrs  r0, r0, r3
    orrs  r0, r0, r7
    beq   .Ltexture_one_word
    bl    .Ltexture_zeros
    mov   r2, r11
    subs  r1, r1, #3
    movs  r0, #32
    subs  r0, r0, r1
    lsls  r2, r2, r1
    lsrs  r4, r4, r0
    orrs  r4, r4, r2
    lsls  r3, r3, r1
    lsrs  r5, r5, r0
    orrs  r5, r5, r3
    lsls  r7, r7, r1
    lsrs  r6, r6, r0
    orrs  r6, r6, r7
    b     .Ltexture_scaled
  .Ltexture_one_word:
    movs  r0, r4
    orrs  r0, r0, r5
    orrs  r0, r0, r6
    beq   .Ltexture_scaled
    bl    .Ltexture_zeros
    subs  r1, r1, #3
    bmi   .Ltexture_smaller
    lsls  r4, r4, r1
    lsls  r5, r5, r1
    lsls  r6, r6, r1
    b     .Ltexture_scaled
  .Ltexture_smaller:
    rsbs  r1, r1, #0
    lsrs  r4, r4, r1
    lsrs  r5, r5, r1
    lsrs  r6, r6, r1
  .Ltexture_scaled:
    add   r7, sp, #.Lstack.one_over_w_0
    stm   r7!, {r4-r6}
    movs  r2, r4
    subs  r3, r5, r4
    subs  r6, r6, r4
    str   r6, [sp, #.Lstack.argument]
    ldr   r4, [sp, #.Lstack.scan]
    adds  r4, r4, #.Ltextured.start_one_over_w
    bl    .Ltexture_plane

    @ The bases, whole texels near vertex 0. r7 is at the products, where zstrip_texture_vertex writes them.
    mov   r0, r8
    ldr   r1, [r0, #.Lcorner.u]
    ldr   r2, [r0, #.Lcorner.v]
    lsrs  r1, r1, #16
    lsls  r1, r1, #16
    lsrs  r2, r2, #16
    lsls  r2, r2, #16
    mov   r11, r1
    mov   r12, r2
    str   r1, [r4, #.Ltextured.base_u - .Ltextured.start_u_over_w]
    str   r2, [r4, #.Ltextured.base_v - .Ltextured.start_u_over_w]
    movs  r4, #0
    zstrip_texture_vertex r8, .Lstack.one_over_w_0
    zstrip_texture_vertex r9, .Lstack.one_over_w_1
    zstrip_texture_vertex r10, .Lstack.one_over_w_2
    @ r5 becomes how far products are shifted to the right: to 29 bits and a sign.
    movs  r5, #0
    movs  r0, r4
    bne   .Ltexture_two_words
    add   r7, sp, #.Lstack.u_0        @ all products are short
    movs  r1, #6
  .Ltexture_short:
    ldm   r7!, {r2, r3}
    eors  r2, r2, r3
    subs  r2, r2, r3
    orrs  r0, r0, r2
    subs  r1, r1, #1
    bne   .Ltexture_short
    cmp   r0, #0
    beq   .Ltexture_shift
    subs  r5, r5, #32
  .Ltexture_two_words:
    bl    .Ltexture_zeros
    adds  r5, r5, #35
    subs  r5, r5, r1
    bpl   .Ltexture_shift
    movs  r5, #0
  .Ltexture_shift:
    ldr   r4, [sp, #.Lstack.scan]
    adds  r4, r4, #.Ltextured.start_u_over_w
    movs  r6, #30
    subs  r6, r6, r5
    str   r6, [r4, #.Ltextured.right_shift - .Ltextured.start_u_over_w]
    adds  r6, r6, #1
    zstrip_texture_plane .Lstack.u_0
    zstrip_texture_plane .Lstack.v_0
    add   sp, sp, #.Lstack.size
  )" ZSTRIP_THUMB1_POP R"(

    @ The plane of r2, with the differences r3 and on the stack, to where r4 is in the scan's texture coordinates. Moves
    @ r4 to the next one.
  .Ltexture_plane:
    mov   r11, lr
    add   r0, sp, #.Lstack.plane
    ldr   r1, [sp, #.Lstack.planes]
    bl    zstrip_set_plane_thumb
    add   r0, sp, #.Lstack.plane
    ldm   r0!, {r1-r3}                @ start, step_x, step_y
    str   r1, [r4]
    str   r3, [r4, #.Ltextured.step_y_one_over_w - .Ltextured.start_one_over_w]
    str   r2, [r4, #.Ltextured.step_x_one_over_w - .Ltextured.start_one_over_w]
    adds  r4, r4, #4
    bx    r11

    @ The product of r0 with the halves r5 and r6 to r7; the upper word of its magnitude into r4. Less than 2^31 each
    @ is a sum of two products of halves: r6 is below 2^13, and r0 within 2^30 and some.
  .Ltexture_product:
    uxth  r1, r0
    asrs  r0, r0, #16
    movs  r2, r1
    muls  r2, r5, r2
    muls  r1, r6, r1
    movs  r3, r0
    muls  r3, r5, r3
    adds  r1, r1, r3
    muls  r0, r6, r0
    asrs  r3, r1, #16
    lsls  r1, r1, #16
    adds  r2, r2, r1
    adcs  r3, r3, r0
    stm   r7!, {r2, r3}
    asrs  r1, r3, #31
    eors  r2, r2, r1
    eors  r3, r3, r1
    subs  r2, r2, r1
    sbcs  r3, r3, r1
    orrs  r4, r4, r3
    bx    lr

    @ r1: how many zeros r0, not 0, begins with. Uses r0 and r2.
  .Ltexture_zeros:
    movs  r1, #0
    lsrs  r2, r0, #16
    bne   .Ltexture_zeros_8
    adds  r1, r1, #16
    lsls  r0, r0, #16
  .Ltexture_zeros_8:
    lsrs  r2, r0, #24
    bne   .Ltexture_zeros_4
    adds  r1, r1, #8
    lsls  r0, r0, #8
  .Ltexture_zeros_4:
    lsrs  r2, r0, #28
    bne   .Ltexture_zeros_2
    adds  r1, r1, #4
    lsls  r0, r0, #4
  .Ltexture_zeros_2:
    lsrs  r2, r0, #30
    bne   .Ltexture_zeros_1
    adds  r1, r1, #2
    lsls  r0, r0, #2
  .Ltexture_zeros_1:
    cmp   r0, #0
    bmi   .Ltexture_zeros_0
    adds  r1, r1, #1
  .Ltexture_zeros_0:
    bx    lr
    .purgem zstrip_texture_vertex
    .purgem zstrip_texture_word
    .purgem zstrip_texture_plane
  )");
}

#endif

}  // namespace zstrip::detail
