// The assembly behind textured_run_thumb2.hpp. 15 values for 14 registers: shifts by a register look at its lowest byte
// only, so that the bytes above count the pixels.
#include "zstrip/raster/textured_run_thumb2.hpp"

#include <cstddef>

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

using State = TexturedRunState<std::uint32_t>;
static_assert(offsetof(State, z) == 16 && offsetof(State, texels) == 24 && offsetof(State, row_mask) == 36);

[[gnu::naked]] void fill_run_thumb2(State&, std::uint16_t*, std::uint16_t*, std::int32_t) {
  asm(R"(
    push  {r0, r4-r11, lr}
    mov   r12, r0
    mov   r10, r1
    sub   r11, r2, r1
    subs  r11, r11, #2                @ from behind a cell of depth to its pixel
    sub   lr, r3, #1
    ldm   r12, {r0-r9}                @ u, v, their steps, depth, its step, texels, both shifts, mask
    add   r7, r7, lr, lsl #8
  .Lrun_texel:
    ldrh  r12, [r10], #2
    cmp   r12, r4, lsr #16
    bhs   .Lrun_behind
    lsrs  r12, r4, #16
    strh  r12, [r10, #-2]
    lsr   r12, r1, r8
    and   r12, r12, r9
    lsr   lr, r0, r7
    add   r12, r12, lr
    ldrh  r12, [r6, r12, lsl #1]
    strh  r12, [r10, r11]
  .Lrun_behind:
    add   r4, r4, r5
    add   r0, r0, r2
    add   r1, r1, r3
    subs  r7, r7, #256
    bhs   .Lrun_texel
    ldr   r0, [sp]
    str   r4, [r0, #16]
    pop   {r0, r4-r11, pc}
  )");
}

#endif

}  // namespace zstrip::detail
