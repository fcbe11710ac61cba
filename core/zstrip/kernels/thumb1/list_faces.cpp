// The assembly behind thumb/list_faces.hpp, for Cortex-M0: what GCC makes of the C++ takes half as much again.
#include "zstrip/kernels/thumb/list_faces.hpp"

#include <cstddef>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

static_assert(offsetof(FaceLists, for_top) == 0 && offsetof(FaceLists, for_bottom) == 4 &&
              offsetof(FaceLists, inverse) == 8 && offsetof(FaceLists, strips) == 12 &&
              offsetof(FaceLists, lists) == 16 && offsetof(FaceLists, slots) == 20 && offsetof(FaceLists, batch) == 24);
static_assert(offsetof(FaceLists, bins) == 28 && offsetof(FaceLists, vertices) == 32 && offsetof(FaceLists, end) == 40);
static_assert(offsetof(BinList, next) == 0 && offsetof(BinList, batch) == 4 && sizeof(BinList) == 8);
static_assert(kBinChunkSlots == 16);
static_assert(offsetof(SnappedVertex, x) == 0 && offsetof(SnappedVertex, y) == 2 && sizeof(SnappedVertex) == 8);
static_assert(sizeof(Triangle) == 6);

// Used: the assembly calls it by its name.
[[gnu::used]] bool append_to_list(Bins& bins, BinList& list, std::uint32_t batch, std::uint32_t triangle) {
  return bins.append(list, static_cast<std::uint16_t>(batch), static_cast<std::uint16_t>(triangle));
}

// r0 the next triangle, r8 its vertices, r9 the end of triangles, r10 the lists, lr the triangle's index, r12 one.
// While one is listed, r0 its index, r11 the next triangle.
[[gnu::naked]] bool list_faces_thumb(FaceLists&, const Triangle*, std::uint32_t) {
  asm(ZSTRIP_THUMB1_PUSH R"(
    push  {r3}
    mov   r10, r0
    ldr   r3, [r0, #32]
    mov   r8, r3
    lsls  r3, r2, #1
    adds  r3, r3, r2
    lsls  r3, r3, #1
    adds  r3, r3, r1
    mov   r9, r3
    movs  r3, #1
    mov   r12, r3
    subs  r3, r3, #2
    mov   lr, r3
    movs  r0, r1
  .Lfaces_next:
    cmp   r0, r9
    beq   .Lfaces_end
    add   lr, r12
    mov   r1, r8
    ldrh  r2, [r0]
    ldrh  r3, [r0, #2]
    ldrh  r4, [r0, #4]
    adds  r0, r0, #6
    lsls  r2, r2, #3
    lsls  r3, r3, #3
    lsls  r4, r4, #3
    ldr   r2, [r1, r2]                @ y and x in one word
    ldr   r3, [r1, r3]
    ldr   r4, [r1, r4]
    subs  r5, r3, r2                  @ differences are below 2^15
    subs  r6, r4, r2
    sxth  r5, r5
    sxth  r6, r6
    asrs  r7, r2, #16
    asrs  r1, r3, #16
    subs  r1, r1, r7
    muls  r6, r6, r1
    asrs  r1, r4, #16
    subs  r1, r1, r7
    muls  r5, r5, r1
    cmp   r6, r5
    ble   .Lfaces_next

    cmp   r2, r3                      @ words are in the order of y: r2 the least, r3 the greatest
    ble   .Lfaces_ordered
    movs  r5, r2
    movs  r2, r3
    movs  r3, r5
  .Lfaces_ordered:
    cmp   r4, r3
    ble   .Lfaces_below
    movs  r3, r4
  .Lfaces_below:
    cmp   r4, r2
    bge   .Lfaces_above
    movs  r2, r4
  .Lfaces_above:
    mov   r7, r10
    ldr   r4, [r7]
    ldr   r5, [r7, #4]
    asrs  r2, r2, #16
    asrs  r3, r3, #16
    adds  r2, r2, r4
    adds  r3, r3, r5
    ldr   r6, [r7, #40]
    cmp   r2, r6
    bhs   .Lfaces_cut
    cmp   r3, r6
    bhs   .Lfaces_cut
  .Lfaces_inside:
    mov   r11, r0
    ldrh  r4, [r7, #8]                @ strips by halves of the inverse
    ldrh  r5, [r7, #10]
    movs  r6, r2
    muls  r6, r6, r4
    muls  r2, r2, r5
    lsrs  r6, r6, #16
    adds  r2, r2, r6
    lsrs  r2, r2, #16                 @ first strip
    muls  r4, r4, r3
    muls  r3, r3, r5
    lsrs  r4, r4, #16
    adds  r3, r3, r4
    lsrs  r3, r3, #16                 @ last strip
    ldr   r4, [r7, #16]
    ldr   r5, [r7, #20]
    ldr   r6, [r7, #24]
    lsls  r7, r2, #3
    adds  r4, r4, r7
    mov   r0, lr
  .Lfaces_list:
    ldr   r7, [r4]
    ldrh  r1, [r4, #4]
    cmp   r1, r6
    bne   .Lfaces_append
    lsls  r1, r7, #28
    beq   .Lfaces_append
    lsls  r1, r7, #1
    strh  r0, [r5, r1]
    adds  r7, r7, #1
    str   r7, [r4]
  .Lfaces_listed:
    adds  r4, r4, #8
    adds  r2, r2, #1
    cmp   r2, r3
    ble   .Lfaces_list
    mov   r0, r11
    b     .Lfaces_next

  .Lfaces_cut:
    cmp   r3, #0
    blt   .Lfaces_next
    cmp   r2, r6
    bge   .Lfaces_next
    cmp   r2, #0
    bge   .Lfaces_from_top
    movs  r2, #0
  .Lfaces_from_top:
    cmp   r3, r6
    blt   .Lfaces_inside
    subs  r3, r6, #1
    b     .Lfaces_inside

  .Lfaces_append:
    push  {r2, r3}
    push  {r0, r4}
    mov   r7, lr
    mov   r3, r10
    ldr   r1, [r3, #28]
    movs  r3, r0
    movs  r0, r1
    movs  r1, r4
    movs  r2, r6
    bl    zstrip_append_to_list
    mov   lr, r7
    movs  r1, r0
    movs  r0, #1
    mov   r12, r0
    pop   {r0, r4}
    pop   {r2, r3}
    cmp   r1, #0
    bne   .Lfaces_listed
    movs  r0, #0
    b     .Lfaces_return
  .Lfaces_end:
    movs  r0, #1
  .Lfaces_return:
    pop   {r3}
  )" ZSTRIP_THUMB1_POP);
}

#endif

}  // namespace zstrip::detail
