// The assembly behind transform.hpp: products of coordinates and coefficients by the halves of these, which wait
// in memory in the order of their use.
#include "zstrip/kernels/thumb1/transform.hpp"

#include <cstddef>

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1

static_assert(sizeof(LinearHalves) == 28 && offsetof(LinearHalves, offset) == 8);
static_assert(offsetof(HalvedTransform, x) == 0 && offsetof(HalvedTransform, y) == 28 &&
              offsetof(HalvedTransform, w) == 56);
static_assert(offsetof(HalvedTransform, w_near) == 84 && offsetof(HalvedTransform, w_range) == 88);
static_assert(offsetof(HalvedTransform, shift_x) == 92 && offsetof(HalvedTransform, bias_y) == 104);
static_assert(offsetof(HalvedTransform, depth_scale_low) == 108 && offsetof(HalvedTransform, depth_offset) == 124);

// r8 x and r9 y, r10 the next position, r11 the next vertex, r12 the normalisation of the last w, lr how many are left.
// On the stack: 0 the transform, 4 whether all so far are narrow, 8 the table of reciprocals for an index that begins
// at 256.
template <ReciprocalOf kind>
[[gnu::naked]] static bool transform(const HalvedTransform&, const Position*, std::uint32_t, SnappedVertex*,
                                     const std::uint16_t*);
template <>
[[gnu::naked]] bool transform<ReciprocalOf::newton>(const HalvedTransform&, const Position*, std::uint32_t,
                                                    SnappedVertex*, const std::uint16_t*) {
  asm(ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL ".set .Ltransform_reciprocal, 0\n"
#include "zstrip/kernels/thumb1/transform.inc"
      ZSTRIP_THUMB1_PURGE_RECIPROCAL ZSTRIP_THUMB1_POP);
}
template <>
[[gnu::naked]] bool transform<ReciprocalOf::quotient>(const HalvedTransform&, const Position*, std::uint32_t,
                                                      SnappedVertex*, const std::uint16_t*) {
  asm(ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL ".set .Ltransform_reciprocal, 1\n"
#include "zstrip/kernels/thumb1/transform.inc"
      ZSTRIP_THUMB1_PURGE_RECIPROCAL ZSTRIP_THUMB1_POP);
}
template <>
[[gnu::naked]] bool transform<ReciprocalOf::table>(const HalvedTransform&, const Position*, std::uint32_t,
                                                   SnappedVertex*, const std::uint16_t*) {
  asm(ZSTRIP_THUMB1_PUSH ZSTRIP_THUMB1_RECIPROCAL ".set .Ltransform_reciprocal, 2\n"
#include "zstrip/kernels/thumb1/transform.inc"
      ZSTRIP_THUMB1_PURGE_RECIPROCAL ZSTRIP_THUMB1_POP);
}

template <ReciprocalOf kind>
bool transform_vertices_thumb1(const HalvedTransform& instance, const Position* positions, std::uint32_t count,
                               SnappedVertex* vertices) {
  return transform<kind>(instance, positions, count, vertices, kReciprocalTable.data());
}
template bool transform_vertices_thumb1<ReciprocalOf::newton>(const HalvedTransform&, const Position*, std::uint32_t,
                                                              SnappedVertex*);
template bool transform_vertices_thumb1<ReciprocalOf::quotient>(const HalvedTransform&, const Position*, std::uint32_t,
                                                                SnappedVertex*);
template bool transform_vertices_thumb1<ReciprocalOf::table>(const HalvedTransform&, const Position*, std::uint32_t,
                                                             SnappedVertex*);

#endif

}  // namespace zstrip::detail
