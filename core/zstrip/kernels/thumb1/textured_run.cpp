// The assembly of thumb/textured_run.hpp for Thumb-1 (Cortex-M0, M0+). Only eight registers can shift, multiply and
// address, so that values that are only added or copied are in the upper ones.
#include "zstrip/kernels/thumb/textured_run.hpp"

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/thumb/run_layout.hpp"
#include "zstrip/kernels/thumb1/interpolator.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

#if ZSTRIP_HAS_INTERPOLATORS

// A pixel: depth test, texel, steps. r1 and r4 are temporary; r2 depth; r3 and r6 the addresses of `cell` and `to`; r5
// the step of depth; r7 the interpolator: reading it gives the address of a texel, and steps u and v.
#define ZSTRIP_TEXEL                      \
  ".macro zstrip_texel cell:req to:req\n" \
  "  ldr   r1, [r7, #.Linterp.pop]\n"     \
  "  ldrh  r0, [r3, \\cell]\n"            \
  "  lsrs  r4, r2, #16\n"                 \
  "  cmp   r0, r4\n"                      \
  "  bhs   .Ltexel_behind\\@\n"           \
  "  strh  r4, [r3, \\cell]\n"            \
  "  ldrh  r1, [r1]\n"                    \
  "  strh  r1, [r6, \\to]\n"              \
  ".Ltexel_behind\\@:\n"                  \
  "  adds  r2, r2, r5\n"                  \
  ".endm\n" ZSTRIP_INTERPOLATOR

// lr is the end of the cells.
[[gnu::naked]] void fill_run_thumb(WordRunState&, std::uint16_t*, std::uint16_t*, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_THUMB1_PUSH ZSTRIP_TEXEL R"(
    lsls  r3, r3, #1                  @ cells of 2 bytes
    adds  r3, r3, r1
    mov   lr, r3                      @ behind the last cell
    push  {r0}
    mov   r12, r1
    mov   r8, r2
    zstrip_interpolated_texture
    ldm   r0!, {r1, r2, r3, r4}       @ u, v, their steps
    stm   r7!, {r1, r2, r3, r4}
    subs  r7, r7, #.Linterp.base2 - .Linterp.accum0
    ldm   r0!, {r2, r5}               @ depth and its step
    mov   r3, r12
    mov   r6, r8
  .Lrun_texel:
    zstrip_texel #0*.Lcell, #0*.Lcell
    adds  r3, r3, #.Lcell
    adds  r6, r6, #.Lcell
    cmp   r3, lr
    bne   .Lrun_texel
    pop   {r0}
    str   r2, [r0, #.Lrun.z]
    .purgem zstrip_texel
    .purgem zstrip_interpolator
    .purgem zstrip_interpolated_texture
  )" ZSTRIP_THUMB1_POP);
}

#else

// A pixel: depth test, texel, steps. `cell` and `to` are the addresses of its depth and its colour. r2 depth; r4
// texels; r5 and r6 shifts of u and v; r7 mask; r8 u and r9 its step; r10 v and r11 its step; r12 the step of depth. lr
// is copied to r1 before the colour is stored.
#define ZSTRIP_TEXEL                      \
  ".macro zstrip_texel cell:req to:req\n" \
  "  ldrh  r0, [r3, \\cell]\n"            \
  "  lsrs  r1, r2, #16\n"                 \
  "  cmp   r0, r1\n"                      \
  "  bhs   .Ltexel_behind\\@\n"           \
  "  strh  r1, [r3, \\cell]\n"            \
  "  mov   r0, r10\n"                     \
  "  lsrs  r0, r0, r6\n"                  \
  "  ands  r0, r0, r7\n"                  \
  "  mov   r1, r8\n"                      \
  "  lsrs  r1, r1, r5\n"                  \
  "  adds  r0, r0, r1\n"                  \
  "  lsls  r0, r0, #1\n"                  \
  "  ldrh  r0, [r4, r0]\n"                \
  "  mov   r1, lr\n"                      \
  "  strh  r0, [r1, \\to]\n"              \
  ".Ltexel_behind\\@:\n"                  \
  "  add   r2, r2, r12\n"                 \
  "  add   r8, r8, r9\n"                  \
  "  add   r10, r10, r11\n"               \
  ".endm\n"

// r3 the cell; lr the distance from a cell to its pixel, so that one register serves both.
[[gnu::naked]] void fill_run_thumb(WordRunState&, std::uint16_t*, std::uint16_t*, std::int32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN) ZSTRIP_THUMB1_PUSH ZSTRIP_TEXEL R"(
    .set .Lstack.state, 0
    .set .Lstack.end, 4               @ behind the last cell

    lsls  r3, r3, #1                  @ cells of 2 bytes
    adds  r3, r3, r1
    push  {r0, r3}
    movs  r3, r1
    subs  r2, r2, r1
    mov   lr, r2                      @ from a cell of depth to its pixel
    ldm   r0!, {r4-r7}                @ u, v, their steps
    mov   r8, r4
    mov   r10, r5
    mov   r9, r6
    mov   r11, r7
    ldm   r0!, {r2, r4}               @ depth and its step
    mov   r12, r4
    ldm   r0!, {r4-r7}                @ texels, both shifts, mask
  .Lrun_texel:
    zstrip_texel #0*.Lcell, r3
    ldr   r0, [sp, #.Lstack.end]
    adds  r3, r3, #.Lcell
    cmp   r3, r0
    bne   .Lrun_texel
    pop   {r0, r3}
    str   r2, [r0, #.Lrun.z]
    .purgem zstrip_texel
  )" ZSTRIP_THUMB1_POP);
}

#endif

// The parts of whole runs that depend on the interpolator: before the first run, with the state in r0; before each run,
// with u in r2, its step in r1, v in r3, its step in r0, and the address of the state's u_over_w_step in r7; after
// eight pixels; and at the end of the text.
#if ZSTRIP_HAS_INTERPOLATORS
#define ZSTRIP_BEGIN_RUNS "  zstrip_interpolated_texture\n"
#define ZSTRIP_BEGIN_RUN                                \
  "  movs  r4, r1\n"                                    \
  "  movs  r5, r0\n"                                    \
  "  zstrip_interpolator\n"                             \
  "  stm   r7!, {r2, r3, r4, r5}\n"                     \
  "  subs  r7, r7, #.Linterp.base2 - .Linterp.accum0\n" \
  "  mov   r5, r12\n"                                   \
  "  mov   r6, lr\n"
#define ZSTRIP_NEXT_EIGHT         \
  "  adds  r6, r6, #8 * .Lcell\n" \
  "  mov   lr, r6\n"
#define ZSTRIP_END_RUNS ".purgem zstrip_interpolator\n.purgem zstrip_interpolated_texture\n"
#else
#define ZSTRIP_BEGIN_RUNS ""
#define ZSTRIP_BEGIN_RUN                                   \
  "  mov   r8, r2\n"                                       \
  "  mov   r9, r1\n"                                       \
  "  mov   r10, r3\n"                                      \
  "  mov   r11, r0\n"                                      \
  "  subs  r7, r7, #.Lruns.u_over_w_step - .Lrun.texels\n" \
  "  ldm   r7, {r4-r7}             @ texels, both shifts, mask\n"
#define ZSTRIP_NEXT_EIGHT         \
  "  mov   r1, lr\n"              \
  "  adds  r1, r1, #8 * .Lcell\n" \
  "  mov   lr, r1\n"
#define ZSTRIP_END_RUNS ""
#endif

// A run is two passes over eight pixels. A pixel's values have the registers of zstrip_texel; lr is the pixel. Between
// runs r7 walks through the state: u/w, v/w and 1/w at the run's end; their quotients, in r8 and r10; then u and v,
// whose distance from the run's start gives both steps. Depth and its cell wait on the stack, because the division uses
// r0 to r6.
[[gnu::naked]] static void fill_runs(TexturedRunsState&, std::uint16_t*, std::uint16_t*, std::uint32_t,
                                     const std::uint16_t*) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_TEXEL_RUN)
          ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL ZSTRIP_TEXEL R"(
    @ On the stack:
    .set .Lstack.state, 0
    .set .Lstack.runs, 4              @ left
    .set .Lstack.normalisation, 8     @ of the last 1/w; the next one's is rarely another
    .set .Lstack.z, 12
    .set .Lstack.cell, 16             @ of z
    .set .Lstack.end, 20              @ behind the run's last cell
    .set .Lstack.reciprocals, 24      @ the table for an index that begins at 256
    .set .Lstack.size, 28

    sub   sp, sp, #.Lstack.size
    mov   lr, r2
    str   r0, [sp, #.Lstack.state]
    str   r3, [sp, #.Lstack.runs]
    )" ZSTRIP_BEGIN_RUNS R"(
    movs  r2, #0
    str   r2, [sp, #.Lstack.normalisation]
    ldr   r2, [r0, #.Lrun.z]
    ldr   r3, [r0, #.Lrun.step_z]
    str   r2, [sp, #.Lstack.z]
    mov   r12, r3
    str   r1, [sp, #.Lstack.cell]
    ldr   r2, [sp, #.Lstack.size + .Lsaved]
    movs  r3, #2
    lsls  r3, r3, #8
    subs  r2, r2, r3
    str   r2, [sp, #.Lstack.reciprocals]
  .Lruns_next:
    ldr   r7, [sp, #.Lstack.state]
    adds  r7, r7, #.Lruns.u_over_w
    ldm   r7!, {r0-r2}
    ldm   r7!, {r3-r5}                @ steps
    subs  r7, r7, #.Lruns.base_u - .Lruns.u_over_w
    adds  r0, r0, r3                  @ u/w, v/w, 1/w at the run's end
    adds  r1, r1, r4
    adds  r2, r2, r5
    stm   r7!, {r0-r2}                @ r7: at u_over_w_step
    mov   r8, r0
    mov   r10, r1
    bne   .Lruns_divisor
    movs  r2, #1
  .Lruns_divisor:
    ldr   r6, [sp, #.Lstack.normalisation]
    ldr   r5, [sp, #.Lstack.reciprocals]
    zstrip_reciprocal
    str   r6, [sp, #.Lstack.normalisation]
    uxth  r4, r3
    lsrs  r5, r3, #16
    mov   r0, r8
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    mov   r8, r0
    mov   r0, r10
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    mov   r1, r8
    ldr   r2, [r7, #.Lruns.right_shift - .Lruns.u_over_w_step]
    subs  r2, r2, r6
    bpl   .Lruns_right
    rsbs  r2, r2, #0
    cmp   r2, #31
    ble   .Lruns_left
    movs  r2, #31
  .Lruns_left:
    lsls  r1, r1, r2
    lsls  r0, r0, r2
    b     .Lruns_shifted
  .Lruns_right:
    asrs  r1, r1, r2
    asrs  r0, r0, r2
  .Lruns_shifted:
    ldr   r2, [r7, #.Lruns.base_u - .Lruns.u_over_w_step] @ the exact position at the end
    ldr   r3, [r7, #.Lruns.base_v - .Lruns.u_over_w_step]
    adds  r1, r1, r2
    adds  r0, r0, r3
    ldr   r2, [r7, #.Lruns.from_u - .Lruns.u_over_w_step] @ at the start
    ldr   r3, [r7, #.Lruns.from_v - .Lruns.u_over_w_step]
    str   r1, [r7, #.Lruns.from_u - .Lruns.u_over_w_step]
    str   r0, [r7, #.Lruns.from_v - .Lruns.u_over_w_step]
    subs  r1, r1, r2
    subs  r0, r0, r3
    asrs  r1, r1, #4                  @ a sixteenth of the run, a pixel
    asrs  r0, r0, #4
    ldr   r4, [r7, #.Lruns.to_fraction_u - .Lruns.u_over_w_step] @ fractions of the texture
    ldr   r5, [r7, #.Lruns.to_fraction_v - .Lruns.u_over_w_step]
    muls  r2, r2, r4
    muls  r1, r1, r4
    muls  r3, r3, r5
    muls  r0, r0, r5
    )" ZSTRIP_BEGIN_RUN R"(
    ldr   r2, [sp, #.Lstack.z]
    ldr   r3, [sp, #.Lstack.cell]
    movs  r0, r3
    adds  r0, r0, #16 * .Lcell
    str   r0, [sp, #.Lstack.end]
  .Lruns_texels:
    zstrip_texel #0*.Lcell, #0*.Lcell
    zstrip_texel #1*.Lcell, #1*.Lcell
    zstrip_texel #2*.Lcell, #2*.Lcell
    zstrip_texel #3*.Lcell, #3*.Lcell
    zstrip_texel #4*.Lcell, #4*.Lcell
    zstrip_texel #5*.Lcell, #5*.Lcell
    zstrip_texel #6*.Lcell, #6*.Lcell
    zstrip_texel #7*.Lcell, #7*.Lcell
    )" ZSTRIP_NEXT_EIGHT R"(
    ldr   r0, [sp, #.Lstack.end]
    adds  r3, r3, #8 * .Lcell
    cmp   r3, r0
    beq   .Lruns_end
    b     .Lruns_texels
  .Lruns_end:
    str   r2, [sp, #.Lstack.z]
    str   r3, [sp, #.Lstack.cell]
    ldr   r0, [sp, #.Lstack.runs]
    subs  r0, r0, #1
    str   r0, [sp, #.Lstack.runs]
    beq   .Lruns_done
    b     .Lruns_next
  .Lruns_done:
    ldr   r0, [sp, #.Lstack.state]
    str   r2, [r0, #.Lrun.z]
    add   sp, sp, #.Lstack.size
    .purgem zstrip_texel
  )" ZSTRIP_END_RUNS ZSTRIP_THUMB1_PURGE_RECIPROCAL ZSTRIP_THUMB1_POP);
}

void fill_runs_thumb(TexturedRunsState& state, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count) {
  fill_runs(state, depth, pixel, count, kReciprocalTable.data());
}

#endif

}  // namespace zstrip::detail
