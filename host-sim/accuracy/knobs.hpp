// The knobs that trade accuracy for time or memory: their names, their values, and settings, one value of each.
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

/// The first value is the default.
struct KnobInfo {
  Knob knob;
  std::string_view name;
  std::string_view meaning;
  std::vector<KnobValue> values;
};

/// In the order of Knob.
std::span<const KnobInfo> knobs();
const KnobInfo& info(Knob knob);

/// An index into KnobInfo::values for each knob; zeros are the defaults.
struct Settings {
  std::array<std::uint8_t, kKnobs> value{};
  std::uint8_t operator[](Knob knob) const { return value[static_cast<std::size_t>(knob)]; }
  std::uint8_t& operator[](Knob knob) { return value[static_cast<std::size_t>(knob)]; }
  std::string_view name_of(Knob knob) const { return info(knob).values[(*this)[knob]].name; }
  friend auto operator<=>(const Settings&,
                          const Settings&) = default;  // NOLINT(modernize-use-nullptr): clang 14 sees a 0 in it
};

/// With those strips that the default has: they change no pixel.
Settings without_strips(Settings settings);

/// The settings that are not the default's, "depth=z24,strips=8"; "default" where none is.
std::string to_text(const Settings& settings);
/// The reverse, of a part of them: a usage error names the nearest knob or value.
Result<Settings> parse_settings(std::string_view text);
/// Names separated by commas, or "all".
Result<std::vector<Knob>> parse_knobs(std::string_view text);

/// What the settings are to the renderer.
Effects extra_effects(const Settings& settings);  ///< beside those that the scene calls for
PixelFormat pixel_format(const Settings& settings);
/// The picture of this size, in the settings' format, dithered and with samples as in the settings.
View picture(const Settings& settings, const View& size);
/// Of the strips of a picture of `height` rows.
Budget budget(const Settings& settings, std::uint16_t height);
bool filters_bilinearly(const Settings& settings);
bool filters_mipmaps(const Settings& settings);
bool blends_edges(const Settings& settings);
/// Of 100, how many triangles a mesh keeps.
std::uint32_t detail_percent(const Settings& settings);

/// Which knobs change anything of a scene that calls for `effects`; `may_simplify`: it has a mesh that is worth it;
/// `textured_triangles`: textures are not on quadrics alone.
std::vector<Knob> knobs_for(Effects effects, bool may_simplify, bool textured_triangles);
/// Whether the renderer can draw with all of these at once: not every pair of values goes together.
bool agree(Effects effects);
/// The same, and each changes something.
bool possible(Effects effects);

/// The presets of docs/accuracy.md by their names: tiny, balanced, exact.
struct NamedSettings {
  std::string_view name;
  Settings settings;
};
std::span<const NamedSettings> named_settings();

}  // namespace zstrip::sim
