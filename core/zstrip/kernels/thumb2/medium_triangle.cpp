// The assembly of thumb/medium_triangle.hpp: a row of a triangle with all its values in registers.
#include "zstrip/kernels/thumb/medium_triangle.hpp"

#include "zstrip/kernels/thumb/medium_layout.hpp"
#include "zstrip/kernels/thumb2/medium_edges.hpp"
#include "zstrip/kernels/thumb2/medium_plane.hpp"
#include "zstrip/pixels/medium_scan.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// r0 is always the scan. The vertices, r1 to r3, give the shared values in the registers that zstrip_medium_plane and
// zstrip_medium_channel read. Depth comes first, while the vertices' addresses are still in registers. Red comes before
// the other channels: in white light all three are equal.
[[gnu::naked]] bool set_up_medium_thumb(MediumScan&, const SnappedVertex&, const SnappedVertex&, const SnappedVertex&) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_MEDIUM_PLANE R"(
    .set .Lword, 4

    @ A channel's plane, of value \to, from the colours' byte at offset \at of the scan. Needs the mantissa of 1 / area in
    @ r4, the shifted weights of vertices 1 and 2: right r11 and r9, down r10 and r8, and the way to the anchor in r12
    @ and lr. Collects in r7 what is beyond 32 bits.
    .macro zstrip_medium_channel at, to
      ldrb  r1, [r0, #\at]
      ldrb  r2, [r0, #\at + .Lcolour.size]
      ldrb  r3, [r0, #\at + 2 * .Lcolour.size]
      subs  r2, r2, r1
      subs  r3, r3, r1
      mul   r5, r2, r11
      mla   r5, r3, r9, r5
      smull r5, r6, r5, r4
      lsrs  r5, r5, #27
      orr   r5, r5, r6, lsl #5
      add   r6, r6, #0x04000000
      orrs  r7, r7, r6
      asrs  r6, r5, #8                @ the carry is the bit that rounds
      adc   r6, r6, #0
      str   r6, [r0, #.Lmedium.step_x_depth + .Lword * \to]
      smull r5, r6, r5, r12
      mul   r2, r2, r10
      mla   r2, r3, r8, r2
      smull r2, r3, r2, r4
      lsrs  r2, r2, #27
      orr   r2, r2, r3, lsl #5
      add   r3, r3, #0x04000000
      orrs  r7, r7, r3
      asrs  r3, r2, #8
      adc   r3, r3, #0
      str   r3, [r0, #.Lmedium.step_y_depth + .Lword * \to]
      smlal r5, r6, r2, lr
      lsrs  r5, r5, #12
      orr   r5, r5, r6, lsl #20
      add   r5, r5, r1, lsl #16
      add   r5, r5, #0x8000
      str   r5, [r0, #.Lmedium.start_depth + .Lword * \to]
    .endm

    push  {r4-r11, lr}
    @ r4: the mantissa of 1 / area, of an area that is normalised; r5: how far weights are shifted then.
    ldr   r4, [r0, #.Lmedium.area]    @ area
    clz   r5, r4
    lsls  r4, r4, r5
    lsrs  r6, r4, #16                 @ as reciprocal()
    mvn   r7, #0
    udiv  r6, r7, r6
    lsls  r6, r6, #14
    umull r7, lr, r4, r6
    rsb   lr, lr, #0x80000000
    lsl   lr, lr, #1
    umull r7, r4, r6, lr
    lsls  r4, r4, #1
    subs  r5, r5, #7
    ldrsh r6, [r1, #.Lvertex.x]
    ldrsh r7, [r1, #.Lvertex.y]
    ldrsh r8, [r2, #.Lvertex.x]
    ldrsh r9, [r2, #.Lvertex.y]
    ldrsh r10, [r3, #.Lvertex.x]
    ldrsh r11, [r3, #.Lvertex.y]
    ldrd  r12, lr, [r0, #.Lmedium.anchor_x] @ and anchor_y
    rsb   r12, r6, r12, lsl #4
    rsb   lr, r7, lr, lsl #4
    add   r12, r12, #15               @ from vertex 0 to the anchor's centre
    add   lr, lr, #15
    sub   r10, r10, r6                @ weights of vertices 1 and 2: down,
    sub   r8, r6, r8
    sub   r11, r7, r11                @ and to the right
    sub   r9, r9, r7
    lsl   r10, r10, r5
    lsl   r8, r8, r5
    lsl   r11, r11, r5
    lsl   r9, r9, r5
    add   r7, r0, #.Lmedium.shared    @ for other planes
    stm   r7, {r4, r8-r12, lr}

    ldr   r1, [r1, #.Lvertex.depth]
    ldr   r2, [r2, #.Lvertex.depth]
    ldr   r3, [r3, #.Lvertex.depth]
    subs  r2, r2, r1
    subs  r3, r3, r1
    zstrip_medium_plane .Lmedium.start_depth, .Lmedium.step_y_depth, .Lmedium.step_x_depth
    ldrb  r1, [r0, #.Lmedium.has_channels]
    movs  r7, #0                      @ bits beyond 32 of any channel's step
    cmp   r1, #0
    beq   .Lmedium_planes_set
    zstrip_medium_channel .Lmedium.colours + .Lcolour.r, 1
    add   r1, r0, #.Lmedium.colours
    ldm   r1, {r1-r3}
    eor   r5, r1, r1, lsr #8          @ red and green, green and blue
    eor   r6, r2, r2, lsr #8
    orrs  r5, r5, r6
    eor   r6, r3, r3, lsr #8
    orrs  r5, r5, r6
    lsls  r5, r5, #16
    bne   .Lmedium_coloured
    ldr   r1, [r0, #.Lmedium.start_red] @ white light: all channels are red's
    ldr   r2, [r0, #.Lmedium.step_y_red]
    ldr   r3, [r0, #.Lmedium.step_x_red]
    strd  r1, r1, [r0, #.Lmedium.start_green]
    strd  r2, r2, [r0, #.Lmedium.step_y_green]
    strd  r3, r3, [r0, #.Lmedium.step_x_green]
    b     .Lmedium_planes_set
  .Lmedium_coloured:
    zstrip_medium_channel .Lmedium.colours + .Lcolour.g, 2
    zstrip_medium_channel .Lmedium.colours + .Lcolour.b, 3
  .Lmedium_planes_set:
    lsrs  r0, r7, #27
    ite   eq
    moveq r0, #1
    movne r0, #0
    pop   {r4-r11, pc}
    .purgem zstrip_medium_channel
    .purgem zstrip_medium_step
    .purgem zstrip_medium_plane
  )");
}

// In the loop over pixels: r1 the cell; r2 the distance from its end to its pixel; r4, r5, r10 and r11 the steps of
// depth, red, green and blue; r6 to r9 the values; r12 remaining pixels. Before the loop, rows and starts are moved
// down in memory, while these registers hold the steps down.
[[gnu::naked]] void scan_medium_gouraud_thumb(MediumScan&, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_MEDIUM_EDGES R"(
    .set .Lstack.rows, 0              @ left

    push  {r1, r4-r11, lr}
  .Lmedium_row:
    zstrip_medium_edges
    add   r3, r0, #.Lmedium.depth_row
    ldm   r3!, {r1, r2, r4-r11}       @ rows, strides, starts, of the steps down two
    add   r4, r4, r1
    add   r5, r5, r2
    strd  r4, r5, [r0, #.Lmedium.depth_row]
    ldrd  r4, r5, [r0, #.Lmedium.step_y_green]
    add   r10, r10, r6                @ the next row's starts
    add   r11, r11, r7
    add   r4, r4, r8
    add   r5, r5, r9
    strd  r10, r11, [r0, #.Lmedium.start_depth]
    strd  r4, r5, [r0, #.Lmedium.start_green]
    cmp   r12, #0
    ble   .Lmedium_next_row
    add   r1, r1, lr, lsl #1
    add   r2, r2, lr, lsl #1
    add   r3, r0, #.Lmedium.step_x_depth
    ldm   r3, {r4, r5, r10, r11}      @ steps to the right
    mla   r6, r4, lr, r6
    mla   r7, r5, lr, r7
    mla   r8, r10, lr, r8
    mla   r9, r11, lr, r9
    subs  r2, r2, r1
    subs  r2, r2, #.Lcell             @ from behind a cell of depth to its pixel
  .Lmedium_pixel:
    ldrh  r3, [r1], #.Lcell
    cmp   r3, r6, lsr #16
    bhs   .Lmedium_hidden
    lsrs  r3, r6, #16
    strh  r3, [r1, #-.Lcell]
    lsrs  r3, r7, #19
    lsr   lr, r8, #18
    orr   r3, lr, r3, lsl #6
    lsr   lr, r9, #19
    orr   r3, lr, r3, lsl #5
    strh  r3, [r1, r2]
  .Lmedium_hidden:
    add   r6, r6, r4
    add   r7, r7, r5
    add   r8, r8, r10
    add   r9, r9, r11
    subs  r12, r12, #1
    bne   .Lmedium_pixel
  .Lmedium_next_row:
    ldr   r3, [sp, #.Lstack.rows]
    subs  r3, r3, #1
    str   r3, [sp, #.Lstack.rows]
    bne   .Lmedium_row
    pop   {r1, r4-r11, pc}
    .purgem zstrip_medium_edges
  )");
}

// In the loop over pixels: r1 the cell; r2 the distance from its end to its pixel; r4 depth; r5 its step; r6 the
// colour; r12 remaining pixels. r11 has the remaining rows.
[[gnu::naked]] void scan_medium_flat_thumb(MediumScan&, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_MEDIUM_EDGES R"(
    push  {r4-r11, lr}
    mov   r11, r1
  .Lmedium_flat_row:
    zstrip_medium_edges
    ldrd  r1, r2, [r0, #.Lmedium.depth_row] @ rows and strides
    ldrd  r3, r4, [r0, #.Lmedium.depth_stride]
    add   r3, r3, r1
    add   r4, r4, r2
    strd  r3, r4, [r0, #.Lmedium.depth_row]
    ldr   r4, [r0, #.Lmedium.start_depth]
    ldr   r3, [r0, #.Lmedium.step_y_depth]
    add   r3, r3, r4
    str   r3, [r0, #.Lmedium.start_depth]
    cmp   r12, #0
    ble   .Lmedium_flat_next_row
    ldr   r5, [r0, #.Lmedium.step_x_depth]
    ldrh  r6, [r0, #.Lmedium.flat_colour]
    mla   r4, r5, lr, r4
    add   r1, r1, lr, lsl #1
    add   r2, r2, lr, lsl #1
    subs  r2, r2, r1
    subs  r2, r2, #.Lcell             @ from behind a cell of depth to its pixel
  .Lmedium_flat_pixel:
    ldrh  r3, [r1], #.Lcell
    cmp   r3, r4, lsr #16
    bhs   .Lmedium_flat_hidden
    lsrs  r3, r4, #16
    strh  r3, [r1, #-.Lcell]
    strh  r6, [r1, r2]
  .Lmedium_flat_hidden:
    add   r4, r4, r5
    subs  r12, r12, #1
    bne   .Lmedium_flat_pixel
  .Lmedium_flat_next_row:
    subs  r11, r11, #1
    bne   .Lmedium_flat_row
    pop   {r4-r11, pc}
    .purgem zstrip_medium_edges
  )");
}

#endif

}  // namespace zstrip::detail
