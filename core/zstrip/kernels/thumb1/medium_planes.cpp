// The assembly behind thumb1/medium_planes.hpp. A difference times a side is a number of whole words and one of 16 bits
// below; both times the reciprocal of the area, of halves, give the upper 48 bits of the product.
#include "zstrip/kernels/thumb1/medium_planes.hpp"

#include <cstddef>

#include "zstrip/kernels/medium_textured.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/textured_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

static_assert(sizeof(ThumbPlanes) == 36);  // no gaps: the members lie in order
static_assert(sizeof(Plane) == 12 && offsetof(Plane, start) == 0 && offsetof(Plane, step_x) == 4);

// Of planes at r7, and the halves of 1 / area in r5 and r6.
// zstrip_plane_quotient: of r4 and what r3 / 2^16 is below it, r3 being its product with 1 / area already: a step in r1
// and 16 bits below it in the lower half of r0. Uses r2.
// zstrip_plane_round at: stores that step, rounded, at offset `at` of r3; r0 is 16 bits.
#define ZSTRIP_THUMB1_PLANES            \
  ".macro zstrip_plane_quotient\n"      \
  "  sxth  r0, r4\n"                    \
  "  subs  r4, r4, r0\n"                \
  "  asrs  r4, r4, #16\n"               \
  "  movs  r1, r0\n"                    \
  "  muls  r1, r5, r1\n"                \
  "  uxth  r2, r3\n"                    \
  "  adds  r1, r1, r2\n"                \
  "  asrs  r1, r1, #16\n"               \
  "  lsrs  r3, r3, #16\n"               \
  "  adds  r1, r1, r3\n"                \
  "  muls  r0, r6, r0\n"                \
  "  adds  r1, r1, r0\n"                \
  "  movs  r0, r4\n"                    \
  "  muls  r0, r5, r0\n"                \
  "  adds  r1, r1, r0\n"                \
  "  muls  r4, r6, r4\n"                \
  "  lsls  r0, r4, #16\n"               \
  "  adds  r0, r0, r1\n"                \
  "  asrs  r1, r1, #16\n"               \
  "  adds  r1, r1, r4\n"                \
  "  ldr   r2, [r7, #32]\n"             \
  "  lsrs  r0, r0, r2\n"                \
  "  asrs  r1, r1, r2\n"                \
  ".endm\n"                             \
  ".macro zstrip_plane_round base at\n" \
  "  uxth  r0, r0\n"                    \
  "  lsls  r3, r1, #8\n"                \
  "  lsrs  r2, r0, #8\n"                \
  "  adcs  r2, r2, r3\n"                \
  "  \\base\n"                          \
  "  str   r2, [r3, #\\at]\n"           \
  ".endm\n"
#define ZSTRIP_THUMB1_PURGE_PLANES ".purgem zstrip_plane_quotient\n.purgem zstrip_plane_round\n"

// r8 and r10 the halves of the first difference, r9 and r11 of the second; r12 and lr the way to the anchor. On the
// stack: the plane, the value at vertex 0.
[[gnu::naked, gnu::used]] void ThumbPlanes::set_plane(Plane&, const ThumbPlanes&, std::int32_t, std::int32_t,
                                                      std::int32_t) {
  asm(ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_PLANES R"(
    @ A step of the weights at \first and \first + 4.
    .macro zstrip_plane_step first
      ldr   r1, [r7, #\first]
      ldr   r2, [r7, #\first + 4]
      mov   r3, r8
      muls  r3, r1, r3
      mov   r4, r9
      muls  r4, r2, r4
      adds  r3, r3, r4
      mov   r4, r10
      muls  r4, r1, r4
      mov   r0, r11
      muls  r0, r2, r0
      adds  r4, r4, r0
      asrs  r0, r3, #16
      adds  r4, r4, r0
      uxth  r3, r3
      movs  r0, r3
      muls  r0, r5, r0
      lsrs  r0, r0, #16
      muls  r3, r6, r3
      adds  r3, r3, r0
      zstrip_plane_quotient
    .endm

    push  {r0, r2}
    movs  r7, r1
    ldr   r4, [sp, #44]
    uxth  r0, r3
    mov   r8, r0
    asrs  r3, r3, #16
    mov   r10, r3
    uxth  r0, r4
    mov   r9, r0
    asrs  r4, r4, #16
    mov   r11, r4
    ldm   r1!, {r5, r6}
    zstrip_plane_step 8
    zstrip_plane_round "ldr r3, [sp]", 4
    ldr   r2, [r7, #24]
    muls  r1, r2, r1
    muls  r0, r2, r0
    mov   r12, r1
    mov   lr, r0
    zstrip_plane_step 16
    zstrip_plane_round "ldr r3, [sp]", 8
    ldr   r2, [r7, #28]
    muls  r1, r2, r1
    muls  r0, r2, r0
    add   r1, r1, r12
    add   r0, r0, lr
    asrs  r2, r0, #16
    adds  r1, r1, r2
    lsls  r1, r1, #4
    uxth  r0, r0
    lsrs  r0, r0, #12
    adds  r1, r1, r0
    pop   {r2, r3}
    adds  r1, r1, r3
    str   r1, [r2]
    .purgem zstrip_plane_step
  )" ZSTRIP_THUMB1_PURGE_PLANES ZSTRIP_THUMB1_POP);
}

// r8 and r9 the differences of a channel, r10 its colours, r11 where its start is, r12 0 in white light. On the stack:
// 0 the way to the anchor, 8 the channel at vertex 0.
[[gnu::naked]] void ThumbPlanes::set_channels(MediumScan&) const {
  asm(ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_PLANES R"(
    @ A step of the weights at \first and \first + 4.
    .macro zstrip_channel_step first
      mov   r2, r8
      ldr   r1, [r7, #\first]
      muls  r1, r2, r1
      mov   r2, r9
      ldr   r0, [r7, #\first + 4]
      muls  r0, r2, r0
      adds  r0, r0, r1
      sxth  r1, r0
      cmp   r1, r0
      beq   .Lchannel_short_\first
      movs  r4, r0
      movs  r3, #0
      bl    .Lchannel_long
      b     .Lchannel_step_\first
    .Lchannel_short_\first:
      muls  r0, r6, r0
      muls  r1, r5, r1
      asrs  r1, r1, #16
      adds  r0, r0, r1
      asrs  r0, r0, r4
      asrs  r1, r0, #16
    .Lchannel_step_\first:
    .endm

    sub   sp, sp, #12
    movs  r7, r0
    adds  r1, r1, #60
    mov   r11, r1
    adds  r1, r1, #60
    mov   r10, r1
    ldm   r1!, {r2-r4}
    lsrs  r5, r2, #8                  @ red and green, green and blue
    eors  r5, r5, r2
    lsrs  r6, r3, #8
    eors  r6, r6, r3
    orrs  r5, r5, r6
    lsrs  r6, r4, #8
    eors  r6, r6, r4
    orrs  r5, r5, r6
    lsls  r5, r5, #16
    mov   r12, r5
    ldm   r0!, {r5, r6}
    ldr   r4, [r7, #32]
  .Lchannel_next:
    mov   r0, r10
    ldrb  r1, [r0]
    ldrb  r2, [r0, #4]
    ldrb  r3, [r0, #8]
    adds  r0, r0, #1
    mov   r10, r0
    subs  r2, r2, r1
    mov   r8, r2
    subs  r3, r3, r1
    mov   r9, r3
    str   r1, [sp, #8]
    zstrip_channel_step 8
    zstrip_plane_round "mov r3, r11", 32
    ldr   r2, [r7, #24]
    muls  r1, r2, r1
    muls  r0, r2, r0
    str   r1, [sp, #0]
    str   r0, [sp, #4]
    zstrip_channel_step 16
    zstrip_plane_round "mov r3, r11", 16
    ldr   r2, [r7, #28]
    muls  r1, r2, r1
    muls  r0, r2, r0
    ldr   r2, [sp, #4]
    adds  r0, r0, r2
    ldr   r2, [sp, #0]
    adds  r1, r1, r2
    asrs  r2, r0, #16
    adds  r1, r1, r2
    lsls  r1, r1, #4
    uxth  r0, r0
    lsrs  r0, r0, #12
    adds  r1, r1, r0
    ldr   r2, [sp, #8]
    lsls  r2, r2, #1
    adds  r2, r2, #1
    lsls  r2, r2, #15
    adds  r1, r1, r2
    stm   r3!, {r1}
    mov   r11, r3
    mov   r0, r12
    cmp   r0, #0
    bne   .Lchannel_coloured
    str   r1, [r3, #0]                @ white light: all channels are red's
    str   r1, [r3, #4]
    ldr   r0, [r3, #12]
    str   r0, [r3, #16]
    str   r0, [r3, #20]
    ldr   r0, [r3, #28]
    str   r0, [r3, #32]
    str   r0, [r3, #36]
    b     .Lchannel_end
  .Lchannel_coloured:
    mov   r0, r10                     @ the last one's offset is 3 more than a multiple of 4
    lsls  r0, r0, #30
    asrs  r0, r0, #30
    adds  r0, r0, #1
    bne   .Lchannel_next
  .Lchannel_end:
    add   sp, sp, #12
  )" ZSTRIP_THUMB1_POP R"(
  .Lchannel_long:
    zstrip_plane_quotient
    movs  r4, r2
    bx    lr
    .purgem zstrip_channel_step
  )" ZSTRIP_THUMB1_PURGE_PLANES);
}

// r8, r9 and r10 the vertices, r11 and r12 the bases of u and v. On the stack: 0 an argument, 4 the scan, 8 the planes,
// 12 a plane, 24 the 1/w of each vertex, 36 their u/w and v/w in 64 bits, u and v of a vertex after each other.
[[gnu::naked]] void ThumbPlanes::set_texture(TexturedScan&, const TexturedVertex* const (&)[3], std::int64_t) const {
  asm(ZSTRIP_THUMB1_PUSH R"(
    @ u/w and v/w of the vertex \vertex, whose 1/w is at \at, to r7, and what zstrip_texture_product does.
    .macro zstrip_texture_vertex vertex at
      ldr   r5, [sp, #\at]
      lsrs  r6, r5, #16
      uxth  r5, r5
      mov   r0, \vertex
      ldr   r1, [r0, #8]
      mov   \vertex, r1
      ldr   r0, [r0, #4]
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
      ldr   r0, [sp, #\at + 4]
      lsls  r0, r0, #1
      lsls  r0, r0, r6
      lsrs  r1, r1, r5
      orrs  r0, r0, r1
    .endm
    @ The plane of the products from \at on.
    .macro zstrip_texture_plane at
      zstrip_texture_word \at
      movs  r2, r0
      zstrip_texture_word \at + 16
      subs  r3, r0, r2
      zstrip_texture_word \at + 32
      subs  r0, r0, r2
      str   r0, [sp, #0]
      bl    .Ltexture_plane
    .endm

    sub   sp, sp, #84
    str   r1, [sp, #4]
    str   r0, [sp, #8]
    ldr   r0, [sp, #120]
    ldr   r1, [sp, #124]
    ldm   r2!, {r4-r6}
    mov   r8, r4
    mov   r9, r5
    mov   r10, r6
    ldr   r4, [r4]                    @ 1/w of each vertex: r2 and r4, r3 and r5, r7 and r6
    adds  r4, r4, r0
    movs  r2, #0
    adcs  r2, r2, r1
    ldr   r5, [r5]
    adds  r5, r5, r0
    movs  r3, #0
    adcs  r3, r3, r1
    ldr   r6, [r6]
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
    add   r7, sp, #24
    stm   r7!, {r4-r6}
    movs  r2, r4
    subs  r3, r5, r4
    subs  r6, r6, r4
    str   r6, [sp, #0]
    ldr   r4, [sp, #4]
    adds  r4, r4, #160
    bl    .Ltexture_plane

    mov   r0, r8
    ldr   r1, [r0, #4]
    ldr   r2, [r0, #8]
    lsrs  r1, r1, #16
    lsls  r1, r1, #16
    lsrs  r2, r2, #16
    lsls  r2, r2, #16
    mov   r11, r1
    mov   r12, r2
    str   r1, [r4, #32]
    str   r2, [r4, #36]
    movs  r4, #0
    zstrip_texture_vertex r8, 24
    zstrip_texture_vertex r9, 28
    zstrip_texture_vertex r10, 32
    movs  r5, #0
    movs  r0, r4
    bne   .Ltexture_two_words
    add   r7, sp, #36                 @ all products are short
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
    ldr   r4, [sp, #4]
    adds  r4, r4, #164
    movs  r6, #30
    subs  r6, r6, r5
    str   r6, [r4, #48]
    adds  r6, r6, #1
    zstrip_texture_plane 36
    zstrip_texture_plane 44
    add   sp, sp, #84
  )" ZSTRIP_THUMB1_POP R"(

    @ The plane of r2, with the differences r3 and on the stack, to where r4 is in the scan's texture coordinates. Moves
    @ r4 to the next one.
  .Ltexture_plane:
    mov   r11, lr
    add   r0, sp, #12
    ldr   r1, [sp, #8]
    bl    zstrip_set_plane_thumb
    add   r0, sp, #12
    ldm   r0!, {r1-r3}
    str   r1, [r4]
    str   r3, [r4, #12]
    str   r2, [r4, #24]
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
