// A campaign: one scene, one knob at a time from the default, then the combinations worth trying, and the front.
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
  std::vector<Knob> knobs;     ///< those that are turned
  std::vector<Settings> only;  ///< these settings instead, if there are any
  unsigned jobs = 1;           ///< points measured at once
  bool product = true;         ///< combinations too
  bool presets = false;        ///< the presets of zstrip/plan.hpp too
};

struct Campaign {
  AccuracyRequest request;
  std::vector<AccuracyPoint> points;  ///< by time, the default among them
  std::size_t measured = 0;           ///< that the journal did not have
  std::vector<CauseErrors> causes{};  ///< where the error comes from; of all targets the same
};

/// `progress(done, all)` is called from one thread at a time; `all` grows when the combinations are known.
Result<Campaign> run_campaign(const AccuracyScene& scene, const CampaignOptions& options, Journal& journal,
                              const std::function<void(std::size_t done, std::size_t all)>& progress);

/// Everything that can be drawn by turning these knobs, `from` among them.
std::vector<Settings> all_settings(const AccuracyScene& scene, const std::vector<Knob>& turned,
                                   const Settings& from = {});

/// The boards' programs that these settings need, without folder and suffix, each once.
std::vector<std::string> programs_for(const AccuracyScene& scene, const std::vector<Settings>& settings);

/// One knob at a time from the default, which comes first; and dithering with each format.
std::vector<Settings> one_at_a_time(const AccuracyScene& scene, const std::vector<Knob>& turned);

/// A usage error if options.only has settings that exclude each other in this scene.
Result<Done> check_settings(const AccuracyScene& scene, const CampaignOptions& options);
/// What is measured before combinations: options.only, or one knob at a time and, on request, the presets as far as
/// their knobs change anything of the scene. Each once.
std::vector<Settings> first_settings(const AccuracyScene& scene, const CampaignOptions& options);

/// All combinations of the values that are on the front of their own knob: a value that costs more time, memory and
/// accuracy than another of its knob costs them in combinations too. At most `limit`, those with the fewest changes
/// first.
std::vector<Settings> combinations(const AccuracyScene& scene, const std::vector<Knob>& turned,
                                   const std::vector<AccuracyPoint>& singles, std::size_t limit);

/// Puts the points into the order of their time and finds which no other beats.
void find_front(Campaign& campaign);

/// Time, visible error and RAM of a point.
Respects respects_of(const AccuracyPoint& point);

}  // namespace zstrip::sim
