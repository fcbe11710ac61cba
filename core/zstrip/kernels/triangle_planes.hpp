// Kernel: the planes of a triangle that is drawn span by span. Words of 32 bits suffice for most, and give the same
// bits as PlaneSetup.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/kernels/thumb1/medium_planes.hpp"
#include "zstrip/pixels/plane.hpp"

namespace zstrip::detail {

/// Planes in words of 32 bits. plane() is not inlined: a triangle calls it up to a dozen times. If `Owner` is a type of
/// an unnamed namespace, the function is local, too, and its callers keep values in the registers that it leaves alone.
template <class Owner>
class CalledPlanes : public MediumPlanes {
 public:
  using MediumPlanes::MediumPlanes;
  [[gnu::noinline]] Plane plane(std::int32_t value_0, std::int32_t d1, std::int32_t d2) const {
    return MediumPlanes::plane(value_0, d1, d2);
  }
};
template <class Owner>
using WordPlanes = std::conditional_t<kHasThumb1, ThumbPlanes,
                                      std::conditional_t<kMultipliesLonger, MediumPlanes, CalledPlanes<Owner>>>;

/// Has the functions of PlaneSetup. The vertices must outlive it.
class WordOrLongPlanes {
 public:
  using Value = std::int64_t;
  WordOrLongPlanes(const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2, std::int64_t area,
                   std::int32_t anchor_x, std::int32_t anchor_y);

  Plane plane(std::int64_t value_0, std::int64_t from_0_to_1, std::int64_t from_0_to_2) const {
    const auto is_word = [](std::int64_t value) { return value == static_cast<std::int32_t>(value); };
    if (!fits_words_ || !is_word(from_0_to_1) || !is_word(from_0_to_2)) [[unlikely]]
      return long_plane(value_0, from_0_to_1, from_0_to_2);
    return words_.plane(static_cast<std::int32_t>(value_0), static_cast<std::int32_t>(from_0_to_1),
                        static_cast<std::int32_t>(from_0_to_2));
  }
  /// True if planes are computed in words, unless a difference needs more.
  bool in_words() const { return fits_words_; }
  WidePlane wide_plane(std::int64_t value_0, std::int64_t from_0_to_1, std::int64_t from_0_to_2) const {
    return setup().wide_plane(value_0, from_0_to_1, from_0_to_2);
  }

 private:
  PlaneSetup setup() const { return PlaneSetup(v0_, v1_, v2_, area_, anchor_x_, anchor_y_); }
  Plane long_plane(std::int64_t value_0, std::int64_t from_0_to_1, std::int64_t from_0_to_2) const;

  const RasterVertex &v0_, &v1_, &v2_;
  std::int64_t area_;
  std::int32_t anchor_x_, anchor_y_;
  WordPlanes<void> words_;  ///< set if fits_words_
  bool fits_words_;
};

/// With -Os one arithmetic serves all triangles.
using TrianglePlanes = std::conditional_t<sizeof(void*) == 4 && !kForSize, WordOrLongPlanes, PlaneSetup>;

}  // namespace zstrip::detail
