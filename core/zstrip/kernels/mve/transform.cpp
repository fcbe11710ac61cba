// Does the same as project_narrow for four vertices. Only the quotients are computed one by one.
#include "zstrip/kernels/mve/transform.hpp"

#include <algorithm>

#include "zstrip/base/division.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/kernels/mve/vectors.hpp"

#if ZSTRIP_HAS_MVE

namespace zstrip::detail {
namespace {

/// LinearForm::at for coordinates times 2^15: the instruction doubles products, so that floor(a p / 2^16) is the upper
/// word of 2 a 2^15 p.
[[gnu::always_inline]] inline int32x4_t at(const LinearForm& form, int32x4_t x, int32x4_t y, int32x4_t z) {
  const int32x4_t sum = vaddq_s32(vqdmulhq_n_s32(x, form.x), vqdmulhq_n_s32(y, form.y));
  return vaddq_n_s32(vaddq_s32(sum, vqdmulhq_n_s32(z, form.z)), form.offset);
}

/// Returns floor((2^32 - 1) / d) for each word.
[[gnu::always_inline]] inline uint32x4_t quotients(uint32x4_t d) {
  return uint32x4_t{quotient_32(vgetq_lane_u32(d, 0)), quotient_32(vgetq_lane_u32(d, 1)),
                    quotient_32(vgetq_lane_u32(d, 2)), quotient_32(vgetq_lane_u32(d, 3))};
}

}  // namespace

bool transform_vertices_mve(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                            std::uint32_t count, SnappedVertex* vertices) {
  const NarrowProjection<false> narrow(instance, origin);
  const uint32x4_t offsets = vmulq_n_u32(vidupq_n_u32(0, 1), sizeof(Position));
  std::uint32_t outside = 0;
  for (std::uint32_t first = 0;;) {
    const Position* const p = positions + first;
    const auto coordinate = [&](const std::int16_t* of) {
      return vshlq_n_s32(vldrhq_gather_offset_s32(of, offsets), 15);
    };
    const int32x4_t px = coordinate(&p->x), py = coordinate(&p->y), pz = coordinate(&p->z);
    const uint32x4_t w = vreinterpretq_u32_s32(at(instance.w, px, py, pz));
    mve_pred16_t wide = vcmphiq_n_u32(vsubq_n_u32(w, narrow.w_near), narrow.w_range);
    // reciprocal_of. A w of 0 is not narrow, but must not be a divisor: the highest bit of divisors is set, anyway.
    const int32x4_t normalisation = vreinterpretq_s32_u32(vclzq_u32(w));
    const uint32x4_t divisor = vshlq_u32(w, normalisation);
    const uint32x4_t quotient = vshlq_n_u32(quotients(vorrq_n_u32(vshrq_n_u32(divisor, 16), 0x8000)), 14);
    // (2^31 - product) << 1, modulo 2^32
    const int32x4_t correction = vnegq_s32(vshlq_n_s32(vreinterpretq_s32_u32(vmulhq_u32(divisor, quotient)), 1));
    const uint32x4_t reciprocal = vshlq_n_u32(vmulhq_u32(quotient, vreinterpretq_u32_s32(correction)), 1);
    const auto projected = [&](const LinearForm& form, std::int32_t shift, std::int32_t bias) {
      const int32x4_t high = vmulhq_s32(at(form, px, py, pz), vreinterpretq_s32_u32(reciprocal));
      const int32x4_t scaled = vshlq_s32(high, vsubq_n_s32(normalisation, shift));
      return vshrq_n_s32(vaddq_n_s32(scaled, bias), 1);
    };
    const int32x4_t x = projected(instance.x, narrow.shift_x, narrow.bias_x);
    const int32x4_t y = projected(instance.y, narrow.shift_y, narrow.bias_y);
    const uint32x4_t range =
        vreinterpretq_u32_s32(vorrq_s32(vaddq_n_s32(x, kNarrowLimit), vaddq_n_s32(y, kNarrowLimit)));
    wide |= vcmpcsq_n_u32(range, 2 * kNarrowLimit);
    const uint32x4_t relative = vshlq_u32(reciprocal, vsubq_n_s32(normalisation, instance.depth_normalisation));
    uint32x4_t depth = vshlq_r_u32(vmulhq_u32(relative, vdupq_n_u32(instance.depth_scale)), instance.depth_shift);
    depth = vsubq_n_u32(depth, origin.depth_offset);
    // snap_depth
    depth = vorrq_n_u32(vbicq_n_u32(vbicq_n_u32(depth, 0xFF), 0x3F00), 0x2000);
    uint32x4_t place = vsliq_n_u32(vreinterpretq_u32_s32(x), vreinterpretq_u32_s32(y), 16);
    if (wide != 0) [[unlikely]] {
      outside |= wide;
      place = vpselq_u32(vdupq_n_u32(static_cast<std::uint16_t>(kNotNarrow)), place, wide);
      depth = vpselq_u32(vdupq_n_u32(0), depth, wide);
    }
    // Not vst2q_u32, for which GCC copies both vectors through the stack.
    const uint32x4_t to = vidupq_n_u32(0, sizeof(SnappedVertex));
    auto* const words = reinterpret_cast<std::uint32_t*>(vertices + first);
    vstrwq_scatter_offset_u32(words, to, place);
    vstrwq_scatter_offset_u32(words + 1, to, depth);
    // Some of the last four vertices may already be transformed.
    const std::uint32_t next = std::min(first + kMveVertices, count - kMveVertices);
    if (next == first) break;
    first = next;
  }
  return outside == 0;
}

}  // namespace zstrip::detail

#endif
