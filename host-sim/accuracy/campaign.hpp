// A campaign: measures one scene, one knob at a time from the default, then promising combinations, and finds the
// front.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "accuracy/causes.hpp"
#include "accuracy/journal.hpp"
#include "accuracy/measure.hpp"
#include "accuracy/pareto.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct CampaignOptions {
  std::vector<Knob> knobs;     ///< the knobs to vary
  std::vector<Settings> only;  ///< if not empty: measure only these settings
  unsigned jobs = 1;           ///< points measured at the same time
  bool product = true;         ///< also measure combinations
  bool presets = false;        ///< also measure the presets of zstrip/plan.hpp
};

struct Campaign {
  AccuracyRequest request;
  std::vector<AccuracyPoint> points;  ///< by time, with the default
  std::size_t measured = 0;           ///< number of points that the journal did not have
  std::vector<CauseErrors> causes{};  ///< the causes of the error, the same for all targets
};

/// Calls `progress(done, all)` from one thread at a time; `all` grows when the combinations are known.
Result<Campaign> run_campaign(const AccuracyScene& scene, const CampaignOptions& options, Journal& journal,
                              const std::function<void(std::size_t done, std::size_t all)>& progress);

/// Returns all settings that can be drawn by varying these knobs, with `from`.
std::vector<Settings> all_settings(const AccuracyScene& scene, const std::vector<Knob>& turned,
                                   const Settings& from = {});

/// Returns the boards' programs that these settings need, without folder and suffix, each once.
std::vector<std::string> programs_for(const AccuracyScene& scene, const std::vector<Settings>& settings);

/// Varies one knob at a time from the default, which comes first; adds dithering with each format.
std::vector<Settings> one_at_a_time(const AccuracyScene& scene, const std::vector<Knob>& turned);

/// Returns a usage error if options.only has settings that exclude each other in this scene.
Result<Done> check_settings(const AccuracyScene& scene, const CampaignOptions& options);
/// Returns the settings to measure before combinations: options.only, or one knob at a time and, on request, the
/// presets, as far as their knobs change the scene. Each once.
std::vector<Settings> first_settings(const AccuracyScene& scene, const CampaignOptions& options);

/// Returns all combinations of values that are on the front of their own knob: a value that costs more time, memory and
/// accuracy than another value of its knob costs more of them in combinations, too. At most `limit`, those with the
/// fewest changes first.
std::vector<Settings> combinations(const AccuracyScene& scene, const std::vector<Knob>& turned,
                                   const std::vector<AccuracyPoint>& singles, std::size_t limit);

/// Sorts the points by time, and marks those that no other point dominates.
void find_front(Campaign& campaign);

/// Returns time, visible error and RAM of a point.
Respects respects_of(const AccuracyPoint& point);

}  // namespace zstrip::sim
