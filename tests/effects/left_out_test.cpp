// What a renderer leaves out because its scene never has it: shades, back faces, clipping, and checks of what the
// compiler knows. With and without, pictures are equal; what is missing and called for is an error.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "billboards_scene.hpp"
#include "csg_scene.hpp"
#include "draw.hpp"
#include "edges_scene.hpp"
#include "lines_scene.hpp"
#include "outlines_scene.hpp"
#include "overlay_scene.hpp"
#include "shadows_scene.hpp"
#include "zstrip/effects/unclipped/unclipped_stage.hpp"
#include "zstrip/fixed_renderer.hpp"
#include "zstrip/state/bounds.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/stage.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace left_out_test {
namespace {

using namespace zstrip;

constexpr Scene kTeapot = scenes::teapot.scene;
constexpr Scene kKnot = scenes::knot.scene;
constexpr Scene kFlatKnot = scenes::knot_flat.scene;
constexpr Scene kTexturedKnot = scenes::knot_textured.scene;
constexpr Scene kCube = scenes::cube.scene;
constexpr Scene kRoom = scenes::room.scene;

Camera seen_from(double distance, double angle) {
  Camera camera;
  const auto turn = static_cast<Angle>(angle * kFullTurn);
  EXPECT_TRUE(orbit(camera, {0, 0, 0}, static_cast<Fixed>(distance * kFixedOne), turn, kFullTurn / 5));
  return camera;
}

/// As picture::draw, whose memory this renderer has itself. `begun`: of its begin_frame.
template <class Fixed>
picture::Picture draw_begun(Fixed& renderer, const Status& begun, const View& view) {
  picture::Picture drawn{.status = begun, .pixels = {}, .statistics = {}, .bounds = {}};
  if (!drawn.status) return drawn;
  const Plan& plan = renderer.kPlan;
  EXPECT_EQ(plan.columns_of_strips(view), 1);
  alignas(2) std::byte pixels[Fixed::kStripBytes];
  for (std::uint16_t strip = 0; strip < plan.strips; ++strip) {
    EXPECT_TRUE(renderer.draw_strip(strip, pixels));
    const auto rows = static_cast<std::uint32_t>(plan.strip_area(strip, view).height());
    drawn.pixels.insert(drawn.pixels.end(), pixels, pixels + rows * bytes_per_row(view.width, view.format));
  }
  EXPECT_EQ(renderer.draw_strip(plan.strips, pixels).error, Error::strip_rows);
  drawn.bounds = renderer.frame().bounds();
  return drawn;
}

template <class Fixed>
picture::Picture draw_fixed(Fixed& renderer, const Camera& camera, const View& view) {
  return draw_begun(renderer, renderer.begin_frame(camera), view);
}

template <const Scene& scene, const View& view, Effects more = Effects{}, SceneCounts counts = count(scene),
          std::uint16_t strip_rows = 8>
void expect_as_any_renderer(double distance) {
  static FixedRenderer<scene, view, Budget{.strip_rows = strip_rows}, more, Projection::perspective, counts> renderer;
  for (const double angle : {0.0, 0.13, 0.61}) {
    const Camera camera = seen_from(distance, angle);
    const picture::Picture expected = picture::draw(effects_of(scene, camera) | more, scene, camera, view);
    const picture::Picture drawn = draw_fixed(renderer, camera, view);
    ASSERT_TRUE(expected.status);
    ASSERT_TRUE(drawn.status) << message(drawn.status.error);
    EXPECT_TRUE(drawn.pixels == expected.pixels) << distance << " " << angle;
    EXPECT_EQ(drawn.bounds, expected.bounds);
  }
}

template <PixelFormat format>
void expect_in_format() {
  static constexpr View kView{97, 61, format};
  expect_as_any_renderer<kTeapot, kView>(4);
  expect_as_any_renderer<kTeapot, kView, effect::unclipped>(4);
}

TEST(LeftOut, AFixedRendererDrawsEachFormat) {
  expect_in_format<PixelFormat::rgb565>();
  expect_in_format<PixelFormat::rgb565_swapped>();
  expect_in_format<PixelFormat::gray4>();
  expect_in_format<PixelFormat::mono>();
  expect_in_format<PixelFormat::rgb666>();
  expect_in_format<PixelFormat::rgb444>();
  expect_in_format<PixelFormat::xrgb8888>();
}

constexpr View kSmall{120, 90};

TEST(LeftOut, AFixedRendererDrawsEachShade) {
  expect_as_any_renderer<kKnot, kSmall>(4);
  expect_as_any_renderer<kKnot, kSmall, effect::unclipped>(4);
  expect_as_any_renderer<kFlatKnot, kSmall, effect::unclipped>(4);
  expect_as_any_renderer<kTexturedKnot, kSmall, effect::unclipped, scenes::knot_textured.counts>(4);
  expect_as_any_renderer<kTexturedKnot, kSmall, effect::unclipped | effect::bins, scenes::knot_textured.counts>(4);
  expect_as_any_renderer<kCube, kSmall, effect::unclipped>(5);
  expect_as_any_renderer<kRoom, kSmall>(0.5);
  expect_as_any_renderer<kKnot, kSmall, effect::depth_24 | effect::unclipped>(4);
}

/// Regression: small triangles that strips cut to less than vectors draw at once had the colours of large ones.
TEST(LeftOut, StripsOfFewRowsHaveTheSamePixels) {
  static constexpr View kView{61, 47};
  expect_as_any_renderer<kTeapot, kView, effect::unclipped, count(kTeapot), 1>(5);
  expect_as_any_renderer<kTeapot, kView, effect::unclipped, count(kTeapot), 5>(5);
  expect_as_any_renderer<kTeapot, kView, effect::unclipped | effect::bins, count(kTeapot), 3>(5);
}

/// By a renderer of exactly what the scene calls for, and by the host's.
template <const scenes::BuiltIn& built_in>
void expect_exact(const View& view = kSmall) {
  static Renderer<effects_of(built_in.scene, built_in.camera) | effect::dithered_colours> renderer;
  const Effects effects = effects_of(built_in.scene, built_in.camera) | effect::dithered_colours;
  const PlanResult planned = plan(built_in.counts, view, effects, {.strip_rows = 16});
  ASSERT_TRUE(planned.status);
  const picture::Picture drawn = picture::draw(renderer, built_in.scene, built_in.camera, view, planned.plan);
  ASSERT_TRUE(drawn.status) << built_in.name << ": " << message(drawn.status.error);
  EXPECT_TRUE(drawn.pixels == picture::draw(effects, built_in.scene, built_in.camera, view).pixels) << built_in.name;
}

TEST(LeftOut, ARendererOfExactlyTheScenesShadesDrawsEachEffect) {
  for (const View& view : {kSmall, View{120, 90, PixelFormat::rgb565, true}}) {
    expect_exact<scenes::fog>(view);
    expect_exact<scenes::emissive>(view);
    expect_exact<scenes::specular>(view);
    expect_exact<scenes::punctual>(view);
    expect_exact<scenes::mask>(view);
    expect_exact<scenes::blend>(view);
    expect_exact<scenes::bilinear>(view);
    expect_exact<scenes::palette>(view);
    expect_exact<scenes::mipmaps>(view);
    expect_exact<scenes::environment>(view);
    expect_exact<scenes::per_pixel>(view);
    expect_exact<scenes::lines>(view);
    expect_exact<scenes::billboards>(view);
    expect_exact<scenes::outlines>(view);
    expect_exact<scenes::shadows>(view);
    expect_exact<scenes::csg>(view);
    expect_exact<scenes::edges>(view);
    expect_exact<scenes::spheres>(view);
    expect_exact<scenes::overlay>(view);
  }
}

/// Frames of the turntable, with and without clipping.
template <const scenes::BuiltIn& built_in>
void expect_same_turn() {
  constexpr Effects kEffects = effects_of(built_in.scene, built_in.camera) | effect::unclipped;
  static Renderer<kEffects> renderer;
  constexpr std::uint32_t kFrames = 5;
  const PlanResult planned = plan(built_in.counts, kSmall, kEffects, {.strip_rows = 16});
  ASSERT_TRUE(planned.status);
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    scenes::Staged staged;
    scenes::stage(built_in, staged, frame, kFrames, kSmall);
    const picture::Picture drawn = picture::draw(renderer, staged.scene, staged.camera, kSmall, planned.plan);
    ASSERT_TRUE(drawn.status) << built_in.name << ": " << message(drawn.status.error);
    EXPECT_TRUE(drawn.pixels == picture::draw(kEffects, staged.scene, staged.camera, kSmall).pixels)
        << built_in.name << ' ' << frame;
  }
}

TEST(LeftOut, ARendererWithoutClippingDrawsWhatEffectsMakeOfInstances) {
  expect_same_turn<scenes::blend>();
  expect_same_turn<scenes::environment>();
  expect_same_turn<scenes::per_pixel>();
  expect_same_turn<scenes::lines>();
  expect_same_turn<scenes::billboards>();
  expect_same_turn<scenes::csg>();
  expect_same_turn<scenes::edges>();
  expect_same_turn<scenes::spheres>();
  expect_same_turn<scenes::overlay>();
}

/// Instances in RAM, moved as the turntable moves them, are drawn as any renderer draws them.
template <const Scene& scene, Effects more>
void expect_moving(const scenes::BuiltIn& built_in) {
  using Fixed = FixedRenderer<scene, kSmall, Budget{.strip_rows = 8}, more>;
  static Fixed renderer;
  static typename Fixed::Moving moving;
  for (const std::uint32_t frame : {0U, 3U, 4U}) {
    scenes::Staged staged;
    scenes::stage(built_in, staged, frame, 7, kSmall);
    std::ranges::copy(staged.scene.instances, moving.instances().begin());
    const picture::Picture drawn = draw_begun(renderer, renderer.begin_frame(staged.camera, moving), kSmall);
    ASSERT_TRUE(drawn.status) << built_in.name << ": " << message(drawn.status.error);
    const Effects effects = effects_of(scene, staged.camera) | more;
    EXPECT_TRUE(drawn.pixels == picture::draw(effects, staged.scene, staged.camera, kSmall).pixels)
        << built_in.name << ' ' << frame;
  }
}

constexpr Scene kBlend = scenes::blend.scene;
constexpr Scene kCsg = scenes::csg.scene;
constexpr Scene kBillboards = scenes::billboards.scene;
constexpr Scene kSpheres = scenes::spheres.scene;

TEST(LeftOut, AFixedRendererDrawsInstancesThatMove) {
  expect_moving<kKnot, effect::unclipped>(scenes::knot);
  expect_moving<kCube, Effects{}>(scenes::cube);
  expect_moving<kBlend, Effects{}>(scenes::blend);
  expect_moving<kCsg, effect::unclipped>(scenes::csg);
  expect_moving<kBillboards, Effects{}>(scenes::billboards);
  expect_moving<kSpheres, effect::unclipped>(scenes::spheres);
}

TEST(LeftOut, InstancesThatMoveKeepMeshAndMaterial) {
  using Fixed = FixedRenderer<kRoom, kSmall, Budget{.strip_rows = 8}>;
  static Fixed renderer;
  static Fixed::Moving moving;
  const Camera camera = seen_from(0.5, 0);
  alignas(2) std::byte pixels[Fixed::kStripBytes];
  const auto expect_refused = [&](const auto& change) {
    EXPECT_TRUE(renderer.begin_frame(camera, moving));
    Instance& instance = moving.instances()[2];
    const Instance before = instance;
    change(instance);
    const Status status = renderer.begin_frame(camera, moving);
    EXPECT_EQ(status.error, Error::instance);
    EXPECT_EQ(status.needed, 2U);
    EXPECT_EQ(renderer.draw_strip(0, pixels).error, Error::not_begun) << "nothing of the frame before";
    instance = before;
  };
  expect_refused([](Instance& instance) { instance.mesh = 0; });
  expect_refused([](Instance& instance) { instance.material = 1; });
  expect_refused([](Instance& instance) { instance.transform.m[1][1] = 256 * kFixedOne; });
  EXPECT_TRUE(renderer.begin_frame(camera, moving));
  EXPECT_TRUE(renderer.draw_strip(0, pixels));
}

TEST(LeftOut, AFixedRendererTakesPixelsOfAnySizeThatSuffices) {
  static FixedRenderer<kCube, kSmall, Budget{.strip_rows = 8}> renderer;
  constexpr std::uint32_t kBytes = renderer.kStripBytes;
  ASSERT_TRUE(renderer.begin_frame(seen_from(4, 0)));
  alignas(2) std::array<std::byte, kBytes> known{};
  alignas(2) std::array<std::byte, kBytes + 2> larger{};
  for (std::uint16_t strip = 0; strip < renderer.kPlan.strips; ++strip) {
    ASSERT_TRUE(renderer.draw_strip(strip, known));
    ASSERT_TRUE(renderer.draw_strip(strip, std::span<std::byte>(larger)));
    EXPECT_TRUE(std::equal(known.begin(), known.end(), larger.begin())) << strip;
    EXPECT_EQ(renderer.draw_strip(strip, std::span<std::byte>(known).first(kBytes - 1)),
              (Status{.error = Error::pixels_too_small, .needed = kBytes, .available = kBytes - 1}));
  }
}

TEST(LeftOut, AFrameThatWouldBeClippedIsRefused) {
  static FixedRenderer<kCube, kSmall, Budget{.strip_rows = 8}, effect::unclipped> renderer;
  int refused = 0;
  int drawn = 0;
  for (double distance = 0.1; distance < 12; distance *= 1.07) {
    const Camera camera = seen_from(distance, distance);
    const picture::Picture expected = picture::draw(effects_of(kCube, camera), kCube, camera, kSmall);
    const picture::Picture shown = draw_fixed(renderer, camera, kSmall);
    if (shown.status) {
      ++drawn;
      EXPECT_TRUE(shown.pixels == expected.pixels) << distance;
      EXPECT_EQ(expected.statistics.clipped, 0) << distance;
    } else {
      ++refused;
      EXPECT_EQ(shown.status.error, Error::clipping);
      EXPECT_EQ(shown.status.needed, 0) << "the cube is instance 0";
      alignas(2) std::byte pixels[renderer.kStripBytes];
      EXPECT_EQ(renderer.draw_strip(0, pixels).error, Error::not_begun);
    }
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(drawn, 25) << "from a little more than the corners' distance on";
  EXPECT_TRUE(renderer.begin_frame(seen_from(4, 0)));
  Camera parallel = seen_from(4, 0);
  parallel.projection = Projection::orthographic;
  EXPECT_EQ(renderer.begin_frame(parallel).error, Error::camera);
}

TEST(LeftOut, AShadeThatIsMissingIsRefused) {
  const Camera camera = seen_from(4, 0);
  const PlanResult planned = plan(count(kKnot), kSmall, effect::all);
  Renderer<effects_of(kKnot, Camera{})> smooth;
  EXPECT_TRUE(picture::begun(smooth, kKnot, camera, kSmall, planned.plan));
  EXPECT_EQ(picture::begun(smooth, kFlatKnot, camera, kSmall, planned.plan).error, Error::effect_missing);
  Material both_sides = kKnot.materials[0];
  both_sides.double_sided = true;
  Scene scene = kKnot;
  scene.materials = {&both_sides, 1};
  EXPECT_EQ(picture::begun(smooth, scene, camera, kSmall, planned.plan).error, Error::effect_missing);
  Renderer<effect::gouraud | effect::vertex_colours> any;
  EXPECT_TRUE(picture::begun(any, kFlatKnot, camera, kSmall, planned.plan)) << "no shade is named: it has all";
  EXPECT_TRUE(picture::begun(any, scene, camera, kSmall, planned.plan));
}

// What renderers without clipping rely on: a box that passes has no position that project_narrow refuses.
template <bool orthographic>
void expect_box_is_safe() {
  using namespace zstrip::detail;
  std::mt19937 random(7);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto fixed = [](double value) { return static_cast<Fixed>(value * kFixedOne); };
  int accepted = 0;
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    Mesh mesh;
    const Position one{};
    mesh.positions = {&one, 1};
    mesh.half_extent = {fixed(between(0.1, 3)), fixed(between(0.1, 3)), fixed(between(0, 3))};
    Material material;
    Instance instance;
    for (auto& row : instance.transform.m) {
      for (Fixed& element : row) element = fixed(between(-1, 1));
    }
    Scene scene;
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.instances = {&instance, 1};
    Camera camera = seen_from(std::exp(between(-1, 4)), between(0, 1));
    camera.focal = fixed(std::exp(between(-1, 4)));
    camera.projection = orthographic ? Projection::orthographic : Projection::perspective;
    camera.fixed_depth_range = between(0, 1) < 0.3;
    const View view{static_cast<std::uint16_t>(between(1, 2000)), static_cast<std::uint16_t>(between(1, 2000))};
    const DepthFit fit = fit_to(reach_of(scene, camera), camera);
    if (fit.near == 0) continue;
    CompiledInstance compiled{};
    if (!compile_instance(compiled, scene, instance, camera, view, fit) || !compiled.visible) continue;
    const RasterOrigin origin = raster_origin(view, fit, orthographic);
    if (!unclipped::is_box_narrow<orthographic>(compiled, origin)) {
      ++refused;
      continue;
    }
    ++accepted;
    const NarrowProjection<orthographic> narrow(compiled, origin);
    for (int j = 0; j < 40; ++j) {
      const auto side = [&](int axis) -> std::int16_t {
        if (j < 8) return (j >> axis & 1) != 0 ? INT16_MAX : INT16_MIN;
        return static_cast<std::int16_t>(random());
      };
      const Position p{side(0), side(1), side(2)};
      SnappedVertex vertex;
      ASSERT_TRUE(project_narrow<orthographic>(narrow, compiled, origin, compiled.x.at(p), compiled.y.at(p),
                                               compiled.w.at(p), vertex))
          << i << ' ' << j;
    }
  }
  EXPECT_GT(accepted, 2000);
  EXPECT_GT(refused, 2000);
}

TEST(LeftOut, ABoxThatPassesHoldsNothingThatIsClipped) {
  expect_box_is_safe<false>();
  expect_box_is_safe<true>();
}

}  // namespace
}  // namespace left_out_test
