// The assembly behind thumb/list_faces.hpp. With both coordinates of a vertex in one word a triangle is culled in 20
// instructions and listed in some 35, half of what GCC makes of the C++.
#include "zstrip/kernels/thumb/list_faces.hpp"

#include <cstddef>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

static_assert(offsetof(FaceLists, for_top) == 0 && offsetof(FaceLists, for_bottom) == 4 &&
              offsetof(FaceLists, inverse) == 8 && offsetof(FaceLists, strips) == 12 &&
              offsetof(FaceLists, lists) == 16 && offsetof(FaceLists, slots) == 20 && offsetof(FaceLists, batch) == 24);
static_assert(offsetof(FaceLists, bins) == 28 && offsetof(FaceLists, vertices) == 32 &&
              offsetof(FaceLists, last) == 36);
static_assert(offsetof(BinList, next) == 0 && offsetof(BinList, batch) == 4 && sizeof(BinList) == 8);
static_assert(kBinChunkSlots == 16);
static_assert(offsetof(SnappedVertex, x) == 0 && offsetof(SnappedVertex, y) == 2 && sizeof(SnappedVertex) == 8);
static_assert(sizeof(Triangle) == 6);

// Used: the assembly calls it by its name.
[[gnu::used]] bool append_to_list(Bins& bins, BinList& list, std::uint32_t batch, std::uint32_t triangle) {
  return bins.append(list, static_cast<std::uint16_t>(batch), static_cast<std::uint16_t>(triangle));
}

// r0 the lists, r10 the next triangle, r11 its vertices, lr how many triangles are left.
[[gnu::naked]] bool list_faces_thumb(FaceLists&, const Triangle*, std::uint32_t) {
  asm(ZSTRIP_TRIANGLE_OF_WORDS R"(
    push  {r3-r11, lr}
    mov   r10, r1
    mov   lr, r2
    subs  r2, r2, #1
    str   r2, [r0, #36]
    ldr   r11, [r0, #32]
  .Lfaces_next:
    subs  lr, lr, #1
    bmi   .Lfaces_end
    ldrh  r1, [r10], #6
    ldrh  r2, [r10, #-4]
    ldrh  r3, [r10, #-2]
    ldr   r4, [r11, r1, lsl #3]       @ y and x in one word
    ldr   r5, [r11, r2, lsl #3]
    ldr   r6, [r11, r3, lsl #3]
    zstrip_triangle_area
    cmp   r7, #0
    ble   .Lfaces_next

    cmp   r4, r5                      @ words are in the order of y: r4 the least, r5 the greatest
    bgt   .Lfaces_swap
  .Lfaces_swapped:
    cmp   r6, r4
    it    lt
    movlt r4, r6
    cmp   r6, r5
    it    gt
    movgt r5, r6
    ldm   r0, {r1, r2, r3, r6, r7, r8, r12}
    add   r4, r1, r4, asr #16
    add   r5, r2, r5, asr #16
    smull r9, r4, r3, r4              @ first strip
    smull r9, r5, r3, r5              @ last strip
    cmp   r4, r6
    it    lo
    cmplo r5, r6
    bhs   .Lfaces_cut
  .Lfaces_inside:
    ldr   r1, [r0, #36]
    add   r7, r7, r4, lsl #3
    sub   r1, r1, lr                  @ the triangle's index
  .Lfaces_list:
    ldr   r2, [r7]
    ldrh  r3, [r7, #4]
    cmp   r3, r12
    bne   .Lfaces_append
    lsls  r3, r2, #28
    beq   .Lfaces_append
    strh  r1, [r8, r2, lsl #1]
    adds  r2, r2, #1
    str   r2, [r7]
  .Lfaces_listed:
    cmp   r4, r5
    bge   .Lfaces_next
    adds  r4, r4, #1
    adds  r7, r7, #8
    b     .Lfaces_list

  .Lfaces_swap:
    mov   r12, r4
    mov   r4, r5
    mov   r5, r12
    b     .Lfaces_swapped

  .Lfaces_cut:
    bic   r4, r4, r4, asr #31
    cmp   r5, r6
    it    ge
    subge r5, r6, #1
    cmp   r4, r5
    bgt   .Lfaces_next
    b     .Lfaces_inside

  .Lfaces_append:
    push  {r0, r1, r12, lr}
    ldr   r0, [r0, #28]
    mov   r3, r1
    mov   r1, r7
    mov   r2, r12
    bl    zstrip_append_to_list
    cmp   r0, #0
    pop   {r0, r1, r12, lr}
    bne   .Lfaces_listed
    movs  r0, #0
    pop   {r3-r11, pc}
  .Lfaces_end:
    movs  r0, #1
    pop   {r3-r11, pc}
    .purgem zstrip_triangle_area
    .purgem zstrip_triangle_box
  )");
}

#endif

}  // namespace zstrip::detail
