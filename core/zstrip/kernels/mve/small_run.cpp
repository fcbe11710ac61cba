// Culls triangles one by one, sets up four of those that face the viewer, each in a lane of a vector of words, and
// draws them in their order. The formulas are those of set_up_small and PackedEdges; every plane is a sum of the
// weights of vertices 1 and 2.
#include "zstrip/kernels/mve/small_run.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "zstrip/base/division.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/mve/vectors.hpp"
#include "zstrip/kernels/thumb/layout.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/pixels/small_scan.hpp"

#if ZSTRIP_HAS_MVE

namespace zstrip::detail {
namespace {

constexpr std::uint32_t kLanes = 4;

/// The planes of a triangle and the pixels of its box. The assembly depends on the order of the members.
struct MveTriangle {
  std::uint32_t start[4], step_x[4];  ///< of each SmallScan::Value
  std::uintptr_t depth, colour;       ///< address of the box's first cell and pixel
  std::uint32_t step_y[4];
  std::int32_t width, height;  ///< of the box in the strip; no pixel is drawn unless both are > 0
};

/// Four triangles that face the viewer, and what the steps of their set-up leave for later ones: a vector has their
/// values, one in each lane.
struct FourTriangles {
  using Lanes = std::int32_t[kLanes];

  alignas(16) std::uint32_t corners[3][kLanes];  ///< of the mesh's vertices; byte offsets after rotate
  const Triangle* after[kLanes];                 ///< the triangle that follows
  std::uint32_t colours[3][kLanes];              ///< byte offsets of the corners' colours
  Lanes at_1, at_2;                              ///< weights of vertices 1 and 2 at the anchor
  Lanes right_1, right_2, down_1, down_2;        ///< their steps: a sub-pixel, and a pixel after set_up_edges
  Lanes area;                                    ///< twice the area; its inverse after set_up_depth
  std::int16_t moved[2 * kLanes];                ///< from the box to its part in the strip: columns and rows
  MveTriangle drawn[kLanes];
};

// clang-format off
#define ZSTRIP_MVE_TRIANGLE(field, number) \
  field(mve, MveTriangle, start, 0)        \
  field(mve, MveTriangle, step_x, 16)      \
  field(mve, MveTriangle, depth, 32)       \
  field(mve, MveTriangle, step_y, 40)      \
  field(mve, MveTriangle, width, 56)       \
  field(mve, MveTriangle, height, 60)      \
  number(mve.size, sizeof(MveTriangle), 64) \
  field(four, FourTriangles, corners, 0)   \
  number(four.corner, sizeof(FourTriangles::corners[0]), 16) \
  field(four, FourTriangles, after, 48)    \
  field(four, FourTriangles, colours, 64)
// clang-format on
ZSTRIP_CHECK_LAYOUT(ZSTRIP_MVE_TRIANGLE)
static_assert(PackedEdges::kSigns == 0x80200400);
static_assert(sizeof(SnappedVertex) == 8 && sizeof(Colour) == 4);

/// Draws the triangles from `first` to before `end`. Strides are in bytes.
///
/// q0 to q3 edges, depth, green, red and blue of four pixels of a row; q4 the pixels' columns; q5 the signs of edges;
/// q6 and q7 are temporary. r0 and r1 the cell and the pixel; r2 and r3 strides; r4 to r7 steps a row; r10 the width;
/// r11 the end; r12 the triangle; lr counts rows.
[[gnu::naked]] void draw_rows_mve(MveTriangle* /*first*/, const MveTriangle* /*end*/, std::int32_t /*depth_stride*/,
                                  std::int32_t /*colour_stride*/) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MVE_TRIANGLE) R"(
    push  {r4-r12, lr}
    vpush {d8-d15}
    mov   r12, r0
    mov   r11, r1
    movs  r4, #0
    vidup.u32 q4, r4, #1
    movw  r4, #0x0400
    movt  r4, #0x8020
    vdup.32 q5, r4
  .Lmve_small_triangle:
    ldrd  r10, lr, [r12, #.Lmve.width]
    cmp   r10, #0
    it    gt
    cmpgt lr, #0
    ble   .Lmve_small_done
  .Lmve_small_columns:
    ldm   r12, {r0, r1, r4-r9}        @ starts, steps to the right
    vdup.32 q0, r0
    vdup.32 q1, r1
    vdup.32 q2, r4
    vdup.32 q3, r5
    vmla.s32 q0, q4, r6
    vmla.s32 q1, q4, r7
    vmla.s32 q2, q4, r8
    vmla.s32 q3, q4, r9
    add   r0, r12, #.Lmve.depth
    ldm   r0, {r0, r1, r4-r7, r10}    @ the cell, the pixel, steps down, the width
    dls   lr, lr
  .Lmve_small_row:
    vctp.32 r10
    vand  q6, q0, q5
    vshr.u32 q7, q1, #16
    vpstttt
    vcmpt.i32 eq, q6, zr
    vldrht.u32 q6, [r0]
    vcmpt.u32 hi, q7, q6
    vstrht.32 q7, [r0]
    vshr.u32 q7, q3, #16              @ RGB565 in the lower half
    vsri.16 q7, q2, #5
    vsri.16 q7, q3, #11
    vpst
    vstrht.32 q7, [r1]
    vadd.i32 q0, q0, r4
    vadd.i32 q1, q1, r5
    vadd.i32 q2, q2, r6
    vadd.i32 q3, q3, r7
    add   r0, r0, r2
    add   r1, r1, r3
    le    lr, .Lmve_small_row
    subs  r10, r10, #4
    bgt   .Lmve_small_wider
  .Lmve_small_done:
    add   r12, r12, #.Lmve.size
    cmp   r12, r11
    bne   .Lmve_small_triangle
    vpop  {d8-d15}
    pop   {r4-r12, pc}
  .Lmve_small_wider:                  @ the next four columns
    str   r10, [r12, #.Lmve.width]
    ldm   r12, {r0, r1, r4-r9}
    add   r0, r0, r6, lsl #2
    add   r1, r1, r7, lsl #2
    add   r4, r4, r8, lsl #2
    add   r5, r5, r9, lsl #2
    stm   r12, {r0, r1, r4, r5}
    ldrd  r0, r1, [r12, #.Lmve.depth]
    adds  r0, r0, #4 * .Lcell
    adds  r1, r1, #4 * .Lcell
    strd  r0, r1, [r12, #.Lmve.depth]
    ldr   lr, [r12, #.Lmve.height]
    b     .Lmve_small_columns
  )");
}

/// Signed products of the halves of each word: x of the one by y of the other, minus the reverse. `swapped` has its
/// halves swapped.
int32x4_t cross(int16x8_t swapped, int16x8_t b) {
  return vsubq_s32(vmulltq_int_s16(swapped, b), vmullbq_int_s16(swapped, b));
}

int16x8_t in_all_pairs(std::int32_t low, std::int32_t high) {
  return vreinterpretq_s16_s32(vdupq_n_s32((high << 16) | (low & 0xFFFF)));
}

/// The part of a strip within the range of narrow coordinates.
struct MveStrip {
  int16x8_t first, end;          ///< pairs of columns and rows
  std::uintptr_t depth, colour;  ///< address of the first pixel
  std::int32_t depth_stride, colour_stride;

  explicit MveStrip(const ThumbSmallRun& run) : MveStrip(run, narrow(run.area)) {}

 private:
  MveStrip(const ThumbSmallRun& run, const Rect& area)
      : first(in_all_pairs(area.left, area.top)),
        end(in_all_pairs(area.right, area.bottom)),
        depth(address(run, area, run.depth, run.scan.depth_stride)),
        colour(address(run, area, run.colour, run.scan.colour_stride)),
        depth_stride(run.scan.depth_stride),
        colour_stride(run.scan.colour_stride) {}
  static Rect narrow(const Rect& area) {
    const auto limited = [](std::int32_t pixel) { return std::clamp(pixel, -kNarrowLimit / 16, kNarrowLimit / 16); };
    return {limited(area.left), limited(area.top), limited(area.right), limited(area.bottom)};
  }
  static std::uintptr_t address(const ThumbSmallRun& run, const Rect& area, const std::uint16_t* of_run,
                                std::int32_t stride) {
    return reinterpret_cast<std::uintptr_t>(of_run + (area.top - run.area.top) * stride + (area.left - run.area.left));
  }
};

// The steps of a set-up load and store these vectors by the names of FourTriangles' members. In assembly, because GCC
// computes an address for each of its own loads and stores of vectors, and has eight registers for the values of all
// steps. `volatile` keeps their order.
#define ZSTRIP_IN_FOUR(member) offsetof(FourTriangles, member)

template <std::size_t at>
[[gnu::always_inline]] inline int32x4_t load(const FourTriangles& four) {
  int32x4_t values;
  asm volatile("vldrw.u32 %q0, [%1, %2]" : "=w"(values) : "r"(&four), "n"(at));
  return values;
}
template <std::size_t at, class Values>
[[gnu::always_inline]] inline void store(FourTriangles& four, Values values) {
  asm volatile("vstrw.32 %q0, [%1, %2]" : : "w"(values), "r"(&four), "n"(at) : "memory");
}
/// Returns the sum of products of two vectors and of two members.
template <std::size_t at_1, std::size_t at_2>
[[gnu::always_inline]] inline int32x4_t sum_of_products(const FourTriangles& four, int32x4_t by_1, int32x4_t by_2) {
  const int32x4_t product = vmulq_s32(by_1, load<at_1>(four));
  return vaddq_s32(product, vmulq_s32(by_2, load<at_2>(four)));
}

/// The addresses of the triangles.
[[gnu::always_inline]] inline uint32x4_t addresses(const FourTriangles& four) {
  return vaddq_n_u32(vmulq_n_u32(vidupq_n_u32(0, 1), sizeof(MveTriangle)),
                     static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(four.drawn)));
}

template <int value>
[[gnu::always_inline]] inline void store_plane(uint32x4_t to, int32x4_t start, int32x4_t step_x, int32x4_t step_y) {
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, start) + 4 * value, start);
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, step_x) + 4 * value, step_x);
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, step_y) + 4 * value, step_y);
}

/// Collects up to four triangles that face the viewer, from `next` to before `end`. Returns the triangle after the
/// last one that it tested, in the lower word, and the number of collected ones in the upper word.
//
// r0 the next free lane, lr the place behind the fourth; r1 the next triangle, r2 the end, r3 the vertices; r4 to r6
// the corners' indices; r7 to r9 their places, then their differences and the area. The area is tested before anything
// is stored, because half of the triangles end there.
[[gnu::naked]] std::uint64_t collect(FourTriangles& /*four*/, const Triangle* /*next*/, const Triangle* /*end*/,
                                     std::uintptr_t /*vertices*/) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_MVE_TRIANGLE) R"(
    push  {r0, r4-r9, lr}
    add   lr, r0, #.Lfour.corner      @ behind the fourth lane
  .Lmve_collect_next:
    cmp   r1, r2
    beq   .Lmve_collect_end
    ldrh  r4, [r1], #.Ltriangle.size
    ldrh  r5, [r1, #.Ltriangle.b - .Ltriangle.size]
    ldrh  r6, [r1, #.Ltriangle.c - .Ltriangle.size]
    ldr   r7, [r3, r4, lsl #3]        @ y and x in one word
    ldr   r8, [r3, r5, lsl #3]
    ldr   r9, [r3, r6, lsl #3]
    ssub16 r8, r8, r7                 @ differences are below 2^15
    ssub16 r9, r9, r7
    smusdx r9, r9, r8
    cmp   r9, #0
    ble   .Lmve_collect_next
    str   r4, [r0, #.Lfour.corners]
    str   r5, [r0, #.Lfour.corners + .Lfour.corner]
    str   r6, [r0, #.Lfour.corners + 2 * .Lfour.corner]
    str   r1, [r0, #.Lfour.after]
    adds  r0, r0, #4
    cmp   r0, lr
    bne   .Lmve_collect_next
  .Lmve_collect_end:
    pop   {r2, r4-r9, lr}
    sub   r2, r0, r2
    mov   r0, r1
    lsrs  r1, r2, #2
    bx    lr
  )");
}

struct Places {
  int16x8_t first, second, third;
};

/// Makes the highest corner the first; if several are, the leftmost of them. Returns the places of the corners, in
/// pairs. The order of corners grows with y, then x.
//
// %3 the triangles, %4 the vertices. q0 to q2 the vertices' offsets, q3 to q5 their places with the sign bit of x
// inverted: so one signed comparison of words orders them by y, then x. From vpsel on q6, q7 and q4 have the offsets in
// the new order. The places are loaded again at the end, because the three results need registers that are free only
// then.
[[gnu::always_inline]] inline Places rotate(FourTriangles& four, std::uintptr_t vertices) {
  register int16x8_t first asm("q5");
  register int16x8_t second asm("q6");
  register int16x8_t third asm("q7");
  asm volatile(ZSTRIP_NAMES(ZSTRIP_MVE_TRIANGLE) R"(
    vldrw.u32 q0, [%3, #.Lfour.corners]
    vldrw.u32 q1, [%3, #.Lfour.corners + .Lfour.corner]
    vldrw.u32 q2, [%3, #.Lfour.corners + 2 * .Lfour.corner]
    vshl.i32  q0, q0, #3
    vshl.i32  q1, q1, #3
    vshl.i32  q2, q2, #3
    vldrw.u32 q3, [%4, q0]
    vldrw.u32 q4, [%4, q1]
    vldrw.u32 q5, [%4, q2]
    vmov.i32  q6, #0x8000
    veor      q3, q3, q6
    veor      q4, q4, q6
    veor      q5, q5, q6
    vpt.s32   gt, q3, q4
    vcmpt.s32 gt, q5, q4
    vpsel     q6, q1, q0              @ the second becomes the first
    vpsel     q7, q2, q1
    vpsel     q4, q0, q2
    vpnot
    vpst
    vcmpt.s32 gt, q3, q5
    vpsel     q6, q2, q6              @ the third becomes the first
    vpsel     q7, q0, q7
    vpsel     q4, q1, q4
    vstrw.32  q6, [%3, #.Lfour.corners]
    vstrw.32  q7, [%3, #.Lfour.corners + .Lfour.corner]
    vstrw.32  q4, [%3, #.Lfour.corners + 2 * .Lfour.corner]
    vshr.u32  q0, q6, #1
    vshr.u32  q1, q7, #1
    vshr.u32  q2, q4, #1
    vstrw.32  q0, [%3, #.Lfour.colours]
    vstrw.32  q1, [%3, #.Lfour.colours + .Lfour.corner]
    vstrw.32  q2, [%3, #.Lfour.colours + 2 * .Lfour.corner]
    vldrw.u32 q5, [%4, q6]
    vldrw.u32 q6, [%4, q7]
    vldrw.u32 q7, [%4, q4]
  )"
               : "=w"(first), "=w"(second), "=w"(third)
               : "r"(&four), "r"(vertices)
               : "q0", "q1", "q2", "q3", "q4", "memory");
  return {first, second, third};
}

/// Sets up the boxes and the weights of vertices 1 and 2. Returns lanes that are too large for small triangles.
[[gnu::always_inline]] inline mve_pred16_t set_up_boxes(FourTriangles& four, const Places& places,
                                                        const MveStrip& strip) {
  const int16x8_t p0 = places.first, p1 = places.second, p2 = places.third;
  const int16x8_t least = vminq_s16(vminq_s16(p0, p1), p2), greatest = vmaxq_s16(vmaxq_s16(p0, p1), p2);
  // Sides from the end of each edge to its start: its function grows by y to the right and by -x downwards.
  const int16x8_t side_1 = vsubq_s16(p0, p2), side_2 = vsubq_s16(p1, p0);
  const int16x8_t to_anchor = vrev32q_s16(vsubq_s16(vorrq_s16(least, vdupq_n_s16(kPixelCentre)), p0));
  static_assert(kPixelCentre == 15);
  store<ZSTRIP_IN_FOUR(at_1)>(four, cross(to_anchor, side_1));
  store<ZSTRIP_IN_FOUR(at_2)>(four, cross(to_anchor, side_2));
  store<ZSTRIP_IN_FOUR(area)>(four, cross(vrev32q_s16(side_2), side_1));
  store<ZSTRIP_IN_FOUR(right_1)>(four, vmovltq_s16(side_1));
  store<ZSTRIP_IN_FOUR(right_2)>(four, vmovltq_s16(side_2));
  store<ZSTRIP_IN_FOUR(down_1)>(four, vnegq_s32(vmovlbq_s16(side_1)));
  store<ZSTRIP_IN_FOUR(down_2)>(four, vnegq_s32(vmovlbq_s16(side_2)));

  const int16x8_t extent = vsubq_s16(greatest, least);
  const int16x8_t sum = vaddq_s16(extent, vrev32q_s16(extent));
  const mve_pred16_t large = vcmpcsq_n_u16(vreinterpretq_u16_s16(sum), kSmallExtent);
  const uint32x4_t to = addresses(four);
  const int16x8_t box = vshrq_n_s16(least, 4);
  const int16x8_t first = vmaxq_s16(box, strip.first), end = vminq_s16(vshrq_n_s16(greatest, 4), strip.end);
  store<ZSTRIP_IN_FOUR(moved)>(four, vsubq_s16(first, box));
  const int16x8_t size = vsubq_s16(end, first);
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, width), vmovlbq_s16(size));
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, height), vmovltq_s16(size));
  const int16x8_t from_strip = vsubq_s16(first, strip.first);
  const int32x4_t columns = vmovlbq_s16(from_strip), rows = vmovltq_s16(from_strip);
  const auto address = [&](std::uintptr_t origin, std::int32_t stride) {
    const int32x4_t at = vaddq_s32(vmulq_n_s32(rows, stride), columns);
    return vaddq_n_s32(vshlq_n_s32(at, 1), static_cast<std::int32_t>(origin));
  };
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, depth), address(strip.depth, strip.depth_stride));
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, colour), address(strip.colour, strip.colour_stride));
  return large;
}

/// Sets up PackedEdges.
[[gnu::always_inline]] inline void set_up_edges(FourTriangles& four) {
  const auto field = [](int32x4_t exact, int32x4_t right, int32x4_t down) {
    const int32x4_t rule = vshrq_n_s32(vaddq_s32(vshlq_n_s32(right, 16), down), 31);
    return vshrq_n_s32(vaddq_s32(exact, rule), 4);
  };
  const auto pack = [](int32x4_t a, int32x4_t b, int32x4_t c) {
    return vaddq_s32(vaddq_s32(vshlq_n_s32(a, 22), vshlq_n_s32(b, 11)), c);
  };
  const uint32x4_t to = addresses(four);
  const int32x4_t right_1 = load<ZSTRIP_IN_FOUR(right_1)>(four), right_2 = load<ZSTRIP_IN_FOUR(right_2)>(four);
  const int32x4_t right_0 = vnegq_s32(vaddq_s32(right_1, right_2));
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, step_x) + 4 * SmallScan::edges, pack(right_0, right_1, right_2));
  store<ZSTRIP_IN_FOUR(right_1)>(four, vshlq_n_s32(right_1, 4));
  store<ZSTRIP_IN_FOUR(right_2)>(four, vshlq_n_s32(right_2, 4));
  const int32x4_t down_1 = load<ZSTRIP_IN_FOUR(down_1)>(four), down_2 = load<ZSTRIP_IN_FOUR(down_2)>(four);
  const int32x4_t down_0 = vnegq_s32(vaddq_s32(down_1, down_2));
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, step_y) + 4 * SmallScan::edges, pack(down_0, down_1, down_2));
  store<ZSTRIP_IN_FOUR(down_1)>(four, vshlq_n_s32(down_1, 4));
  store<ZSTRIP_IN_FOUR(down_2)>(four, vshlq_n_s32(down_2, 4));
  const int32x4_t at_1 = load<ZSTRIP_IN_FOUR(at_1)>(four), at_2 = load<ZSTRIP_IN_FOUR(at_2)>(four);
  const int32x4_t of_1 = field(at_1, right_1, down_1), of_2 = field(at_2, right_2, down_2);
  const int32x4_t at_0 = vsubq_s32(vsubq_s32(load<ZSTRIP_IN_FOUR(area)>(four), at_1), at_2);
  vstrwq_scatter_base_s32(to, offsetof(MveTriangle, start) + 4 * SmallScan::edges,
                          pack(field(at_0, right_0, down_0), of_1, of_2));
}

/// Sets up depth. Returns lanes whose depths differ too much for small triangles.
[[gnu::always_inline]] inline mve_pred16_t set_up_depth(FourTriangles& four, const std::uint32_t* vertices) {
  for (std::int32_t& area : four.area) area = static_cast<std::int32_t>(quotient_31(static_cast<std::uint32_t>(area)));
  const auto depth = [vertices](int32x4_t offset) {
    return vldrwq_gather_offset_u32(vertices + 1, vreinterpretq_u32_s32(offset));
  };
  const uint32x4_t z0 = depth(load<ZSTRIP_IN_FOUR(corners[0])>(four)),
                   z1 = depth(load<ZSTRIP_IN_FOUR(corners[1])>(four)),
                   z2 = depth(load<ZSTRIP_IN_FOUR(corners[2])>(four));
  // Compares halves, because differences of whole depths need 33 bits.
  const auto near = [&](uint32x4_t z) {
    return vaddq_n_u32(vsubq_u32(vshrq_n_u32(z0, 1), vshrq_n_u32(z, 1)), kSmallDepthDifference / 2);
  };
  static_assert(kSmallDepthDifference == 1U << 29);
  const mve_pred16_t far = vcmpcsq_n_u32(vorrq_u32(near(z1), near(z2)), kSmallDepthDifference);
  asm volatile("" : : : "memory");  // the inverse areas are stored
  const int32x4_t inverse = load<ZSTRIP_IN_FOUR(area)>(four);
  const auto per_unit = [&](uint32x4_t z) {
    return vrmulhq_s32(vshlq_n_s32(vreinterpretq_s32_u32(vsubq_u32(z, z0)), 1), inverse);
  };
  const int32x4_t unit_1 = per_unit(z1), unit_2 = per_unit(z2);
  const int32x4_t at_anchor = sum_of_products<ZSTRIP_IN_FOUR(at_1), ZSTRIP_IN_FOUR(at_2)>(four, unit_1, unit_2);
  const int32x4_t step_x = sum_of_products<ZSTRIP_IN_FOUR(right_1), ZSTRIP_IN_FOUR(right_2)>(four, unit_1, unit_2);
  const int32x4_t step_y = sum_of_products<ZSTRIP_IN_FOUR(down_1), ZSTRIP_IN_FOUR(down_2)>(four, unit_1, unit_2);
  const int32x4_t start = vaddq_s32(vreinterpretq_s32_u32(z0), at_anchor);
  store_plane<SmallScan::depth>(addresses(four), start, step_x, step_y);
  return far;
}

struct Channel {
  int32x4_t start, step_x, step_y;
};

/// Sets up a channel in 8.8, from the address of vertex 0's.
[[gnu::always_inline]] inline Channel channel_of(const FourTriangles& four, std::uintptr_t of, int32x4_t inverse) {
  const auto at = [of](int32x4_t offset) {
    return vreinterpretq_s32_u32(
        vldrbq_gather_offset_u32(reinterpret_cast<const std::uint8_t*>(of),
                                 vreinterpretq_u32_s32(offset)));  // NOLINT(performance-no-int-to-ptr)
  };
  const int32x4_t first = at(load<ZSTRIP_IN_FOUR(colours[0])>(four));
  // Scaled, so that the products with 1 / area have a channel's 8.8 in their upper words.
  const int32x4_t d1 = vshlq_n_s32(vsubq_s32(at(load<ZSTRIP_IN_FOUR(colours[1])>(four)), first), 9);
  const int32x4_t d2 = vshlq_n_s32(vsubq_s32(at(load<ZSTRIP_IN_FOUR(colours[2])>(four)), first), 9);
  const int32x4_t at_anchor = sum_of_products<ZSTRIP_IN_FOUR(at_1), ZSTRIP_IN_FOUR(at_2)>(four, d1, d2);
  const int32x4_t start = vaddq_s32(vaddq_n_s32(vshlq_n_s32(first, 8), 128), vmulhq_s32(at_anchor, inverse));
  const int32x4_t right = sum_of_products<ZSTRIP_IN_FOUR(right_1), ZSTRIP_IN_FOUR(right_2)>(four, d1, d2);
  const int32x4_t down = sum_of_products<ZSTRIP_IN_FOUR(down_1), ZSTRIP_IN_FOUR(down_2)>(four, d1, d2);
  return {start, vmulhq_s32(right, inverse), vmulhq_s32(down, inverse)};
}

[[gnu::always_inline]] inline void set_up_colours(FourTriangles& four, std::uintptr_t colours) {
  const int32x4_t inverse = load<ZSTRIP_IN_FOUR(area)>(four);
  const uint32x4_t to = addresses(four);
  const Channel green = channel_of(four, colours + offsetof(Colour, g), inverse);
  store_plane<SmallScan::green>(to, green.start, green.step_x, green.step_y);
  const Channel red = channel_of(four, colours + offsetof(Colour, r), inverse);
  store_plane<SmallScan::red_blue>(to, vshlq_n_s32(red.start, 16), vshlq_n_s32(red.step_x, 16),
                                   vshlq_n_s32(red.step_y, 16));
  const Channel blue = channel_of(four, colours + offsetof(Colour, b), inverse);
  constexpr std::size_t kValue = 4 * SmallScan::red_blue;
  const auto both = [to]<std::size_t at>(std::integral_constant<std::size_t, at>, int32x4_t low) {
    vstrwq_scatter_base_s32(to, at + kValue, vaddq_s32(vldrwq_gather_base_s32(to, at + kValue), low));
  };
  both(std::integral_constant<std::size_t, offsetof(MveTriangle, start)>{}, blue.start);
  both(std::integral_constant<std::size_t, offsetof(MveTriangle, step_x)>{}, blue.step_x);
  both(std::integral_constant<std::size_t, offsetof(MveTriangle, step_y)>{}, blue.step_y);
}

/// Moves the starts to the first pixels in the strip.
[[gnu::noinline]] void move(FourTriangles& four) {
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    MveTriangle& t = four.drawn[lane];
    const std::int32_t columns = four.moved[2 * lane], rows = four.moved[2 * lane + 1];
    for (int value = 0; value < 4; ++value) {
      t.start[value] +=
          t.step_x[value] * static_cast<std::uint32_t>(columns) + t.step_y[value] * static_cast<std::uint32_t>(rows);
    }
  }
}

/// Sets up the triangles. Returns a mask of those that are not small: bit 4 lane. Not inlined, so that it has all
/// registers.
[[gnu::noinline]] std::uint32_t set_up(FourTriangles& four, const ThumbSmallRun& run, const MveStrip& strip) {
  const mve_pred16_t large = set_up_boxes(four, rotate(four, run.vertices), strip);
  set_up_edges(four);
  const auto* const vertices = reinterpret_cast<const std::uint32_t*>(run.vertices);  // NOLINT
  const mve_pred16_t far = set_up_depth(four, vertices);
  set_up_colours(four, run.colours);
  if (vcmpneq_n_s32(load<ZSTRIP_IN_FOUR(moved)>(four), 0) != 0) [[unlikely]]
    move(four);
  return (large | far) & 0x1111U;
}

/// Draws a triangle that is not small. Returns false if it is not a medium one either.
bool draw_other(ThumbSmallRun& run, const Triangle& triangle) {
  const auto vertex = [&run](std::uint32_t i) -> const SnappedVertex& {
    return *reinterpret_cast<const SnappedVertex*>(  // NOLINT(performance-no-int-to-ptr)
        run.vertices + i * sizeof(SnappedVertex));
  };
  const auto order = [&](std::uint32_t i) { return vertex(i).y * 65536 + vertex(i).x; };
  std::uint32_t corners[3] = {triangle.a, triangle.b, triangle.c};
  const std::int32_t a = order(corners[0]), b = order(corners[1]), c = order(corners[2]);
  const std::uint32_t first = b < a && b < c ? 1 : c < a ? 2 : 0;
  for (std::uint32_t i = 0; i < first; ++i) {
    const std::uint32_t last = corners[0];
    corners[0] = corners[1], corners[1] = corners[2], corners[2] = last;
  }
  const SnappedVertex &v0 = vertex(corners[0]), &v1 = vertex(corners[1]), &v2 = vertex(corners[2]);
  run.scan.area = (v2.x - v0.x) * (v1.y - v0.y) - (v1.x - v0.x) * (v2.y - v0.y);
  for (int i = 0; i < 3; ++i) {
    run.scan.set_colour(i, *reinterpret_cast<const Colour*>(  // NOLINT(performance-no-int-to-ptr)
                               run.colours + corners[i] * sizeof(Colour)));
  }
  return draw_medium_of_run(run, v0, v1, v2);
}

}  // namespace

std::uint32_t draw_small_run_mve(ThumbSmallRun& run, const Triangle* triangles, std::uint32_t count) {
  const MveStrip strip(run);
  const std::int32_t depth_stride = strip.depth_stride * 2, colour_stride = strip.colour_stride * 2;
  FourTriangles four;
  const Triangle* next = triangles;
  const Triangle* const end = triangles + count;
  while (next != end) {
    const std::uint64_t collected = collect(four, next, end, run.vertices);
    next = reinterpret_cast<const Triangle*>(static_cast<std::uintptr_t>(collected));  // NOLINT
    const auto lanes = static_cast<std::uint32_t>(collected >> 32);
    if (lanes == 0) break;
    for (std::uint32_t lane = lanes; lane != kLanes; ++lane) {
      for (auto& corner : four.corners) corner[lane] = corner[0];
    }
    const std::uint32_t other = set_up(four, run, strip);
    std::uint32_t first = 0;
    if (other != 0) [[unlikely]] {
      for (std::uint32_t lane = 0; lane != lanes; ++lane) {
        if ((other >> (4 * lane) & 1) == 0) continue;
        if (first != lane) draw_rows_mve(four.drawn + first, four.drawn + lane, depth_stride, colour_stride);
        first = lane + 1;
        const Triangle* const triangle = four.after[lane] - 1;
        if (!draw_other(run, *triangle)) return static_cast<std::uint32_t>(triangle - triangles);
      }
    }
    if (first != lanes) draw_rows_mve(four.drawn + first, four.drawn + lanes, depth_stride, colour_stride);
  }
  return count;
}

}  // namespace zstrip::detail

#endif
