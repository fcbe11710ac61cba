// The assembly of thumb/medium_triangle.hpp: rows of a triangle, with its values in the low registers and their steps
// in the high ones.
#include "zstrip/kernels/thumb/medium_triangle.hpp"

#include "zstrip/kernels/thumb/medium_layout.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb1/medium_edges.hpp"
#include "zstrip/pixels/medium_scan.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// In the loop over pixels: r0 the cell; r4 to r7 depth, red, green and blue; r8 to r11 their steps; r12 the distance
// from a cell to its pixel; lr the end of the cells. Each row begins with the edges, which need r1 to r7. Then rows and
// starts are moved down in memory, because no register is free for them.
[[gnu::naked]] void scan_medium_gouraud_thumb(MediumScan&, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_MEDIUM_EDGES R"(
    @ On the stack:
    .set .Lstack.scan, 0
    .set .Lstack.rows, 4              @ left
    .set .Lstack.cell, 8              @ the row's first one
    .set .Lstack.size, 12
    .set .Lword, 4

    @ The start in \value a row down, for value number \number; starts at r1, steps at r3. Uses r0.
    .macro zstrip_medium_down value number
      ldr   r0, [r3, #.Lword * \number]
      adds  r0, r0, \value
      str   r0, [r1, #.Lword * \number]
    .endm
    @ The start moved by r2 columns. Uses r1.
    .macro zstrip_medium_right value step
      mov   r1, \step
      muls  r1, r2, r1
      adds  \value, \value, r1
    .endm

    push  {r0-r2}
    movs  r3, r0
    adds  r3, r3, #.Lmedium.step_x_depth
    ldm   r3!, {r4-r7}                @ steps to the right
    mov   r8, r4
    mov   r9, r5
    mov   r10, r6
    mov   r11, r7
  .Lmedium_row:
    zstrip_medium_edges
    mov   r12, r1                     @ the row's end, for a while
    ldm   r6!, {r1-r4}                @ rows and strides
    adds  r3, r3, r1
    adds  r4, r4, r2
    str   r3, [r0, #.Lmedium.depth_row]
    str   r4, [r0, #.Lmedium.colour_row]
    lsls  r3, r7, #1
    adds  r1, r1, r3
    adds  r2, r2, r3
    subs  r2, r2, r1
    mov   r3, r12
    mov   r12, r2                     @ from a cell to its pixel
    subs  r3, r3, r7
    lsls  r3, r3, #1
    adds  r3, r3, r1
    mov   lr, r3                      @ behind the last cell
    str   r1, [sp, #.Lstack.cell]
    movs  r2, r7                      @ r1 at the starts, r3 behind them at the steps down
    movs  r1, r6
    movs  r3, r6
    ldm   r3!, {r4-r7}
    zstrip_medium_down r4 0
    zstrip_medium_down r5 1
    zstrip_medium_down r6 2
    zstrip_medium_down r7 3
    ldr   r0, [sp, #.Lstack.cell]
    cmp   r0, lr
    bhs   .Lmedium_next_row
    zstrip_medium_right r4 r8
    zstrip_medium_right r5 r9
    zstrip_medium_right r6 r10
    zstrip_medium_right r7 r11
  .Lmedium_pixel:
    lsrs  r1, r4, #16
    ldrh  r2, [r0]
    cmp   r2, r1
    bhs   .Lmedium_hidden
    strh  r1, [r0]
    lsrs  r1, r5, #19
    lsls  r1, r1, #6
    lsrs  r2, r6, #18
    orrs  r1, r1, r2
    lsls  r1, r1, #5
    lsrs  r2, r7, #19
    orrs  r1, r1, r2
    mov   r2, r12
    strh  r1, [r0, r2]
  .Lmedium_hidden:
    add   r4, r4, r8
    add   r5, r5, r9
    add   r6, r6, r10
    add   r7, r7, r11
    adds  r0, r0, #.Lcell
    cmp   r0, lr
    bne   .Lmedium_pixel
  .Lmedium_next_row:
    ldr   r0, [sp, #.Lstack.rows]
    subs  r0, r0, #1
    beq   .Lmedium_end
    str   r0, [sp, #.Lstack.rows]
    ldr   r0, [sp, #.Lstack.scan]
    b     .Lmedium_row
  .Lmedium_end:
    add   sp, sp, #.Lstack.size
    .purgem zstrip_medium_down
    .purgem zstrip_medium_right
  )" ZSTRIP_THUMB1_PURGE_MEDIUM_EDGES ZSTRIP_THUMB1_POP);
}

// In the loop over pixels: r1 the cell; r2 the distance to its pixel; r3 the end of the cells; r4 the step of depth; r5
// depth; r6 the colour. r8 and r9 keep that step and the colour while the edges use the low registers.
[[gnu::naked]] void scan_medium_flat_thumb(MediumScan&, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MEDIUM_SCAN) ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_MEDIUM_EDGES R"(
    .set .Lstack.scan, 0
    .set .Lstack.rows, 4              @ left
    .set .Lstack.size, 8

    push  {r0, r1}
    movs  r3, r0
    adds  r3, r3, #.Lmedium.step_x_depth
    ldr   r4, [r3]
    mov   r8, r4
    ldrh  r4, [r3, #.Lmedium.flat_colour - .Lmedium.step_x_depth]
    mov   r9, r4
  .Lflat_medium_row:
    zstrip_medium_edges
    mov   r12, r1
    ldm   r6!, {r1-r4}                @ rows and strides
    adds  r3, r3, r1
    adds  r4, r4, r2
    str   r3, [r0, #.Lmedium.depth_row]
    str   r4, [r0, #.Lmedium.colour_row]
    ldr   r5, [r6]                    @ start_depth
    ldr   r4, [r6, #.Lmedium.step_y_depth - .Lmedium.start_depth]
    adds  r4, r4, r5
    str   r4, [r6]
    mov   r3, r12
    subs  r3, r3, r7
    ble   .Lflat_medium_next_row
    lsls  r6, r7, #1
    adds  r1, r1, r6
    adds  r2, r2, r6
    subs  r2, r2, r1
    lsls  r3, r3, #1
    adds  r3, r3, r1
    mov   r4, r8
    muls  r7, r4, r7
    adds  r5, r5, r7
    mov   r6, r9
  .Lflat_medium_pixel:
    ldrh  r7, [r1]
    lsrs  r0, r5, #16
    cmp   r7, r0
    bhs   .Lflat_medium_hidden
    strh  r0, [r1]
    strh  r6, [r1, r2]
  .Lflat_medium_hidden:
    adds  r5, r5, r4
    adds  r1, r1, #.Lcell
    cmp   r1, r3
    bne   .Lflat_medium_pixel
  .Lflat_medium_next_row:
    ldr   r1, [sp, #.Lstack.rows]
    subs  r1, r1, #1
    beq   .Lflat_medium_end
    str   r1, [sp, #.Lstack.rows]
    ldr   r0, [sp, #.Lstack.scan]
    b     .Lflat_medium_row
  .Lflat_medium_end:
    add   sp, sp, #.Lstack.size
  )" ZSTRIP_THUMB1_PURGE_MEDIUM_EDGES ZSTRIP_THUMB1_POP);
}

#endif

}  // namespace zstrip::detail
