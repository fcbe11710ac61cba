// Anti-aliased edges: pixels against exact areas, pictures against larger ones, what is hidden, and what strips, bins,
// formats and memory must not change.
#include <array>
#include <cmath>
#include <random>

#include "edges_of.hpp"
#include "edges_scene.hpp"
#include "own_mesh.hpp"
#include "samples.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test {
namespace {

using zstrip::test::OwnMesh;

constexpr double kPi = 3.14159265358979;
constexpr View kSquare{64, 64};
/// As many units fill the picture's height as its pixels are.
constexpr double kPixel = 1.0 / 16;

Fixed to_fixed(double value) { return static_cast<Fixed>(std::lround(std::ldexp(value, 16))); }

Transform turned_flat(double angle, double scale, double x, double y, double z) {
  const Fixed c = to_fixed(scale * std::cos(angle)), s = to_fixed(scale * std::sin(angle));
  return {{{c, -s, 0, to_fixed(x)}, {s, c, 0, to_fixed(y)}, {0, 0, to_fixed(scale), to_fixed(z)}}};
}

/// Looks along -z at the origin: 4 units fill the height.
Camera parallel_camera() {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.eye = {0, 0, to_fixed(10)};
  camera.focal = to_fixed(0.5);
  camera.near_plane = to_fixed(1);
  camera.far_plane = to_fixed(20);
  return camera;
}

/// A square of half a side 1 that faces +z, in two triangles.
OwnMesh square() {
  OwnMesh own;
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    own.positions.push_back({static_cast<std::int16_t>(32767 * x), static_cast<std::int16_t>(32767 * y), 0});
    own.normals.push_back({0, 0, 127, 0});
  }
  own.triangles = {{0, 1, 2}, {0, 2, 3}};
  return own;
}

/// Instances of one mesh, without light, each with a material of its own.
struct World {
  OwnMesh own;
  Mesh meshes[1];
  std::vector<Edge> edges;
  EdgeSet sets[1];
  std::vector<Material> materials;
  std::vector<Instance> instances;
  Scene scene;

  World(const OwnMesh& shape, bool creases) : own(shape) {
    meshes[0] = own.mesh();
    edges = edges_of_mesh(meshes[0], [this, creases](std::size_t i, std::size_t j) {
      const Normal& a = own.normals[own.triangles[i].a];
      const Normal& b = own.normals[own.triangles[j].a];
      return creases && (a.x != b.x || a.y != b.y || a.z != b.z);
    });
    sets[0] = {edges, 0};
    scene.meshes = meshes;
    scene.edges = sets;
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add(const Colour& colour, const Transform& transform, bool lit = false) {
    instances.push_back({.mesh = 0, .material = static_cast<std::uint16_t>(materials.size()), .transform = transform});
    materials.push_back({.colour = colour, .lit = lit, .smooth = false});
    scene.materials = materials;
    scene.instances = instances;
  }
  Scene without_edges() const {
    Scene plain = scene;
    plain.edges = {};
    return plain;
  }
};

using Point = std::array<double, 2>;

/// What of a convex polygon lies in x below `limit` (axis 0) or y, or above it.
std::vector<Point> cut(const std::vector<Point>& polygon, std::size_t axis, double limit, double sign) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = sign * (limit - p[axis]), dq = sign * (limit - q[axis]);
    if (dp >= 0) kept.push_back(p);
    if ((dp < 0) != (dq < 0)) {
      const double t = dp / (dp - dq);
      kept.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
    }
  }
  return kept;
}

/// The part of pixel (x, y) that a convex polygon covers.
double area_in_pixel(std::vector<Point> polygon, int x, int y) {
  polygon = cut(cut(polygon, 0, x, -1), 0, x + 1, 1);
  polygon = cut(cut(polygon, 1, y, -1), 1, y + 1, 1);
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - q[0] * p[1];
  }
  return std::abs(twice) / 2;
}

constexpr Effects kFlatEdges = effect::orthographic | effect::edges | effect::bins;

TEST(Edges, PixelsAreTheAreaThatTheEdgeLeavesThem) {
  // Where an edge crosses a pixel's row, its height in the middle of the pixel is the area; where it leaves the pixel
  // at the top or bottom, a corner of at most 1/8 is not counted. Beside that: ends that are snapped to 1/16 pixels,
  // weights of 1/32, green in 6 bits.
  constexpr double kRounding = 1.0 / 32 + 1.0 / 64 + 1.0 / 63;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.3, 0.3), angles(0, kPi);
  double error = 0, error_without = 0;
  int pixels = 0;
  for (int i = 0; i < 60; ++i) {
    const double angle = angles(random), dx = place(random), dy = place(random);
    World world(square(), false);
    world.add({0, 255, 0, 255}, turned_flat(angle, 1.2, dx, dy, 0));
    const Drawn with = draw<kFlatEdges>(world.scene, parallel_camera(), kSquare);
    const Drawn without = draw<kFlatEdges>(world.without_edges(), parallel_camera(), kSquare);
    std::vector<Point> polygon;
    for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      polygon.push_back({32 + (1.2 * (x * std::cos(angle) - y * std::sin(angle)) + dx) / kPixel,
                         32 - (1.2 * (x * std::sin(angle) + y * std::cos(angle)) + dy) / kPixel});
    }
    for (int y = 0; y < kSquare.height; ++y) {
      for (int x = 0; x < kSquare.width; ++x) {
        bool is_corner = false;
        for (const Point& p : polygon) is_corner |= std::hypot(p[0] - x - 0.5, p[1] - y - 0.5) < 2;
        const double area = area_in_pixel(polygon, x, y);
        const double drawn = (with.at(x, y) >> 5 & 0x3F) / 63.0, plain = (without.at(x, y) >> 5 & 0x3F) / 63.0;
        if (!is_corner) {
          EXPECT_NEAR(drawn, area, 1.0 / 8 + kRounding) << "angle " << angle << ", pixel " << x << ", " << y;
        }
        if (area == 0 || area == 1) continue;
        ++pixels;
        error += std::abs(drawn - area);
        error_without += std::abs(plain - area);
      }
    }
  }
  EXPECT_LT(error / pixels, 0.04);
  EXPECT_GT(error_without / pixels, 0.15);
}

TEST(Edges, UprightAndLevelEdgesBetweenPixelsStay) {
  World world(square(), false);
  world.add({0, 255, 0, 255}, turned_flat(0, 1, 0, 0, 0));
  const Drawn with = draw<kFlatEdges>(world.scene, parallel_camera(), kSquare);
  EXPECT_EQ(with, draw<kFlatEdges>(world.without_edges(), parallel_camera(), kSquare));
  EXPECT_EQ(with.green(16, 16), 252);
  EXPECT_EQ(with.green(15, 16), 0);
}

/// Mean difference of all channels from the means of a picture of `factor` times as many rows and columns, 0..1.
double distance_from(const Drawn& large, const Drawn& drawn, int factor) {
  double sum = 0;
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      for (const auto& [shift, most] : {std::array{11, 31}, {5, 63}, {0, 31}}) {
        double mean = 0;
        for (int i = 0; i < factor * factor; ++i) {
          mean += large.at(x * factor + i % factor, y * factor + i / factor) >> shift & most;
        }
        sum += std::abs(mean / (factor * factor) - (drawn.at(x, y) >> shift & most)) / most;
      }
    }
  }
  return sum / (drawn.width * drawn.height * 3);
}

/// How far from a picture of four times as many rows and columns it is, with edges over without.
template <Effects effects>
double share_of_error(const Scene& scene, const Camera& camera, const View& view) {
  constexpr int kFactor = 4;
  Scene plain = scene;
  plain.edges = {};
  const View larger{static_cast<std::uint16_t>(view.width * kFactor),
                    static_cast<std::uint16_t>(view.height * kFactor)};
  const Drawn large = draw<effects>(plain, camera, larger);
  const double with = distance_from(large, draw<effects>(scene, camera, view), kFactor);
  return with / distance_from(large, draw<effects>(plain, camera, view), kFactor);
}

Camera near_camera(double distance) {
  Camera camera;
  camera.eye = {0, 0, to_fixed(distance)};
  camera.focal = to_fixed(1.5);
  camera.near_plane = to_fixed(0.1);
  camera.far_plane = to_fixed(50);
  return camera;
}

Transform turned_about_x_and_y(double x, double y, double scale = 1) {
  const double cx = std::cos(x), sx = std::sin(x), cy = std::cos(y), sy = std::sin(y);
  const auto f = [scale](double value) { return to_fixed(scale * value); };
  return {{{f(cy), f(sy * sx), f(sy * cx), 0}, {0, f(cx), f(-sx), 0}, {f(-sy), f(cy * sx), f(cy * cx), 0}}};
}

constexpr Effects kLitEdges = effect::lighting | effect::edges | effect::bins;
constexpr DirectionalLight kLights[] = {{.x = 13000, .y = 26000, .z = 14500}};

TEST(Edges, ACubeIsNearerToATruePicture) {
  for (int i = 0; i < 12; ++i) {
    World world(zstrip::test::faceted_box(), true);
    world.scene.lights = kLights;
    world.add({255, 220, 90, 255}, turned_about_x_and_y(0.2 + 0.5 * i, 0.7 + 0.3 * i), true);
    EXPECT_LT(share_of_error<kLitEdges>(world.scene, near_camera(5), {80, 60}), 0.35) << i;
  }
}

TEST(Edges, AKnotIsNearerToATruePicture) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  for (std::uint32_t frame = 0; frame < 6; ++frame) {
    scenes::Staged staged;
    scenes::stage(scenes::edges, staged, frame, 18, {160, 120});
    EXPECT_LT(share_of_error<kEffects>(staged.scene, staged.camera, {160, 120}), 0.65) << frame;
  }
}

// A face narrower than a pixel lies between the crease and the outline: the crease was blended with the background, and
// then the outline once more.
TEST(Edges, CreasesBesideAnOutlineWereBlendedWithTheBackground) {
  OwnMesh own = square();
  for (const auto& [x, y, z] :
       {std::array{-32767, 24000, 0}, {32767, 24000, 0}, {32767, 24300, -200}, {-32767, 24300, -200}}) {
    own.positions.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)});
    own.normals.push_back({0, 100, 80, 0});
  }
  own.positions[2].y = own.positions[3].y = 24000;
  own.triangles.push_back({4, 5, 6});
  own.triangles.push_back({4, 6, 7});
  for (const double angle : {0.03, 0.1, 0.4, 1.2, 1.7, 2.4}) {
    World world(own, true);
    world.add({255, 220, 90, 255}, turned_flat(angle, 1.2, 0.1, 0, 0));
    EXPECT_LT(share_of_error<kFlatEdges>(world.scene, parallel_camera(), kSquare), 0.35) << angle;
  }
}

TEST(Edges, WhatTheNearPlaneCutsIsBlendedToo) {
  // A floor that reaches from behind the viewer to the horizon, turned.
  for (int i = 0; i < 8; ++i) {
    World world(square(), false);
    world.add({255, 255, 255, 255}, turned_about_x_and_y(-1.3, 0.15 * i, 20));
    world.instances[0].transform.m[1][3] = to_fixed(-1);
    EXPECT_LT(share_of_error<effect::edges | effect::bins>(world.scene, near_camera(3), {80, 60}), 0.3) << i;
  }
}

TEST(Edges, OfASheetAreSeenFromItsFront) {
  World world(square(), false);
  world.add({0, 255, 0, 255}, turned_flat(0.3, 1, 0, 0, 0));
  world.instances[0].transform.m[0][0] = -world.instances[0].transform.m[0][0];
  world.instances[0].transform.m[1][0] = -world.instances[0].transform.m[1][0];
  const Drawn empty = draw<kFlatEdges>(world.scene, parallel_camera(), kSquare);
  EXPECT_EQ(empty, draw<kFlatEdges>(world.without_edges(), parallel_camera(), kSquare));
  world.materials[0].double_sided = true;
  EXPECT_LT(share_of_error<kFlatEdges>(world.scene, parallel_camera(), kSquare), 0.2);
}

TEST(Edges, HiddenOnesAreNotBlended) {
  // Behind a sheet of narrow stripes, which any blending would change.
  std::vector<std::uint16_t> texels;
  for (int i = 0; i < 64; ++i) texels.push_back(i % 2 == 0 ? 0xFFFF : 0x0000);
  const Texture textures[1] = {{.texels = texels, .log2_width = 6, .log2_height = 0}};
  std::vector<TexCoord> texcoords = {{0, 0}, {4096, 0}, {4096, 0}, {0, 0}};
  for (int i = 0; i < 6; ++i) {
    World world(square(), false);
    world.meshes[0].texcoords = texcoords;
    world.scene.textures = textures;
    world.add({255, 255, 255, 255}, turned_flat(0, 1.9, 0, 0, 1));
    world.materials[0].texture = 0;
    const Drawn alone = draw<kFlatEdges | effect::textures>(world.scene, parallel_camera(), kSquare);
    world.add({0, 255, 0, 255}, turned_flat(0.3 + i, 0.8, 0, 0, i < 3 ? 0 : 0.9));
    EXPECT_EQ(draw<kFlatEdges | effect::textures>(world.scene, parallel_camera(), kSquare), alone) << i;
  }
}

TEST(Edges, NeitherStripsNorBinsChangeAPixel) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  const View view{75, 58};
  scenes::Staged staged;
  scenes::stage(scenes::edges, staged, 3, 20, view);
  const Drawn whole = draw<kEffects>(staged.scene, staged.camera, view);
  Scene plain = staged.scene;
  plain.edges = {};
  EXPECT_NE(whole, draw<kEffects>(plain, staged.camera, view));
  for (const int rows : {1, 2, 7, 29, 58}) {
    for (const int columns : {8, 40, 75}) {
      for (const Modes mode : {Modes::streamed, Modes::binned}) {
        EXPECT_EQ(draw<kEffects>(staged.scene, staged.camera, view,
                                 {.strip_rows = static_cast<std::uint16_t>(rows),
                                  .strip_columns = static_cast<std::uint16_t>(columns),
                                  .modes = mode}),
                  whole)
            << rows << " rows, " << columns << " columns, " << (mode == Modes::binned ? "binned" : "streamed");
      }
    }
  }
}

TEST(Edges, MeshletsChangeNoPixel) {
  // Runs of triangles; edges between two runs look for one face's corner elsewhere, and some come in the wrong order.
  World world(zstrip::test::sphere(12, 16), false);
  world.add({0, 255, 0, 255}, turned_about_x_and_y(0.4, 0.2));
  const View view{64, 48};
  const Drawn whole = draw<effect::edges | effect::bins>(world.scene, near_camera(4), view, {.strip_rows = 9});
  std::vector<Meshlet> meshlets;
  for (std::uint16_t ring = 0; ring < 12; ++ring) {
    meshlets.push_back({.first_triangle = static_cast<std::uint32_t>(ring * 32),
                        .first_vertex = static_cast<std::uint16_t>(ring * 16),
                        .vertex_count = 32,
                        .triangle_count = 32,
                        .radius = 65535,
                        .centre = {}});
  }
  world.meshes[0].meshlets = meshlets;
  std::sort(world.edges.begin(), world.edges.end(), [](const Edge& a, const Edge& b) { return a.left < b.left; });
  for (const bool in_order : {true, false}) {
    if (!in_order) std::shuffle(world.edges.begin(), world.edges.end(), std::mt19937(3));
    for (const Modes mode : {Modes::streamed, Modes::binned}) {
      EXPECT_EQ(draw<effect::edges | effect::bins>(world.scene, near_camera(4), view, {.strip_rows = 9, .modes = mode}),
                draw<effect::edges | effect::bins>(world.scene, near_camera(4), view));
    }
    if (in_order) {
      world.sets[0].edges = world.edges;
    }
  }
  EXPECT_LT(share_of_error<effect::edges | effect::bins>(world.scene, near_camera(4), view), 0.6);
  EXPECT_FALSE(whole.pixels.empty());
}

TEST(Edges, OtherFormatsAreMadeOfTheBlendedPixels) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  scenes::Staged staged;
  scenes::stage(scenes::edges, staged, 3, 20, kPixels);
  const Drawn pixels = draw<kEffects>(staged.scene, staged.camera, kPixels);
  for (const PixelFormat format :
       {PixelFormat::rgb565, PixelFormat::rgb565_swapped, PixelFormat::gray4, PixelFormat::mono, PixelFormat::rgb666,
        PixelFormat::rgb444, PixelFormat::xrgb8888}) {
    const View view = with_samples(kPixels, 1, format);
    std::vector<std::uint16_t> all = pixels.pixels;
    std::vector<std::uint8_t> expected(std::size_t{bytes_per_row(view.width, format)} * view.height);
    if (format == PixelFormat::rgb565 || format == PixelFormat::rgb565_swapped) {
      convert_pixels(format, view.width, view.height, all.data(), reinterpret_cast<std::byte*>(all.data()));
      std::memcpy(expected.data(), all.data(), expected.size());
    } else {
      convert_pixels(format, view.width, view.height, all.data(), reinterpret_cast<std::byte*>(expected.data()));
    }
    for (const std::uint16_t rows : {std::uint16_t{5}, view.height}) {
      const PlanResult planned = plan(count(staged.scene), view, kEffects, {.strip_rows = rows});
      ASSERT_TRUE(planned.status);
      Renderer<kEffects> renderer;
      EXPECT_EQ(bytes_by(renderer, staged.scene, staged.camera, view, planned.plan), expected)
          << static_cast<int>(format) << ", " << rows << " rows";
    }
  }
}

TEST(Edges, PlansThatAreTooSmallAreRefused) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::mono}) {
    const View view{75, 58, format};
    const PlanResult planned = plan(count(scenes::edges.scene), view, kEffects, {.strip_rows = 8});
    ASSERT_TRUE(planned.status);
    for (const auto& [part, purpose] : {std::pair{&Plan::effect_bytes, Purpose::effects},
                                        {&Plan::depth_bytes, Purpose::depth},
                                        {&Plan::colour_bytes, Purpose::colour}}) {
      Plan small = planned.plan;
      small.*part -= 8;
      std::vector<std::uint64_t> arena(planned.plan.bytes() / 8);
      Renderer<kEffects> renderer;
      const Status status = renderer.begin_frame(scenes::edges.scene, scenes::edges.camera, view, small,
                                                 std::as_writable_bytes(std::span(arena)));
      EXPECT_EQ(status.error, Error::arena_too_small);
      EXPECT_EQ(status.purpose, purpose);
    }
  }
}

TEST(Edges, WhatDoesNotGoWithThemIsRefused) {
  constexpr Effects kOwn = effects_of(scenes::edges.scene, scenes::edges.camera);
  for (const Effects other : {effect::depth_24, effect::depth_32, effect::depth_float, effect::depth_w16,
                              effect::depth_ranges, effect::coarse_reciprocal, effect::table_reciprocal}) {
    EXPECT_FALSE(depth_effects_agree(kOwn | other));
    EXPECT_EQ(plan(count(scenes::edges.scene), {75, 58}, kOwn | other).status.error, Error::edges);
  }
  for (const Effects way : {method::painter, method::front_to_back, method::hierarchical_z, method::midpoint,
                            method::midpoint_safe, method::culling}) {
    EXPECT_FALSE(methods_agree(kOwn | way));
  }
  EXPECT_EQ(plan(count(scenes::edges.scene), {75, 58, PixelFormat::rgb565, false, 2}, kOwn | effect::supersampled)
                .status.error,
            Error::edges);
  EXPECT_EQ(plan(count(scenes::edges.scene), {80, 56}, kOwn, {.layer = layer_bytes_worst({80, 56})}).status.error,
            Error::edges);

  static constexpr Effects kMore =
      kOwn | effect::lighting | effect::supersampled | effect::outlines | effect::shadows | effect::csg;
  const Shadow shadow{};
  const Outline outline{};
  const CsgOperand operand{};
  const DirectionalLight light{};
  const auto refused = [](const Scene& scene, const View& view) {
    Plan large = plan(count(scene), view, without(kMore, effect::edges)).plan;
    std::vector<std::uint64_t> arena(1 << 20);
    Renderer<kMore> renderer;
    const Status status =
        renderer.begin_frame(scene, scenes::edges.camera, view, large, std::as_writable_bytes(std::span(arena)));
    return status.error;
  };
  Scene scene = scenes::edges.scene;
  EXPECT_EQ(refused(scene, {75, 58, PixelFormat::rgb565, false, 4}), Error::edges);
  scene.csg = {&operand, 1};
  EXPECT_EQ(refused(scene, {75, 58}), Error::edges);
  scene.csg = {};
  Mesh mesh = scene.meshes[0];
  mesh.outline = 1;
  scene.meshes = {&mesh, 1};
  scene.outlines = {&outline, 1};
  EXPECT_EQ(refused(scene, {75, 58}), Error::edges);
  scene = scenes::edges.scene;
  std::vector<Normal> normals(scene.meshes[0].positions.size(), Normal{0, 0, 127, 0});
  mesh = scene.meshes[0];
  mesh.normals = normals;
  scene.meshes = {&mesh, 1};
  const Material lit{};
  scene.materials = {&lit, 1};
  scene.lights = {&light, 1};
  scene.shadow = &shadow;
  EXPECT_EQ(refused(scene, {75, 58}), Error::edges);
}

TEST(Edges, OnlyStripsThatWereDrawnWholeAreKept) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera);
  const View view{80, 56};
  const Plan planned = plan(count(scenes::edges.scene), view, kEffects, {.strip_rows = 8}).plan;
  std::vector<std::uint64_t> arena(planned.bytes() / 8), memory(1 << 16);
  Renderer<kEffects> renderer;
  ASSERT_TRUE(renderer.begin_frame(scenes::edges.scene, scenes::edges.camera, view, planned,
                                   std::as_writable_bytes(std::span(arena))));
  EXPECT_FALSE(renderer.frame().has_plain_depth());
  std::vector<std::uint16_t> pixels(std::size_t{80} * 56), depth(pixels.size());
  EXPECT_EQ(renderer.draw_over({0, 0, 80, 56}, pixels, depth).error, Error::edges);
}

TEST(Edges, WhatIsWrongWithASetIsFound) {
  const auto error_of = [](const Edge& edge, std::uint16_t mesh) {
    Scene scene = scenes::edges.scene;
    const EdgeSet set{{&edge, 1}, mesh};
    scene.edges = {&set, 1};
    return validate(scene).error;
  };
  constexpr auto kBeyond = static_cast<std::uint16_t>(scenes::kKnotVertices);
  EXPECT_EQ(error_of({0, 1, 2, 3}, 0), Error::none);
  EXPECT_EQ(error_of({0, 1, 2, kNoFace}, 0), Error::none);
  EXPECT_EQ(error_of({kBeyond, 1, 2, 3}, 0), Error::edges);
  EXPECT_EQ(error_of({0, kBeyond, 2, 3}, 0), Error::edges);
  EXPECT_EQ(error_of({0, 1, kBeyond, 3}, 0), Error::edges);
  EXPECT_EQ(error_of({0, 1, 2, kBeyond}, 0), Error::edges);
  EXPECT_EQ(error_of({0, 1, 2, 3}, 1), Error::edges);
  Scene twice = scenes::edges.scene;
  const EdgeSet sets[2] = {scenes::kKnotEdges[0], scenes::kKnotEdges[0]};
  twice.edges = sets;
  EXPECT_EQ(validate(twice), (Status{.error = Error::edges, .needed = 1}));
}

/// From the nearest code to the farthest in a sixteenth of a pixel: what comes behind its only middle left 32 bits.
TEST(Edges, DepthBehindAnEdgeThatIsSeenEndOnLeft32Bits) {
  std::array<std::uint16_t, 9> pixels{}, own{}, depth{};
  own.fill(0x7BEF);
  pixels = own;
  constexpr Rect kArea{0, 0, 3, 3};
  const detail::EdgeTarget target{kArea, pixels.data(), kArea, own.data(), kArea, depth.data()};
  detail::EdgeBlend<std::int32_t>::draw(target, {.a = {15, 20, 0x10000},
                                                 .b = {16, 21, 0xFFFE0000},
                                                 .third = {{40, 44, 0x10000}},
                                                 .faces = 1,
                                                 .crease = false,
                                                 .narrow = true});
  EXPECT_EQ(pixels, own);
}

TEST(Edges, EndsMayBeAnywhere) {
  // Random triangles and edges that need not be theirs, near and far, in and out of the picture: nothing may be read or
  // written beyond what is lent.
  std::mt19937 random(11);
  const auto anywhere = [&random] { return static_cast<std::int16_t>(random()); };
  for (int i = 0; i < 200; ++i) {
    World world(square(), false);
    for (Position& p : world.own.positions) p = {anywhere(), anywhere(), anywhere()};
    for (Edge& edge : world.edges) {
      const auto vertex = [&random] { return static_cast<std::uint16_t>(random() % 4); };
      edge = {vertex(), vertex(), vertex(), random() % 3 == 0 ? kNoFace : vertex()};
    }
    const double scale = std::pow(2.0, static_cast<double>(random() % 10) - 2);
    world.add({0, 255, 0, 255}, turned_about_x_and_y(0.1 * i, 0.3 * i, scale));
    world.materials[0].double_sided = i % 2 == 0;
    const View view{33, 21};
    const Camera camera = near_camera(std::pow(2.0, static_cast<double>(random() % 6) - 2));
    const Drawn whole = draw<effect::edges | effect::bins>(world.scene, camera, view);
    EXPECT_EQ(draw<effect::edges | effect::bins>(world.scene, camera, view, {.strip_rows = 4, .strip_columns = 16}),
              whole)
        << i;
    Camera parallel = camera;
    parallel.projection = Projection::orthographic;
    const Drawn flat = draw<kFlatEdges>(world.scene, parallel, view);
    EXPECT_EQ(draw<kFlatEdges>(world.scene, parallel, view, {.strip_rows = 4, .strip_columns = 16}), flat) << i;
  }
}

}  // namespace
}  // namespace effects_test
