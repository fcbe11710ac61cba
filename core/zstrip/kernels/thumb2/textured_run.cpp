// The assembly of thumb/textured_run.hpp. It has 15 values for 14 registers: a shift by a register uses only the
// register's lowest byte, so that the bytes above it can count the pixels.
#include "zstrip/kernels/thumb/textured_run.hpp"

#include "zstrip/kernels/thumb/run_layout.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// A pixel: depth test, texel, steps. r0 and r1 u and v; r2 and r3 their steps; r4 depth; r5 its step; r6 texels; r7 and
// r8 shifts of u and v; r9 the mask of rows; r10 the cell; r11 the distance from its end to its pixel; r12 and lr are
// temporary. It is a text, because assembler macros outside of functions get lost if the linker changes the order of
// the files' code.
#define ZSTRIP_TEXEL                 \
  ".macro zstrip_texel\n"            \
  "  ldrh  r12, [r10], #.Lcell\n"    \
  "  cmp   r12, r4, lsr #16\n"       \
  "  bhs   .Ltexel_behind\\@\n"      \
  "  lsrs  r12, r4, #16\n"           \
  "  strh  r12, [r10, #-.Lcell]\n"   \
  "  lsr   r12, r1, r8\n"            \
  "  and   r12, r12, r9\n"           \
  "  lsr   lr, r0, r7\n"             \
  "  add   r12, r12, lr\n"           \
  "  ldrh  r12, [r6, r12, lsl #1]\n" \
  "  strh  r12, [r10, r11]\n"        \
  ".Ltexel_behind\\@:\n"             \
  "  add   r4, r4, r5\n"             \
  "  add   r0, r0, r2\n"             \
  "  add   r1, r1, r3\n"             \
  ".endm\n"

[[gnu::naked]] void fill_run_thumb(WordRunState&, std::uint16_t*, std::uint16_t*, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_TEXEL R"(
    .set .Lstack.state, 0

    push  {r0, r4-r11, lr}
    mov   r12, r0
    mov   r10, r1
    sub   r11, r2, r1
    subs  r11, r11, #.Lcell           @ from behind a cell of depth to its pixel
    sub   lr, r3, #1
    ldm   r12, {r0-r9}                @ u, v, their steps, depth, its step, texels, both shifts, mask
    add   r7, r7, lr, lsl #8
  .Lrun_texel:
    zstrip_texel
    subs  r7, r7, #256
    bhs   .Lrun_texel
    ldr   r0, [sp, #.Lstack.state]
    str   r4, [r0, #.Lrun.z]
    pop   {r0, r4-r11, pc}
    .purgem zstrip_texel
  )");
}

// Draws two pixels at a time, which share the count. Between runs r3 is the state; depth, its step, texels, shifts,
// mask and place stay in r4 to r6 and r8 to r11; r7, which also counts, is loaded again.
[[gnu::naked]] void fill_runs_thumb(TexturedRunsState&, std::uint16_t*, std::uint16_t*, std::uint32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_TEXEL R"(
    .set .Lstack.state, 0
    .set .Lstack.runs, 8              @ left; before it a gap, which keeps the stack aligned to 8 bytes

    push  {r0-r1, r3-r11, lr}
    mov   r10, r1
    sub   r11, r2, r1
    subs  r11, r11, #.Lcell           @ from behind a cell of depth to its pixel
    mov   r3, r0
    add   r12, r0, #.Lrun.z
    ldm   r12, {r4-r9}                @ depth, its step, texels, both shifts, mask
  .Lruns_next:
    add   r12, r3, #.Lruns.u_over_w
    ldm   r12!, {r0-r2}
    ldm   r12, {r7, r12, lr}          @ steps
    add   r0, r0, r7                  @ u/w, v/w, 1/w at the run's end
    add   r1, r1, r12
    strd  r0, r1, [r3, #.Lruns.u_over_w]
    adds  r2, r2, lr
    str   r2, [r3, #.Lruns.one_over_w]
    it    eq
    moveq r2, #1
    clz   r7, r2                      @ reciprocal(): r12
    lsl   r2, r2, r7
    lsr   r12, r2, #16
    mvn   lr, #0
    udiv  r12, lr, r12
    lsl   r12, r12, #14
    umull lr, r2, r2, r12
    rsb   r2, r2, #0x80000000
    lsls  r2, r2, #1
    umull lr, r12, r12, r2
    lsl   r12, r12, #1
    smull lr, r0, r0, r12
    smull lr, r1, r1, r12
    ldr   r2, [r3, #.Lruns.right_shift]
    subs  r7, r2, r7
    bmi   .Lruns_left
    asrs  r0, r0, r7
    asrs  r1, r1, r7
  .Lruns_shifted:
    ldrd  r2, r12, [r3, #.Lruns.base_u]
    add   r2, r2, r0                  @ the exact position at the end
    add   r12, r12, r1
    ldrd  r0, r1, [r3, #.Lruns.from_u] @ at the start
    strd  r2, r12, [r3, #.Lruns.from_u]
    subs  r2, r2, r0
    sub   r12, r12, r1
    ldrd  r7, lr, [r3, #.Lruns.to_fraction_u]
    asrs  r2, r2, #4
    asr   r12, r12, #4
    mul   r0, r7, r0                  @ fractions of the texture
    mul   r1, lr, r1
    mul   r2, r7, r2
    ldr   r7, [r3, #.Lrun.to_column]
    mul   r3, lr, r12
    add   r7, r7, #7 << 8             @ eight times, counted above the shift's lowest byte
  .Lruns_texel:
    zstrip_texel
    zstrip_texel
    subs  r7, r7, #256
    bhs   .Lruns_texel
    ldr   r12, [sp, #.Lstack.runs]
    ldr   r3, [sp, #.Lstack.state]
    subs  r12, r12, #1
    str   r12, [sp, #.Lstack.runs]
    bne   .Lruns_next
    str   r4, [r3, #.Lrun.z]
    pop   {r0-r1, r3-r11, pc}
  .Lruns_left:
    rsbs  r7, r7, #0
    cmp   r7, #31
    it    gt
    movgt r7, #31
    lsls  r0, r0, r7
    lsls  r1, r1, r7
    b     .Lruns_shifted
    .purgem zstrip_texel
  )");
}

// r0 the state; r1 the cell; r2 the distance from its end to its pixel; r3 the shift to a column and the count; r4 and
// r5 u and v; r6 and r7 their steps; r8 depth; r10 texels. The mask of rows, the shift to them, the light and the step
// of z stay in memory, because products need r9, r11, r12 and lr.
[[gnu::naked]] void fill_lit_run_thumb(LitWordRunState&, std::uint16_t*, std::uint16_t*, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) R"(
    push  {r4-r11, lr}
    ldr   r11, [r0, #.Lrun.to_column]
    subs  r3, r3, #1
    orr   r3, r11, r3, lsl #8         @ pixels left, counted above the shift's lowest byte
    ldm   r0, {r4-r8}                 @ u and v, their steps, z
    ldr   r10, [r0, #.Lrun.texels]
    subs  r2, r2, r1
    subs  r2, r2, #.Lcell             @ from behind a cell of depth to its pixel
  .Llit_texel:
    ldrh  r12, [r1], #.Lcell
    cmp   r12, r8, lsr #16
    bhs   .Llit_behind
    lsr   r12, r8, #16
    strh  r12, [r1, #-.Lcell]
    ldrd  r11, r12, [r0, #.Lrun.to_row]
    lsr   r11, r5, r11
    and   r11, r11, r12
    lsr   r12, r4, r3
    add   r11, r11, r12
    ldrh  lr, [r10, r11, lsl #1]
    ldrd  r11, r12, [r0, #.Llit.r]    @ red and green
    lsr   r9, lr, #11
    mul   r11, r9, r11
    ubfx  r9, lr, #5, #6
    mul   r12, r9, r12
    ldr   r9, [r0, #.Llit.b]
    and   lr, lr, #31
    mul   lr, r9, lr
    add   r12, r12, #128
    add   lr, lr, r11, lsl #16        @ products of 13 bits
    add   lr, lr, #0x00800080
    lsr   r12, r12, #8
    lsr   r11, lr, #24
    ubfx  lr, lr, #8, #5
    orr   r12, r12, r11, lsl #6
    orr   r12, lr, r12, lsl #5
    strh  r12, [r1, r2]
  .Llit_behind:
    ldr   r9, [r0, #.Lrun.step_z]
    add   r4, r4, r6
    add   r5, r5, r7
    add   r8, r8, r9
    subs  r3, r3, #256
    bhs   .Llit_texel
    str   r8, [r0, #.Lrun.z]
    pop   {r4-r11, pc}
  )");
}

#endif

}  // namespace zstrip::detail
