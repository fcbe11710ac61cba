// Chooses settings, measures the points that the journal does not have, and finds the front.
#include "accuracy/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>

#include "accuracy/board_cost.hpp"
#include "bench/board_bench.hpp"
#include "render/parallel.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxCombinations = 160;
// Times on this machine vary by this much from run to run.
constexpr double kNoise = 0.03;

std::size_t changes(const Settings& settings) {
  return static_cast<std::size_t>(std::ranges::count_if(settings.value, [](std::uint8_t v) { return v != 0; }));
}

/// Returns the fingerprint of all programs that take part in the measurement.
Result<std::uint32_t> fingerprint_of(const AccuracyRequest& request, Effects effects) {
  if (request.target == "host") return fingerprint({});
  BenchCase bench_case;
  bench_case.target = request.target;
  bench_case.program = board_program_name(request.target, effects);
  const Result<std::filesystem::path> program = board_program(bench_case, request.firmware);
  if (!program) return program.failure();
  return fingerprint(*program);
}

class Measuring {
 public:
  Measuring(const AccuracyScene& scene, unsigned jobs, Journal& journal, Campaign& campaign,
            const std::function<void(std::size_t, std::size_t)>& progress)
      : scene_(scene), jobs_(jobs), journal_(journal), campaign_(campaign), progress_(progress) {}

  Result<Done> measure(const std::vector<Settings>& wanted, const char* part, std::size_t all) {
    return for_each_on_threads(static_cast<std::uint32_t>(wanted.size()), jobs_, [&](unsigned, std::uint32_t index) {
      Result<AccuracyPoint> point = measure_one(wanted[index]);
      if (!point) return Result<Done>(point.failure());
      point->part = part;
      const std::scoped_lock lock(mutex_);
      campaign_.points.push_back(std::move(*point));
      progress_(campaign_.points.size(), all);
      return Result<Done>(Done{});
    });
  }

 private:
  Result<AccuracyPoint> measure_one(const Settings& settings) {
    const AccuracyRequest& request = scene_.request();
    const Result<std::uint32_t> programs = fingerprint_once(settings);
    if (!programs) return programs.failure();
    const std::string key = journal_key(request, settings, *programs);
    {
      const std::scoped_lock lock(mutex_);
      if (const std::optional<AccuracyPoint> known = journal_.find(key)) return *known;
    }
    AccuracyPoint point{
        .scene = request.scene, .target = request.target, .settings = settings, .part = "", .errors = {}, .cost = {}};
    const Result<Errors> errors = scene_.errors(settings);
    if (!errors) return errors.failure();
    point.errors = *errors;
    const Result<Cost> cost = scene_.cost(settings);
    if (!cost) return cost.failure();
    point.cost = *cost;
    const std::scoped_lock lock(mutex_);
    ++campaign_.measured;
    if (const Result<Done> added = journal_.add(key, point); !added) return added.failure();
    return point;
  }

  Result<std::uint32_t> fingerprint_once(const Settings& settings) {
    const Effects effects = scene_.effects_with(settings);
    const std::scoped_lock lock(mutex_);
    const auto known = fingerprints_.find(effects.bits);
    if (known != fingerprints_.end()) return known->second;
    Result<std::uint32_t> found = fingerprint_of(scene_.request(), effects);
    if (found) fingerprints_[effects.bits] = *found;
    return found;
  }

  const AccuracyScene& scene_;
  unsigned jobs_;
  Journal& journal_;
  Campaign& campaign_;
  const std::function<void(std::size_t, std::size_t)>& progress_;
  std::map<std::uint64_t, std::uint32_t> fingerprints_;
  std::mutex mutex_;
};

}  // namespace

Respects respects_of(const AccuracyPoint& point) {
  double time = time_of(point);
  // Times within the noise of the clock count as equal; instructions are exact.
  if (!point.cost.instructions) time = std::pow(1 + kNoise, std::round(std::log(time) / std::log1p(kNoise)));
  return {time, point.errors[Figure::perceived] + point.errors[Figure::wrong_pixels],
          static_cast<double>(point.cost.ram_bytes)};
}

void find_front(Campaign& campaign) {
  std::ranges::sort(campaign.points, {}, [](const AccuracyPoint& p) { return std::pair{time_of(p), p.settings}; });
  std::vector<Respects> respects;
  for (const AccuracyPoint& point : campaign.points) respects.push_back(respects_of(point));
  const std::vector<bool> front = pareto_front(respects);
  for (std::size_t i = 0; i < front.size(); ++i) campaign.points[i].on_front = front[i];
}

std::vector<Settings> all_settings(const AccuracyScene& scene, const std::vector<Knob>& turned, const Settings& from) {
  std::vector<Settings> grown{from};
  const std::vector<Knob> useful = scene.knobs();
  for (const Knob knob : turned) {
    if (std::ranges::find(useful, knob) == useful.end()) continue;
    const std::vector<Settings> before = grown;
    for (const Settings& settings : before) {
      for (std::uint8_t value = 1, end = static_cast<std::uint8_t>(info(knob).values.size()); value < end; ++value) {
        Settings more = settings;
        more[knob] = value;
        if (scene.possible(more)) grown.push_back(more);
      }
    }
  }
  return grown;
}

std::vector<std::string> programs_for(const AccuracyScene& scene, const std::vector<Settings>& settings) {
  std::set<std::string> names;
  for (const Settings& s : settings) names.insert(board_program_name(scene.request().target, scene.effects_with(s)));
  return {names.begin(), names.end()};
}

std::vector<Settings> one_at_a_time(const AccuracyScene& scene, const std::vector<Knob>& turned) {
  std::vector<Settings> wanted{Settings{}};
  const std::vector<Knob> useful = scene.knobs();
  for (const Knob knob : turned) {
    if (std::ranges::find(useful, knob) == useful.end()) continue;
    for (std::uint8_t value = 1, end = static_cast<std::uint8_t>(info(knob).values.size()); value < end; ++value) {
      Settings settings;
      settings[knob] = value;
      if (scene.possible(settings)) wanted.push_back(settings);
    }
  }
  // Dithering is for formats with few colours: it is measured with each of these formats, in addition to the default's.
  const auto turns = [&](Knob knob) { return std::ranges::find(turned, knob) != turned.end(); };
  for (std::uint8_t format = 1; turns(Knob::format) && turns(Knob::dither) && format < info(Knob::format).values.size();
       ++format) {
    Settings settings;
    settings[Knob::format] = format;
    settings[Knob::dither] = 1;
    wanted.push_back(settings);
  }
  return wanted;
}

Result<Done> check_settings(const AccuracyScene& scene, const CampaignOptions& options) {
  for (const Settings& settings : options.only) {
    if (agree(scene.effects_with(settings))) continue;
    return Failure{ExitStatus::usage,
                   fmt::format("'{}' cannot be drawn: these settings exclude each other, or effects of {}",
                               to_text(settings), scene.request().scene)};
  }
  return Done{};
}

std::vector<Settings> first_settings(const AccuracyScene& scene, const CampaignOptions& options) {
  if (!options.only.empty()) return options.only;
  std::vector<Settings> wanted = one_at_a_time(scene, options.knobs);
  if (!options.presets) return wanted;
  const std::vector<Knob> useful = scene.knobs();
  for (const NamedSettings& named : named_settings()) {
    Settings settings = named.settings;
    for (const KnobInfo& knob : knobs()) {
      if (std::ranges::find(useful, knob.knob) == useful.end()) settings[knob.knob] = 0;
    }
    if (std::ranges::find(wanted, settings) == wanted.end()) wanted.push_back(settings);
  }
  return wanted;
}

std::vector<Settings> combinations(const AccuracyScene& scene, const std::vector<Knob>& turned,
                                   const std::vector<AccuracyPoint>& singles, std::size_t limit) {
  std::vector<Settings> grown{Settings{}};
  for (const Knob knob : turned) {
    // The points with values of only this knob, the default first.
    std::vector<Respects> alone;
    std::vector<std::uint8_t> values;
    for (std::uint8_t value = 0, end = static_cast<std::uint8_t>(info(knob).values.size()); value < end; ++value) {
      Settings settings;
      settings[knob] = value;
      const auto found = std::ranges::find(singles, settings, &AccuracyPoint::settings);
      if (found == singles.end()) continue;
      alone.push_back(respects_of(*found));
      values.push_back(value);
    }
    const std::vector<bool> worth = pareto_front(alone);
    std::vector<Settings> next;
    for (const Settings& settings : grown) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!worth[i] && values[i] != 0) continue;
        Settings more = settings;
        more[knob] = values[i];
        if (scene.possible(more)) next.push_back(more);
      }
    }
    grown = std::move(next);
  }
  std::ranges::stable_sort(grown, {}, changes);
  std::erase_if(grown, [](const Settings& settings) { return changes(settings) < 2; });
  if (grown.size() > limit) grown.resize(limit);
  return grown;
}

Result<Campaign> run_campaign(const AccuracyScene& scene, const CampaignOptions& options, Journal& journal,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
  if (const Result<Done> checked = check_settings(scene, options); !checked) return checked.failure();
  Campaign campaign{.request = scene.request(), .points = {}};
  Measuring measuring(scene, options.jobs, journal, campaign, progress);
  const std::vector<Settings> singles = first_settings(scene, options);
  if (const Result<Done> done = measuring.measure(singles, "one", singles.size()); !done) return done.failure();
  if (options.product && options.only.empty()) {
    const std::vector<Settings> more = combinations(scene, options.knobs, campaign.points, kMaxCombinations);
    const Result<Done> done = measuring.measure(more, "product", singles.size() + more.size());
    if (!done) return done.failure();
  }
  find_front(campaign);
  return campaign;
}

}  // namespace zstrip::sim
