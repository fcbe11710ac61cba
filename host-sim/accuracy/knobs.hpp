// The knobs that trade accuracy for time or memory: their names and values, and settings, which have one value of each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "result.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {

enum class Knob : std::uint8_t { depth, fit, shading, perspective, filter, detail, format, dither, strips, samples };
inline constexpr std::size_t kKnobs = 10;

struct KnobValue {
  std::string_view name;
  std::string_view meaning;  ///< one phrase
};

/// A knob; the first value is the default.
struct KnobInfo {
  Knob knob;
  std::string_view name;
  std::string_view meaning;
  std::vector<KnobValue> values;
};

/// In the order of Knob.
std::span<const KnobInfo> knobs();
const KnobInfo& info(Knob knob);

/// An index into KnobInfo::values for each knob; 0 is the default.
struct Settings {
  std::array<std::uint8_t, kKnobs> value{};
  std::uint8_t operator[](Knob knob) const { return value[static_cast<std::size_t>(knob)]; }
  std::uint8_t& operator[](Knob knob) { return value[static_cast<std::size_t>(knob)]; }
  std::string_view name_of(Knob knob) const { return info(knob).values[(*this)[knob]].name; }
  friend auto operator<=>(const Settings&,
                          const Settings&) = default;  // NOLINT(modernize-use-nullptr): clang 14 sees a 0 in it
};

/// Returns the settings with the default strips: strips change no pixel.
Settings without_strips(Settings settings);

/// Returns the settings that differ from the default, "depth=z24,strips=8"; "default" if none does.
std::string to_text(const Settings& settings);
/// Parses text of to_text, or a part of it; a usage error says the nearest knob or value.
Result<Settings> parse_settings(std::string_view text);
/// Parses names separated by commas, or "all".
Result<std::vector<Knob>> parse_knobs(std::string_view text);

/// Convert the settings to the renderer's types.
Effects extra_effects(const Settings& settings);  ///< in addition to those that the scene needs
PixelFormat pixel_format(const Settings& settings);
/// Returns a view of this size, with the format, dithering and samples of the settings.
View picture(const Settings& settings, const View& size);
/// Returns the budget with the strips of a picture of `height` rows.
Budget budget(const Settings& settings, std::uint16_t height);
bool filters_bilinearly(const Settings& settings);
bool filters_mipmaps(const Settings& settings);
bool blends_edges(const Settings& settings);
/// Returns the percentage of a mesh's triangles to keep.
std::uint32_t detail_percent(const Settings& settings);

/// Returns the knobs that can change a scene which needs `effects`. `may_simplify`: the scene has a mesh with enough
/// triangles; `textured_triangles`: the scene has textures on other objects than quadrics.
std::vector<Knob> knobs_for(Effects effects, bool may_simplify, bool textured_triangles);
/// True if the renderer can draw with all these effects at once: some pairs of values exclude each other.
bool agree(Effects effects);
/// True if the effects agree, and each of them changes something.
bool possible(Effects effects);

/// The presets of docs/accuracy.md by name: tiny, balanced, exact.
struct NamedSettings {
  std::string_view name;
  Settings settings;
};
std::span<const NamedSettings> named_settings();

}  // namespace zstrip::sim
