// The assembly behind thumb/small_triangle.hpp. GCC has a dozen registers for twice as many values and moves a third
// of them to the stack and back; by hand all fit. Offsets are thumb/small_layout.hpp's.
#include "zstrip/kernels/thumb/small_triangle.hpp"

#include "zstrip/kernels/small_scan.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// Used: small_run.cpp calls it by its name.
[[gnu::naked, gnu::used]] void set_up_small_thumb(SmallScan&, const SnappedVertex&, const SnappedVertex&,
                                                  const SnappedVertex&) {
  asm(R"(
    @ A channel's plane: start r1, steps r2 and r3, from the channel at offset \at of the scan. Needs the inverse area
    @ in r4 and the weights of vertices 1 and 2, scaled: at the anchor r7 and r8, right r12 and r10, down r11 and r9.
    .macro zstrip_small_channel at
      ldrb  lr, [r0, #\at]
      ldrb  r5, [r0, #\at + 4]
      ldrb  r6, [r0, #\at + 8]
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
    ldrd  r5, r6, [r0, #88]           @ anchor
    ldr   r4, [r0, #84]               @ area
    ldrsh r7, [r1]
    ldrsh r8, [r1, #2]
    ldrsh r9, [r2]
    ldrsh r10, [r2, #2]
    ldrsh r11, [r3]
    ldrsh r12, [r3, #2]
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
    str   r5, [r0, #16]
    lsls  r6, r6, #22
    add   r6, r6, r11, lsl #11
    add   r6, r6, r9
    str   r6, [r0, #32]
    add   r5, r11, r12, lsl #16       @ fields of the edges of weights 1 and 2
    add   r5, r7, r5, asr #31
    asrs  r5, r5, #4
    add   lr, lr, r5, lsl #11
    add   r5, r9, r10, lsl #16
    add   r5, r8, r5, asr #31
    add   lr, lr, r5, asr #4
    str   lr, [r0]

    ldr   r1, [r1, #4]
    ldr   r2, [r2, #4]
    ldr   r3, [r3, #4]
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
    str   r1, [r0, #4]
    mul   r5, r2, r12
    mla   r5, r3, r10, r5
    lsls  r5, r5, #4
    str   r5, [r0, #20]
    mul   r6, r2, r11
    mla   r6, r3, r9, r6
    lsls  r6, r6, #4
    str   r6, [r0, #36]

    lsls  r7, r7, #9
    lsl   r8, r8, #9
    lsl   r12, r12, #13
    lsl   r10, r10, #13
    lsl   r11, r11, #13
    lsl   r9, r9, #13
    zstrip_small_channel 73
    str   r1, [r0, #8]
    str   r2, [r0, #24]
    str   r3, [r0, #40]
    zstrip_small_channel 72
    push  {r1, r2, r3}
    zstrip_small_channel 74
    pop   {r5, r6, lr}
    add   r1, r1, r5, lsl #16
    add   r2, r2, r6, lsl #16
    add   r3, r3, lr, lsl #16
    str   r1, [r0, #12]
    str   r2, [r0, #28]
    str   r3, [r0, #44]
    pop   {r4-r11, pc}
    .purgem zstrip_small_channel
  )");
}

// Used: small_run.cpp calls it by its name.
[[gnu::naked, gnu::used]] void scan_small_thumb(SmallScan&) {
  asm(R"(
    push  {r0, r4-r11, lr}
    movw  lr, #0x0400                 @ the signs of the packed edges
    movt  lr, #0x8020
  .Lsmall_row:
    ldm   r0, {r1-r12}                @ this row's starts, steps to the right, steps down
    add   r9, r9, r1
    add   r10, r10, r2
    add   r11, r11, r3
    add   r12, r12, r4
    stm   r0, {r9-r12}                @ the next row's starts
    ldrd  r9, r10, [r0, #48]
    ldrd  r11, r12, [r0, #56]
    add   r11, r9, r11, lsl #1
    add   r12, r10, r12, lsl #1
    strd  r11, r12, [r0, #48]
    ldr   r12, [r0, #64]
    mov   r11, r12                    @ columns left
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
    subs  r10, r10, #2                @ from behind a cell of depth to its pixel
    add   r9, r9, r12, lsl #1
  .Lsmall_pixel:
    ldrh  r12, [r9], #2
    cmp   r12, r2, lsr #16
    bhs   .Lsmall_hidden
    lsrs  r12, r2, #16
    strh  r12, [r9, #-2]
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
    ldr   r0, [sp]
  .Lsmall_next_row:
    ldr   r12, [r0, #68]
    subs  r12, r12, #1
    str   r12, [r0, #68]
    bne   .Lsmall_row
    pop   {r0, r4-r11, pc}
  )");
}

[[gnu::naked]] void scan_small_flat_thumb(SmallScan&) {
  asm(R"(
    push  {r4-r11, lr}
    movw  lr, #0x0400                 @ the signs of the packed edges
    movt  lr, #0x8020
    ldrd  r3, r4, [r0, #16]           @ steps to the right: edges and depth
    ldrd  r5, r6, [r0, #48]
    ldrh  r7, [r0, #104]
  .Lflat_row:
    ldrd  r1, r2, [r0]                @ this row's starts
    ldrd  r9, r10, [r0, #32]
    add   r9, r9, r1
    add   r10, r10, r2
    strd  r9, r10, [r0]               @ the next row's starts
    ldr   r11, [r0, #64]
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
    subs  r10, r10, #2                @ from behind a cell of depth to its pixel
  .Lflat_pixel:
    ldrh  r9, [r12], #2
    cmp   r9, r2, lsr #16
    bhs   .Lflat_hidden
    lsr   r9, r2, #16
    strh  r9, [r12, #-2]
    strh  r7, [r12, r10]
  .Lflat_hidden:
    add   r1, r1, r3
    add   r2, r2, r4
    subs  r8, r8, #1
    beq   .Lflat_next_row
    tst   r1, lr
    beq   .Lflat_pixel
  .Lflat_next_row:
    ldrd  r9, r10, [r0, #56]
    ldr   r11, [r0, #68]
    add   r5, r5, r9, lsl #1
    add   r6, r6, r10, lsl #1
    subs  r11, r11, #1
    str   r11, [r0, #68]
    bne   .Lflat_row
    pop   {r4-r11, pc}
  )");
}

#endif

}  // namespace zstrip::detail
