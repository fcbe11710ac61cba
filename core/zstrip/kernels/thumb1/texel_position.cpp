// The assembly of thumb1/texel_position.hpp.
#include "zstrip/kernels/thumb1/texel_position.hpp"

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

// r8 holds u/w and r7 v/w while the division of 1 by r2 uses r0 to r6. Shifts come last, because they depend on the
// normalisation in r6, a result of the division.
[[gnu::naked]] std::uint64_t divide_texels_thumb1(std::uint32_t, std::uint32_t, std::uint32_t, std::int32_t,
                                                  std::uintptr_t) {
  asm(".syntax unified\n" ZSTRIP_THUMB1_RECIPROCAL R"(
    .set .Lstack.size, 28             @ all that is pushed; the fifth argument, the table, is behind it

    push  {r4-r7, lr}
    mov   r4, r8
    push  {r3, r4}
    mov   r8, r1
    movs  r7, r2
    movs  r2, r0
    bne   .Lposition_divisor
    movs  r2, #1
  .Lposition_divisor:
    ldr   r5, [sp, #.Lstack.size]
    movs  r6, #3                      @ most have 29 bits
    zstrip_reciprocal
    uxth  r4, r3
    lsrs  r5, r3, #16
    mov   r0, r8
    zstrip_multiply_high r0, r4, r5, r1, r2, r3
    zstrip_multiply_high r7, r4, r5, r1, r2, r3
    movs  r1, r7
    pop   {r2, r4}
    mov   r8, r4
    subs  r2, r2, r6
    bmi   .Lposition_left
    asrs  r0, r0, r2                  @ from 32 on it leaves the sign
    asrs  r1, r1, r2
    pop   {r4-r7, pc}
  .Lposition_left:
    rsbs  r2, r2, #0
    cmp   r2, #31
    ble   .Lposition_limited
    movs  r2, #31
  .Lposition_limited:
    lsls  r0, r0, r2
    lsls  r1, r1, r2
    pop   {r4-r7, pc}
  )" ZSTRIP_THUMB1_PURGE_RECIPROCAL);
}

#endif

}  // namespace zstrip::detail
