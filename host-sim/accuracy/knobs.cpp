// The table of knobs.
#include "accuracy/knobs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "cli/nearest_name.hpp"
#include "compose/retired.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace zstrip::sim {
namespace {

const std::vector<KnobInfo>& table() {
  static const std::vector<KnobInfo> table{
      {Knob::depth,
       "depth",
       "how the z-buffer keeps depth",
       {{"z16", "16 bits, linear in 1/w"},
        {"float", "16 bits, 3.13 of near/w: needs no far bound"},
        {"z24", "24 bits in cells of 32"},
        {"ranges", "z16 in four sub-ranges: 14 bits, three clears of four saved"}}},
      {Knob::fit,
       "fit",
       "which distances the depth codes span",
       {{"fitted", "those that the scene can reach in this frame"}, {"fixed", "the camera's near to its far plane"}}},
      {Knob::shading,
       "shading",
       "colour within a triangle",
       {{"gouraud", "interpolated between the vertices"},
        {"flat", "that of the first vertex"},
        {"pixel", "lit at each pixel, by the normal there"}}},
      {Knob::perspective,
       "perspective",
       "pixels of a row from one pair of exact texture coordinates to the next",
       {{"16", "every 16th pixel"},
        {"affine", "only the triangle's corners"},
        {"8", "every 8th pixel"},
        {"1", "every pixel"}}},
      {Knob::filter,
       "filter",
       "how a texel is chosen",
       {{"nearest", "the one in which the pixel's centre lies"},
        {"bilinear", "the four around it, by their distance"},
        {"mipmapped", "the nearest of the smaller texture whose texels are about as large as pixels"},
        {"mipmapped_bilinear", "the four around it in that texture"}}},
      {Knob::detail,
       "detail",
       "percent of a mesh's triangles that are left (meshoptimizer)",
       {{"100", "all"}, {"50", "half"}, {"25", "a quarter"}, {"10", "a tenth"}}},
      {Knob::format,
       "format",
       "pixels of the display",
       {{"rgb565", "65,536 colours"}, {"gray4", "16 greys"}, {"mono", "black and white"}}},
      {Knob::dither,
       "dither",
       "mixes colours that the format lacks from neighbouring pixels",
       {{"off", "colours are cut"}, {"on", "by Bayer's matrix"}}},
      {Knob::strips,
       "strips",
       "rows of a strip: trades memory for time, changes no pixel",
       {{"16", "16 rows, geometry transformed again for each strip"},
        {"4", "4 rows"},
        {"8", "8 rows"},
        {"64", "64 rows"},
        {"whole", "the whole picture at once"},
        {"bins16", "16 rows, geometry transformed once and listed by strip"}}},
      {Knob::samples,
       "samples",
       "anti-aliasing: samples a pixel, whose mean is shown, or edges alone",
       {{"1", "one, in the pixel's middle"},
        {"2", "two side by side"},
        {"4", "two by two"},
        {"edges", "one, and edges of meshes are blended by how much of a pixel they cover"}}},
  };
  return table;
}

/// Returns the index of `word` among the names in `range`. The failure lists the names, and says the nearest name, or
/// the replacement of a removed one.
template <class Range>
Result<std::size_t> find_word(const Range& range, std::string_view word, std::string_view what) {
  std::vector<std::string_view> names;
  for (const auto& known : range) names.push_back(known.name);
  const auto found = std::ranges::find(names, word);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string_view instead = instead_of(word);
  const std::string hint = instead.empty() ? fmt::format("the nearest is '{}'", nearest_name(word, names))
                                           : fmt::format("it is gone, {}", instead);
  return Failure{ExitStatus::usage,
                 fmt::format("no {} is called '{}', {}; there are {}", what, word, hint, fmt::join(names, ", "))};
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    words.push_back(text.substr(0, comma));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return words;
}

}  // namespace

std::span<const KnobInfo> knobs() { return table(); }
const KnobInfo& info(Knob knob) { return table()[static_cast<std::size_t>(knob)]; }

Settings without_strips(Settings settings) {
  settings[Knob::strips] = 0;
  return settings;
}

std::string to_text(const Settings& settings) {
  std::string text;
  for (const KnobInfo& knob : knobs()) {
    if (settings[knob.knob] == 0) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", knob.name, settings.name_of(knob.knob));
  }
  return text.empty() ? "default" : text;
}

Result<Settings> parse_settings(std::string_view text) {
  Settings settings;
  for (const NamedSettings& named : named_settings()) {
    if (named.name == text) return named.settings;
  }
  if (text == "default") return settings;
  if (text.find_first_of("=,") == std::string_view::npos &&
      std::ranges::find(knobs(), text, &KnobInfo::name) == knobs().end()) {
    std::vector<std::string_view> names{"default"};
    for (const NamedSettings& named : named_settings()) names.push_back(named.name);
    return Failure{ExitStatus::usage, fmt::format("{} and KNOB=VALUE,...", unknown_value(text, names))};
  }
  std::set<Knob> set;
  for (const std::string_view word : split(text)) {
    const std::size_t equals = word.find('=');
    const Result<std::size_t> knob = find_word(knobs(), word.substr(0, equals), "knob");
    if (!knob) return knob.failure();
    const KnobInfo& found = knobs()[*knob];
    const std::string_view wanted = equals == std::string_view::npos ? "" : word.substr(equals + 1);
    const Result<std::size_t> value = find_word(found.values, wanted, fmt::format("value of {}", found.name));
    if (!value) return value.failure();
    if (!set.insert(found.knob).second) {
      return Failure{ExitStatus::usage, fmt::format("'{}' sets {} twice", text, found.name)};
    }
    settings[found.knob] = static_cast<std::uint8_t>(*value);
  }
  return settings;
}

Result<std::vector<Knob>> parse_knobs(std::string_view text) {
  std::vector<Knob> found;
  for (const std::string_view word : split(text)) {
    if (word == "all") {
      for (const KnobInfo& knob : knobs()) found.push_back(knob.knob);
      continue;
    }
    const Result<std::size_t> knob = find_word(knobs(), word, "knob");
    if (!knob) return knob.failure();
    found.push_back(knobs()[*knob].knob);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Effects extra_effects(const Settings& settings) {
  Effects effects{};
  const std::string_view depth = settings.name_of(Knob::depth);
  if (depth == "float") effects = effect::depth_float;
  if (depth == "z24") effects = effect::depth_24;
  if (depth == "ranges") effects = effect::depth_ranges;
  const std::string_view perspective = settings.name_of(Knob::perspective);
  if (perspective == "affine") effects = effects | effect::perspective_affine;
  if (perspective == "8") effects = effects | effect::perspective_8;
  if (perspective == "1") effects = effects | effect::perspective_1;
  if (filters_bilinearly(settings)) effects = effects | effect::bilinear;
  if (filters_mipmaps(settings)) effects = effects | effect::mipmaps;
  if (settings.name_of(Knob::strips) == "bins16") effects = effects | effect::bins;
  if (blends_edges(settings)) effects = effects | effect::edges;
  return effects | effects_of(picture(settings, {}));
}

PixelFormat pixel_format(const Settings& settings) {
  const std::string_view format = settings.name_of(Knob::format);
  if (format == "gray4") return PixelFormat::gray4;
  return format == "mono" ? PixelFormat::mono : PixelFormat::rgb565;
}

View picture(const Settings& settings, const View& size) {
  constexpr std::array<std::uint8_t, 4> kSamples{1, 2, 4, 1};
  return {size.width, size.height, pixel_format(settings), settings.name_of(Knob::dither) == "on",
          kSamples[settings[Knob::samples]]};
}

Budget budget(const Settings& settings, std::uint16_t height) {
  const std::string_view strips = settings.name_of(Knob::strips);
  std::uint16_t rows = 16;
  if (strips == "4") rows = 4;
  if (strips == "8") rows = 8;
  if (strips == "64") rows = 64;
  if (strips == "whole") rows = height;
  return {.strip_rows = std::min(rows, height), .modes = strips == "bins16" ? Modes::binned : Modes::streamed};
}

bool filters_bilinearly(const Settings& settings) {
  const std::string_view filter = settings.name_of(Knob::filter);
  return filter == "bilinear" || filter == "mipmapped_bilinear";
}
bool filters_mipmaps(const Settings& settings) {
  const std::string_view filter = settings.name_of(Knob::filter);
  return filter == "mipmapped" || filter == "mipmapped_bilinear";
}

bool blends_edges(const Settings& settings) { return settings.name_of(Knob::samples) == "edges"; }

std::uint32_t detail_percent(const Settings& settings) {
  constexpr std::array<std::uint32_t, 4> kPercent{100, 50, 25, 10};
  return kPercent[settings[Knob::detail]];
}

std::vector<Knob> knobs_for(Effects effects, bool may_simplify, bool textured_triangles) {
  std::vector<Knob> found;
  for (const KnobInfo& knob : knobs()) {
    if (knob.knob == Knob::shading && !effects.has(effect::gouraud)) continue;
    // Fragments with effects always have exact texture coordinates at every 16th pixel.
    if (knob.knob == Knob::perspective &&
        (!textured_triangles || effects.has(effect::orthographic) || effects.any(effect::fragments)))
      continue;
    if (knob.knob == Knob::filter && (!textured_triangles || effects.has(effect::bilinear))) continue;
    if (knob.knob == Knob::detail && !may_simplify) continue;
    found.push_back(knob.knob);
  }
  return found;
}

bool agree(Effects effects) {
  if (!effects_agree(effects) || effects.has(effect::bins | effect::depth_ranges)) return false;
  if (effects.has(effect::edges) && effects.any(effect::outlines | effect::csg)) return false;
  const bool runs =
      effects.any(effect::perspective_runs) && effects.has(effect::textures) && !effects.has(effect::orthographic);
  // Libraries for programs that choose at run time have no pipeline with both.
  return !(runs && effects.any(effect::depth_formats | effect::depth_ranges));
}

bool possible(Effects effects) {
  if (!agree(effects)) return false;
  // Fragments with effects have exact texture coordinates at every 16th pixel.
  if (effects.any(effect::fragments) && effects.any(effect::perspective_runs)) return false;
  return !(effects.any(effect::perspective_runs) && effects.any(effect::depth_formats | effect::depth_ranges));
}

std::span<const NamedSettings> named_settings() {
  static const std::array<NamedSettings, 3> named = [] {
    Settings tiny, exact;
    tiny[Knob::shading] = 1;       // flat
    tiny[Knob::strips] = 1;        // 4 rows
    tiny[Knob::detail] = 1;        // half
    exact[Knob::perspective] = 3;  // every pixel
    return std::array<NamedSettings, 3>{{{"tiny", tiny}, {"balanced", Settings{}}, {"exact", exact}}};
  }();
  return named;
}

}  // namespace zstrip::sim
