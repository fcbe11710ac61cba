// The assembly of mve/textured_run.hpp. A register has the values of four even pixels, as words; those of the odd ones
// are a step further. Indices of texels and codes of depth are narrowed to the eight halves of a register: one
// instruction then gathers eight texels.
#include "zstrip/kernels/mve/textured_run.hpp"

#include "zstrip/kernels/thumb/run_layout.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_MVE

// q0 to q2 depth, u and v of the even pixels; q3 and q4 the shifts to columns and rows, negative, because they go to
// the right; q5 to q7 are temporary. r0 the cell; r1 the pixel; r4 and r5 the steps of depth a pixel and eight pixels;
// r6 texels; r7 and r8 the steps of u; r9 and r10 those of v; r11 the logarithm of the texture's width.
#define ZSTRIP_EIGHT_TEXELS                                                                       \
  ".macro zstrip_eight_texels\n"                                                                  \
  "  vadd.i32   q5, q1, r7\n"                                                                     \
  "  vshl.u32   q6, q1, q3\n"                                                                     \
  "  vshl.u32   q5, q5, q3\n"                                                                     \
  "  vmovnt.i32 q6, q5          @ columns\n"                                                      \
  "  vadd.i32   q5, q2, r9\n"                                                                     \
  "  vshl.u32   q7, q2, q4\n"                                                                     \
  "  vshl.u32   q5, q5, q4\n"                                                                     \
  "  vmovnt.i32 q7, q5          @ rows\n"                                                         \
  "  vshl.u16   q7, r11\n"                                                                        \
  "  vadd.i16   q6, q6, q7\n"                                                                     \
  "  vldrh.u16  q5, [r6, q6, uxtw #1]\n"                                                          \
  "  vadd.i32   q6, q0, r4\n"                                                                     \
  "  vsri.32    q6, q0, #16     @ codes\n"                                                        \
  "  vldrh.u16  q7, [r0]\n"                                                                       \
  "  vptt.u16   hi, q6, q7\n"                                                                     \
  "  vstrht.16  q6, [r0], #8 * .Lcell\n"                                                          \
  "  vstrht.16  q5, [r1], #8 * .Lcell\n"                                                          \
  "  vadd.i32   q0, q0, r5\n"                                                                     \
  "  vadd.i32   q1, q1, r8\n"                                                                     \
  "  vadd.i32   q2, q2, r10\n"                                                                    \
  ".endm\n"                                                                                       \
  "@ Sets up q0, q3, q4, r4, r5, r6 and r11 from the run r3. Changes r2, r7, r12 and q5.\n"       \
  ".macro zstrip_begin_texels\n"                                                                  \
  "  ldrd  r2, r4, [r3, #.Lrun.z]\n"                                                              \
  "  ldrd  r6, r12, [r3, #.Lrun.texels]\n"                                                        \
  "  ldrd  r7, r11, [r3, #.Lrun.to_row]\n"                                                        \
  "  rsb   r12, r12, #0\n"                                                                        \
  "  vdup.32 q3, r12\n"                                                                           \
  "  mvn   r11, r11             @ the mask's clear bits: as many as the logarithm of the width\n" \
  "  clz   r11, r11\n"                                                                            \
  "  rsb   r11, r11, #32\n"                                                                       \
  "  add   r7, r7, r11\n"                                                                         \
  "  rsb   r7, r7, #0\n"                                                                          \
  "  vdup.32 q4, r7\n"                                                                            \
  "  vdup.32 q0, r2\n"                                                                            \
  "  movs  r2, #0\n"                                                                              \
  "  vidup.u32 q5, r2, #2\n"                                                                      \
  "  vmla.s32 q0, q5, r4\n"                                                                       \
  "  lsl   r5, r4, #3\n"                                                                          \
  ".endm\n"

[[gnu::naked]] void fill_run_mve(WordRunState&, std::uint16_t*, std::uint16_t*, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_EIGHT_TEXELS R"(
    push  {r3-r11, lr}
    vpush {d8-d15}
    mov   lr, r3
    mov   r3, r0
    mov   r0, r1
    mov   r1, r2
    zstrip_begin_texels
    ldr   r12, [r3, #.Lrun.z]
    mla   r12, r4, lr, r12
    str   r12, [r3, #.Lrun.z]
    ldrd  r2, r12, [r3, #.Lrun.u]
    ldrd  r7, r9, [r3, #.Lrun.step_u]
    vdup.32 q1, r2
    vdup.32 q2, r12
    vmla.s32 q1, q5, r7
    vmla.s32 q2, q5, r9
    lsl   r8, r7, #3
    lsl   r10, r9, #3
    dlstp.16 lr, lr                   @ the last time only the pixels that are left
  .Lmve_run_texels:
    zstrip_eight_texels
    letp  lr, .Lmve_run_texels
    vpop  {d8-d15}
    pop   {r3-r11, pc}
    .purgem zstrip_eight_texels
    .purgem zstrip_begin_texels
  )");
}

// Between runs r0, r1, r4 to r6, r11, q0, q3 and q4 keep what zstrip_eight_texels says; all others are free. r3 has the
// state. u/w, v/w and 1/w are stepped first, then r12 becomes the reciprocal of 1/w, r7 and r8 the position at the
// run's end: the position at its start was the last one's end, so that each run needs one division.
[[gnu::naked]] void fill_runs_mve(TexturedRunsState&, std::uint16_t*, std::uint16_t*, std::uint32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_EIGHT_TEXELS R"(
    .set .Lstack.state, 64            @ below it d8 to d15
    .set .Lstack.runs, 68             @ left

    push  {r0, r3-r12, lr}
    vpush {d8-d15}
    mov   r3, r0
    mov   r0, r1
    mov   r1, r2
    zstrip_begin_texels
  .Lmve_runs_next:
    ldrd  r7, r8, [r3, #.Lruns.u_over_w]
    ldrd  r9, r10, [r3, #.Lruns.u_over_w_step]
    add   r7, r7, r9                  @ u/w, v/w, 1/w at the run's end
    add   r8, r8, r10
    strd  r7, r8, [r3, #.Lruns.u_over_w]
    ldr   r9, [r3, #.Lruns.one_over_w]
    ldr   r10, [r3, #.Lruns.one_over_w_step]
    adds  r9, r9, r10
    str   r9, [r3, #.Lruns.one_over_w]
    it    eq
    moveq r9, #1
    clz   r10, r9                     @ reciprocal(): r12
    lsl   r9, r9, r10
    lsr   r12, r9, #16
    mvn   lr, #0
    udiv  r12, lr, r12
    lsl   r12, r12, #14
    umull lr, r9, r9, r12
    rsb   r9, r9, #0x80000000
    lsl   r9, r9, #1
    umull lr, r12, r12, r9
    lsl   r12, r12, #1
    smull lr, r7, r7, r12
    smull lr, r8, r8, r12
    ldr   r2, [r3, #.Lruns.right_shift]
    subs  r2, r2, r10
    bmi   .Lmve_runs_left
    asr   r7, r7, r2
    asr   r8, r8, r2
  .Lmve_runs_shifted:
    ldrd  r9, r10, [r3, #.Lruns.base_u]
    add   r9, r9, r7                  @ the exact position at the end
    add   r10, r10, r8
    ldrd  r7, r8, [r3, #.Lruns.from_u] @ at the start
    strd  r9, r10, [r3, #.Lruns.from_u]
    sub   r9, r9, r7
    sub   r10, r10, r8
    asr   r9, r9, #4
    asr   r10, r10, #4
    ldrd  r2, r12, [r3, #.Lruns.to_fraction_u]
    mul   r7, r7, r2                  @ fractions of the texture
    mul   r8, r8, r12
    vdup.32 q1, r7
    vdup.32 q2, r8
    mul   r7, r9, r2
    mul   r9, r10, r12
    movs  r2, #0
    vidup.u32 q5, r2, #2
    vmla.s32 q1, q5, r7
    vmla.s32 q2, q5, r9
    lsl   r8, r7, #3
    lsl   r10, r9, #3
    zstrip_eight_texels
    zstrip_eight_texels
    ldrd  r3, r12, [sp, #.Lstack.state]
    subs  r12, r12, #1
    str   r12, [sp, #.Lstack.runs]
    bne   .Lmve_runs_next
    vmov  r12, s0                     @ the first word of q0
    str   r12, [r3, #.Lrun.z]
    vpop  {d8-d15}
    pop   {r0, r3-r12, pc}
  .Lmve_runs_left:
    rsb   r2, r2, #0
    cmp   r2, #31
    it    gt
    movgt r2, #31
    lsl   r7, r7, r2
    lsl   r8, r8, r2
    b     .Lmve_runs_shifted
    .purgem zstrip_eight_texels
    .purgem zstrip_begin_texels
  )");
}

#endif

}  // namespace zstrip::detail
