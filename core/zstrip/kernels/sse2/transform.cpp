// A vertex at a time: its three linear forms in one vector.
#include "zstrip/kernels/sse2/transform.hpp"

#include "zstrip/kernels/sse2/intrinsics.hpp"

#if ZSTRIP_HAS_SSE2

namespace zstrip::detail {
namespace {

/// The forms w, x and y, a word each. A coefficient a is 2^16 high + low, both signed, so that floor(a p / 2^16) is
/// high p + floor(low p / 2^16).
class Forms {
 public:
  explicit Forms(const CompiledInstance& instance) {
    const LinearForm* const forms[3] = {&instance.w, &instance.x, &instance.y};
    const auto each = [&forms](const auto& word_of) {
      return _mm_set_epi32(0, word_of(*forms[2]), word_of(*forms[1]), word_of(*forms[0]));
    };
    offset_ = each([](const LinearForm& f) { return f.offset; });
    high_xy_ = each([](const LinearForm& f) { return pair(high(f.x), high(f.y)); });
    high_z_ = each([](const LinearForm& f) { return pair(high(f.z), 0); });
    low_xy_ = each([](const LinearForm& f) { return pair(f.x, f.y); });
    low_z_ = each([](const LinearForm& f) { return pair(f.z, 0); });
  }

  __m128i at(const Position& p) const {
    std::int32_t both;
    __builtin_memcpy(&both, &p, sizeof both);
    const __m128i xy = _mm_set1_epi32(both);
    const __m128i z = _mm_set1_epi32(static_cast<std::uint16_t>(p.z));
    const __m128i ones = _mm_set1_epi16(1);
    const __m128i whole = _mm_add_epi32(_mm_madd_epi16(xy, high_xy_), _mm_madd_epi16(z, high_z_));
    const __m128i rest = _mm_add_epi32(_mm_madd_epi16(_mm_mulhi_epi16(xy, low_xy_), ones),
                                       _mm_madd_epi16(_mm_mulhi_epi16(z, low_z_), ones));
    return _mm_add_epi32(offset_, _mm_add_epi32(whole, rest));
  }

 private:
  static constexpr std::int32_t high(std::int32_t value) {
    return static_cast<std::int32_t>((std::int64_t{value} + 0x8000) >> 16);
  }
  static constexpr std::int32_t pair(std::int32_t low, std::int32_t high) {
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(high) << 16) |
                                     (static_cast<std::uint32_t>(low) & 0xFFFF));
  }

  __m128i offset_, high_xy_, high_z_, low_xy_, low_z_;
};

}  // namespace

bool transform_vertices_sse2(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                             std::uint32_t count, SnappedVertex* vertices) {
  const NarrowProjection<false> narrow(instance, origin);
  const Forms forms(instance);
  bool all_narrow = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    const __m128i at = forms.at(positions[i]);
    const std::int32_t w = _mm_cvtsi128_si32(at);
    const std::int32_t x = _mm_cvtsi128_si32(_mm_shuffle_epi32(at, 1));
    const std::int32_t y = _mm_cvtsi128_si32(_mm_shuffle_epi32(at, 2));
    if (!project_narrow<false>(narrow, instance, origin, x, y, w, vertices[i])) {
      vertices[i] = {kNotNarrow, 0, 0};
      all_narrow = false;
    }
  }
  return all_narrow;
}

}  // namespace zstrip::detail

#endif
