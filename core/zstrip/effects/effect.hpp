// The interface between an effect and the rest of zstrip. A wing's Effect overrides the members that differ.
#pragma once

#include <array>
#include <cstdint>

#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip {

/// The name in reports and options.
struct EffectName {
  Effects effect;
  const char* name;
  const char* called_for_by;  ///< the part of a scene or a picture that needs it
};

/// Effects and visibility methods that exclude each other: none of `one` with any of `other`.
struct Exclusion {
  Effects one, other;
  const char* why;  ///< the end of a sentence: "... because"
};

}  // namespace zstrip

namespace zstrip::detail {

struct AnyEffect {
  /// Effects that exclude each other in every renderer.
  static constexpr std::array<Exclusion, 0> kExclusions{};

  /// Effects that keep data in the arena from begin_frame to the strips, if a scene needs one of them.
  static constexpr Effects kNeedMemory{};
  static constexpr std::uint32_t kAlignment = 4;  ///< alignment of that memory: 4 or 8
  static constexpr std::uint64_t bytes(const SceneCounts&) { return 0; }
};

}  // namespace zstrip::detail
