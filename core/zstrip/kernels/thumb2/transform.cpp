// The assembly behind transform.hpp: the instance's numbers come in pairs from memory, in the order of their
// use, where GCC keeps some in registers and loads the rest one by one. Offsets are those of NarrowTransform.
#include "zstrip/kernels/thumb2/transform.hpp"

#include <cstddef>

#include "zstrip/base/division.hpp"
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
template <>
[[gnu::naked]] bool transform_vertices_thumb2<ReciprocalOf::newton>(const NarrowTransform&, const Position*,
                                                                    std::uint32_t, SnappedVertex*) {
  asm(".set .Ltransform_reciprocal, 0\n"
#include "zstrip/kernels/thumb2/transform.inc"
  );
}
template <>
[[gnu::naked]] bool transform_vertices_thumb2<ReciprocalOf::quotient>(const NarrowTransform&, const Position*,
                                                                      std::uint32_t, SnappedVertex*) {
  asm(".set .Ltransform_reciprocal, 1\n"
#include "zstrip/kernels/thumb2/transform.inc"
  );
}
// The same, with the table on the stack above the registers that are saved.
[[gnu::naked]] static bool transform_by_table(const NarrowTransform&, const Position*, std::uint32_t, SnappedVertex*,
                                              const std::uint16_t*) {
  asm(".set .Ltransform_reciprocal, 2\n"
#include "zstrip/kernels/thumb2/transform.inc"
  );
}
template <>
bool transform_vertices_thumb2<ReciprocalOf::table>(const NarrowTransform& transform, const Position* positions,
                                                    std::uint32_t count, SnappedVertex* vertices) {
  return transform_by_table(transform, positions, count, vertices, kReciprocalTable.data());
}

#endif

}  // namespace zstrip::detail
