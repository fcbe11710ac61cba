// The assembly of thumb/small_triangle.hpp for Thumb-1 (Cortex-M0, M0+). Products of 32 bits are sums of products of
// halves; the halves of the reciprocal stay in two of the eight registers that can multiply.
#include "zstrip/kernels/thumb/small_triangle.hpp"

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/pixels/small_scan.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// r0 is always the scan. After the quotient, r6 and r7 hold the halves of 1 / area, a factor of every plane, and
// weights and differences wait on the stack. Edges come first, because they need no quotient; then depth, because it
// needs the whole quotient in r3; then channels, for which the halves suffice.
[[gnu::naked]] static void set_up(SmallScan&, const SnappedVertex&, const SnappedVertex&, const SnappedVertex&,
                                  const std::uint16_t*) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_MULTIPLY_HIGH R"(
    @ On the stack:
    .set .Lstack.weight_1, 0          @ of vertex 1 at the anchor
    .set .Lstack.weight_2, 4
    .set .Lstack.right_1, 8           @ their steps to the right
    .set .Lstack.right_2, 12
    .set .Lstack.down_1, 16           @ and down
    .set .Lstack.down_2, 20
    .set .Lstack.depth_0, 24          @ of vertex 0
    .set .Lstack.depth_1, 28          @ differences to vertices 1 and 2
    .set .Lstack.depth_2, 32
    .set .Lstack.reciprocals, 36      @ the table for an index that begins at 256
    .set .Lstack.size, 40

    @ r1: a channel along the weights on the stack at \at1 and \at2 times 1 / area, which is 2^31; its differences are
    @ r8 and r9. \right is left to shift, after 16, where the sum has 16 bits, as most have. Uses r2, r4 and r5.
    .macro zstrip_channel_along at1 at2 right
      mov   r1, r8
      ldr   r2, [sp, #\at1]
      muls  r1, r1, r2
      mov   r4, r9
      ldr   r2, [sp, #\at2]
      muls  r4, r4, r2
      adds  r1, r1, r4
      sxth  r2, r1
      cmp   r2, r1
      beq   .Lsetup_short\@
      lsls  r1, r1, #16 - \right
      bl    .Lsetup_long
      b     .Lsetup_along\@
    .Lsetup_short\@:
      muls  r2, r6, r2
      asrs  r2, r2, #16
      muls  r1, r7, r1
      adds  r1, r1, r2
      asrs  r1, r1, #\right
    .Lsetup_along\@:
    .endm
    @ r3: the sum of the weights at \at1 and \at2 times r1 and r3.
    .macro zstrip_depth_along at1 at2
      ldr   r4, [sp, #\at1]
      muls  r4, r4, r1
      ldr   r5, [sp, #\at2]
      muls  r5, r5, r3
      adds  r4, r4, r5
    .endm

    sub   sp, sp, #.Lstack.size
    ldr   r4, [sp, #.Lstack.size + .Lsaved]
    movs  r5, #2
    lsls  r5, r5, #8
    subs  r4, r4, r5
    str   r4, [sp, #.Lstack.reciprocals]

    @ Weights: r5 and r4 are x and y of vertex 0; then r6 and r7 the steps of weight 1, r8 and r9 of weight 2.
    ldr   r4, [r1, #.Lvertex.x]       @ and y
    sxth  r5, r4
    asrs  r4, r4, #16
    ldr   r6, [r2, #.Lvertex.x]
    sxth  r7, r6
    asrs  r6, r6, #16
    subs  r6, r6, r4                  @ weight 2: right, down
    subs  r7, r5, r7
    str   r6, [sp, #.Lstack.right_2]
    str   r7, [sp, #.Lstack.down_2]
    mov   r8, r6
    mov   r9, r7
    ldr   r6, [r3, #.Lvertex.x]
    sxth  r7, r6
    asrs  r6, r6, #16
    subs  r6, r4, r6                  @ weight 1
    subs  r7, r7, r5
    str   r6, [sp, #.Lstack.right_1]
    str   r7, [sp, #.Lstack.down_1]
    ldr   r1, [r1, #.Lvertex.depth]
    ldr   r2, [r2, #.Lvertex.depth]
    ldr   r3, [r3, #.Lvertex.depth]
    subs  r2, r2, r1
    subs  r3, r3, r1
    str   r1, [sp, #.Lstack.depth_0]
    str   r2, [sp, #.Lstack.depth_1]
    str   r3, [sp, #.Lstack.depth_2]
    ldr   r1, [r0, #.Lsmall.anchor_x] @ from vertex 0 to the anchor's centre
    ldr   r2, [r0, #.Lsmall.anchor_y]
    lsls  r1, r1, #4
    lsls  r2, r2, #4
    adds  r1, r1, #15
    adds  r2, r2, #15
    subs  r1, r1, r5
    subs  r2, r2, r4
    movs  r3, r1
    muls  r3, r3, r6
    movs  r4, r2
    muls  r4, r4, r7
    adds  r3, r3, r4                  @ weight 1 at the anchor
    mov   r4, r8
    mov   r5, r9
    muls  r1, r1, r4
    muls  r2, r2, r5
    adds  r1, r1, r2                  @ weight 2
    str   r3, [sp, #.Lstack.weight_1]
    str   r1, [sp, #.Lstack.weight_2]

    @ The packed edges, PackedEdges::field() of each in its place: their sum in r8.
    lsls  r2, r6, #16                 @ weight 1
    adds  r2, r2, r7
    asrs  r2, r2, #31
    adds  r2, r2, r3
    asrs  r2, r2, #4
    lsls  r2, r2, #11
    mov   r8, r2
    lsls  r2, r4, #16                 @ weight 2
    adds  r2, r2, r5
    asrs  r2, r2, #31
    adds  r2, r2, r1
    asrs  r2, r2, #4
    add   r8, r8, r2
    ldr   r2, [r0, #.Lsmall.area]     @ the third one, opposite to vertex 0
    subs  r2, r2, r3
    subs  r2, r2, r1
    adds  r1, r6, r4
    rsbs  r1, r1, #0
    adds  r3, r7, r5
    rsbs  r3, r3, #0
    lsls  r6, r6, #11
    adds  r4, r4, r6
    lsls  r6, r1, #22
    adds  r4, r4, r6
    str   r4, [r0, #.Lsmall.step_x_edges]
    lsls  r7, r7, #11
    adds  r5, r5, r7
    lsls  r7, r3, #22
    adds  r5, r5, r7
    str   r5, [r0, #.Lsmall.step_y_edges]
    lsls  r1, r1, #16
    adds  r1, r1, r3
    asrs  r1, r1, #31
    adds  r2, r2, r1
    asrs  r2, r2, #4
    lsls  r2, r2, #22
    add   r2, r2, r8
    str   r2, [r0, #.Lsmall.start_edges]

    @ r3: quotient_31_by_table() of the area in r1. r2 counts how far the area is normalised, in r3; r4 is the reciprocal
    @ of the table, then with the correction that r3 gives; r6 are remainders.
    ldr   r1, [r0, #.Lsmall.area]
    movs  r2, #1
    lsls  r3, r1, #17
    lsrs  r4, r3, #24
    bne   .Lsetup_8
    adds  r2, r2, #8
    lsls  r3, r3, #8
  .Lsetup_8:
    lsrs  r4, r3, #28
    bne   .Lsetup_4
    adds  r2, r2, #4
    lsls  r3, r3, #4
  .Lsetup_4:
    lsrs  r4, r3, #30
    bne   .Lsetup_2
    adds  r2, r2, #2
    lsls  r3, r3, #2
  .Lsetup_2:
    cmp   r3, #0
    bmi   .Lsetup_1
    adds  r2, r2, #1
    lsls  r3, r3, #1
  .Lsetup_1:
    ldr   r6, [sp, #.Lstack.reciprocals]
    lsrs  r4, r3, #23
    lsls  r4, r4, #1
    ldrh  r4, [r6, r4]
    movs  r5, #1
    lsls  r5, r5, #31
    lsrs  r3, r3, #16
    muls  r3, r3, r4
    subs  r3, r5, r3
    asrs  r3, r3, #7
    muls  r3, r3, r4
    asrs  r3, r3, #23
    lsls  r4, r4, #1
    adds  r4, r4, r3
    subs  r3, r4, #1
    subs  r6, r2, #1
    lsls  r3, r3, r6
    lsrs  r4, r4, #2
    subs  r5, r5, #1
    movs  r6, r3
    muls  r6, r6, r1
    subs  r6, r5, r6
    muls  r6, r6, r4
    movs  r4, #30
    subs  r4, r4, r2
    lsrs  r6, r6, r4
    adds  r3, r3, r6
    movs  r6, r3
    muls  r6, r6, r1
    subs  r6, r5, r6
    cmp   r6, r1
    blo   .Lsetup_quotient
    adds  r3, r3, #1
  .Lsetup_quotient:                   @ halves of 1 / area: r6 and r7
    uxth  r6, r3
    lsrs  r7, r3, #16

    @ Depth, rounded by the uppermost bit of a product's lower word: that takes the whole quotient, r3.
    ldr   r1, [sp, #.Lstack.depth_2]  @ a unit of weight 2, rounded: r8
    lsls  r1, r1, #1
    movs  r2, r1
    muls  r2, r2, r3
    lsrs  r2, r2, #31
    mov   r8, r2
    zstrip_multiply_high r1, r6, r7, r2, r4, r5
    add   r8, r8, r1
    ldr   r1, [sp, #.Lstack.depth_1]  @ of weight 1: r1
    lsls  r1, r1, #1
    muls  r3, r3, r1
    lsrs  r3, r3, #31
    zstrip_multiply_high r1, r6, r7, r2, r4, r5
    adds  r1, r1, r3
    mov   r3, r8
    zstrip_depth_along .Lstack.weight_1 .Lstack.weight_2
    ldr   r5, [sp, #.Lstack.depth_0]
    adds  r4, r4, r5
    str   r4, [r0, #.Lsmall.start_depth]
    zstrip_depth_along .Lstack.right_1 .Lstack.right_2
    lsls  r4, r4, #4
    str   r4, [r0, #.Lsmall.step_x_depth]
    zstrip_depth_along .Lstack.down_1 .Lstack.down_2
    lsls  r4, r4, #4
    str   r4, [r0, #.Lsmall.step_y_depth]

    @ Channels: green has words of its own; red in the upper halves of others is stored first, blue added to them.
    movs  r3, r0
    adds  r3, r3, #.Lsmall.colours + .Lcolour.g
    bl    .Lsetup_channel
    str   r1, [r0, #.Lsmall.step_y_green]
    mov   r1, r10
    str   r1, [r0, #.Lsmall.start_green]
    mov   r1, r11
    str   r1, [r0, #.Lsmall.step_x_green]
    subs  r3, r3, #.Lcolour.g - .Lcolour.r
    bl    .Lsetup_channel
    lsls  r1, r1, #16
    str   r1, [r0, #.Lsmall.step_y_red_blue]
    mov   r1, r10
    lsls  r1, r1, #16
    str   r1, [r0, #.Lsmall.start_red_blue]
    mov   r1, r11
    lsls  r1, r1, #16
    str   r1, [r0, #.Lsmall.step_x_red_blue]
    adds  r3, r3, #.Lcolour.b - .Lcolour.r
    bl    .Lsetup_channel
    ldr   r2, [r0, #.Lsmall.step_y_red_blue]
    adds  r1, r1, r2
    str   r1, [r0, #.Lsmall.step_y_red_blue]
    ldr   r2, [r0, #.Lsmall.start_red_blue]
    add   r2, r2, r10
    str   r2, [r0, #.Lsmall.start_red_blue]
    ldr   r2, [r0, #.Lsmall.step_x_red_blue]
    add   r2, r2, r11
    str   r2, [r0, #.Lsmall.step_x_red_blue]
    add   sp, sp, #.Lstack.size
  )" ZSTRIP_THUMB1_POP R"(

    @ A channel's plane: start r10, steps r11 and r1, from the channels at r3. lr waits in r12, because
    @ .Lsetup_long may be called.
  .Lsetup_channel:
    mov   r12, lr
    ldrb  r1, [r3, #0 * .Lcolour.size]
    ldrb  r2, [r3, #1 * .Lcolour.size]
    ldrb  r4, [r3, #2 * .Lcolour.size]
    subs  r2, r2, r1
    subs  r4, r4, r1
    mov   r8, r2
    mov   r9, r4
    lsls  r1, r1, #8
    adds  r1, r1, #128
    mov   r10, r1
    zstrip_channel_along .Lstack.weight_1 .Lstack.weight_2 7
    add   r10, r10, r1
    zstrip_channel_along .Lstack.right_1 .Lstack.right_2 3
    mov   r11, r1
    zstrip_channel_along .Lstack.down_1 .Lstack.down_2 3
    bx    r12
  .Lsetup_long:
    zstrip_multiply_high r1, r6, r7, r2, r4, r5
    bx    lr
    .purgem zstrip_channel_along
    .purgem zstrip_depth_along
  )" ZSTRIP_THUMB1_PURGE_MULTIPLY_HIGH);
}

// `used`: small_run.cpp calls both by name.
[[gnu::used]] void set_up_small_thumb(SmallScan& scan, const SnappedVertex& v0, const SnappedVertex& v1,
                                      const SnappedVertex& v2) {
  set_up(scan, v0, v1, v2, kReciprocalTable.data());
}

// r1 edges; r2 their signs; r3 depth; r4 its cell; r6 remaining columns; r7 the distance from a cell to its pixel; r8
// green; r9 red and blue; r10 to r12 the steps of depth, green, red and blue; lr the step of edges. The scan is on the
// stack.
[[gnu::naked, gnu::used]] void scan_small_thumb(SmallScan&) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) ZSTRIP_THUMB1_PUSH R"(
    .set .Lstack.scan, 0

    push  {r0}
    ldr   r1, [r0, #.Lsmall.step_x_edges]
    mov   lr, r1
    ldr   r1, [r0, #.Lsmall.step_x_depth]
    mov   r10, r1
    ldr   r1, [r0, #.Lsmall.step_x_green]
    mov   r11, r1
    ldr   r1, [r0, #.Lsmall.step_x_red_blue]
    mov   r12, r1
  .Lsmall_row:
    @ This row's starts, r1, r3, r8 and r9, and the next one's into the scan; r0 moves on as ldm and stm need it.
    ldm   r0!, {r1, r3, r5, r6}
    mov   r8, r5
    mov   r9, r6
    adds  r0, r0, #.Lsmall.step_y_edges - .Lsmall.step_x_edges
    ldm   r0!, {r2, r4, r7}           @ steps down
    adds  r2, r2, r1
    adds  r4, r4, r3
    adds  r5, r5, r7
    ldr   r7, [r0]                    @ step_y_red_blue
    adds  r6, r6, r7
    subs  r0, r0, #.Lsmall.step_y_red_blue - .Lsmall.start_edges
    stm   r0!, {r2, r4, r5, r6}
    adds  r0, r0, #.Lsmall.depth_row - .Lsmall.step_x_edges
    ldm   r0!, {r4, r7}               @ rows
    ldm   r0!, {r2, r5, r6}           @ strides and width
    lsls  r2, r2, #1
    adds  r2, r2, r4
    lsls  r5, r5, #1
    adds  r5, r5, r7
    subs  r0, r0, #.Lsmall.height - .Lsmall.depth_row
    stm   r0!, {r2, r5}
    subs  r7, r7, r4
    ldr   r2, .Lsmall_signs
    @ Two loops: up to the first covered pixel, then over covered ones. A row of a triangle has no gaps: the first pixel
    @ behind them that is not covered ends it.
  .Lsmall_skip:
    tst   r1, r2
    beq   .Lsmall_pixel
    add   r1, r1, lr
    add   r3, r3, r10
    add   r8, r8, r11
    add   r9, r9, r12
    adds  r4, r4, #.Lcell
    subs  r6, r6, #1
    bne   .Lsmall_skip
    b     .Lsmall_next_row
  .Lsmall_pixel:
    ldrh  r0, [r4]
    lsrs  r5, r3, #16
    cmp   r0, r5
    bhs   .Lsmall_hidden
    strh  r5, [r4]
    mov   r0, r9
    lsrs  r5, r0, #27                 @ red, the upper 5 of 8 bits of the upper half
    lsls  r5, r5, #11
    lsls  r0, r0, #16
    lsrs  r0, r0, #27
    orrs  r5, r5, r0
    mov   r0, r8
    lsls  r0, r0, #16
    lsrs  r0, r0, #26
    lsls  r0, r0, #5
    orrs  r5, r5, r0
    strh  r5, [r4, r7]
  .Lsmall_hidden:
    add   r1, r1, lr
    add   r3, r3, r10
    add   r8, r8, r11
    add   r9, r9, r12
    adds  r4, r4, #.Lcell
    subs  r6, r6, #1
    beq   .Lsmall_next_row
    tst   r1, r2
    beq   .Lsmall_pixel
  .Lsmall_next_row:
    ldr   r0, [sp, #.Lstack.scan]
    ldr   r5, [r0, #.Lsmall.height]
    subs  r5, r5, #1
    str   r5, [r0, #.Lsmall.height]
    bne   .Lsmall_row
    pop   {r0}
  )" ZSTRIP_THUMB1_POP R"(
    .align 2
  .Lsmall_signs:
    .word .Lsmall.signs
  )");
}

// Works like scan_small_thumb, with the colour in r8: it steps only edges and depth, and the strides of both rows.
[[gnu::naked]] void scan_small_flat_thumb(SmallScan&) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) ZSTRIP_THUMB1_PUSH R"(
    .set .Lstack.scan, 0

    push  {r0}
    ldr   r1, [r0, #.Lsmall.step_x_edges]
    mov   lr, r1
    ldr   r1, [r0, #.Lsmall.step_x_depth]
    mov   r10, r1
    movs  r1, r0
    adds  r1, r1, #.Lsmall.flat_colour
    ldrh  r1, [r1]
    mov   r8, r1
    ldr   r2, .Lflat_signs
  .Lflat_row:
    ldm   r0!, {r1, r3}               @ this row's starts, and the next one's
    ldr   r5, [r0, #.Lsmall.step_y_edges - .Lsmall.start_green]
    ldr   r6, [r0, #.Lsmall.step_y_depth - .Lsmall.start_green]
    adds  r5, r5, r1
    adds  r6, r6, r3
    subs  r0, r0, #.Lsmall.start_green - .Lsmall.start_edges
    stm   r0!, {r5, r6}
    adds  r0, r0, #.Lsmall.depth_row - .Lsmall.start_green
    ldm   r0!, {r4, r7}               @ rows
    ldr   r5, [r0]                    @ depth_stride
    ldr   r6, [r0, #.Lsmall.colour_stride - .Lsmall.depth_stride]
    lsls  r5, r5, #1
    lsls  r6, r6, #1
    adds  r5, r5, r4
    adds  r6, r6, r7
    subs  r0, r0, #.Lsmall.depth_stride - .Lsmall.depth_row
    stm   r0!, {r5, r6}
    ldr   r6, [r0, #.Lsmall.width - .Lsmall.depth_stride]
    subs  r7, r7, r4
  .Lflat_skip:
    tst   r1, r2
    beq   .Lflat_pixel
    add   r1, r1, lr
    add   r3, r3, r10
    adds  r4, r4, #.Lcell
    subs  r6, r6, #1
    bne   .Lflat_skip
    b     .Lflat_next_row
  .Lflat_pixel:
    ldrh  r0, [r4]
    lsrs  r5, r3, #16
    cmp   r0, r5
    bhs   .Lflat_hidden
    strh  r5, [r4]
    mov   r0, r8
    strh  r0, [r4, r7]
  .Lflat_hidden:
    add   r1, r1, lr
    add   r3, r3, r10
    adds  r4, r4, #.Lcell
    subs  r6, r6, #1
    beq   .Lflat_next_row
    tst   r1, r2
    beq   .Lflat_pixel
  .Lflat_next_row:
    ldr   r0, [sp, #.Lstack.scan]
    ldr   r5, [r0, #.Lsmall.height]
    subs  r5, r5, #1
    str   r5, [r0, #.Lsmall.height]
    bne   .Lflat_row
    pop   {r0}
  )" ZSTRIP_THUMB1_POP R"(
    .align 2
  .Lflat_signs:
    .word .Lsmall.signs
  )");
}

#endif

}  // namespace zstrip::detail
