// The assembly behind transform.hpp: the instance's numbers come in pairs from memory, in the order of their
// use, where GCC keeps some in registers and loads the rest one by one. Offsets are those of NarrowTransform.
#include "zstrip/kernels/thumb2/transform.hpp"

#include <cstddef>

#include "zstrip/kernels/thumb/records.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

static_assert(offsetof(NarrowTransform, w) == 0 && offsetof(NarrowTransform, w_near) == 16 &&
              offsetof(NarrowTransform, w_range) == 20);
static_assert(offsetof(NarrowTransform, x) == 24 && offsetof(NarrowTransform, y) == 40);
static_assert(offsetof(NarrowTransform, shift_x) == 56 && offsetof(NarrowTransform, shift_y) == 60 &&
              offsetof(NarrowTransform, bias_x) == 64 && offsetof(NarrowTransform, bias_y) == 68);
static_assert(offsetof(NarrowTransform, depth_normalisation) == 72 && offsetof(NarrowTransform, depth_scale) == 76 &&
              offsetof(NarrowTransform, depth_shift) == 80 && offsetof(NarrowTransform, depth_offset) == 84);
static_assert(offsetof(LinearForm, x) == 0 && offsetof(LinearForm, y) == 4 && offsetof(LinearForm, z) == 8 &&
              offsetof(LinearForm, offset) == 12);

// r0 the transform, r1 the next position, r2 how many are left, r3 the next vertex. On the stack: whether all so far
// are narrow. Cortex-M4's SMLAWB would spare twelve instructions of these; one form for all serves better.
[[gnu::naked]] bool transform_vertices_thumb2(const NarrowTransform&, const Position*, std::uint32_t, SnappedVertex*) {
  asm(R"(
    movs  r12, #1
    push  {r4-r12, lr}
  1:
    ldrsh r4, [r1], #6
    ldrsh r5, [r1, #-4]
    ldrsh r6, [r1, #-2]
    lsls  r4, r4, #16
    lsls  r5, r5, #16
    lsls  r6, r6, #16
    ldm   r0, {r7-r10}
    smull r12, r7, r4, r7
    smull r12, r8, r5, r8
    smull r12, r9, r6, r9
    add   r10, r10, r7
    add   r10, r10, r8
    add   r10, r10, r9                @ w
    ldrd  r7, r8, [r0, #16]
    sub   r7, r10, r7
    cmp   r7, r8
    bhi   3f
    clz   r7, r10                     @ reciprocal(): r8, for a w that is normalised by r7
    lsl   r10, r10, r7
    lsr   r8, r10, #16
    mvn   r9, #0
    udiv  r8, r9, r8
    lsl   r8, r8, #14
    umull r12, r9, r10, r8
    rsb   r9, r9, #0x80000000
    lsl   r9, r9, #1
    umull r12, r8, r8, r9
    lsl   r8, r8, #1
    ldrd  r9, r10, [r0, #24]
    ldrd  r11, r12, [r0, #32]
    smull lr, r9, r4, r9
    smull lr, r10, r5, r10
    smull lr, r11, r6, r11
    add   r12, r12, r9
    add   r12, r12, r10
    add   r12, r12, r11
    smull lr, r12, r12, r8            @ x / w
    ldrd  r9, r10, [r0, #40]
    smull lr, r9, r4, r9
    smull lr, r10, r5, r10
    ldrd  r4, r5, [r0, #48]
    smull lr, r4, r6, r4
    add   r5, r5, r9
    add   r5, r5, r10
    adds  r5, r5, r4
    smull lr, r5, r5, r8              @ y / w
    ldrd  r9, r10, [r0, #56]
    sub   r9, r9, r7
    sub   r10, r10, r7
    asr   r12, r12, r9
    asr   r5, r5, r10
    ldrd  r9, r10, [r0, #64]
    add   r12, r12, r9
    add   r5, r5, r10
    asr   r12, r12, #1
    asrs  r5, r5, #1
    add   r9, r12, #16384
    add   r10, r5, #16384
    orr   r9, r9, r10
    lsrs  r9, r9, #15
    bne   3f
    ldrd  r9, r10, [r0, #72]
    sub   r9, r9, r7
    lsr   r8, r8, r9
    umull lr, r8, r8, r10
    ldrd  r9, r10, [r0, #80]
    lsl   r8, r8, r9
    sub   r8, r8, r10
    bfc   r8, #0, #14                 @ snap_depth
    orr   r8, r8, #0x2000
    bfi   r12, r5, #16, #16
  2:
    strd  r12, r8, [r3], #8
    subs  r2, r2, #1
    bne   1b
    pop   {r4-r12, lr}
    mov   r0, r12
    bx    lr
  3:
    mov   r12, #0x8000                @ kNotNarrow, 0; its depth 0
    movs  r8, #0
    str   r8, [sp, #32]
    b     2b
  )");
}

#endif

}  // namespace zstrip::detail
