// The assembly of thumb1/medium_planes.hpp. The product of a difference and a side is a number of whole words plus 16
// bits below them; both are multiplied by the halves of the area's reciprocal, which gives the upper 48 bits of the
// product.
#include "zstrip/kernels/thumb1/medium_planes.hpp"

#include <cstddef>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/medium_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// clang-format off
#define ZSTRIP_THUMB_PLANES(field, number)                                            \
  number(planes.mantissa_low, offsetof(ThumbPlanes, mantissa_low_), 0)                \
  number(planes.mantissa_high, offsetof(ThumbPlanes, mantissa_high_), 4)              \
  number(planes.x1, offsetof(ThumbPlanes, x1_), 8)                                    \
  number(planes.x2, offsetof(ThumbPlanes, x2_), 12)                                   \
  number(planes.y1, offsetof(ThumbPlanes, y1_), 16)                                   \
  number(planes.y2, offsetof(ThumbPlanes, y2_), 20)                                   \
  number(planes.x1_to_x2, offsetof(ThumbPlanes, x2_) - offsetof(ThumbPlanes, x1_), 4) \
  number(planes.offset_x, offsetof(ThumbPlanes, offset_x_), 24)                       \
  number(planes.offset_y, offsetof(ThumbPlanes, offset_y_), 28)                       \
  number(planes.right, offsetof(ThumbPlanes, right_), 32)                             \
  field(plane, Plane, start, 0)                                                       \
  field(plane, Plane, step_x, 4)                                                      \
  field(plane, Plane, step_y, 8)
// clang-format on
struct ThumbPlanes::Layout {
  ZSTRIP_CHECK_LAYOUT(ZSTRIP_THUMB_PLANES)
};

// Macros for planes at r7, with the halves of 1 / area in r5 and r6. zstrip_plane_quotient: multiplies r4, and the r3 /
// 2^16 below it (r3 is already multiplied by 1 / area), to a step in r1 and 16 bits below it in the lower half of r0.
// Changes r2. zstrip_plane_round at: stores that step, rounded, at offset `at` of r3; r0 has 16 bits.
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
  "  ldr   r2, [r7, #.Lplanes.right]\n" \
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

// r5 and r6: the halves of 1 / area; r7: the planes; r8 and r10: the halves of the first difference; r9 and r11: those
// of the second. The step to the right, times the distance to the anchor, waits in r12 and lr for the product of the
// step down: their sum leads from the value at vertex 0 to the value at the anchor.
[[gnu::naked, gnu::used]] void ThumbPlanes::set_plane(Plane&, const ThumbPlanes&, std::int32_t, std::int32_t,
                                                      std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_THUMB_PLANES) ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_PLANES R"(
    .set .Lstack.plane, 0
    .set .Lstack.value, 4             @ at vertex 0
    .set .Lstack.size, 8

    @ A step of the weights at \first and behind it: the sum of their products with the differences is r4
    @ and, below it, 16 bits of r3.
    .macro zstrip_plane_step first
      ldr   r1, [r7, #\first]
      ldr   r2, [r7, #\first + .Lplanes.x1_to_x2]
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
    ldr   r4, [sp, #.Lstack.size + .Lsaved]
    uxth  r0, r3
    mov   r8, r0
    asrs  r3, r3, #16
    mov   r10, r3
    uxth  r0, r4
    mov   r9, r0
    asrs  r4, r4, #16
    mov   r11, r4
    ldm   r1!, {r5, r6}               @ mantissa_low, mantissa_high
    zstrip_plane_step .Lplanes.x1
    zstrip_plane_round "ldr r3, [sp, #.Lstack.plane]", .Lplane.step_x
    ldr   r2, [r7, #.Lplanes.offset_x]
    muls  r1, r2, r1
    muls  r0, r2, r0
    mov   r12, r1
    mov   lr, r0
    zstrip_plane_step .Lplanes.y1
    zstrip_plane_round "ldr r3, [sp, #.Lstack.plane]", .Lplane.step_y
    ldr   r2, [r7, #.Lplanes.offset_y]
    muls  r1, r2, r1
    muls  r0, r2, r0
    add   r1, r1, r12                 @ r1, and 16 bits below it in r0; both times 2^4
    add   r0, r0, lr
    asrs  r2, r0, #16
    adds  r1, r1, r2
    lsls  r1, r1, #4
    uxth  r0, r0
    lsrs  r0, r0, #12
    adds  r1, r1, r0
    pop   {r2, r3}                    @ the plane, the value
    adds  r1, r1, r3
    str   r1, [r2, #.Lplane.start]
    .purgem zstrip_plane_step
  )" ZSTRIP_THUMB1_PURGE_PLANES ZSTRIP_THUMB1_POP);
}

// r4: the remaining shift of quotients; r5 and r6: the halves of 1 / area; r7: the planes; r8 and r9: the differences
// of a channel; r10: the address of its byte in the first colour; r11: the address of its start; r12: 0 in white light.
// The channels are a loop, because three copies would be large; white light computes only red. Differences have 9 bits,
// so that most sums with weights have 16, and a step takes two products instead of four.
[[gnu::naked]] void ThumbPlanes::set_channels(MediumScan&) const {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_NAMES(ZSTRIP_THUMB_PLANES)
          ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_PLANES R"(
    .set .Lstack.right, 0             @ a step to the right times the way to the anchor
    .set .Lstack.right_low, 4         @ 16 bits below it
    .set .Lstack.channel, 8           @ at vertex 0
    .set .Lstack.size, 12
    .set .Lto_step_y, .Lmedium.step_y_red - .Lmedium.start_red
    .set .Lto_step_x, .Lmedium.step_x_red - .Lmedium.start_red

    @ A step of the weights at \first and behind it: r1 and 16 bits below it in r0. Of a sum of 16 bits here, of others in
    @ .Lchannel_long.
    .macro zstrip_channel_step first
      mov   r2, r8
      ldr   r1, [r7, #\first]
      muls  r1, r2, r1
      mov   r2, r9
      ldr   r0, [r7, #\first + .Lplanes.x1_to_x2]
      muls  r0, r2, r0
      adds  r0, r0, r1
      sxth  r1, r0
      cmp   r1, r0
      beq   .Lchannel_short\@
      movs  r4, r0
      movs  r3, #0
      bl    .Lchannel_long
      b     .Lchannel_step\@
    .Lchannel_short\@:
      muls  r0, r6, r0
      muls  r1, r5, r1
      asrs  r1, r1, #16
      adds  r0, r0, r1
      asrs  r0, r0, r4
      asrs  r1, r0, #16
    .Lchannel_step\@:
    .endm

    sub   sp, sp, #.Lstack.size
    movs  r7, r0
    adds  r1, r1, #.Lmedium.start_red
    mov   r11, r1
    adds  r1, r1, #.Lmedium.colours - .Lmedium.start_red
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
    ldr   r4, [r7, #.Lplanes.right]
  .Lchannel_next:
    mov   r0, r10
    ldrb  r1, [r0]
    ldrb  r2, [r0, #.Lcolour.size]
    ldrb  r3, [r0, #2 * .Lcolour.size]
    adds  r0, r0, #1
    mov   r10, r0
    subs  r2, r2, r1
    mov   r8, r2
    subs  r3, r3, r1
    mov   r9, r3
    str   r1, [sp, #.Lstack.channel]
    zstrip_channel_step .Lplanes.x1
    zstrip_plane_round "mov r3, r11", .Lto_step_x
    ldr   r2, [r7, #.Lplanes.offset_x]
    muls  r1, r2, r1
    muls  r0, r2, r0
    str   r1, [sp, #.Lstack.right]
    str   r0, [sp, #.Lstack.right_low]
    zstrip_channel_step .Lplanes.y1
    zstrip_plane_round "mov r3, r11", .Lto_step_y
    ldr   r2, [r7, #.Lplanes.offset_y]
    muls  r1, r2, r1
    muls  r0, r2, r0
    ldr   r2, [sp, #.Lstack.right_low]
    adds  r0, r0, r2
    ldr   r2, [sp, #.Lstack.right]
    adds  r1, r1, r2
    asrs  r2, r0, #16
    adds  r1, r1, r2
    lsls  r1, r1, #4
    uxth  r0, r0
    lsrs  r0, r0, #12
    adds  r1, r1, r0
    ldr   r2, [sp, #.Lstack.channel]  @ 8.16, plus one half
    lsls  r2, r2, #1
    adds  r2, r2, #1
    lsls  r2, r2, #15
    adds  r1, r1, r2
    stm   r3!, {r1}
    mov   r11, r3
    mov   r0, r12
    cmp   r0, #0
    bne   .Lchannel_coloured
    @ White light: all channels are red's. r3 is at start_green.
    str   r1, [r3]
    str   r1, [r3, #.Lmedium.start_blue - .Lmedium.start_green]
    ldr   r0, [r3, #.Lmedium.step_y_red - .Lmedium.start_green]
    str   r0, [r3, #.Lmedium.step_y_green - .Lmedium.start_green]
    str   r0, [r3, #.Lmedium.step_y_blue - .Lmedium.start_green]
    ldr   r0, [r3, #.Lmedium.step_x_red - .Lmedium.start_green]
    str   r0, [r3, #.Lmedium.step_x_green - .Lmedium.start_green]
    str   r0, [r3, #.Lmedium.step_x_blue - .Lmedium.start_green]
    b     .Lchannel_end
  .Lchannel_coloured:
    mov   r0, r10                     @ the last one's offset is 3 more than a multiple of 4
    lsls  r0, r0, #30
    asrs  r0, r0, #30
    adds  r0, r0, #1
    bne   .Lchannel_next
  .Lchannel_end:
    add   sp, sp, #.Lstack.size
  )" ZSTRIP_THUMB1_POP R"(
  .Lchannel_long:
    zstrip_plane_quotient
    movs  r4, r2
    bx    lr
    .purgem zstrip_channel_step
  )" ZSTRIP_THUMB1_PURGE_PLANES);
}

#endif

}  // namespace zstrip::detail
