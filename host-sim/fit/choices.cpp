// Each combination is a bake that writes nothing.
#include "fit/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

#include "accuracy/pareto.hpp"
#include "bake/baked_light.hpp"
#include "bench/board_cycles.hpp"
#include "image/to_rgb.hpp"
#include "plan/staged_cost.hpp"
#include "render/render_frame.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

constexpr int kVisiblyOff = 24;
constexpr std::uint32_t kSmallestSide = 8;
constexpr const char* kPalettes[] = {"rgb565", "palette8", "palette4"};
constexpr const char* kLightings[] = {"drawn", "baked"};
constexpr const char* kShares[] = {"", "50%", "25%", "12%", "6%"};
constexpr std::size_t kFewTriangles = 64;  // fewer are not removed

/// Returns the vertices that a header's program bends before each frame; a blob's are bent while they are drawn.
std::size_t bent_before(const BakedScene& baked) {
  std::size_t vertices = 0;
  if (baked.characters != nullptr) return vertices;
  for (const ModelSkin& skin : baked.skins.meshes) vertices += skin.bind.positions.size();
  return vertices;
}

/// True if an instance is so far away that it has a coarser mesh.
bool uses_levels(const BakedScene& baked) {
  std::vector<Instance> instances(baked.scene.instances.begin(), baked.scene.instances.end());
  choose_levels(baked.levels, baked.scene, baked.camera, instances);
  return !std::ranges::equal(instances, baked.scene.instances, {}, &Instance::mesh, &Instance::mesh);
}

/// Draws the scene as it was baked, and fills in all that does not depend on other choices.
Result<FitChoice> measured(const BakeArguments& arguments, const BoardModel& board, const BakedScene& baked,
                           const BakeRecord& record) {
  constexpr Effects kAdded = effect::perspective_runs | effect::depth_formats;
  FrameRenderer renderer(baked.view, {}, baked.effects & kAdded);
  const Staging staging{
      .scene = baked.scene, .camera = baked.camera, .bent_vertices = bent_before(baked), .levels = baked.levels};
  const Result<FrameReport> drawn = renderer.render(staging, baked.plan);
  if (!drawn) return drawn.failure();
  Plan plan = baked.plan;
  plan.mode = drawn->mode;
  const Work work = work_of(drawn->statistics);
  EstimatedFrame frame{baked.plan, baked.view,
                       staged_cost(staging, record.counts, baked.effects, baked.view, plan, work)};
  if (staging.bent_vertices == 0) {
    frame.cycles = estimated_cycles(board.name, record.counts, baked.effects, baked.view, plan, work);
  }
  FitChoice choice{.arguments = arguments,
                   .textures = {},
                   .triangles = {},
                   .smoothing = {},
                   .flash = record.flash.total(),
                   .ram = std::uint64_t{baked.plan.bytes()} +
                          std::uint64_t{record.strip_buffers} * baked.plan.strip_pixel_bytes(baked.view) +
                          record.skin_ram.total() + (record.levels ? record.levels->ram : 0),
                   .triangle_count = record.counts.triangles,
                   .error_pixels = record.reduced ? record.reduced->pixels : 0,
                   .rate = rate_on(board, board.spi_mhz, frame),
                   .picture = rgb_image_of(baked.view, renderer.pixels())};
  return choice;
}

void compare(FitChoice& choice, const RgbImage& whole) {
  double sum = 0;
  for (std::size_t i = 0; i < whole.rgb.size(); i += 3) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int difference = std::abs(int{choice.picture.rgb[i + channel]} - int{whole.rgb[i + channel]});
      largest = std::max(largest, difference);
      sum += difference * difference;
    }
    choice.off += largest > kVisiblyOff;
  }
  choice.rms = std::sqrt(sum / static_cast<double>(whole.rgb.size()));
}

/// The factor by which a choice exceeds its limits, at most 1 if it keeps them, and the worst excess in words.
struct Excess {
  double factor = 0;
  std::string words;
};

Excess excess_of(const FitChoice& choice, const FitLimits& limits) {
  Excess worst;
  const auto consider = [&worst](double factor, std::string words) {
    if (factor > worst.factor) worst = {factor, std::move(words)};
  };
  if (limits.flash) {
    consider(
        static_cast<double>(choice.flash) / static_cast<double>(*limits.flash),
        fmt::format("takes {} of flash, and {} are allowed", counted(choice.flash, "byte"), grouped(*limits.flash)));
  }
  consider(static_cast<double>(choice.ram) / static_cast<double>(limits.ram),
           fmt::format("takes {} of RAM, and {} are allowed", counted(choice.ram, "byte"), grouped(limits.ram)));
  if (limits.frames) {
    consider(choice.rate.least > 0 ? *limits.frames / choice.rate.least : std::numeric_limits<double>::infinity(),
             fmt::format("has {} frames a second, and {:g} are asked for", choice.rate.words(), *limits.frames));
  }
  return worst;
}

/// A limit for --texture-size; nothing: textures as they are.
using TextureSide = std::optional<std::uint32_t>;

/// The sides of the largest texture and of its halves, and 0, colours of vertices; only textures as they are without
/// textures.
std::vector<TextureSide> texture_sides(const Scene& scene) {
  std::vector<TextureSide> sides{std::nullopt};
  std::uint32_t largest = 0;
  for (const Texture& texture : scene.textures) {
    largest = std::max(largest, 1U << std::max(texture.log2_width, texture.log2_height));
  }
  for (std::uint32_t side = largest / 2; side >= kSmallestSide; side /= 2) sides.emplace_back(side);
  if (largest > 0) sides.emplace_back(0);
  return sides;
}

std::string texture_words(const BakeArguments& arguments) {
  std::string side = arguments.camera.reduction.texture_size.value_or("whole");
  if (side == "0") return "none: vertices";
  if (arguments.textures == "rgb565") return side;
  return side + (arguments.textures == "palette8" ? ", 256 colours" : ", 16 colours");
}

/// "edges", "4 samples", "no".
std::string smoothing_words(const ViewArguments& view) {
  const std::uint32_t samples = view.samples.value_or(1);
  if (samples == 1) return view.edges.value_or(false) ? "edges" : "no";
  return fmt::format("{} samples{}", samples, view.edges.value_or(false) ? ", edges" : "");
}

/// Returns the picture's options as given, and without edges and samples if they were asked for.
std::vector<ViewArguments> smoothings(const ViewArguments& given) {
  ViewArguments plain = given;
  if (plain.edges) plain.edges = false;
  if (plain.samples) plain.samples = 1;
  if (smoothing_words(plain) == smoothing_words(given)) return {given};
  return {given, plain};
}

/// Flash, frames a second and effects of a combination whose light is drawn.
struct DrawnLight {
  std::uint64_t flash = 0;
  double rate = 0;
  Effects effects;
};

/// True if baked light saves flash, a hundredth of the time or the code for light.
bool pays(const FitChoice& baked, Effects effects, const DrawnLight& drawn) {
  constexpr double kFaster = 1.01;
  return baked.flash < drawn.flash || baked.rate.least > kFaster * drawn.rate ||
         (effects & effect::lighting) != (drawn.effects & effect::lighting);
}

/// Returns the same number for differences that look the same: by less than a tenth, or below a quarter of a step.
double look_of(const FitChoice& choice) {
  constexpr double kMinSeen = 0.25, kStep = 1.1;
  return std::round(std::log(std::max(choice.rms, kMinSeen)) / std::log(kStep));
}

/// Keeps the choices that no other one beats, and puts the best looking one first. Baked light never beats light that
/// is drawn, because it does not follow what moves later.
void keep_front(std::vector<FitChoice>& choices) {
  std::vector<Respects> all, drawn;
  for (const FitChoice& choice : choices) {
    all.push_back({static_cast<double>(choice.flash), look_of(choice), 1 / choice.rate.least});
    if (!choice.has_baked_light()) drawn.push_back(all.back());
  }
  const std::vector<bool> front = pareto_front(all), front_of_drawn = pareto_front(drawn);
  std::vector<FitChoice> kept;
  for (std::size_t i = 0, next = 0; i < choices.size(); ++i) {
    if (choices[i].has_baked_light() ? front[i] : front_of_drawn[next++]) kept.push_back(std::move(choices[i]));
  }
  std::ranges::stable_sort(
      kept, {}, [](const FitChoice& choice) { return std::tuple(choice.rms, choice.has_baked_light(), choice.flash); });
  choices = std::move(kept);
}

}  // namespace

Result<FitSearch> search(const BakeArguments& base, const BoardModel& board, const FitLimits& limits,
                         const std::function<void(std::uint32_t done, std::uint32_t all)>& progress) {
  FitSearch found;
  std::vector<TextureSide> sides{std::nullopt};
  std::vector<const char*> shares{""};
  std::vector<const char*> palettes{"rgb565"};
  std::vector<bool> lods{base.camera.reduction.lod};
  const std::vector<ViewArguments> views = smoothings(base.plan.view);
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<Failure> refused;
  std::uint32_t shown = 0;  // combinations, however they are lit
  for (std::size_t s = 0; s < shares.size(); ++s) {
    for (std::size_t t = 0; t < sides.size(); ++t) {
      std::unique_ptr<Stage> stage;
      bool has_light = false;  // that colours of vertices can hold
      DrawnLight drawn;
      const std::size_t pictures = palettes.size() * views.size() * lods.size();
      for (std::size_t each = 0; each < pictures * std::size(kLightings); ++each) {
        const std::size_t p = each / std::size(kLightings), light = each % std::size(kLightings);
        if (sides[t] == 0U && p % palettes.size() > 0) continue;  // palettes are for textures
        if (light == 0) has_light = false;
        if (light > 0 && !has_light) continue;
        BakeArguments arguments = base;
        arguments.lighting = kLightings[light];
        arguments.plan.view = views[p / palettes.size() % views.size()];
        arguments.camera.reduction.lod = lods[p / palettes.size() / views.size()];
        if (*shares[s] != '\0') arguments.camera.reduction.triangles = shares[s];
        if (sides[t]) arguments.camera.reduction.texture_size = std::to_string(*sides[t]);
        arguments.textures = palettes[p % palettes.size()];
        std::optional<FitChoice> choice;
        Effects effects;
        // The memory does not limit the first choice, because the others are compared with it.
        const bool is_whole = found.tried == 0;
        const BakeTrial trial{&stage, [&](const BakedScene& baked, const BakeRecord& record) -> Result<Done> {
                                Result<FitChoice> one = measured(arguments, board, baked, record);
                                if (!one) return one.failure();
                                choice = std::move(*one);
                                effects = baked.effects;
                                has_light = LightBakedScene(baked.scene, {}).baked() > 0;
                                if (s == 1 && record.reduced && !record.reduced->in_file.keeps_limit)
                                  found.triangles_stay = true;
                                return Done{};
                              }};
        if (is_whole) {
          BakeArguments whole = arguments;
          whole.output = "whole.hpp";
          whole.plan.memory.ram.reset();
          whole.pico = {};
          if (const Result<Done> done = bake(whole, &trial); !done) return done.failure();
          found.whole = choice->picture;
          choice.reset();
          const Result<Staging> staging = stage->place(0, 1);
          if (!staging) return staging.failure();
          sides = texture_sides(staging->scene);
          if (!staging->scene.textures.empty()) palettes.assign(std::begin(kPalettes), std::end(kPalettes));
          if (count(staging->scene).triangles >= kFewTriangles) shares.assign(std::begin(kShares), std::end(kShares));
          if (staging->scene.instances.size() > 1 && staging->camera.projection == Projection::perspective) {
            bool pays = false;
            whole.camera.reduction.lod = true;
            const BakeTrial with_levels{&stage, [&pays](const BakedScene& baked, const BakeRecord&) {
                                          pays = uses_levels(baked);
                                          return Result<Done>(Done{});
                                        }};
            if (const Result<Done> done = bake(whole, &with_levels); !done) return done.failure();
            if (pays) lods = {false, true};
          }
        }
        const Result<Done> done = bake(arguments, &trial);
        const std::size_t folded = sides.size() > 1 ? palettes.size() - 1 : 0;
        ++found.tried;
        if (light == 0) ++shown;
        progress(shown, static_cast<std::uint32_t>(shares.size() * views.size() * lods.size() *
                                                   (sides.size() * palettes.size() - folded)));
        if (!done) {
          if (done.failure().status != ExitStatus::budget) return done.failure();
          refused = done.failure();
          continue;
        }
        if (light == 0) {
          drawn = {choice->flash, choice->rate.least, effects};
        } else if (!pays(*choice, effects, drawn)) {
          continue;
        }
        choice->textures = sides.size() > 1 ? texture_words(arguments) : "none";
        choice->triangles = *shares[s] == '\0' ? "all" : shares[s];
        if (arguments.camera.reduction.lod) choice->triangles += ", lod";
        choice->smoothing = smoothing_words(arguments.plan.view);
        compare(*choice, found.whole);
        const Excess excess = excess_of(*choice, limits);
        if (excess.factor <= 1) {
          found.choices.push_back(std::move(*choice));
        } else if (excess.factor < nearest || found.nearest.empty()) {
          nearest = excess.factor;
          const std::string textures = sides.size() > 1 ? fmt::format("textures {} and ", choice->textures) : "";
          found.nearest =
              fmt::format("the nearest, with {}{} of the triangles, {}", textures, choice->triangles, excess.words);
        }
      }
    }
  }
  if (found.nearest.empty() && refused) found.nearest = refused->message;
  keep_front(found.choices);
  return found;
}

}  // namespace zstrip::sim
