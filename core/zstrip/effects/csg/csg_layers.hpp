// CSG does not draw the fragments of an operand: it peels them off into a layer, or counts them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/pixels/depth_rule.hpp"

namespace zstrip::detail {

/// One side of an operand, drawn over arrays with the strip's rows and columns: a layer of cells in place of the
/// z-buffer, and either the previous layer or counts.
struct CsgPass {
  const void* first_cell = nullptr;
  const void* before = nullptr;    ///< cells of the previous layer: the layer takes the nearest fragments behind it
  std::uint8_t* counts = nullptr;  ///< used instead of `before`; modulo 2^8, so that the order of triangles does not
                                   ///< matter
  std::uint8_t step = 0;           ///< added for each fragment
  bool behind = false;             ///< true: fragments behind the layer are counted; false: all other fragments are
};

template <DepthMode mode>
requires(mode.use == DepthUse::layered) class DepthRule<mode> {
  static constexpr DepthMode kPlain = mode.with(DepthUse::tested);

 public:
  using Cell = DepthCell<mode.format>;
  static constexpr bool kNearerOnly = false;

  template <class Vertex>
  constexpr DepthRule(const TargetFor<mode>& target, const Vertex& v0, const Vertex& v1, const Vertex& v2,
                      std::int64_t area)
      : plain_(target, v0, v1, v2, area), pass_(target.pass) {}

  /// Returns false, because nothing is drawn, but updates the layer or the count of the cell's pixel.
  template <class Value>
  bool draws(Value value, Cell& layer) const {
    const Cell code = plain_.code(value);
    const std::ptrdiff_t at = &layer - static_cast<const Cell*>(pass_->first_cell);
    if (pass_->counts != nullptr) {
      if ((code < layer) == pass_->behind)
        pass_->counts[at] = static_cast<std::uint8_t>(pass_->counts[at] + pass_->step);
    } else if (code > layer && code < static_cast<const Cell*>(pass_->before)[at]) {
      layer = code;
    }
    return false;
  }

 private:
  [[no_unique_address]] DepthRule<kPlain> plain_;
  const CsgPass* pass_;
};

}  // namespace zstrip::detail
