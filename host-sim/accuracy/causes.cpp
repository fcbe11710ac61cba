// Pictures of the truth with one coarse stage, observed as if the renderer had drawn them.
#include "accuracy/causes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "accuracy/campaign.hpp"
#include "accuracy/observation.hpp"
#include "accuracy/truth.hpp"
#include "accuracy/truth_stages.hpp"
#include "accuracy/variant.hpp"
#include "render/parallel.hpp"

namespace zstrip::sim {
namespace {

Stages stages_of(const CauseCase& wanted, const View& size) {
  const Settings& settings = wanted.settings;
  Stages stages;
  switch (wanted.cause) {
    case Cause::aliasing: break;
    case Cause::snapping: stages.snapping = true; break;
    case Cause::transform: stages.transform = true; break;
    case Cause::interpolation:
      stages.interpolation = static_cast<std::uint32_t>(perspective_run(extra_effects(settings)));
      break;
    case Cause::depth: {
      const Effects effects = extra_effects(settings);
      stages.depth = Stages::Depth{depth_format(effects), effects.has(effect::depth_ranges)};
      break;
    }
    case Cause::colour: stages.colour = picture(settings, size); break;
  }
  return stages;
}

/// Returns the observation of a picture of the truth in the form of the renderer's observations.
Observation looked_at(const TruthPicture& picture, const Staging& staged, const Stages& stages) {
  const truth::DepthCodes codes(staged.scene, staged.camera, stages.depth.value_or(Stages::Depth{}));
  const std::vector<const Texture*> textures = textures_of(staged.scene);
  Observation seen;
  for (std::size_t i = 0; i < picture.samples.size(); ++i) {
    const TruthSample& sample = picture.samples[i];
    const bool covered = sample.triangle != kNoTriangle;
    seen.rgb.push_back(sample.rgb);
    seen.label.push_back(covered ? label_of(sample.triangle) : 0);
    seen.depth.push_back(stages.depth ? depth_of(stages.depth->format, picture.code[i])
                                      : DepthSeen{covered ? codes.linear(sample.w) : 0, 1});
    const Texture* const texture = covered ? textures[sample.triangle] : nullptr;
    if (texture == nullptr) {
      seen.texel.push_back({});
      continue;
    }
    seen.texel.push_back({std::floor(sample.u) + 0.5F, std::floor(sample.v) + 0.5F,
                          std::ldexp(1.0F, texture->log2_width), std::ldexp(1.0F, texture->log2_height)});
  }
  return seen;
}

/// Returns the truth with one exact sample a pixel, in the middle of the pixel.
Truth in_the_middle(const Truth& truth) {
  Truth exact;
  exact.centres = exact.snapped = truth.centres;
  exact.triangles = truth.triangles;
  for (const TruthSample& sample : truth.centres.samples) exact.mean.push_back(sample.rgb);
  return exact;
}

}  // namespace

const std::vector<CauseInfo>& causes() {
  static const std::vector<CauseInfo> table{
      {Cause::aliasing, "aliasing", "one exact sample in the middle of each pixel, against the mean of 16", {}},
      {Cause::snapping, "snapping", "corners on the screen rounded to 1/16 pixel", {}},
      {Cause::transform, "transform", "positions and 1/w in fixed point of 32 bits", {}},
      {Cause::interpolation,
       "interpolation",
       "light found at vertices, colours linear on the screen, texture coordinates exact at every 16th pixel, depth "
       "stepped with 16 fraction bits",
       {Knob::shading, Knob::perspective}},
      {Cause::depth, "depth", "pixels keep codes of the z-buffer's format", {Knob::depth, Knob::fit}},
      {Cause::colour, "colour", "pixels of the display's format", {Knob::format, Knob::dither}},
  };
  return table;
}

std::vector<CauseCase> cause_cases(const AccuracyScene& scene, const std::vector<Knob>& turned) {
  std::vector<CauseCase> cases;
  for (const CauseInfo& cause : causes()) {
    std::vector<Knob> own;
    std::ranges::copy_if(cause.knobs, std::back_inserter(own),
                         [&](Knob knob) { return std::ranges::find(turned, knob) != turned.end(); });
    for (const Settings& settings : one_at_a_time(scene, own)) cases.push_back({cause.cause, settings});
  }
  return cases;
}

Result<Errors> errors_of(const AccuracyScene& scene, const CauseCase& wanted) {
  const View& size = scene.request().view;
  const std::span<const Staging> staged = scene.staged();
  const SceneVariant variant(staged[0].scene, wanted.settings);
  const Stages stages = stages_of(wanted, size);
  const bool orthographic = staged[0].camera.projection == Projection::orthographic;
  ErrorSum sum(size, staged[0].camera, {stages.depth.value_or(Stages::Depth{}).format, orthographic}, false);
  std::optional<Observation> last_seen;
  std::optional<Truth> last_truth;
  for (std::size_t i = 0; i < staged.size(); ++i) {
    const Staging varied = variant.apply(staged[i]);
    const Result<TruthPicture> drawn = draw_truth(varied.scene, varied.camera, size, 1, stages);
    if (!drawn) return drawn.failure();
    Observation seen = looked_at(*drawn, varied, stages);
    Truth truth = wanted.cause == Cause::aliasing ? scene.truths()[i] : in_the_middle(scene.truths()[i]);
    // Depth in codes is compared at the exact corners.
    truth.snapped = truth.centres;
    if (i % 2 == 0) {
      sum.add(seen, truth);
    } else {
      sum.add_flicker(*last_seen, *last_truth, seen, truth);
    }
    last_seen = std::move(seen);
    last_truth = std::move(truth);
  }
  return sum.take();
}

Result<std::vector<CauseErrors>> errors_of(const AccuracyScene& scene, const std::vector<CauseCase>& wanted,
                                           unsigned jobs) {
  std::vector<CauseErrors> found;
  for (const CauseCase& of : wanted) found.push_back({of, {}});
  const Result<Done> done =
      for_each_on_threads(static_cast<std::uint32_t>(wanted.size()), jobs, [&](unsigned, std::uint32_t i) {
        const Result<Errors> errors = errors_of(scene, wanted[i]);
        if (!errors) return Result<Done>(errors.failure());
        found[i].errors = *errors;
        return Result<Done>(Done{});
      });
  if (!done) return done.failure();
  return found;
}

}  // namespace zstrip::sim
