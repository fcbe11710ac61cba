// Finds errors and memory of all settings on this machine; times only the cheapest candidates on the target.
#include "accuracy/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "accuracy/campaign.hpp"
#include "render/parallel.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxTimed = 10;

struct Candidate {
  Settings settings;
  Errors errors;
  std::uint64_t ram = 0, flash = 0;
  double expected_time = 0;  ///< if the knobs' savings were independent of each other
};

bool within(double value, const std::optional<double>& limit) { return !limit || value <= *limit; }

struct Checks {
  bool wrong_pixels, perceived, ram, flash;
  bool all() const { return wrong_pixels && perceived && ram && flash; }
};
Checks checked(const Candidate& c, const Limits& limits) {
  return {within(c.errors[Figure::wrong_pixels], limits.wrong_pixels),
          within(c.errors[Figure::perceived], limits.perceived), !limits.ram || c.ram <= *limits.ram,
          !limits.flash || c.flash <= *limits.flash};
}

/// Returns the knobs to choose from. The display's format is given. More samples a pixel and dithering only cost, and
/// do not make surfaces more correct: they are used if there is a limit on the perceived error.
std::vector<Knob> choices(const AccuracyScene& scene, const Limits& limits) {
  std::vector<Knob> knobs = scene.knobs();
  std::erase_if(knobs, [&](Knob knob) {
    const bool looks = knob == Knob::samples || knob == Knob::dither;
    return knob == Knob::format || (looks && !limits.perceived);
  });
  return knobs;
}

/// Returns all settings to examine.
Result<std::vector<Settings>> settings_to_tune(const AccuracyScene& scene, const Limits& limits,
                                               std::string_view format) {
  const Result<Settings> of_format = parse_settings(fmt::format("format={}", format));
  if (!of_format) return of_format.failure();
  return all_settings(scene, choices(scene, limits), *of_format);
}

/// Returns the best `value` among the candidates that hold the other limits; nothing if there are none.
template <class Value, class Holds>
std::optional<double> best_of(const std::vector<Candidate>& candidates, const Value& value, const Holds& holds) {
  std::optional<double> best;
  for (const Candidate& c : candidates) {
    if (holds(c) && (!best || value(c) < *best)) best = value(c);
  }
  return best;
}

std::vector<std::string> explain(const std::vector<Candidate>& candidates, const Limits& limits) {
  std::vector<std::string> lines;
  const auto say = [&](bool asked, std::string_view name, double limit, auto value, auto holds, std::string_view unit) {
    if (!asked) return;
    const std::optional<double> best = best_of(candidates, value, holds);
    if (!best) return;
    if (*best > limit) {
      const auto number = [&](double amount) {
        return unit == "bytes" ? grouped(static_cast<std::uint64_t>(amount)) : fmt::format("{:.3g}", amount);
      };
      lines.push_back(fmt::format("{}: {} {} asked for, {} is the least within the other limits, {} too much", name,
                                  number(limit), unit, number(*best), number(*best - limit)));
    }
  };
  say(
      limits.wrong_pixels.has_value(), "--max-error-pixels", limits.wrong_pixels.value_or(0),
      [](const Candidate& c) { return c.errors[Figure::wrong_pixels]; },
      [&](const Candidate& c) {
        const Checks k = checked(c, limits);
        return k.perceived && k.ram && k.flash;
      },
      "%");
  say(
      limits.perceived.has_value(), "--max-perceived", limits.perceived.value_or(0),
      [](const Candidate& c) { return c.errors[Figure::perceived]; },
      [&](const Candidate& c) {
        const Checks k = checked(c, limits);
        return k.wrong_pixels && k.ram && k.flash;
      },
      "units");
  say(
      limits.ram.has_value(), "--max-ram", limits.ram.value_or(0),
      [](const Candidate& c) { return static_cast<double>(c.ram); },
      [&](const Candidate& c) {
        const Checks k = checked(c, limits);
        return k.wrong_pixels && k.perceived && k.flash;
      },
      "bytes");
  say(
      limits.flash.has_value(), "--max-flash", limits.flash.value_or(0),
      [](const Candidate& c) { return static_cast<double>(c.flash); },
      [&](const Candidate& c) {
        const Checks k = checked(c, limits);
        return k.wrong_pixels && k.perceived && k.ram;
      },
      "bytes");
  if (lines.empty()) lines.emplace_back("each limit can be met, but not all of them by the same settings");
  return lines;
}

/// Returns the C++ names of the effects that settings add.
std::string effect_names(const Settings& settings) {
  std::string names;
  const auto add = [&](std::string_view name) { names += fmt::format(" | zstrip::effect::{}", name); };
  const std::string_view depth = settings.name_of(Knob::depth);
  if (depth == "float") add("depth_float");
  if (depth == "z24") add("depth_24");
  if (depth == "ranges") add("depth_ranges");
  const std::string_view perspective = settings.name_of(Knob::perspective);
  if (perspective != "16") add(fmt::format("perspective_{}", perspective));
  if (settings.name_of(Knob::strips) == "bins16") add("bins");
  if (blends_edges(settings)) add("edges");
  return names;
}

}  // namespace

Result<std::vector<std::string>> programs_to_tune(const AccuracyScene& scene, const Limits& limits,
                                                  std::string_view format) {
  const Result<std::vector<Settings>> settings = settings_to_tune(scene, limits, format);
  if (!settings) return settings.failure();
  return programs_for(scene, *settings);
}

std::optional<double> frames_per_second(const AccuracyPoint& point) {
  if (!point.cost.instructions) return 1e9 / point.cost.nanoseconds;
  return point.cost.least_fps;
}

Result<Tuned> tune(const AccuracyScene& scene, const Limits& limits, std::string_view format, unsigned jobs,
                   const std::function<void(std::size_t, std::size_t)>& progress) {
  const Result<std::vector<Settings>> all_to_tune = settings_to_tune(scene, limits, format);
  if (!all_to_tune) return all_to_tune.failure();
  const std::vector<Settings>& settings = *all_to_tune;
  std::vector<Settings> pictures;
  for (const Settings& s : settings) {
    if (without_strips(s) == s) pictures.push_back(s);
  }
  // The default and each knob alone are timed first; the others can then be sorted by expected time.
  std::vector<Settings> alone;
  for (const Settings& s : settings) {
    const auto turned = std::ranges::count_if(s.value, [](std::uint8_t v) { return v != 0; });
    if (turned - (s[Knob::format] != 0 ? 1 : 0) <= 1) alone.push_back(s);
  }
  const std::size_t all = pictures.size() + alone.size() + kMaxTimed;
  std::size_t done = 0;
  std::mutex mutex;
  std::map<Settings, Errors> errors;
  const Result<Done> drawn =
      for_each_on_threads(static_cast<std::uint32_t>(pictures.size()), jobs, [&](unsigned, std::uint32_t i) {
        const Result<Errors> found = scene.errors(pictures[i]);
        if (!found) return Result<Done>(found.failure());
        const std::scoped_lock lock(mutex);
        errors[pictures[i]] = *found;
        progress(++done, all);
        return Result<Done>(Done{});
      });
  if (!drawn) return drawn.failure();
  std::map<Settings, Cost> costs;
  const auto time_all = [&](const std::vector<Settings>& wanted) {
    return for_each_on_threads(static_cast<std::uint32_t>(wanted.size()), jobs, [&](unsigned, std::uint32_t i) {
      const Result<Cost> found = scene.cost(wanted[i]);
      if (!found) return Result<Done>(found.failure());
      const std::scoped_lock lock(mutex);
      costs[wanted[i]] = *found;
      progress(++done, all);
      return Result<Done>(Done{});
    });
  };
  if (const Result<Done> timed = time_all(alone); !timed) return timed.failure();

  const auto point_of = [&](const Settings& s) {
    return AccuracyPoint{.scene = scene.request().scene,
                         .target = scene.request().target,
                         .settings = s,
                         .part = "tune",
                         .errors = errors.at(without_strips(s)),
                         .cost = costs.at(s)};
  };
  const Settings& standard = settings.front();
  const double standard_time = time_of(point_of(standard));
  std::vector<Candidate> candidates;
  for (const Settings& s : settings) {
    const Result<MemoryCost> memory = scene.memory(s);
    if (!memory) return memory.failure();
    Candidate candidate{s, errors.at(without_strips(s)), memory->ram_bytes, memory->scene_bytes, standard_time};
    for (const Knob knob : choices(scene, limits)) {
      if (s[knob] == 0) continue;
      Settings single = standard;
      single[knob] = s[knob];
      candidate.expected_time *= time_of(point_of(single)) / standard_time;
    }
    candidates.push_back(candidate);
  }
  Tuned tuned;
  tuned.candidates = candidates.size();
  std::vector<Candidate> fine;
  std::ranges::copy_if(candidates, std::back_inserter(fine),
                       [&](const Candidate& c) { return checked(c, limits).all(); });
  if (fine.empty()) {
    tuned.broken = explain(candidates, limits);
    tuned.timed = costs.size();
    return tuned;
  }
  std::ranges::stable_sort(fine, {}, &Candidate::expected_time);
  if (fine.size() > kMaxTimed) fine.resize(kMaxTimed);
  std::vector<Settings> wanted;
  for (const Candidate& c : fine) {
    if (!costs.contains(c.settings)) wanted.push_back(c.settings);
  }
  if (const Result<Done> timed = time_all(wanted); !timed) return timed.failure();
  tuned.timed = costs.size();
  std::optional<AccuracyPoint> fastest;
  for (const Candidate& c : fine) {
    const AccuracyPoint point = point_of(c.settings);
    if (!fastest || time_of(point) < time_of(*fastest)) fastest = point;
  }
  const std::optional<double> fps = frames_per_second(*fastest);
  if (limits.frames && (!fps || *fps < *limits.frames)) {
    tuned.broken.push_back(
        fps ? fmt::format(
                  "--min-fps: {:.4g} asked for, {:.4g} is the most within the other limits ({}), {:.4g} too few",
                  *limits.frames, *fps, to_text(fastest->settings), *limits.frames - *fps)
            : fmt::format("--min-fps: the board has too little RAM for the fastest settings ({}); give --max-ram",
                          to_text(fastest->settings)));
    return tuned;
  }
  tuned.best = fastest;
  return tuned;
}

std::string quality_toml(const AccuracyPoint& point) {
  std::string text = "[quality]\n";
  for (const KnobInfo& knob : knobs())
    text += fmt::format("{} = \"{}\"\n", knob.name, point.settings.name_of(knob.knob));
  return text;
}

std::string quality_json(const AccuracyPoint& point) {
  nlohmann::json object;
  for (const KnobInfo& knob : knobs()) object["quality"][std::string(knob.name)] = point.settings.name_of(knob.knob);
  object["point"] = nlohmann::json::parse(point_json(point));
  return object.dump(1) + "\n";
}

std::string quality_header(const AccuracyPoint& point, const View& size) {
  const Budget strips = budget(point.settings, size.height);
  const std::string_view shading = point.settings.name_of(Knob::shading);
  const View shown = picture(point.settings, size);
  return fmt::format(
      "// Written by zstrip tune for {} on {}: {}.\n"
      "#pragma once\n\n"
      "#include \"zstrip/budget.hpp\"\n#include \"zstrip/effects.hpp\"\n#include "
      "\"zstrip/scene.hpp\"\n#include \"zstrip/view.hpp\"\n\n"
      "namespace quality {{\n\n"
      "inline constexpr zstrip::View kView{{{}, {}, zstrip::PixelFormat::{}, {}, {}}};\n"
      "/// In addition to the scene's effects: Renderer<effects_of(scene, camera) | quality::kEffects>.\n"
      "inline constexpr zstrip::Effects kEffects = zstrip::effects_of(kView){};\n"
      "inline constexpr zstrip::Budget kBudget{{.strip_rows = {}, .modes = zstrip::Modes::{}}};\n"
      "/// For Camera::fixed_depth_range.\n"
      "inline constexpr bool kFixedDepthRange = {};\n"
      "/// For Material::smooth of all materials.\n"
      "inline constexpr zstrip::Shading kSmooth = zstrip::Shading::{};\n"
      "/// For Finish::filter of all textured materials: TextureFilter::bilinear.\n"
      "inline constexpr bool kBilinear = {};\n"
      "/// For zstrip bake: --mipmaps on.\n"
      "inline constexpr bool kMipmaps = {};\n"
      "/// For zstrip bake: --edges.\n"
      "inline constexpr bool kEdges = {};\n"
      "/// Percentage of the triangles that stay when the meshes are baked.\n"
      "inline constexpr int kDetailPercent = {};\n\n"
      "}}  // namespace quality\n",
      point.scene, point.target, to_text(point.settings), size.width, size.height,
      shown.format == PixelFormat::gray4  ? "gray4"
      : shown.format == PixelFormat::mono ? "mono"
                                          : "rgb565",
      shown.dither, shown.samples, effect_names(point.settings), strips.strip_rows,
      strips.modes == Modes::binned ? "binned" : "streamed", point.settings.name_of(Knob::fit) == "fixed", shading,
      filters_bilinearly(point.settings), filters_mipmaps(point.settings), blends_edges(point.settings),
      detail_percent(point.settings));
}

}  // namespace zstrip::sim
