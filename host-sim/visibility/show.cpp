// Draws a frame, and converts the data of its visibility method to pixels.
#include "visibility/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "visibility/methods.hpp"
#include "visibility/numbered_scene.hpp"
#include "visibility/surface_judge.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint16_t kRed = 0xF800;

std::uint16_t grey(double light) {
  const double l = std::clamp(light, 0.0, 1.0);
  return static_cast<std::uint16_t>((static_cast<unsigned>(31 * l) << 11) | (static_cast<unsigned>(63 * l) << 5) |
                                    static_cast<unsigned>(31 * l));
}

/// Scales from the farthest code drawn to the nearest; drawn pixels are never quite black.
template <class Codes>
std::vector<std::uint16_t> greys_of(const Codes& codes) {
  std::uint32_t least = UINT32_MAX, most = 0;
  for (const std::uint32_t code : codes) {
    if (code == 0) continue;
    least = std::min(least, code);
    most = std::max(most, code);
  }
  std::vector<std::uint16_t> pixels;
  for (const std::uint32_t code : codes) {
    const double range = std::max<double>(1, static_cast<double>(most) - least);
    pixels.push_back(code == 0 ? std::uint16_t{0} : grey(0.15 + 0.85 * (static_cast<double>(code) - least) / range));
  }
  return pixels;
}

std::vector<std::uint16_t> colours_of(const std::vector<std::uint8_t>& overdraw) {
  constexpr std::array<std::uint16_t, 6> kColours{0x0000, 0x001F, 0x07E0, 0xFFE0, kRed, 0xFFFF};
  std::vector<std::uint16_t> pixels;
  for (const std::uint8_t times : overdraw) pixels.push_back(kColours[std::min<std::size_t>(times, 5)]);
  return pixels;
}

/// Draws a second frame, of numbered triangles, and checks it.
Result<std::vector<std::uint8_t>> errors_of(const Staging& staging, const MethodRequest& request) {
  const Result<NumberedScene> numbered = NumberedScene::of(staging.scene);
  if (!numbered) return numbered.failure();
  // The triangles are those of the scene, in its order, also with a baked tree.
  const bool is_whole = numbered->scene().instances.size() == staging.scene.instances.size();
  const Result<LookedAtFrame> drawn =
      draw_looked_at({numbered->scene(), staging.camera, is_whole ? staging.tree : BspTree{}}, request);
  if (!drawn) return drawn.failure();
  SurfaceJudge judge(numbered->scene(), staging.camera, request.view);
  judge.find_nearest(
      {.nearness = drawn->nearest == 0 ? 0 : 1.5 * nearness_of_code(staging.camera, drawn->nearest, drawn->farthest)});
  return wrong_pixels(judge, drawn->pixels, request.view);
}

}  // namespace

Result<Show> parse_show(const std::string& name) {
  if (name == "depth") return Show::depth;
  if (name == "overdraw") return Show::overdraw;
  if (name == "tiles") return Show::tiles;
  if (name == "error") return Show::error;
  if (name == "accuracy") return Show::accuracy;
  return Failure{ExitStatus::usage,
                 fmt::format("--show '{}' is not one of: depth, overdraw, tiles, error, accuracy", name)};
}

Result<ShownFrame> draw_shown(const Staging& original, const MethodRequest& request, Show show) {
  Staging staging = original;
  // A shadow is drawn with depths that it changes, so that the picture's depths are lost.
  if (show == Show::depth || show == Show::tiles) staging.scene.shadow = nullptr;
  MethodRequest counting = request;
  // Only pipelines of methods count pixels.
  if (show == Show::overdraw && request.effects.any(effect::depth_formats | effect::depth_ranges)) {
    return Failure{ExitStatus::usage,
                   "--show overdraw counts with depth in z16 alone; add --depth-format z16 --visibility zbuffer"};
  }
  if (show == Show::overdraw) counting.effects = counting.effects | method::culling;
  if (show == Show::overdraw && !methods_agree(counting.effects)) counting.effects = request.effects;
  if (show == Show::depth && request.effects.has(method::painter)) {
    return Failure{ExitStatus::usage, "--show depth: the painter has no depth memory; take another --visibility"};
  }
  if (show == Show::tiles && !request.effects.any(method::bounded)) {
    return Failure{ExitStatus::usage,
                   "--show tiles needs --visibility hierarchical-z, front-to-back-hierarchical-z or midpoint-safe"};
  }
  // The judge knows only triangles, and treats each as opaque.
  if (show == Show::error && effects_of(staging.scene, staging.camera)
                                 .any(effect::surfaces | effect::alpha_test | effect::blending | effect::csg)) {
    return Failure{ExitStatus::usage,
                   "--show error judges opaque triangles; the scene has spheres, ellipsoids, lines, CSG "
                   "or transparent materials"};
  }
  Result<LookedAtFrame> drawn = draw_looked_at(staging, counting);
  if (!drawn) return drawn.failure();
  ShownFrame shown{std::move(*drawn), {}, 0};
  switch (show) {
    case Show::colour:
    case Show::accuracy: shown.pixels = shown.frame.pixels; break;
    case Show::depth: shown.pixels = greys_of(shown.frame.depth); break;
    case Show::overdraw: shown.pixels = colours_of(shown.frame.overdraw); break;
    case Show::tiles: shown.pixels = greys_of(shown.frame.tiles); break;
    case Show::error: {
      const Result<std::vector<std::uint8_t>> wrong = errors_of(staging, request);
      if (!wrong) return wrong.failure();
      for (std::size_t i = 0; i < wrong->size(); ++i) {
        const std::uint16_t pixel = shown.frame.pixels[i];
        const double light = ((pixel >> 11) / 31.0 + ((pixel >> 5) & 63) / 63.0 + (pixel & 31) / 31.0) / 3;
        shown.pixels.push_back((*wrong)[i] != 0 ? kRed : grey(0.7 * light));
        shown.wrong += (*wrong)[i];
      }
    }
  }
  return shown;
}

}  // namespace zstrip::sim
