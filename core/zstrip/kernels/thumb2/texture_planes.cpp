// The planes of texture coordinates in assembly: TextureCoordinates<false> with MediumPlanes, and its start_rows().
#include "zstrip/kernels/thumb/medium_textured.hpp"
#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb2/medium_plane.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// 1/w is scaled first, in registers, because every product needs it. Products wait on the stack in 64 bits until the
// largest determines the shift of all. Planes come last, u/w first, because its differences are in registers then; r4
// and r8 to lr hold the shared values.
[[gnu::naked]] void set_up_texture_thumb(TexturedScan&, const TexturedVertex* const*, std::int64_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_NAMES(ZSTRIP_TEXTURED_SCAN)
          ZSTRIP_MEDIUM_PLANE R"(
    @ On the stack:
    .set .Lstack.scan, 0
    .set .Lstack.u_0, 8               @ products of u and 1/w of each vertex, 64 bits
    .set .Lstack.u_1, 16
    .set .Lstack.u_2, 24
    .set .Lstack.v_0, 32              @ of v
    .set .Lstack.v_1, 40
    .set .Lstack.v_2, 48
    .set .Lstack.v_over_w, 32         @ later v/w at vertex 0 and its differences
    .set .Lstack.one_over_w, 56       @ at vertex 0, and its differences
    .set .Lstack.size, 72
    .set .Ldifference_2, 8            @ behind the value at vertex 0: the difference to vertex 2

    @ A texture coordinate times 1/w, to offset \at of the stack. Collects in r3 and lr the words of its magnitude. Takes
    @ r0 to r2.
    .macro zstrip_texture_product coordinate, inverse, at
      smull r0, r1, \coordinate, \inverse
      strd  r0, r1, [sp, #\at]
      eor   r2, r1, r1, asr #31
      eor   r0, r0, r1, asr #31
      subs  r0, r0, r1, asr #31
      sbc   r2, r2, r1, asr #31
      orrs  r3, r3, r2
      orr   lr, lr, r0
    .endm
    @ The product at offset \at of the stack, shifted to the right by r2, 32 less r3, into \to. Takes \high.
    .macro zstrip_texture_shifted to, high, at
      ldrd  \to, \high, [sp, #\at]
      lsr   \to, \to, r2
      lsl   \high, \high, r3
      orr   \to, \to, \high
    .endm

    push  {r4-r11, lr}
    sub   sp, sp, #.Lstack.size
    str   r0, [sp, #.Lstack.scan]
    ldm   r1, {r4-r6}
    ldm   r4, {r7-r9}                 @ depth, u, v of vertex 0, of 1, of 2
    ldm   r5, {r4, r10, r11}
    ldm   r6, {r5, r6, r12}
    lsr   r1, r8, #16                 @ from whole texels near vertex 0
    lsls  r1, r1, #16
    str   r1, [r0, #.Ltextured.base_u]
    sub   r8, r8, r1
    sub   r10, r10, r1
    subs  r6, r6, r1
    lsr   r1, r9, #16
    lsls  r1, r1, #16
    str   r1, [r0, #.Ltextured.base_v]
    sub   r9, r9, r1
    sub   r11, r11, r1
    sub   r12, r12, r1
    adds  r7, r7, r2                  @ 1/w in two words: r1 and r7, lr and r4, r3 and r5
    adc   r1, r3, #0
    adds  r4, r4, r2
    adc   lr, r3, #0
    adds  r5, r5, r2
    adc   r3, r3, #0
    orr   r2, r1, lr
    orrs  r2, r2, r3
    beq   .Ltexture_words
    clz   r2, r2
    rsb   r2, r2, #35
    @ Right by r2, left by r0 where 1/w has two words. r7, r4 and r5 become 1/w of the vertices in one.
  .Ltexture_right:
    rsb   r0, r2, #32
    lsls  r1, r1, r0
    lsrs  r7, r7, r2
    orrs  r7, r7, r1
    lsl   lr, lr, r0
    lsrs  r4, r4, r2
    orr   r4, r4, lr
    lsls  r3, r3, r0
    lsrs  r5, r5, r2
    orrs  r5, r5, r3
  .Ltexture_scaled:
    subs  r1, r4, r7
    subs  r2, r5, r7
    strd  r7, r1, [sp, #.Lstack.one_over_w]
    str   r2, [sp, #.Lstack.one_over_w + .Ldifference_2]
    movs  r3, #0
    mov   lr, r3
    zstrip_texture_product r8, r7, .Lstack.u_0
    zstrip_texture_product r10, r4, .Lstack.u_1
    zstrip_texture_product r6, r5, .Lstack.u_2
    zstrip_texture_product r9, r7, .Lstack.v_0
    zstrip_texture_product r11, r4, .Lstack.v_1
    zstrip_texture_product r12, r5, .Lstack.v_2
    clz   r2, r3                      @ to 29 bits and a sign
    cmp   r2, #32
    itt   eq
    clzeq r0, lr
    addeq r2, r2, r0
    rsbs  r2, r2, #35
    it    mi
    movmi r2, #0
    ldr   r0, [sp, #.Lstack.scan]
    rsb   r3, r2, #30
    str   r3, [r0, #.Ltextured.right_shift]
    rsb   r3, r2, #32
    zstrip_texture_shifted r4, r5, .Lstack.v_0
    zstrip_texture_shifted r5, r6, .Lstack.v_1
    zstrip_texture_shifted r6, r7, .Lstack.v_2
    subs  r5, r5, r4
    subs  r6, r6, r4
    strd  r4, r5, [sp, #.Lstack.v_over_w]
    str   r6, [sp, #.Lstack.v_over_w + .Ldifference_2]
    zstrip_texture_shifted r1, r4, .Lstack.u_0
    zstrip_texture_shifted r5, r4, .Lstack.u_1
    zstrip_texture_shifted r6, r4, .Lstack.u_2
    subs  r2, r5, r1
    subs  r3, r6, r1
    add   r7, r0, #.Lmedium.shared
    ldm   r7, {r4, r8-r12, lr}
    zstrip_medium_plane .Ltextured.start_u_over_w, .Ltextured.step_y_u_over_w, .Ltextured.step_x_u_over_w
    add   r1, sp, #.Lstack.v_over_w
    ldm   r1, {r1-r3}
    zstrip_medium_plane .Ltextured.start_v_over_w, .Ltextured.step_y_v_over_w, .Ltextured.step_x_v_over_w
    add   r1, sp, #.Lstack.one_over_w
    ldm   r1, {r1-r3}
    zstrip_medium_plane .Ltextured.start_one_over_w, .Ltextured.step_y_one_over_w, .Ltextured.step_x_one_over_w
    add   sp, sp, #.Lstack.size
    pop   {r4-r11, pc}

  .Ltexture_words:
    orr   r2, r7, r4
    orrs  r2, r2, r5
    clz   r2, r2
    rsbs  r2, r2, #3
    bpl   .Ltexture_right
    rsbs  r2, r2, #0
    lsls  r7, r7, r2
    lsls  r4, r4, r2
    lsls  r5, r5, r2
    b     .Ltexture_scaled
    .purgem zstrip_texture_product
    .purgem zstrip_texture_shifted
    .purgem zstrip_medium_step
    .purgem zstrip_medium_plane
  )");
}

#endif

}  // namespace zstrip::detail
