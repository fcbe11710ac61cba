// Transforms four vertices at a time. Only divisions are done one by one, while the previous four are finished.
#include "zstrip/kernels/vector/transform.hpp"

#include <algorithm>
#include <bit>

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/vector/vector.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {

using namespace vectors;

namespace {

/// Does the same as project_narrow for four vertices. All values that it reads are copies, because compilers must
/// assume that its stores change any memory.
class FourVertices {
 public:
  FourVertices(const CompiledInstance& instance, const RasterOrigin& origin)
      : FourVertices(instance, origin, NarrowProjection<false>(instance, origin)) {}

  /// Four vertices whose reciprocals are being computed: a processor divides while it executes other code.
  struct Begun {
    FourPositions at;
    Words w, reciprocals;
    Words normalisations;  ///< FourShifts::of
  };
  [[gnu::always_inline]] Begun begin(const Position* positions) const {
    const FourPositions at(positions);
    const Words w = w_.at(at);
    const Words divisors = w - as_words(w == Words{});  // w = 0 is not narrow, but must not be a divisor
    // reciprocal_of: the divisions come one after the other.
    const Normalised n[4] = {Normalised(divisors[0]), Normalised(divisors[1]), Normalised(divisors[2]),
                             Normalised(divisors[3])};
    const Words first = Words{n[0].quotient, n[1].quotient, n[2].quotient, n[3].quotient} << 14;
    const Words product = unsigned_upper_products(Words{n[0].divisor, n[1].divisor, n[2].divisor, n[3].divisor}, first);
    return {at, w, unsigned_upper_products(first, (in_all_words(kSign) - product) << 1) << 1,
            Words{n[0].shift, n[1].shift, n[2].shift, n[3].shift}};
  }
  /// Returns a mask that is 0 for vertices that are narrow.
  [[gnu::always_inline]] Words finish(const Begun& begun, SnappedVertex* vertices) const {
    const FourShifts shifts(begun.normalisations);
    const Words w = begun.w, reciprocals = begun.reciprocals;
    const auto coordinate = [&](const Coordinate& c) {
      const Words scaled = shifts.arithmetically(upper_products<0>(c.form.at(begun.at), reciprocals), c.shift);
      return settled(arithmetically_right(scaled + c.bias, 1));
    };
    const Words x = coordinate(x_), y = coordinate(y_);
    const Words relative = shifts.logically(reciprocals, depth_normalisation_);
    const Words depth = (unsigned_upper_products(relative, depth_scale_) << depth_shift_) - depth_offset_;

    const Words limit = in_all_words(kNarrowLimit);
    static_assert(2 * kNarrowLimit == 1 << 15);
    const Words outside = (((x + limit) | (y + limit)) >> 15) | greater(w - w_near_, w_range_);
    const Words narrow = as_words(outside == Words{});
    const Words place = (x & in_all_words(0xFFFF)) | (y << 16);
    const Words no_place = in_all_words(static_cast<std::uint16_t>(kNotNarrow));
    const Words snapped = (depth & in_all_words(~0x3FFFU)) | in_all_words(0x2000);  // snap_depth
    store_pairs(vertices, (place & narrow) | (no_place & ~narrow), snapped & narrow);
    return outside;
  }

 private:
  struct Coordinate {
    FormOfFour form;
    Words bias;
    std::int32_t shift;
  };

  FourVertices(const CompiledInstance& instance, const RasterOrigin& origin, const NarrowProjection<false>& narrow)
      : x_{FormOfFour(instance.x), in_all_words(static_cast<std::uint32_t>(narrow.bias_x)), narrow.shift_x},
        y_{FormOfFour(instance.y), in_all_words(static_cast<std::uint32_t>(narrow.bias_y)), narrow.shift_y},
        w_(instance.w),
        w_near_(in_all_words(narrow.w_near + kSign)),
        w_range_(in_all_words(narrow.w_range + kSign)),
        depth_scale_(in_all_words(instance.depth_scale)),
        depth_offset_(in_all_words(origin.depth_offset)),
        depth_shift_(instance.depth_shift),
        depth_normalisation_(instance.depth_normalisation) {}

  /// The values that reciprocal_of computes first.
  struct Normalised {
    std::uint32_t shift;  ///< FourShifts::of
    std::uint32_t divisor, quotient;

    explicit Normalised(std::uint32_t value) {
      if (value == 0) __builtin_unreachable();
      const int zeros = std::countl_zero(value);
      shift = FourShifts::of(zeros);
      divisor = value << zeros;
      quotient = quotient_32(divisor >> 16);
    }
  };
  /// Added to unsigned words, it makes signed words with the same order.
  static constexpr std::uint32_t kSign = std::uint32_t{1} << 31;

  Coordinate x_, y_;
  FormOfFour w_;
  Words w_near_, w_range_;  ///< from NarrowProjection, with kSign
  Words depth_scale_, depth_offset_;
  std::int32_t depth_shift_, depth_normalisation_;
};

}  // namespace

bool transform_vertices_vector(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                               std::uint32_t count, SnappedVertex* vertices) {
  const FourVertices four(instance, origin);
  Words outside{};
  std::uint32_t first = 0;
  FourVertices::Begun begun = four.begin(positions);
  for (;;) {
    // Some of the last four vertices may already be transformed.
    const std::uint32_t next = std::min(first + kVectorVertices, count - kVectorVertices);
    const FourVertices::Begun following = four.begin(positions + next);
    outside |= four.finish(begun, vertices + first);
    if (first == next) break;
    first = next, begun = following;
  }
  return !any_clear(as_halves(outside == Words{}));
}

}  // namespace zstrip::detail

#endif
