// Layers of CSG: what the fragments of an operand do that is not drawn, but peeled off, or counted.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/raster/depth_rule.hpp"

namespace zstrip::detail {

/// One side of an operand, drawn over arrays that have the strip's rows and columns: a layer of cells, in place of the
/// z-buffer, and either the layer before it or a count.
struct CsgPass {
  const void* first_cell = nullptr;  ///< of the layer
  const void* before = nullptr;      ///< cells: the layer takes the nearest fragments that are farther than these
  std::uint8_t* counts = nullptr;    ///< otherwise; modulo 2^8, so that no order of triangles is too much
  std::uint8_t step = 0;             ///< added for each fragment
  bool behind = false;               ///< those farther than the layer are counted; else all others
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

  /// Never, but the layer, or the count, of the cell's pixel is another then.
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
