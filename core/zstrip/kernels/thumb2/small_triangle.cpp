// The assembly of thumb/small_triangle.hpp. GCC has a dozen registers for twice as many values and moves a third of
// them to the stack and back; this code needs no stack for them.
#include "zstrip/kernels/thumb/small_triangle.hpp"

#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/pixels/small_scan.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// `used`: small_run.cpp calls it by name.
//
// r0 is always the scan. The weights of vertices 1 and 2 stay in registers to the end: at the anchor r7 and r8, right
// r12 and r10, down r11 and r9. Edges come first, because they need no quotient; then r4, the area, is replaced by its
// inverse. Depth comes before channels, whose products need scaled weights.
[[gnu::naked, gnu::used]] void set_up_small_thumb(SmallScan&, const SnappedVertex&, const SnappedVertex&,
                                                  const SnappedVertex&) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) R"(
    @ A channel's plane: start r1, steps r2 and r3, from the channel at offset \at of the scan. Needs the inverse area
    @ in r4 and the weights of vertices 1 and 2, scaled: at the anchor r7 and r8, right r12 and r10, down r11 and r9.
    .macro zstrip_small_channel at
      ldrb  lr, [r0, #\at]
      ldrb  r5, [r0, #\at + .Lcolour.size]
      ldrb  r6, [r0, #\at + 2 * .Lcolour.size]
      subs  r5, r5, lr
      subs  r6, r6, lr
      mul   r1, r5, r7
      mla   r1, r6, r8, r1
      smull r2, r1, r4, r1
      mul   r2, r5, r12
      mla   r2, r6, r10, r2
      smull r3, r2, r4, r2
      mul   r3, r5, r11
      mla   r3, r6, r9, r3
      smull r5, r3, r4, r3
      add   r1, r1, lr, lsl #8
      adds  r1, r1, #128
    .endm

    push  {r4-r11, lr}
    ldrd  r5, r6, [r0, #.Lsmall.anchor_x] @ anchor
    ldr   r4, [r0, #.Lsmall.area]     @ area
    ldrsh r7, [r1, #.Lvertex.x]
    ldrsh r8, [r1, #.Lvertex.y]
    ldrsh r9, [r2, #.Lvertex.x]
    ldrsh r10, [r2, #.Lvertex.y]
    ldrsh r11, [r3, #.Lvertex.x]
    ldrsh r12, [r3, #.Lvertex.y]
    rsb   r5, r7, r5, lsl #4
    rsb   r6, r8, r6, lsl #4
    adds  r5, r5, #15                 @ from vertex 0 to the anchor's centre
    adds  r6, r6, #15
    sub   r12, r8, r12                @ right, of weight 1
    sub   r10, r10, r8                @ right, of weight 2
    sub   r11, r11, r7                @ down
    sub   r9, r7, r9
    mul   r7, r5, r12                 @ at the anchor
    mla   r7, r6, r11, r7
    mul   r8, r5, r10
    mla   r8, r6, r9, r8

    @ The packed edges, PackedEdges::field() of each in its place: their sum in lr.
    add   r5, r12, r10                @ the third edge, opposite to vertex 0
    add   r6, r11, r9
    rsbs  r5, r5, #0
    rsbs  r6, r6, #0
    add   lr, r6, r5, lsl #16
    add   lr, r4, lr, asr #31
    sub   lr, lr, r7
    sub   lr, lr, r8
    asr   lr, lr, #4
    lsl   lr, lr, #22
    lsls  r5, r5, #22                 @ steps of the packed word
    add   r5, r5, r12, lsl #11
    add   r5, r5, r10
    str   r5, [r0, #.Lsmall.step_x_edges]
    lsls  r6, r6, #22
    add   r6, r6, r11, lsl #11
    add   r6, r6, r9
    str   r6, [r0, #.Lsmall.step_y_edges]
    add   r5, r11, r12, lsl #16       @ fields of the edges of weights 1 and 2
    add   r5, r7, r5, asr #31
    asrs  r5, r5, #4
    add   lr, lr, r5, lsl #11
    add   r5, r9, r10, lsl #16
    add   r5, r8, r5, asr #31
    add   lr, lr, r5, asr #4
    str   lr, [r0, #.Lsmall.start_edges]

    @ Depth. r2 and r3 are a unit of each weight, rounded by what smull leaves in the lower word.
    ldr   r1, [r1, #.Lvertex.depth]
    ldr   r2, [r2, #.Lvertex.depth]
    ldr   r3, [r3, #.Lvertex.depth]
    mvn   r5, #0x80000000
    udiv  r4, r5, r4                  @ (2^31 - 1) / area
    subs  r2, r2, r1
    subs  r3, r3, r1
    lsls  r2, r2, #1
    lsls  r3, r3, #1
    smull r5, r2, r4, r2              @ depth a unit of weight 1, rounded
    add   r2, r2, r5, lsr #31
    smull r5, r3, r4, r3
    add   r3, r3, r5, lsr #31
    mla   r1, r2, r7, r1
    mla   r1, r3, r8, r1
    str   r1, [r0, #.Lsmall.start_depth]
    mul   r5, r2, r12
    mla   r5, r3, r10, r5
    lsls  r5, r5, #4
    str   r5, [r0, #.Lsmall.step_x_depth]
    mul   r6, r2, r11
    mla   r6, r3, r9, r6
    lsls  r6, r6, #4
    str   r6, [r0, #.Lsmall.step_y_depth]

    @ Channels. Scaled, the weights' products with 1 / area have a channel's 8.8 in their upper words. Red waits on the
    @ stack until blue, which ends up in the same registers, is added to it.
    lsls  r7, r7, #9
    lsl   r8, r8, #9
    lsl   r12, r12, #13
    lsl   r10, r10, #13
    lsl   r11, r11, #13
    lsl   r9, r9, #13
    zstrip_small_channel .Lsmall.colours+.Lcolour.g
    str   r1, [r0, #.Lsmall.start_green]
    str   r2, [r0, #.Lsmall.step_x_green]
    str   r3, [r0, #.Lsmall.step_y_green]
    zstrip_small_channel .Lsmall.colours+.Lcolour.r
    push  {r1, r2, r3}
    zstrip_small_channel .Lsmall.colours+.Lcolour.b
    pop   {r5, r6, lr}
    add   r1, r1, r5, lsl #16
    add   r2, r2, r6, lsl #16
    add   r3, r3, lr, lsl #16
    str   r1, [r0, #.Lsmall.start_red_blue]
    str   r2, [r0, #.Lsmall.step_x_red_blue]
    str   r3, [r0, #.Lsmall.step_y_red_blue]
    pop   {r4-r11, pc}
    .purgem zstrip_small_channel
  )");
}

// `used`: small_run.cpp calls it by name.
//
// r1 edges; r2 depth; r3 green; r4 red and blue; r5 to r8 their steps to the right; r9 the cell; r10 the distance from
// its end to its pixel; r11 remaining columns; lr the signs of edges. r0 is the scan, and a temporary in the loop over
// pixels.
[[gnu::naked, gnu::used]] void scan_small_thumb(SmallScan&) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) R"(
    .set .Lstack.scan, 0

    push  {r0, r4-r11, lr}
    movw  lr, #.Lsmall.signs & 0xFFFF
    movt  lr, #.Lsmall.signs >> 16
  .Lsmall_row:
    ldm   r0, {r1-r12}                @ this row's starts, steps to the right, steps down
    add   r9, r9, r1
    add   r10, r10, r2
    add   r11, r11, r3
    add   r12, r12, r4
    stm   r0, {r9-r12}                @ the next row's starts
    ldrd  r9, r10, [r0, #.Lsmall.depth_row]
    ldrd  r11, r12, [r0, #.Lsmall.depth_stride]
    add   r11, r9, r11, lsl #1
    add   r12, r10, r12, lsl #1
    strd  r11, r12, [r0, #.Lsmall.depth_row] @ the next row's cells
    ldr   r12, [r0, #.Lsmall.width]
    mov   r11, r12                    @ columns left
    @ Up to the first covered pixel only the edges are stepped; then one product each moves the other values there.
  .Lsmall_skip:
    tst   r1, lr
    beq   .Lsmall_first
    add   r1, r1, r5
    subs  r11, r11, #1
    bne   .Lsmall_skip
    b     .Lsmall_next_row
  .Lsmall_first:
    subs  r12, r12, r11               @ the first covered column
    mla   r2, r6, r12, r2
    mla   r3, r7, r12, r3
    mla   r4, r8, r12, r4
    sub   r10, r10, r9
    subs  r10, r10, #.Lcell           @ from behind a cell of depth to its pixel
    add   r9, r9, r12, lsl #1
  .Lsmall_pixel:
    ldrh  r12, [r9], #.Lcell
    cmp   r12, r2, lsr #16
    bhs   .Lsmall_hidden
    lsrs  r12, r2, #16
    strh  r12, [r9, #-.Lcell]
    lsrs  r0, r4, #27                 @ red, the upper 5 of 8 bits of the upper half
    ubfx  r12, r3, #10, #6
    orr   r12, r12, r0, lsl #6
    ubfx  r0, r4, #11, #5
    orr   r12, r0, r12, lsl #5
    strh  r12, [r9, r10]
  .Lsmall_hidden:
    add   r1, r1, r5
    add   r2, r2, r6
    add   r3, r3, r7
    add   r4, r4, r8
    subs  r11, r11, #1
    beq   .Lsmall_row_done
    tst   r1, lr
    beq   .Lsmall_pixel
  .Lsmall_row_done:
    ldr   r0, [sp, #.Lstack.scan]
  .Lsmall_next_row:
    ldr   r12, [r0, #.Lsmall.height]
    subs  r12, r12, #1
    str   r12, [r0, #.Lsmall.height]
    bne   .Lsmall_row
    pop   {r0, r4-r11, pc}
  )");
}

// r0 the scan; r1 and r2 edges and depth; r3 and r4 their steps to the right; r5 and r6 the rows of depth and colour;
// r7 the colour; r8 remaining columns; r12 the cell; r10 the distance from its end to its pixel; lr the signs of edges.
// The rows stay in registers.
[[gnu::naked]] void scan_small_flat_thumb(SmallScan&) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) R"(
    push  {r4-r11, lr}
    movw  lr, #.Lsmall.signs & 0xFFFF
    movt  lr, #.Lsmall.signs >> 16
    ldrd  r3, r4, [r0, #.Lsmall.step_x_edges] @ steps to the right: edges and depth
    ldrd  r5, r6, [r0, #.Lsmall.depth_row]
    ldrh  r7, [r0, #.Lsmall.flat_colour]
  .Lflat_row:
    ldrd  r1, r2, [r0, #.Lsmall.start_edges] @ this row's starts
    ldrd  r9, r10, [r0, #.Lsmall.step_y_edges]
    add   r9, r9, r1
    add   r10, r10, r2
    strd  r9, r10, [r0, #.Lsmall.start_edges] @ the next row's starts
    ldr   r11, [r0, #.Lsmall.width]
    mov   r8, r11                     @ columns left
  .Lflat_skip:
    tst   r1, lr
    beq   .Lflat_first
    add   r1, r1, r3
    subs  r8, r8, #1
    bne   .Lflat_skip
    b     .Lflat_next_row
  .Lflat_first:
    sub   r11, r11, r8                @ the first covered column
    mla   r2, r4, r11, r2
    add   r12, r5, r11, lsl #1
    sub   r10, r6, r5
    subs  r10, r10, #.Lcell           @ from behind a cell of depth to its pixel
  .Lflat_pixel:
    ldrh  r9, [r12], #.Lcell
    cmp   r9, r2, lsr #16
    bhs   .Lflat_hidden
    lsr   r9, r2, #16
    strh  r9, [r12, #-.Lcell]
    strh  r7, [r12, r10]
  .Lflat_hidden:
    add   r1, r1, r3
    add   r2, r2, r4
    subs  r8, r8, #1
    beq   .Lflat_next_row
    tst   r1, lr
    beq   .Lflat_pixel
  .Lflat_next_row:
    ldrd  r9, r10, [r0, #.Lsmall.depth_stride]
    ldr   r11, [r0, #.Lsmall.height]
    add   r5, r5, r9, lsl #1
    add   r6, r6, r10, lsl #1
    subs  r11, r11, #1
    str   r11, [r0, #.Lsmall.height]
    bne   .Lflat_row
    pop   {r4-r11, pc}
  )");
}

#endif

}  // namespace zstrip::detail
