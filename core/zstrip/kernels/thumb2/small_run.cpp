// The assembly behind thumb/small_run.hpp. Without calls between the stages of a triangle, and with both coordinates
// of a vertex in one word, it takes half of what GCC makes of the C++. Offsets are thumb/small_layout.hpp's.
#include "zstrip/kernels/thumb/small_run.hpp"

#include "zstrip/kernels/thumb/medium_triangle.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// What the assembly calls. With link time optimisation the linker takes from an archive only what C++ names; no program
// keeps these.
[[gnu::used]] static constexpr auto* kSetUp = &set_up_small_thumb;
[[gnu::used]] static constexpr auto* kScan = &scan_small_thumb;
[[gnu::used]] static constexpr auto* kMedium = &draw_medium_of_run;

// r0 the run, r10 the next triangle, r11 its vertices, lr how many triangles are left; r1 to r3 the indices of a
// triangle's vertices, then their addresses. On the stack: what was left of the count, and the count.
[[gnu::naked]] std::uint32_t draw_small_run_thumb(ThumbSmallRun&, const Triangle*, std::uint32_t) {
  asm(R"(
    @ Rows of the box at column r6 and row r9 of the strip; its width r8 and height r5.
    .macro zstrip_small_rows
      strd  r8, r5, [r0, #64]
      ldrd  r7, r4, [r0, #56]
      mla   r7, r9, r7, r6
      mla   r4, r9, r4, r6
      ldrd  r6, r9, [r0, #136]
      add   r6, r6, r7, lsl #1
      add   r9, r9, r4, lsl #1
      strd  r6, r9, [r0, #48]
    .endm
    @ Two starts at offset \at, moved by r12 columns and lr rows.
    .macro zstrip_small_move at
      ldrd  r1, r2, [r0, #\at]
      ldrd  r3, r4, [r0, #\at + 16]
      ldrd  r5, r6, [r0, #\at + 32]
      mla   r1, r3, r12, r1
      mla   r2, r4, r12, r2
      mla   r1, r5, lr, r1
      mla   r2, r6, lr, r2
      strd  r1, r2, [r0, #\at]
    .endm

    push  {r1-r11, lr}
    mov   r10, r1
    mov   lr, r2
    ldr   r11, [r0, #112]
  .Lsmall_run_next:
    subs  lr, lr, #1
    bmi   .Lsmall_run_end
    ldrh  r1, [r10], #6
    ldrh  r2, [r10, #-4]
    ldrh  r3, [r10, #-2]
    ldr   r4, [r11, r1, lsl #3]       @ y and x in one word
    ldr   r5, [r11, r2, lsl #3]
    ldr   r6, [r11, r3, lsl #3]
    sub   r9, r5, r4                  @ differences are below 2^15
    sub   r12, r6, r4
    asr   r8, r4, #16
    sxth  r9, r9
    sxth  r12, r12
    rsb   r7, r8, r5, asr #16
    rsb   r8, r8, r6, asr #16
    mul   r7, r12, r7
    mls   r7, r9, r8, r7              @ twice the area
    cmp   r7, #0
    ble   .Lsmall_run_next

    str   lr, [sp]
    str   r7, [r0, #84]
    eor   r7, r4, #0x8000             @ the order of vertices: y, then x
    eor   r8, r5, #0x8000
    eor   r9, r6, #0x8000
    cmp   r8, r7
    bge   .Lsmall_run_not_second
    cmp   r8, r9
    bge   .Lsmall_run_third
    mov   r12, r1                     @ the second becomes the first
    mov   r1, r2
    mov   r2, r3
    mov   r3, r12
    mov   r12, r4
    mov   r4, r5
    mov   r5, r6
    mov   r6, r12
    b     .Lsmall_run_rotated
  .Lsmall_run_not_second:
    cmp   r9, r7
    bge   .Lsmall_run_rotated
  .Lsmall_run_third:
    mov   r12, r3
    mov   r3, r2
    mov   r2, r1
    mov   r1, r12
    mov   r12, r6
    mov   r6, r5
    mov   r5, r4
    mov   r4, r12
  .Lsmall_run_rotated:
    ldr   r12, [r0, #116]
    ldr   r7, [r12, r1, lsl #2]
    ldr   r8, [r12, r2, lsl #2]
    ldr   r9, [r12, r3, lsl #2]
    strd  r7, r8, [r0, #72]
    str   r9, [r0, #80]
    add   r1, r11, r1, lsl #3
    add   r2, r11, r2, lsl #3
    add   r3, r11, r3, lsl #3
    ldr   r7, [r1, #4]                @ is_small: depths near the first one's
    ldr   r8, [r2, #4]
    ldr   r9, [r3, #4]
    lsrs  r7, r7, #1
    sub   r8, r7, r8, lsr #1
    sub   r9, r7, r9, lsr #1
    add   r8, r8, #0x10000000
    add   r9, r9, #0x10000000
    orr   r8, r8, r9
    lsrs  r8, r8, #29
    bne   .Lsmall_run_stop
    sxth  r7, r4
    sxth  r8, r5
    sxth  r9, r6
    asrs  r4, r4, #16                 @ top
    asrs  r5, r5, #16
    asrs  r6, r6, #16
    cmp   r5, r6
    it    lt
    movlt r5, r6                      @ bottom
    cmp   r7, r8
    ittt  gt
    movgt r12, r7
    movgt r7, r8
    movgt r8, r12
    cmp   r9, r7
    it    lt
    movlt r7, r9                      @ left
    cmp   r9, r8
    it    gt
    movgt r8, r9                      @ right
    sub   r6, r8, r7
    sub   r9, r5, r4
    add   r6, r6, r9
    cmp   r6, #181
    bge   .Lsmall_run_stop
    asrs  r7, r7, #4                  @ to pixels
    asr   r8, r8, #4
    asrs  r4, r4, #4
    asrs  r5, r5, #4
    strd  r7, r4, [r0, #88]
    ldrd  r6, r9, [r0, #120]
    ldrd  r12, lr, [r0, #128]
    subs  r6, r7, r6                  @ distances inwards from the strip's sides
    sub   r9, r4, r9
    sub   r12, r12, r8
    sub   lr, lr, r5
    sub   r8, r8, r7                  @ width
    subs  r5, r5, r4                  @ height
    orr   r7, r6, r9
    orr   r4, r12, lr
    orrs  r7, r7, r4
    bmi   .Lsmall_run_cut
    cmp   r8, #0
    it    ne
    cmpne r5, #0
    beq   .Lsmall_run_done
    zstrip_small_rows
    bl    zstrip_set_up_small_thumb
    bl    zstrip_scan_small_thumb
  .Lsmall_run_done:
    ldr   lr, [sp]
    b     .Lsmall_run_next

  .Lsmall_run_cut:
    and   r12, r12, r12, asr #31      @ what hangs out, as negative numbers
    and   lr, lr, lr, asr #31
    add   r8, r8, r12
    add   r5, r5, lr
    and   r12, r6, r6, asr #31
    and   lr, r9, r9, asr #31
    add   r8, r8, r12
    add   r5, r5, lr
    cmp   r8, #0
    it    gt
    cmpgt r5, #0
    ble   .Lsmall_run_done
    sub   r6, r6, r12
    sub   r9, r9, lr
    rsb   r12, r12, #0
    rsb   lr, lr, #0
    strd  r12, lr, [r0, #96]
    zstrip_small_rows
    bl    zstrip_set_up_small_thumb
    ldrd  r12, lr, [r0, #96]
    zstrip_small_move 0
    zstrip_small_move 8
    bl    zstrip_scan_small_thumb
    b     .Lsmall_run_done

  .Lsmall_run_stop:
    mov   r4, r0
    bl    zstrip_draw_medium_of_run
    cmp   r0, #0
    mov   r0, r4
    bne   .Lsmall_run_done
    ldr   lr, [sp]
  .Lsmall_run_end:
    ldr   r0, [sp, #4]
    sub   r0, r0, lr
    subs  r0, r0, #1
    add   sp, sp, #12
    pop   {r4-r11, pc}
    .purgem zstrip_small_rows
    .purgem zstrip_small_move
  )");
}

#endif

}  // namespace zstrip::detail
