// Whole frames through the public interface: invariance, clipping, errors.
#include <gtest/gtest.h>

#include <cstdlib>

#include <algorithm>
#include <random>
#include <vector>

#include "depth_picture.hpp"

namespace {

using namespace zstrip;
using namespace picture;

class Invariance : public testing::TestWithParam<int> {};

/// The kinds of scene: bits choose texture, light, smoothness, orthographic, camera inside the scene.
TEST_P(Invariance, StripsAndGarbageNeverChangeAPixel) {
  const int kind = GetParam();
  Model model = random_model(static_cast<unsigned>(kind), 60, kind & 1 ? 20000 : 7000);
  if (kind & 2)
    model.material.texture = 0;
  else
    model.texels.clear();
  model.material.lit = (kind & 4) != 0;
  model.material.smooth = (kind & 8) != 0;
  Camera camera;
  if (kind & 16) camera.projection = Projection::orthographic, camera.focal = 50000;
  if (kind & 32) camera.eye = {3000, -2000, 20000};  // among the triangles: clipping
  const View view{61, 45, kind & 64 ? PixelFormat::gray4 : PixelFormat::rgb565};
  const Picture whole = render(model.scene(), camera, view, 45);
  ASSERT_TRUE(whole.status) << message(whole.status.error);
  EXPECT_GT(whole.statistics.fragments, 50U) << "a scene that shows nothing proves nothing";
  for (const int rows : {1, 2, 3, 7, 8, 16, 44}) {
    for (const int garbage : {0x00, 0xFF}) {
      const Picture strips =
          render(model.scene(), camera, view, static_cast<std::uint16_t>(rows), static_cast<std::uint8_t>(garbage));
      ASSERT_TRUE(strips.status);
      ASSERT_EQ(strips.pixels, whole.pixels) << "kind " << kind << " rows " << rows << " garbage " << garbage;
      ASSERT_EQ(strips.statistics.fragments, whole.statistics.fragments);
      ASSERT_EQ(strips.statistics.drawn, whole.statistics.drawn);
    }
  }
}
/// Regression: colours of small triangles once started at the strip's first row and rounded there.
TEST(Frame, SmallGouraudTrianglesDoNotDependOnTheStrip) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Model model = random_model(seed, 400, 2500);
    model.material.lit = false;
    const View view{200, 120};
    const Picture whole = render(model.scene(), Camera{}, view, 120);
    EXPECT_GT(whole.statistics.fragments, 500U);
    for (const int rows : {1, 3, 8}) {
      ASSERT_EQ(render(model.scene(), Camera{}, view, static_cast<std::uint16_t>(rows)).pixels, whole.pixels)
          << seed << ' ' << rows;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Invariance, testing::Range(0, 128));

TEST(Frame, ATiledPlaneCoversEachPixelExactlyOnce) {
  // Seen at a slant, with the near plane cutting through it: clipped and unclipped cells share edges. The cells stay
  // larger than a sub-pixel: below that, snapping folds a mesh.
  for (int n : {1, 2, 7, 25}) {
    Model model = grid(n, 30 * kFixedOne);
    Camera camera;
    for (int tilt = 0; tilt < 40; ++tilt) {
      ASSERT_TRUE(look_at(camera, {kFixedOne / 3, kFixedOne / 5, kFixedOne * 2},
                          {tilt * 9000 - 180000, 70000, kFixedOne}, {0, kFixedOne, 0}));
      camera.far_plane = 30000 * kFixedOne;
      const View view{64, 48};
      const Picture picture = render(model.scene(), camera, view, 48);
      ASSERT_TRUE(picture.status);
      ASSERT_EQ(picture.statistics.fragments, picture.statistics.depth_passes)
          << "a pixel drawn twice, n " << n << " tilt " << tilt;
      const auto* const pixels = reinterpret_cast<const std::uint16_t*>(picture.pixels.data());
      // The plane fills the picture below its horizon: a column has no background between two plane pixels.
      for (int x = 0; x < 64; ++x) {
        int changes = 0;
        for (int y = 1; y < 48; ++y) changes += (pixels[y * 64 + x] == 0xFFFF) != (pixels[(y - 1) * 64 + x] == 0xFFFF);
        ASSERT_LE(changes, 2) << "a crack, n " << n << " tilt " << tilt << " column " << x;
      }
    }
  }
}

TEST(Frame, APlaneThatFillsThePictureFillsEveryPixel) {
  for (int n : {1, 3, 16}) {
    Model model = grid(n, 4000 * kFixedOne);
    Camera camera;
    for (const View view : {View{1, 1}, View{64, 48}, View{63, 47}, View{2048, 3}}) {
      const Picture picture = render(model.scene(), camera, view, view.height);
      ASSERT_TRUE(picture.status);
      EXPECT_EQ(picture.statistics.fragments, static_cast<std::uint32_t>(view.width * view.height))
          << n << ' ' << view.width;
      EXPECT_EQ(picture.statistics.depth_passes, static_cast<std::uint32_t>(view.width * view.height));
    }
  }
}

TEST(Frame, NothingInViewIsJustBackground) {
  Model model = grid(2, kFixedOne);
  Camera camera;
  camera.eye = {0, 0, -3 * kFixedOne};  // the plane is behind
  const Picture picture = render(model.scene(), camera, View{8, 8}, 3);
  ASSERT_TRUE(picture.status);
  EXPECT_TRUE(picture.bounds.empty());
  EXPECT_EQ(picture.statistics.fragments, 0U);
  for (std::size_t i = 0; i < picture.pixels.size(); i += 2) {
    EXPECT_EQ(*reinterpret_cast<const std::uint16_t*>(&picture.pixels[i]),
              ((16 >> 3) << 11) | ((32 >> 2) << 5) | (48 >> 3));
  }
}

TEST(Frame, BackFacesAreCulledUnlessDoubleSided) {
  Model model = grid(2, kFixedOne);
  Camera camera;
  ASSERT_TRUE(look_at(camera, {0, 0, -3 * kFixedOne}, {0, 0, 0}, {0, kFixedOne, 0}));
  EXPECT_EQ(render(model.scene(), camera, View{32, 32}, 32).statistics.fragments, 0U);
  model.material.double_sided = true;
  EXPECT_GT(render(model.scene(), camera, View{32, 32}, 32).statistics.fragments, 100U);
}

TEST(Frame, SwappedFormatIsTheSamePictureWithSwappedBytes) {
  Model model = random_model(3, 40, 9000);
  const Camera camera;
  Picture native = render(model.scene(), camera, View{33, 21, PixelFormat::rgb565}, 4);
  const Picture swapped = render(model.scene(), camera, View{33, 21, PixelFormat::rgb565_swapped}, 4);
  for (std::size_t i = 0; i < native.pixels.size(); i += 2) std::swap(native.pixels[i], native.pixels[i + 1]);
  EXPECT_EQ(native.pixels, swapped.pixels);
}

TEST(Frame, TooSmallAnArenaOrPlanIsAnErrorForEverySize) {
  Model model = random_model(4, 20, 9000);
  const Scene scene = model.scene();
  const Camera camera;
  const View view{16, 16};
  const Effects effects = effects_of(scene, camera);
  const Plan good = plan(count(scene), view, effects).plan;
  std::vector<std::uint64_t> words(good.bytes() / 8);
  const auto arena = std::as_writable_bytes(std::span(words));
  AnyRenderer renderer(effects);
  for (std::size_t bytes = 0; bytes < good.bytes(); ++bytes) {
    const Status status = renderer.begin_frame(scene, camera, view, good, arena.first(bytes));
    ASSERT_EQ(status.error, Error::arena_too_small);
    ASSERT_EQ(status.needed, good.bytes());
    ASSERT_EQ(status.available, bytes);
  }
  for (std::uint32_t Plan::*part : {&Plan::instance_bytes, &Plan::vertex_bytes, &Plan::depth_bytes}) {
    Plan bad = good;
    bad.*part -= 8;
    ASSERT_EQ(renderer.begin_frame(scene, camera, view, bad, arena).error, Error::arena_too_small);
  }
  ASSERT_TRUE(renderer.begin_frame(scene, camera, view, good, arena));
}

TEST(Frame, EveryMistakeHasItsError) {
  Model model = random_model(5, 4, 9000);
  const Scene scene = model.scene();
  Camera camera;
  const View view{16, 16};
  const Effects effects = effects_of(scene, camera);
  const Plan good = plan(count(scene), view, effects, {.strip_rows = 4}).plan;
  std::vector<std::uint64_t> words(good.bytes() / 8);
  const auto arena = std::as_writable_bytes(std::span(words));
  std::vector<std::uint16_t> pixels(16 * 4 + 1);
  const auto strip = std::as_writable_bytes(std::span(pixels));

  AnyRenderer renderer(effects);
  EXPECT_EQ(renderer.draw_strip(0, strip).error, Error::not_begun);
  AnyRenderer plain(Effects{});
  EXPECT_EQ(plain.begin_frame(scene, camera, view, good, arena), effects_missing(without_shades(effects)));

  Camera broken = camera;
  broken.near_plane = 0;
  EXPECT_EQ(renderer.begin_frame(scene, broken, view, good, arena).error, Error::camera);
  broken = camera;
  broken.far_plane = broken.near_plane;
  EXPECT_EQ(renderer.begin_frame(scene, broken, view, good, arena).error, Error::camera);
  broken = camera;
  broken.right = {INT32_MAX, 0, 0};
  EXPECT_EQ(renderer.begin_frame(scene, broken, view, good, arena).error, Error::camera);

  ASSERT_TRUE(renderer.begin_frame(scene, camera, view, good, arena));
  EXPECT_EQ(renderer.draw_strip(4, strip).error, Error::strip_rows);
  EXPECT_EQ(renderer.draw_strip(0, strip.first(16 * 4 * 2 - 1)).error, Error::pixels_too_small);
  EXPECT_EQ(renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels)).subspan(1)).error,
            Error::pixels_misaligned);
  EXPECT_TRUE(renderer.draw_strip(3, strip));
}

/// This program does not link zstrip::methods.
TEST(Frame, AnyRendererRefusesMethodsOfALibraryThatIsNotLinked) {
  Model model = random_model(5, 4, 9000);
  const Scene scene = model.scene();
  const View view{16, 16};
  for (const Effects way : {method::painter, method::front_to_back, method::hierarchical_z, method::midpoint,
                            method::midpoint_safe, method::culling}) {
    const Effects effects = effects_of(scene, Camera{}) | way;
    const Plan planned = plan(count(scene), view, effects, {}).plan;
    std::vector<std::uint64_t> words(planned.bytes() / 8);
    AnyRenderer renderer(effects);
    EXPECT_EQ(renderer.begin_frame(scene, Camera{}, view, planned, std::as_writable_bytes(std::span(words))).error,
              Error::visibility);
  }
}

/// It passed, and draw_strip wrote three bytes a pixel where two had been asked for.
TEST(Frame, AFormatThatDoesNotExistIsRefused) {
  Model model = random_model(5, 4, 9000);
  const Scene scene = model.scene();
  View view{16, 16, PixelFormat::xrgb8888};
  const Effects effects = effects_of(scene, Camera{});
  const Plan planned = plan(count(scene), view, effects, {}).plan;
  std::vector<std::uint64_t> words(planned.bytes() / 8);
  const auto arena = std::as_writable_bytes(std::span(words));
  AnyRenderer renderer(effects);
  ASSERT_TRUE(renderer.begin_frame(scene, Camera{}, view, planned, arena));
  for (const int format : {static_cast<int>(kLastPixelFormat) + 1, 255}) {
    view.format = static_cast<PixelFormat>(format);
    EXPECT_EQ(renderer.begin_frame(scene, Camera{}, view, planned, arena).error, Error::view_size);
    std::byte pixels[1];
    EXPECT_EQ(renderer.draw_strip(0, pixels).error, Error::not_begun);
  }
}

TEST(Validate, FindsEveryBadIndex) {
  Model model = random_model(6, 4, 9000);
  ASSERT_TRUE(validate(model.scene()));
  Model bad = model;
  bad.triangles[2].c = 12;
  EXPECT_EQ(validate(bad.scene()).error, Error::mesh);
  bad = model;
  bad.material.texture = 3;
  EXPECT_EQ(validate(bad.scene()).error, Error::material);
  bad = model;
  bad.instance.mesh = 1;
  EXPECT_EQ(validate(bad.scene()).error, Error::instance);
  bad = model;
  bad.instance.transform.m[1][1] = INT32_MIN;
  EXPECT_EQ(validate(bad.scene()).error, Error::instance);
  bad = model;
  bad.normals.pop_back();
  EXPECT_EQ(validate(bad.scene()).error, Error::mesh);
  bad = model;
  bad.texels.pop_back();
  EXPECT_EQ(validate(bad.scene()).error, Error::texture);
  bad = model;
  bad.mesh.half_extent.x = INT32_MAX;
  EXPECT_EQ(validate(bad.scene()).error, Error::mesh);
}

// Regression: plans whose parts add up to more than 32 bits passed for small ones.
TEST(Frame, PlansThatWrapOrAreMisalignedAreRefused) {
  Model model = random_model(4, 20, 9000);
  const Scene scene = model.scene();
  const View view{16, 16};
  const Effects effects = effects_of(scene, Camera{});
  const Plan good = plan(count(scene), view, effects).plan;
  std::vector<std::uint64_t> words(good.bytes() / 8 + 16);
  const auto arena = std::as_writable_bytes(std::span(words));
  AnyRenderer renderer(effects);
  Plan bad = good;
  bad.depth_bytes = 0x80000000U;
  bad.bin_bytes = 0x80000000U - good.instance_bytes - good.vertex_bytes;
  EXPECT_EQ(renderer.begin_frame(scene, Camera{}, view, bad, arena).error, Error::arena_too_small);
  bad = good;
  bad.instance_bytes += 1;
  EXPECT_EQ(renderer.begin_frame(scene, Camera{}, view, bad, arena).error, Error::arena_too_small);
  const SceneCounts many{.instances = 26'843'545, .triangles = 1, .vertices = 3, .largest_meshlet = 3};
  const PlanResult refused = plan(many, {4096, 4096}, effects);
  EXPECT_EQ(refused.status.error, Error::arena_too_small);
  EXPECT_EQ(refused.status.available, kMaxArena);
}

// Regression: a renderer for orthographic cameras drew perspective scenes wrongly, in silence.
TEST(Frame, AnOrthographicRendererRefusesAPerspectiveCamera) {
  Model model = random_model(4, 20, 9000);
  const Scene scene = model.scene();
  const Effects effects = effects_of(scene, Camera{}) | effect::orthographic;
  const View view{16, 16};
  const Plan p = plan(count(scene), view, effects).plan;
  EXPECT_EQ(begun(AnyRenderer(effects), scene, Camera{}, view, p).error, Error::effect_missing);
}

// Regression: a lit material on a mesh without normals and colours lost its texture in a renderer of just its effects.
TEST(Frame, TheTextureOfALitMaterialNeedsNoNormals) {
  Model model = random_model(9, 20, 12000);
  model.normals.clear();
  model.colours.clear();
  model.material.texture = 0;
  const Picture lit = render(model.scene(), Camera{}, View{48, 32}, 32);
  ASSERT_GT(lit.statistics.fragments, 50U);
  model.material.lit = false;
  EXPECT_EQ(lit.pixels, render(model.scene(), Camera{}, View{48, 32}, 32).pixels);
}

// Regression: where the mesh is huge beside the depth range, the far codes wrapped to the nearest ones.
TEST(Frame, DepthOfAFloorMuchLargerThanTheDepthRange) {
  struct Case {
    Fixed half_extent, near, far, height;
  };
  for (const Case& c : {Case{4095 * kFixedOne, 655, 6553, 1966}, Case{4095 * kFixedOne, 6553, kFixedOne, 19660},
                        Case{4095 * kFixedOne, 6553, 19660, 6553}, Case{kFixedOne, 6553, kFixedOne, 6553}}) {
    Model model;
    model.positions = {{-32767, 0, -32767}, {32767, 0, -32767}, {32767, 0, 32767}, {-32767, 0, 32767}};
    model.triangles = {{0, 2, 1}, {0, 3, 2}};
    model.mesh.half_extent = {c.half_extent, 0, c.half_extent};
    model.material = {.lit = false, .double_sided = true};
    const Scene scene = model.scene();
    Camera camera;
    camera.eye = {0, c.height, 0};
    camera.near_plane = c.near;
    camera.far_plane = c.far;
    const View view{32, 200};
    const DepthPicture drawn = render_depth(scene, camera, view);
    ASSERT_TRUE(drawn.status);
    const double near = c.near / 65536.0, far = c.far / 65536.0;
    int rows = 0;
    for (int y = 101; y < view.height; ++y) {
      const double w = c.height / 65536.0 * (camera.focal / 65536.0) * 100 / (y + 0.5 - 100);
      if (w < near * 1.01 || w > far * 0.99) continue;
      const std::uint32_t code = drawn.depth[static_cast<std::size_t>(y * view.width + 16)];
      const double exact = 1 + 65533 * (1 / w - 1 / far) / (1 / near - 1 / far);
      // A step of w near the camera is 4095 / 2^30 units here: w itself is that uncertain, three roundings.
      const double step = 3.0 * c.half_extent / 65536 / (1 << 30);
      ASSERT_NEAR(code, exact, 2 + 65533 * step / (w * w) / (1 / near - 1 / far) + 65533 * 1e-4) << w;
      ++rows;
    }
    EXPECT_GT(rows, 3);
  }
}

TEST(Validate, RefusesTexturesThatRepeatTooOften) {
  Model model = random_model(6, 4, 9000);
  model.material.texture = 0;
  model.mesh.texcoord_bits = 4;
  ASSERT_TRUE(validate(model.scene()));
  for (TexCoord& t : model.texcoords) t = {32767, 0};  // 2048 repeats of 16 texels
  ASSERT_TRUE(validate(model.scene()));
  Scene scene = model.scene();
  std::vector<std::uint16_t> texels(32 * 8);
  const Texture wider{texels, 5, 3};
  scene.textures = {&wider, 1};
  EXPECT_EQ(validate(scene).error, Error::instance);
}

// Regression: the planes of the guard band dropped all fraction bits, and close to the camera let coordinates pass that
// are ten times beyond it.
TEST(Frame, TheGuardBandHoldsCloseToTheCamera) {
  using namespace zstrip::detail;
  Mesh mesh;
  mesh.half_extent = {4095 * kFixedOne, 4095 * kFixedOne, 4095 * kFixedOne};
  const Position one{};
  mesh.positions = {&one, 1};
  const Material material;
  Instance instance;
  for (int i = 0; i < 3; ++i) instance.transform.m[i][i] = 4 * kFixedOne;
  Scene scene;
  scene.meshes = {&mesh, 1};
  scene.materials = {&material, 1};
  scene.instances = {&instance, 1};
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.near_plane = 1;
  camera.far_plane = 16384 * kFixedOne;
  camera.focal = INT32_MAX;
  const View view{64, 4096};
  const DepthFit fit = fit_to(reach_of(scene, camera), camera);
  CompiledInstance compiled{};
  ASSERT_TRUE(compile_instance(compiled, scene, instance, camera, view, fit));
  const RasterOrigin origin = raster_origin(view, fit, false);
  int corners = 0;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      const Position triangle[3] = {
          {-1, -1, 2}, {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), -2}, {1, 0, -2}};
      ClipPolygon polygon;
      polygon.count = 3;
      for (int i = 0; i < 3; ++i) {
        const auto wide = [&](const LinearForm& form) { return std::int64_t{form.at(triangle[i])} * (1 << kClipBits); };
        polygon.vertices[i] = {wide(compiled.x), wide(compiled.y), wide(compiled.w), 0, 0, 0, 0, 0};
      }
      clip_perspective(polygon, compiled);
      for (int i = 0; i < polygon.count; ++i) {
        const WidePosition position = project_wide<false>(compiled, origin, polygon.vertices[i]);
        // A sixteenth more: what the clipping itself rounds, over the smallest w.
        constexpr std::int32_t kBand = (1 << kGuardBits) + (1 << (kGuardBits - 4));
        EXPECT_LE(std::abs(position.x), kBand) << x << ' ' << y;
        EXPECT_LE(std::abs(position.y), kBand) << x << ' ' << y;
        ++corners;
      }
    }
  }
  EXPECT_GT(corners, 20);
}

// Triangles around and behind the camera, in one that sees wide and in one that sees far.
TEST(Frame, ATriangleIsLeftOutOnlyOfRowsWhereItHasNoPixel) {
  using namespace zstrip::detail;
  std::mt19937 random(7);
  const auto between = [&random](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  const View view{320, 240};
  int left_out = 0, drawn = 0;
  for (int round = 0; round < 400; ++round) {
    Position corners[3];
    const int reach = 1 << between(2, 14);
    for (Position& corner : corners) {
      corner.x = static_cast<std::int16_t>(between(-reach, reach));
      corner.y = static_cast<std::int16_t>(between(-reach, reach));
      corner.z = static_cast<std::int16_t>(between(-reach, reach));
    }
    const Triangle triangle{0, 1, 2};
    Mesh mesh;
    mesh.half_extent = {kFixedOne, kFixedOne, kFixedOne};
    mesh.positions = corners;
    mesh.triangles = {&triangle, 1};
    const Material material{.double_sided = true};
    Instance instance;
    Scene scene;
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.instances = {&instance, 1};
    Camera camera;
    camera.eye = {0, between(-20000, 20000), between(0, 60000)};
    camera.near_plane = 1 << between(0, 12);
    camera.focal = 1 << between(14, 26);
    CompiledInstance compiled{};
    const DepthFit fit = fit_to(reach_of(scene, camera), camera);
    if (!compile_instance(compiled, scene, instance, camera, view, fit)) continue;
    const Batch batch{&compiled, &mesh, nullptr, nullptr, 0, raster_origin(view, fit, false), {}};
    RasterPolygon polygon;
    const bool shown = TriangleClipper<effect::two_sided>::clip(batch, triangle, polygon);
    for (std::int32_t top = -120; top < 120; top += 8) {
      const Rect rows{-160, top, 160, top + 8};
      const bool touches = shown && polygon.box().touches({-(1 << 22), rows.top, 1 << 22, rows.bottom});
      const bool misses = TriangleClipper<effect::two_sided>::misses_rows(batch, triangle, rows);
      ASSERT_FALSE(touches && misses) << round << ' ' << top;
      left_out += misses ? 1 : 0;
      drawn += touches ? 1 : 0;
    }
  }
  EXPECT_GT(left_out, 1000);
  EXPECT_GT(drawn, 1000);
}

}  // namespace
