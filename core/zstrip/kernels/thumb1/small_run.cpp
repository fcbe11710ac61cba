// The assembly behind thumb/small_run.hpp for Thumb-1 (Cortex-M0, M0+). Offsets are
// thumb/small_layout.hpp's.
#include "zstrip/kernels/thumb/small_run.hpp"

#include "zstrip/kernels/thumb/medium_triangle.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// What the assembly calls. With link time optimisation the linker takes from an archive only what C++ names; no program
// keeps these.
[[gnu::used]] static constexpr auto* kSetUp = &set_up_small_thumb;
[[gnu::used]] static constexpr auto* kScan = &scan_small_thumb;
[[gnu::used]] static constexpr auto* kMedium = &draw_medium_of_run;

// r8 the vertices, r9 the next triangle, r10 how many are left, r11 the run. On the stack: the count.
[[gnu::naked]] std::uint32_t draw_small_run_thumb(ThumbSmallRun&, const Triangle*, std::uint32_t) {
  asm(ZSTRIP_THUMB1_PUSH R"(
    @ The colour of the vertex of index \index into the scan, \at behind r0; that of vertex 0 is at r7. Uses r4 and r5.
    .macro zstrip_small_colour index at
      lsls  r4, \index, #2
      adds  r4, r4, r7
      ldrb  r5, [r4]
      strb  r5, [r0, #\at]
      ldrb  r5, [r4, #1]
      strb  r5, [r0, #\at + 1]
      ldrb  r5, [r4, #2]
      strb  r5, [r0, #\at + 2]
    .endm
    @ The same of colours that are words. Uses r4.
    .macro zstrip_small_colour_word index at
      lsls  r4, \index, #2
      ldr   r4, [r7, r4]
      str   r4, [r0, #\at]
    .endm
    @ The start of the value at offset \at of the scan in r0, moved by r5 columns and r6 rows. Uses r1 and r2.
    .macro zstrip_small_move at
      ldr   r1, [r0, #\at]
      ldr   r2, [r0, #\at + 16]
      muls  r2, r2, r5
      adds  r1, r1, r2
      ldr   r2, [r0, #\at + 32]
      muls  r2, r2, r6
      adds  r1, r1, r2
      str   r1, [r0, #\at]
    .endm

    push  {r2}
    mov   r11, r0
    mov   r9, r1
    mov   r10, r2
    adds  r0, r0, #112
    ldr   r0, [r0]
    mov   r8, r0
  .Lsmall_run_next:
    mov   r0, r10
    subs  r0, r0, #1
    bpl   .Lsmall_run_triangle
    pop   {r0}
    b     .Lsmall_run_end
  .Lsmall_run_triangle:
    mov   r10, r0
    mov   r7, r9
    ldrh  r1, [r7]
    ldrh  r2, [r7, #2]
    ldrh  r3, [r7, #4]
    adds  r7, r7, #6
    mov   r9, r7
    mov   r7, r8
    lsls  r1, r1, #3
    lsls  r2, r2, #3
    lsls  r3, r3, #3
    ldr   r4, [r7, r1]                @ y and x in one word
    ldr   r5, [r7, r2]
    ldr   r6, [r7, r3]
    asrs  r1, r4, #16
    asrs  r2, r5, #16
    subs  r2, r2, r1
    asrs  r3, r6, #16
    subs  r3, r3, r1
    subs  r0, r6, r4                  @ differences are below 2^15
    sxth  r0, r0
    muls  r0, r0, r2
    subs  r1, r5, r4
    sxth  r1, r1
    muls  r1, r1, r3
    subs  r0, r0, r1                  @ twice the area
    ble   .Lsmall_run_next

    mov   r7, r11
    str   r0, [r7, #84]
    mov   r0, r9
    subs  r0, r0, #6
    ldrh  r1, [r0]
    ldrh  r2, [r0, #2]
    ldrh  r3, [r0, #4]
    movs  r7, #1                      @ the order of vertices: y, then x
    lsls  r7, r7, #15
    eors  r4, r4, r7
    eors  r5, r5, r7
    eors  r6, r6, r7
    cmp   r5, r4
    bge   .Lsmall_run_not_second
    cmp   r5, r6
    bge   .Lsmall_run_third
    movs  r0, r1                      @ the second becomes the first
    movs  r1, r2
    movs  r2, r3
    movs  r3, r0
    b     .Lsmall_run_rotated
  .Lsmall_run_not_second:
    cmp   r6, r4
    bge   .Lsmall_run_rotated
  .Lsmall_run_third:
    movs  r0, r3
    movs  r3, r2
    movs  r2, r1
    movs  r1, r0
  .Lsmall_run_rotated:
    mov   r0, r11
    adds  r0, r0, #72
    ldr   r7, [r0, #44]
    lsls  r4, r7, #30
    beq   .Lsmall_run_words
    b     .Lsmall_run_colours
  .Lsmall_run_words:
    zstrip_small_colour_word r1, 0
    zstrip_small_colour_word r2, 4
    zstrip_small_colour_word r3, 8
  .Lsmall_run_coloured:
    lsls  r1, r1, #3
    lsls  r2, r2, #3
    lsls  r3, r3, #3
    add   r1, r1, r8
    add   r2, r2, r8
    add   r3, r3, r8
    ldr   r4, [r1, #4]                @ is_small: depths near the first one's
    ldr   r5, [r2, #4]
    ldr   r6, [r3, #4]
    lsrs  r4, r4, #1
    lsrs  r5, r5, #1
    subs  r5, r4, r5
    lsrs  r6, r6, #1
    subs  r6, r4, r6
    movs  r7, #1
    lsls  r7, r7, #28
    adds  r5, r5, r7
    adds  r6, r6, r7
    orrs  r5, r5, r6
    lsrs  r5, r5, #29
    beq   .Lsmall_run_near
    b     .Lsmall_run_stop
  .Lsmall_run_near:
    push  {r1-r3}
    ldr   r4, [r1]
    ldr   r5, [r2]
    ldr   r6, [r3]
    sxth  r0, r4
    asrs  r4, r4, #16                 @ top
    sxth  r7, r5
    asrs  r5, r5, #16
    asrs  r1, r6, #16
    sxth  r6, r6
    cmp   r5, r1
    bge   .Lsmall_run_bottom
    movs  r5, r1                      @ bottom
  .Lsmall_run_bottom:
    cmp   r0, r7
    ble   .Lsmall_run_in_order
    movs  r1, r0
    movs  r0, r7
    movs  r7, r1
  .Lsmall_run_in_order:
    cmp   r6, r0
    bge   .Lsmall_run_left
    movs  r0, r6                      @ left
  .Lsmall_run_left:
    cmp   r6, r7
    ble   .Lsmall_run_right
    movs  r7, r6                      @ right
  .Lsmall_run_right:
    subs  r1, r7, r0
    subs  r2, r5, r4
    adds  r1, r1, r2
    cmp   r1, #181
    blt   .Lsmall_run_small
    pop   {r1-r3}
    b     .Lsmall_run_stop
  .Lsmall_run_small:
    asrs  r0, r0, #4                  @ to pixels
    asrs  r7, r7, #4
    asrs  r4, r4, #4
    asrs  r5, r5, #4
    mov   r6, r11
    adds  r6, r6, #88
    str   r0, [r6]
    str   r4, [r6, #4]
    ldr   r1, [r6, #32]               @ distances inwards from the strip's sides
    subs  r1, r0, r1
    ldr   r2, [r6, #36]
    subs  r2, r4, r2
    ldr   r3, [r6, #40]
    subs  r3, r3, r7
    subs  r7, r7, r0                  @ width
    ldr   r0, [r6, #44]
    subs  r0, r0, r5
    subs  r5, r5, r4                  @ height
    movs  r4, r1
    orrs  r4, r4, r2
    orrs  r4, r4, r3
    orrs  r4, r4, r0
    bmi   .Lsmall_run_cut
    movs  r0, #0
    cmp   r7, #0
    beq   .Lsmall_run_empty
    cmp   r5, #0
    bne   .Lsmall_run_rows
  .Lsmall_run_empty:
    add   sp, sp, #12
    b     .Lsmall_run_next
  .Lsmall_run_cut:
    asrs  r4, r3, #31                 @ what hangs out, as negative numbers
    ands  r3, r3, r4
    adds  r7, r7, r3
    asrs  r4, r0, #31
    ands  r0, r0, r4
    adds  r5, r5, r0
    asrs  r4, r1, #31
    ands  r4, r4, r1
    adds  r7, r7, r4
    asrs  r3, r2, #31
    ands  r3, r3, r2
    adds  r5, r5, r3
    cmp   r7, #0
    ble   .Lsmall_run_empty
    cmp   r5, #0
    ble   .Lsmall_run_empty
    subs  r1, r1, r4
    subs  r2, r2, r3
    rsbs  r4, r4, #0
    rsbs  r3, r3, #0
    str   r4, [r6, #8]
    str   r3, [r6, #12]
    movs  r0, #1
  .Lsmall_run_rows:
    subs  r6, r6, #40                 @ column r1 and row r2 of the strip
    str   r7, [r6, #16]
    str   r5, [r6, #20]
    movs  r7, r0                      @ whether the box is cut
    ldr   r3, [r6, #8]
    muls  r3, r3, r2
    adds  r3, r3, r1
    lsls  r3, r3, #1
    ldr   r4, [r6, #88]
    adds  r3, r3, r4
    str   r3, [r6]
    ldr   r3, [r6, #12]
    muls  r3, r3, r2
    adds  r3, r3, r1
    lsls  r3, r3, #1
    ldr   r4, [r6, #92]
    adds  r3, r3, r4
    str   r3, [r6, #4]
    pop   {r1-r3}
    mov   r0, r11
    bl    zstrip_set_up_small_thumb
    mov   r0, r11
    cmp   r7, #0
    beq   .Lsmall_run_scan
    movs  r4, r0
    adds  r4, r4, #96
    ldm   r4!, {r5, r6}
    zstrip_small_move 0
    zstrip_small_move 4
    zstrip_small_move 8
    zstrip_small_move 12
  .Lsmall_run_scan:
    bl    zstrip_scan_small_thumb
    b     .Lsmall_run_next
  .Lsmall_run_stop:
    mov   r0, r11
    bl    zstrip_draw_medium_of_run
    cmp   r0, #0
    beq   .Lsmall_run_leave
    b     .Lsmall_run_next
  .Lsmall_run_leave:
    pop   {r0}
    mov   r1, r10
    subs  r0, r0, r1
    subs  r0, r0, #1
    b     .Lsmall_run_end
  .Lsmall_run_colours:
    zstrip_small_colour r1, 0
    zstrip_small_colour r2, 4
    zstrip_small_colour r3, 8
    b     .Lsmall_run_coloured
  .Lsmall_run_end:
    .purgem zstrip_small_colour
    .purgem zstrip_small_colour_word
    .purgem zstrip_small_move
  )" ZSTRIP_THUMB1_POP);
}

#endif

}  // namespace zstrip::detail
