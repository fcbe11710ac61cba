// Depth in a pixel loop: the type of a cell, the conversion of a stepped value to a code, and the depth test. With z16
// and the default test this is "greater than the cell".
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/effects.hpp"
#include "zstrip/geometry/depth_mapping.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/visibility/method_state.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

/// The use of the z-buffer by a fragment.
enum class DepthUse : std::uint8_t {
  tested,   ///< drawn if it is nearer
  written,  ///< drawn without a test, because it is known to be nearer
  none,     ///< drawn without a z-buffer
  matched,  ///< drawn if its code equals the cell's, for a CSG operand
  layered,  ///< not drawn; see csg_layers.hpp
};

/// The effects that the pixel loops depend on. A structural type, so that it can be a template argument.
struct DepthMode {
  DepthFormat format = DepthFormat::z16;
  bool state = false;  ///< test, write and bias come from the material
  DepthUse use = DepthUse::tested;
  std::uint32_t methods = 0;  ///< Effects::methods
  bool counted = false;       ///< fragments are counted; only with methods

  friend constexpr bool operator==(const DepthMode&, const DepthMode&) = default;

  constexpr Effects method() const { return {0, methods}; }
  /// True if codes of different draws are compared. Both rasterisers cover the same pixels, but only the span
  /// rasteriser's codes do not depend on the shade.
  constexpr bool compares_codes() const { return use == DepthUse::matched || use == DepthUse::layered; }
  constexpr DepthMode with(DepthUse other) const { return {format, state, other, methods, counted}; }
};

constexpr DepthUse depth_use(Effects effects) {
  if (effects.has(effect::csg_layers)) return DepthUse::layered;
  if (effects.has(effect::csg_colours)) return DepthUse::matched;
  return methods::has_no_depth(effects) ? DepthUse::none : DepthUse::tested;
}

constexpr DepthMode depth_mode(Effects effects) {
  return {depth_format(effects), effects.has(effect::depth_state), depth_use(effects), effects.methods,
          effects.methods != 0 && effects.has(effect::statistics)};
}

/// Settings of depth modes other than the default, set once for each meshlet.
struct DepthSettings {
  DepthTest test = DepthTest::nearer;
  bool write = true;
  std::int32_t bias = 0;                        ///< codes
  Fixed slope_bias = 0;                         ///< 16.16
  std::int32_t bias_clamp = 0;                  ///< codes
  std::uint32_t smallest = 1, largest = 65534;  ///< a bias keeps codes within this range
};

/// True if fragments with these settings can only bring cells nearer, within the depths of their own vertices.
constexpr bool is_plain(const DepthSettings& settings) {
  return settings.test == DepthTest::nearer && settings.bias == 0 && settings.slope_bias == 0;
}

struct StripTargetWithDepth : StripTarget {
  DepthSettings settings;
};
struct StripTargetWithMethod : StripTargetWithDepth {
  MethodState* method;
};
struct CsgPass;
struct StripTargetWithLayers : StripTargetWithDepth {
  const CsgPass* pass;
};
template <DepthMode mode>
using TargetFor =
    std::conditional_t<mode.use == DepthUse::layered, StripTargetWithLayers,
                       std::conditional_t<mode.methods != 0, StripTargetWithMethod,
                                          std::conditional_t<mode.state, StripTargetWithDepth, StripTarget>>>;

template <DepthFormat format>
using DepthCell = std::conditional_t<depth_bytes(format) == 4, std::uint32_t, std::uint16_t>;

/// Converts near / w (0.32) to 16.16 codes of an octave of DepthFormat::float16; exact for the octave's snapped
/// vertices. Outside of the octave it continues the same line.
constexpr std::int64_t float16_depth(std::uint32_t near_over_w, std::uint32_t octave) {
  return ((std::int64_t{near_over_w} << 4) >> octave) + (std::int64_t{octave} << 29);
}

/// Converts depth in 1/2^32 of all codes (near / w for formats that store it) to the value that DepthRule steps.
template <DepthFormat format>
constexpr auto stepped_depth(std::uint32_t depth) {
  if constexpr (format == DepthFormat::z16) {
    return depth;
  } else if constexpr (format == DepthFormat::float16) {
    const std::uint32_t code = float16_code(depth);
    return (code == 0 ? 1U : code) << 16;
  } else {
    return std::uint64_t{depth} << kWideBits;
  }
}

template <DepthFormat format, class Value>
constexpr DepthCell<format> depth_code(Value value) {
  if constexpr (format == DepthFormat::z24) {
    return static_cast<std::uint32_t>(value >> kWideBits) >> 8;
  } else {
    return static_cast<std::uint16_t>(value >> 16);
  }
}

/// Returns a triangle's depth bias in codes; see docs/conventions.md. The vertices' codes have `bits` fraction bits.
template <class Vertex>
constexpr std::int64_t depth_bias(const DepthSettings& settings, const Vertex& v0, const Vertex& v1, const Vertex& v2,
                                  const std::int64_t (&codes)[3], int bits, std::int64_t area) {
  std::int64_t bias = std::int64_t{settings.bias} * kFixedOne;  // 16.16
  if (settings.slope_bias != 0) {
    const std::int64_t d1 = codes[1] - codes[0];
    const std::int64_t d2 = codes[2] - codes[0];
    const auto slope = [&](std::int64_t along) {  // per pixel, from the edge functions' numerator per sub-pixel
      if (along < 0) along = -along;
      const std::int64_t whole = along / area;
      if (whole >= std::int64_t{1} << (26 + bits)) return std::int64_t{1} << (30 + bits);
      return whole * 16 + along % area * 16 / area;
    };
    const std::int64_t steeper =
        std::max(slope(d1 * (v0.y - v2.y) + d2 * (v1.y - v0.y)), slope(d1 * (v0.x - v2.x) + d2 * (v1.x - v0.x)));
    const std::int64_t whole = steeper >> bits;
    const std::int64_t fraction = steeper & ((std::int64_t{1} << bits) - 1);
    bias += whole * settings.slope_bias + ((fraction * settings.slope_bias) >> bits);
  }
  const std::int64_t rounded = (bias + kFixedOne / 2) >> kFixedBits;
  if (settings.bias_clamp > 0) return std::min<std::int64_t>(rounded, settings.bias_clamp);
  if (settings.bias_clamp < 0) return std::max<std::int64_t>(rounded, settings.bias_clamp);
  return rounded;
}

/// The depth test and depth write of a triangle's fragments.
template <DepthMode mode>
class DepthRule {
 public:
  using Cell = DepthCell<mode.format>;
  /// True if the rule draws exactly the fragments whose code, the upper half of a word, is greater than the cell.
  static constexpr bool kNearerOnly = (mode.format == DepthFormat::z16 || mode.format == DepthFormat::float16) &&
                                      mode.use == DepthUse::tested && !mode.state && !mode.counted;

  constexpr DepthRule() = default;
  /// `area` is twice the signed area. Vertices have x, y in sub-pixels and the depth of project_depth.
  template <class Vertex>
  constexpr DepthRule(const TargetFor<mode>& target, const Vertex& v0, const Vertex& v1, const Vertex& v2,
                      std::int64_t area) {
    if constexpr (mode.counted) counted_.method = target.method;
    if constexpr (mode.state) {
      const DepthSettings& settings = target.settings;
      state_ = {static_cast<std::uint8_t>(settings.test), settings.write, 0, settings.smallest, settings.largest};
      if (settings.bias != 0 || settings.slope_bias != 0) {
        const std::int64_t codes[3] = {vertex_code(v0.depth), vertex_code(v1.depth), vertex_code(v2.depth)};
        const std::int64_t bias = depth_bias(settings, v0, v1, v2, codes, kVertexCodeBits, area);
        const std::int64_t limit = settings.largest;
        state_.bias = static_cast<std::int32_t>(std::clamp(bias, -limit, limit));
      }
    }
  }

  /// Returns the code without a bias.
  template <class Value>
  constexpr Cell code(Value value) const {
    return depth_code<mode.format>(value);
  }
  /// Returns true if a fragment of stepped depth `value` is drawn, and then stores it in the cell.
  template <class Value>
  constexpr bool draws(Value value, Cell& cell) const {
    const bool drawn = decides(value, cell);
    count_test();
    if (drawn) count_write(cell);
    return drawn;
  }
  /// Tests a fragment that may still be discarded. `kept` becomes the value that the cell would then hold.
  template <class Value>
  constexpr bool may_draw(Value value, Cell& kept) const {
    count_test();
    return decides(value, kept);
  }
  /// Call it after may_draw when the fragment is drawn. `writes`: the fragment hides what lies behind it.
  constexpr void drawn(Cell kept, bool writes, Cell& cell) const {
    if constexpr (mode.use != DepthUse::none) {
      if (writes) cell = kept;
    }
    count_write(cell);
  }

 private:
  template <class Value>
  constexpr bool decides(Value value, Cell& cell) const {
    if constexpr (mode.use == DepthUse::none) return true;
    Cell code = depth_code<mode.format>(value);
    if constexpr (mode.use == DepthUse::written) {
      cell = code;
      return true;
    } else if constexpr (mode.use == DepthUse::matched) {
      return code == cell;
    } else if constexpr (!mode.state) {
      const bool nearer = code > cell;
      if (nearer) cell = code;
      return nearer;
    } else {
      code = static_cast<Cell>(std::clamp(static_cast<std::int32_t>(code) + state_.bias,
                                          static_cast<std::int32_t>(state_.smallest),
                                          static_cast<std::int32_t>(state_.largest)));
      const auto relation = code > cell ? DepthTest::nearer : code == cell ? DepthTest::equal : DepthTest::farther;
      if ((state_.test & static_cast<std::uint8_t>(relation)) == 0) return false;
      if (state_.write) cell = code;
      return true;
    }
  }

  constexpr void count_test() const {
    if constexpr (mode.counted) {
      VisibilityStatistics& counts = *counted_.method->counts;
      if constexpr (mode.use == DepthUse::tested) ++counts.comparisons;
      if constexpr (mode.use == DepthUse::written) ++counts.untested;
    }
  }
  /// The cell's address identifies the pixel.
  constexpr void count_write([[maybe_unused]] const Cell& cell) const {
    if constexpr (mode.counted) {
      ++counted_.method->counts->writes;
      if constexpr (sizeof(Cell) == sizeof(std::uint16_t)) {
        if (counted_.method->overdraw == nullptr) return;
        std::uint8_t& times = counted_.method->overdraw[&cell - counted_.method->first_cell];
        if (times != 255) ++times;
      }
    }
  }

  struct State {
    std::uint8_t test = 0;  ///< bits of DepthTest
    bool write = true;
    std::int32_t bias = 0;  ///< codes, at most `largest` in magnitude
    std::uint32_t smallest = 1, largest = 0;
  };
  struct NoState {};
  struct Counted {
    MethodState* method = nullptr;
  };
  struct NotCounted {};

  static constexpr int kVertexCodeBits = mode.format == DepthFormat::z24 ? 8 : 16;
  constexpr std::int64_t vertex_code(std::uint32_t depth) const {
    if constexpr (mode.format == DepthFormat::float16) {
      return float16_depth(depth, float16_octave(depth));
    } else {
      return depth;
    }
  }

  [[no_unique_address]] std::conditional_t<mode.state, State, NoState> state_;
  [[no_unique_address]] std::conditional_t<mode.counted, Counted, NotCounted> counted_;
};

}  // namespace zstrip::detail
