// The assembly of thumb2/transform.hpp. The instance's numbers are loaded in pairs, in the order of their use; GCC
// keeps some in registers and loads the others one by one. Offsets are those of NarrowTransform.
#include "zstrip/kernels/thumb2/transform.hpp"

#include <cstddef>

#include "zstrip/kernels/thumb/records.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// clang-format off
#define ZSTRIP_NARROW_TRANSFORM(field, number)                        \
  field(transform, NarrowTransform, w, 0)                             \
  field(transform, NarrowTransform, w_near, 16)                       \
  field(transform, NarrowTransform, w_range, 20)                      \
  number(transform.x_x, offsetof(NarrowTransform, x.x), 24)           \
  number(transform.x_y, offsetof(NarrowTransform, x.y), 28)           \
  number(transform.x_z, offsetof(NarrowTransform, x.z), 32)           \
  number(transform.x_offset, offsetof(NarrowTransform, x.offset), 36) \
  number(transform.y_x, offsetof(NarrowTransform, y.x), 40)           \
  number(transform.y_y, offsetof(NarrowTransform, y.y), 44)           \
  number(transform.y_z, offsetof(NarrowTransform, y.z), 48)           \
  number(transform.y_offset, offsetof(NarrowTransform, y.offset), 52) \
  field(transform, NarrowTransform, shift_x, 56)                      \
  field(transform, NarrowTransform, shift_y, 60)                      \
  field(transform, NarrowTransform, bias_x, 64)                       \
  field(transform, NarrowTransform, bias_y, 68)                       \
  field(transform, NarrowTransform, depth_normalisation, 72)          \
  field(transform, NarrowTransform, depth_scale, 76)                  \
  field(transform, NarrowTransform, depth_shift, 80)                  \
  field(transform, NarrowTransform, depth_offset, 84)
// clang-format on
ZSTRIP_CHECK_LAYOUT(ZSTRIP_NARROW_TRANSFORM)

// r0 the transform; r1 the next position; r2 the remaining ones; r3 the next vertex; r4, r5 and r6 the position in the
// upper halves, so that smull leaves the upper word of each product. w comes first, because the other forms are divided
// by it. SMLAWB of the Cortex-M4 would save twelve instructions, but this code serves all processors.
[[gnu::naked]] bool transform_vertices_thumb2(const NarrowTransform&, const Position*, std::uint32_t, SnappedVertex*) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_NARROW_TRANSFORM) R"(
    .set .Lstack.narrow, 32           @ where r12 is saved: 1 while all vertices are narrow

    movs  r12, #1
    push  {r4-r12, lr}
  1:
    ldrsh r4, [r1], #.Lposition.size
    ldrsh r5, [r1, #.Lposition.y - .Lposition.size]
    ldrsh r6, [r1, #.Lposition.z - .Lposition.size]
    lsls  r4, r4, #16
    lsls  r5, r5, #16
    lsls  r6, r6, #16
    ldm   r0, {r7-r10}                @ .Ltransform.w, first
    smull r12, r7, r4, r7
    smull r12, r8, r5, r8
    smull r12, r9, r6, r9
    add   r10, r10, r7
    add   r10, r10, r8
    add   r10, r10, r9                @ w
    ldrd  r7, r8, [r0, #.Ltransform.w_near]
    sub   r7, r10, r7                 @ w outside w_near and its range is not narrow
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
    @ From here on r7 is the normalisation, r8 is 1 / w; x becomes r12, y r5. Coordinates are free once y has them.
    ldrd  r9, r10, [r0, #.Ltransform.x_x]
    ldrd  r11, r12, [r0, #.Ltransform.x_z]
    smull lr, r9, r4, r9
    smull lr, r10, r5, r10
    smull lr, r11, r6, r11
    add   r12, r12, r9
    add   r12, r12, r10
    add   r12, r12, r11
    smull lr, r12, r12, r8            @ x / w
    ldrd  r9, r10, [r0, #.Ltransform.y_x]
    smull lr, r9, r4, r9
    smull lr, r10, r5, r10
    ldrd  r4, r5, [r0, #.Ltransform.y_z]
    smull lr, r4, r6, r4
    add   r5, r5, r9
    add   r5, r5, r10
    adds  r5, r5, r4
    smull lr, r5, r5, r8              @ y / w
    ldrd  r9, r10, [r0, #.Ltransform.shift_x]
    sub   r9, r9, r7                  @ shifts are less by the normalisation
    sub   r10, r10, r7
    asr   r12, r12, r9
    asr   r5, r5, r10
    ldrd  r9, r10, [r0, #.Ltransform.bias_x]
    add   r12, r12, r9
    add   r5, r5, r10
    asr   r12, r12, #1
    asrs  r5, r5, #1
    add   r9, r12, #16384             @ narrow: both within +-kNarrowLimit, one test for two
    add   r10, r5, #16384
    orr   r9, r9, r10
    lsrs  r9, r9, #15
    bne   3f
    ldrd  r9, r10, [r0, #.Ltransform.depth_normalisation]
    sub   r9, r9, r7                  @ depth, from 1 / w
    lsr   r8, r8, r9
    umull lr, r8, r8, r10
    ldrd  r9, r10, [r0, #.Ltransform.depth_shift]
    lsl   r8, r8, r9
    sub   r8, r8, r10
    bfc   r8, #0, #14                 @ snap_depth
    orr   r8, r8, #0x2000
    bfi   r12, r5, #16, #16           @ y and x in one word
  2:
    strd  r12, r8, [r3], #.Lvertex.size
    subs  r2, r2, #1
    bne   1b
    pop   {r4-r12, lr}
    mov   r0, r12
    bx    lr
  3:
    mov   r12, #0x8000                @ kNotNarrow, 0; its depth 0
    movs  r8, #0
    str   r8, [sp, #.Lstack.narrow]
    b     2b
  )");
}

#endif

}  // namespace zstrip::detail
