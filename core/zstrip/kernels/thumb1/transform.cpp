// The assembly of thumb1/transform.hpp: multiplies coordinates by the halves of coefficients, which are in memory in
// the order of their use.
#include "zstrip/kernels/thumb1/transform.hpp"

#include <cstddef>

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// clang-format off
#define ZSTRIP_HALVED_TRANSFORM(field, number)            \
  number(form.size, sizeof(LinearHalves), 28)             \
  field(form, LinearHalves, offset, 8)                    \
  field(transform, HalvedTransform, x, 0)                 \
  field(transform, HalvedTransform, y, 28)                \
  field(transform, HalvedTransform, w, 56)                \
  field(transform, HalvedTransform, w_near, 84)           \
  field(transform, HalvedTransform, w_range, 88)          \
  field(transform, HalvedTransform, shift_x, 92)          \
  field(transform, HalvedTransform, bias_y, 104)          \
  field(transform, HalvedTransform, depth_scale_low, 108) \
  field(transform, HalvedTransform, depth_offset, 124)
// clang-format on
ZSTRIP_CHECK_LAYOUT(ZSTRIP_HALVED_TRANSFORM)

// r8 x; r9 y; r10 the next position; r11 the next vertex; r12 the normalisation of the last w; lr the end of the
// vertices. For each vertex r7 walks through the transform from its first member to its last: an ldm of two bytes loads
// up to three of them, without any address computation.
[[gnu::naked]] static bool transform(const HalvedTransform&, const Position*, std::uint32_t, SnappedVertex*,
                                     const std::uint16_t*) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL R"(
    @ On the stack:
    .set .Lstack.transform, 0
    .set .Lstack.narrow, 4            @ 1 while all vertices are narrow
    .set .Lstack.reciprocals, 8       @ the table for an index that begins at 256

    @ r3: a form, whose halves begin at r7, at the position in r4, r5 and r6: the offset and the upper words of three
    @ products, floor. Moves r7 behind the form. Uses r1 and r2.
    .macro zstrip_form
      ldm   r7!, {r1-r3}
      muls  r1, r1, r4
      asrs  r1, r1, #16
      adds  r3, r3, r1
      muls  r2, r2, r4
      adds  r3, r3, r2
      ldm   r7!, {r1-r2}
      muls  r1, r1, r5
      asrs  r1, r1, #16
      adds  r3, r3, r1
      muls  r2, r2, r5
      adds  r3, r3, r2
      ldm   r7!, {r1-r2}
      muls  r1, r1, r6
      asrs  r1, r1, #16
      adds  r3, r3, r1
      muls  r2, r2, r6
      adds  r3, r3, r2
    .endm

    ldr   r4, [sp, #.Lsaved]          @ the fifth argument
    movs  r5, #2
    lsls  r5, r5, #8
    subs  r6, r4, r5
    movs  r5, #1
    movs  r4, r0
    push  {r4-r6}
    mov   r10, r1
    lsls  r2, r2, #3                  @ vertices of 8 bytes
    adds  r2, r2, r3
    mov   lr, r2
    mov   r11, r3
    movs  r6, #0
    mov   r12, r6
  1:                                  @ r4, r5 and r6 the position, r7 the transform
    mov   r0, r10
    ldrh  r4, [r0, #.Lposition.x]
    ldrh  r5, [r0, #.Lposition.y]
    ldrh  r6, [r0, #.Lposition.z]
    sxth  r4, r4
    sxth  r5, r5
    sxth  r6, r6
    adds  r0, r0, #.Lposition.size
    mov   r10, r0
    ldr   r7, [sp, #.Lstack.transform]
    zstrip_form
    mov   r8, r3
    zstrip_form
    mov   r9, r3
    zstrip_form
    ldm   r7!, {r1-r2}                @ w_near, w_range
    subs  r1, r3, r1
    cmp   r1, r2
    bls   2f
    b     5f
  2:
    @ 1 / w in r3, its halves in r4 and r5. x is done first, in r8, where 1 / w stays for the depth. r6 is what w was
    @ normalised by, which shifts are less.
    movs  r2, r3
    mov   r6, r12
    ldr   r5, [sp, #.Lstack.reciprocals]
    zstrip_reciprocal
    mov   r12, r6
    uxth  r4, r3
    lsrs  r5, r3, #16
    mov   r0, r8
    mov   r8, r3
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    ldm   r7!, {r1-r2}                @ shift, bias
    subs  r1, r1, r6
    asrs  r0, r0, r1
    adds  r0, r0, r2
    asrs  r0, r0, #1                  @ x, to r9, from where y comes
    mov   r1, r9
    mov   r9, r0
    movs  r0, r1
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    ldm   r7!, {r1-r2}
    subs  r1, r1, r6
    asrs  r0, r0, r1
    adds  r0, r0, r2
    asrs  r0, r0, #1                  @ y
    mov   r1, r9                      @ x
    movs  r2, #1                      @ narrow: both within +-kNarrowLimit, one test for two
    lsls  r2, r2, #14
    adds  r3, r1, r2
    adds  r2, r2, r0
    orrs  r2, r2, r3
    lsrs  r2, r2, #15
    beq   3f
    b     5f
  3:
    mov   r2, r11                     @ the vertex
    strh  r1, [r2, #.Lvertex.x]
    strh  r0, [r2, #.Lvertex.y]
    ldm   r7!, {r3-r5}                @ halves of the depth's scale, its normalisation
    mov   r0, r8
    subs  r5, r5, r6
    lsrs  r0, r0, r5
    zstrip_multiply_high r0, r3, r4, r1, r5, r6, lsrs
    ldm   r7!, {r1, r3}               @ shift, offset
    lsls  r0, r0, r1
    subs  r0, r0, r3
    lsrs  r0, r0, #14                 @ snap_depth
    lsls  r0, r0, #1
    adds  r0, r0, #1
    lsls  r0, r0, #13
  4:
    str   r0, [r2, #.Lvertex.depth]
    adds  r2, r2, #.Lvertex.size
    mov   r11, r2
    cmp   r2, lr
    beq   6f
    b     1b
  5:
    movs  r0, #1
    lsls  r0, r0, #15                 @ kNotNarrow, 0; its depth 0
    mov   r2, r11
    str   r0, [r2, #.Lvertex.x]       @ and y
    movs  r0, #0
    str   r0, [sp, #.Lstack.narrow]
    b     4b
  6:
    pop   {r1-r3}                     @ r2: .Lstack.narrow
    movs  r0, r2
    .purgem zstrip_form
  )" ZSTRIP_THUMB1_PURGE_RECIPROCAL ZSTRIP_THUMB1_POP);
}

bool transform_vertices_thumb1(const HalvedTransform& instance, const Position* positions, std::uint32_t count,
                               SnappedVertex* vertices) {
  return transform(instance, positions, count, vertices, kReciprocalTable.data());
}

#endif

}  // namespace zstrip::detail
