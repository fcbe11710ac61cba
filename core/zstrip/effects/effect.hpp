// The interface of an effect to the rest of zstrip. A wing's Effect replaces what is not so for it.
#pragma once

#include <array>
#include <cstdint>

#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip {

/// As reports and options have it.
struct EffectName {
  Effects effect;
  const char* name;
  const char* called_for_by;  ///< what in a scene or a picture calls for it
};

/// Effects and visibility methods that do not go together: none of `one` with any of `other`.
struct Exclusion {
  Effects one, other;
  const char* why;  ///< a sentence's end: "... because"
};

}  // namespace zstrip

namespace zstrip::detail {

struct AnyEffect {
  /// Effects that no renderer can have together.
  static constexpr std::array<Exclusion, 0> kExclusions{};

  /// Effects that keep something in the arena from begin_frame to the strips, where a scene calls for one of them.
  static constexpr Effects kNeedMemory{};
  static constexpr std::uint32_t kAlignment = 4;  ///< of that memory: 4 or 8
  static constexpr std::uint64_t bytes(const SceneCounts&) { return 0; }
};

}  // namespace zstrip::detail
