// Whole scenes with hostile numbers and indices, drawn as every strip height would: no finding of a sanitizer, the same
// pixels each time, and an error, never a picture, for what is refused.
#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "edges_input.hpp"
#include "input.hpp"
#include "overlay_input.hpp"
#include "picture.hpp"
#include "require.hpp"
#include "scene_input.hpp"
#include "skin_input.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene/validate.hpp"

namespace {

using namespace zstrip;

/// How many of `part`, an OverlayPart, there are.
std::size_t overlay_things(const Overlay& overlay, std::uint32_t part) {
  switch (static_cast<OverlayPart>(part)) {
    case OverlayPart::image: return overlay.images.size();
    case OverlayPart::font: return overlay.fonts.size();
    case OverlayPart::sprite: return overlay.sprites.size();
    case OverlayPart::label: return overlay.labels.size();
  }
  return 0;
}

/// A scene that validate() refuses may still be asked about, and what begin_frame checks itself is refused there too.
/// The rest does no harm.
void offer_refused_scene(const Scene& scene, const fuzz::SceneInput& input, const Status& refusal) {
  const std::size_t things = refusal.error == Error::mesh       ? scene.meshes.size()
                             : refusal.error == Error::texture  ? scene.textures.size()
                             : refusal.error == Error::material ? scene.materials.size()
                             : refusal.error == Error::instance ? scene.instances.size()
                             : refusal.error == Error::outline  ? scene.outlines.size()
                             : refusal.error == Error::shadow   ? 1
                             : refusal.error == Error::csg      ? scene.csg.size()
                             : refusal.error == Error::edges    ? scene.edges.size()
                             : refusal.error == Error::overlay  ? overlay_things(*scene.overlay, refusal.available)
                                                                : 0;
  if (refusal.error == Error::light) {
    fuzz::require(refusal.needed == scene.lights.size() && refusal.available == kMaxLights, "validate counts lights");
  } else {
    fuzz::require(refusal.needed < things, "validate names the culprit: error %d, %u of %zu",
                  static_cast<int>(refusal.error), refusal.needed, things);
  }
  const Effects effects = effects_of(scene, input.camera()) | effect::bins;
  static_cast<void>(plan(count(scene), input.view(), effects, input.budget()));
  if (refusal.error != Error::light && refusal.error != Error::instance) return;
  // validate() looks at meshes, textures and materials before instances and lights: those of this scene are sound. The
  // texture coordinates of instances are left to it alone, because looking at them takes time with every vertex; the
  // axes of billboards to those renderers that turn them.
  const Status again = validate_instances(scene);
  fuzz::require(again == refusal || (again && refusal.error == Error::instance),
                "begin_frame's own check finds what validate found");
  if (again) {
    const Instance& instance = scene.instances[refusal.needed];
    fuzz::require(scene.materials[instance.material].texture != kNoTexture ||
                      scene.meshes[instance.mesh].billboard != Billboard::none,
                  "an instance that begin_frame takes is refused for its texels or its axes");
  }
  const fuzz::Picture picture =
      fuzz::draw(scene, input.camera(), input.view(), {.effects = effects, .budget = {.modes = Modes::streamed}});
  fuzz::require(again || picture.status.error != Error::none, "begin_frame refuses what it checks");
}

void require_same(const fuzz::Picture& expected, const fuzz::Picture& got, const char* difference) {
  fuzz::require(expected.status == got.status, "the same status with %s: %s or %s", difference,
                message(expected.status.error), message(got.status.error));
  fuzz::require(expected.bounds == got.bounds, "the same bounds with %s", difference);
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    fuzz::require(expected.pixels[i] == got.pixels[i], "the same pixels with %s: byte %zu", difference, i);
  }
}

/// In RGB565 an overlay is what draw_overlay draws over the picture without it.
void judge_overlay(const Scene& scene, const fuzz::SceneInput& input, Effects effects, const fuzz::Picture& whole) {
  const View& view = input.view();
  if (scene.overlay == nullptr || view.format != PixelFormat::rgb565 || !whole.status) return;
  Scene bare = scene;
  bare.overlay = nullptr;
  fuzz::Picture expected =
      fuzz::draw(bare, input.camera(), view, {.effects = without(effects, effect::overlay), .budget = {}});
  std::vector<std::uint16_t> pixels(expected.pixels.size() / 2);
  if (!pixels.empty()) std::memcpy(pixels.data(), expected.pixels.data(), expected.pixels.size());
  draw_overlay(*scene.overlay, {0, 0, view.width, view.height}, pixels.data());
  if (!pixels.empty()) std::memcpy(expected.pixels.data(), pixels.data(), expected.pixels.size());
  require_same(expected, whole, "an overlay");
}

/// Mostly none.
std::array<std::uint32_t, 5> read_surplus(fuzz::Input& bytes) {
  std::array<std::uint32_t, 5> surplus{};
  if (bytes.flag()) {
    for (std::uint32_t& part : surplus) part = static_cast<std::uint32_t>(bytes.number(0));
  }
  return surplus;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input bytes(data, size);
  const auto garbage = bytes.any<std::uint8_t>();
  const auto row_choice = bytes.any<std::uint8_t>();
  const Effects more = Effects{bytes.any<std::uint8_t>()} & effect::all;
  const std::array<std::uint32_t, 5> surplus = read_surplus(bytes);
  const fuzz::SceneInput input(bytes);
  const fuzz::EdgesInput edges(input.scene(), bytes);
  Scene scene = input.scene();
  scene.edges = edges.sets;
  // What is new comes last, so that older inputs keep their meaning.
  const fuzz::OverlayInput overlay(bytes);
  scene.overlay = overlay.overlay();
  const Camera& camera = input.camera();
  const View& view = input.view();
  if (const Status refusal = validate(scene); !refusal) {
    offer_refused_scene(scene, input, refusal);
    return 0;
  }
  const fuzz::SkinInput skin(scene, bytes);
  scene.meshes = skin.meshes();
  constexpr Effects kDepth[8] = {
      {}, {}, {}, {}, effect::depth_float, effect::depth_float, effect::depth_24, effect::depth_24};
  const Effects effects = effects_of(scene, camera) | kDepth[garbage / 32];
  const fuzz::Picture whole = fuzz::draw(scene, camera, view, {.effects = effects, .budget = {}});
  fuzz::require(whole.status.error != Error::arena_too_small, "an unlimited budget is enough");
  judge_overlay(scene, input, effects, whole);

  const fuzz::Picture strips = fuzz::draw(scene, camera, view,
                                          {.effects = effects | effect::bins,
                                           .budget = input.budget(),
                                           .garbage = garbage,
                                           .last_strip_first = row_choice % 2 != 0});
  const Error refused = strips.status.error;
  if (refused != Error::arena_too_small && refused != Error::strip_rows && refused != Error::strip_columns &&
      refused != Error::unplannable) {
    require_same(whole, strips, "other strips and other garbage");
  }
  const auto rows = static_cast<std::uint16_t>(1 + row_choice % std::max<std::uint16_t>(view.height, 1));
  const fuzz::Picture counted = fuzz::draw(scene, camera, view,
                                           {.effects = effects | effect::statistics,
                                            .budget = {.bytes = 0, .strip_rows = rows},
                                            .garbage = static_cast<std::uint8_t>(~garbage)});
  require_same(whole, counted, "other strips and statistics");
  fuzz::require(counted.statistics.depth_passes <= counted.statistics.fragments, "what is drawn was covered");
  const fuzz::Picture roomy =
      fuzz::draw(scene, camera, view, {.effects = effects, .budget = {}, .garbage = garbage, .surplus = surplus});
  if (roomy.status) require_same(whole, roomy, "a plan with more room");

  // A pipeline with more effects than the scene calls for may refuse it, but not draw another picture.
  const fuzz::Picture rich =
      fuzz::draw(scene, camera, view, {.effects = effects | more, .budget = {}, .garbage = 0x55});
  if (rich.status.error != Error::effect_missing && rich.status.error != Error::depth_effects)
    require_same(whole, rich, "more effects than the scene calls for");
  return 0;
}
