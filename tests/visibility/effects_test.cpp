// Every method with what scenes have beyond triangles of one colour: fog, alpha, local light, quadrics, rules of depth.
// Where a method can, the picture is the plain z-buffer's; where it cannot, a message says what and which.
#include <algorithm>
#include <iterator>

#include "scenes.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::sim::test {
namespace {

constexpr View kView{96, 80, PixelFormat::rgb565};
constexpr const char* kEffectScenes[] = {"fog",      "emissive", "specular", "punctual",    "mask",      "blend",
                                         "bilinear", "palette",  "mipmaps",  "environment", "per_pixel", "spheres"};
constexpr const char* kKeepingZ[] = {"front-to-back", "hierarchical-z", "front-to-back-hierarchical-z",
                                     "midpoint-safe"};

struct BuiltInFrame {
  explicit BuiltInFrame(const char* name, std::uint32_t frame = 3) {
    scenes::stage_workload(*scenes::find(name), staged, frame);
  }
  Staging staging() const { return {staged.scene, staged.camera}; }
  scenes::Staged staged;
};

MethodRequest with_culling(MethodRequest made) {
  made.effects = made.effects | method::culling;
  made.options.cull_by_spheres = true;
  return made;
}

int differing(const std::vector<std::uint16_t>& a, const std::vector<std::uint16_t>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

/// Squares of 6x6 units that face the camera of camera_at, one above another, in the order given.
class Layers {
 public:
  struct Layer {
    double z;  ///< greater is nearer; the camera is at 8
    Material material;
    double x = 0;  ///< to the right
  };

  explicit Layers(const std::vector<Layer>& layers) {
    for (const Layer& layer : layers) {
      Instance instance{.mesh = 0, .material = static_cast<std::uint16_t>(materials.size())};
      instance.transform.m[0][3] = static_cast<Fixed>(layer.x * kFixedOne);
      instance.transform.m[2][3] = static_cast<Fixed>(layer.z * kFixedOne);
      materials.push_back(layer.material);
      materials.back().lit = false;
      materials.back().smooth = false;
      materials.back().double_sided = true;
      instances.push_back(instance);
    }
    mesh = {.positions = kCorners,
            .normals = {},
            .colours = {},
            .texcoords = kTexCoords,
            .triangles = kTriangles,
            .meshlets = {},
            .centre = {3 * kFixedOne, 3 * kFixedOne, 0},
            .half_extent = {3 * kFixedOne, 3 * kFixedOne, kFixedOne / 256}};
    texture = {.texels = kTexels, .log2_width = 1, .log2_height = 1, .format = TextureFormat::rgb565_alpha};
  }
  Staging staging(Projection projection = Projection::orthographic) const {
    return {{.meshes = {&mesh, 1},
             .materials = materials,
             .textures = {&texture, 1},
             .instances = instances,
             .lights = {},
             .fog = has_fog ? &fog : nullptr,
             .finishes = kFinishes},
            camera_at(projection)};
  }

  static constexpr std::uint8_t kBlend = 0, kMask = 1;
  bool has_fog = false;

 private:
  static constexpr Position kCorners[] = {
      {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
  static constexpr TexCoord kTexCoords[] = {{0, 0}, {16384, 0}, {16384, 16384}, {0, 16384}};
  static constexpr Triangle kTriangles[] = {{0, 1, 2}, {0, 2, 3}};
  static constexpr std::uint16_t kTexels[] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0xFF00, 0x30FF};
  static constexpr Finish kFinishes[] = {{.alpha_mode = AlphaMode::blend}, {.alpha_mode = AlphaMode::mask}};
  static constexpr Fog fog{.colour = {90, 100, 120, 255}, .start = 6 * kFixedOne, .end = 14 * kFixedOne};

  std::vector<Material> materials;
  std::vector<Instance> instances;
  Mesh mesh;
  Texture texture;
};

Material opaque(std::uint8_t r, std::uint8_t g, std::uint8_t b) { return {.colour = {r, g, b, 255}}; }
Material glass(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  return {.colour = {r, g, b, 120}, .finish = Layers::kBlend};
}
Material lattice() { return {.colour = {255, 255, 255, 255}, .texture = 0, .finish = Layers::kMask}; }

/// Glass before, between and behind what is opaque and what has holes, not in the order of depth.
std::vector<Layers::Layer> window() {
  return {{-1, glass(40, 80, 255), 1}, {-3, opaque(200, 60, 30), 2}, {-2, glass(40, 255, 80), -1},
          {-2.5, lattice(), 0.5},      {0, glass(255, 255, 40), -2}, {-1.5, opaque(30, 60, 200), -3},
          {-4, opaque(90, 90, 90), 0}, {-3.5, glass(255, 0, 255), 1}};
}

TEST(VisibilityEffects, MethodsWithAZBufferDrawThePlainOnesPixels) {
  for (const char* name : kEffectScenes) {
    const BuiltInFrame built_in(name);
    for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{80, 13}) {
      const LookedAtFrame plain = drawn(built_in.staging(), request("zbuffer", kView, rows));
      EXPECT_GT(plain.statistics.fragments, 500U) << name;
      for (const char* method : kKeepingZ) {
        const LookedAtFrame other = drawn(built_in.staging(), request(method, kView, rows));
        EXPECT_EQ(plain.depth, other.depth) << name << ' ' << method << ' ' << rows;
        EXPECT_EQ(differing(plain.pixels, other.pixels), 0) << name << ' ' << method << ' ' << rows;
      }
      const LookedAtFrame culled = drawn(built_in.staging(), with_culling(request("zbuffer", kView, rows)));
      EXPECT_EQ(plain.depth, culled.depth) << name;
      EXPECT_EQ(plain.pixels, culled.pixels) << name;
    }
  }
}

TEST(VisibilityEffects, BinnedTheyDrawTheSame) {
  for (const char* name : {"fog", "blend", "punctual", "spheres"}) {
    const BuiltInFrame built_in(name);
    const LookedAtFrame plain = drawn(built_in.staging(), request("zbuffer", kView));
    for (const char* method : kKeepingZ) {
      MethodRequest binned = request(method, kView, 24);
      binned.budget.modes = Modes::binned;
      binned.budget.strip_columns = 32;
      EXPECT_EQ(differing(plain.pixels, drawn(built_in.staging(), binned).pixels), 0) << name << ' ' << method;
    }
  }
}

// Sorted, everything opaque is drawn near first, then the glass far first, whatever the key.
TEST(VisibilityEffects, GlassBetweenWhatIsOpaqueIsTheSameWithEveryMethodThatCan) {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    for (const bool fog : {false, true}) {
      Layers layers(window());
      layers.has_fog = fog;
      const Staging staging = layers.staging(projection);
      const LookedAtFrame plain = drawn(staging, request("zbuffer", kView));
      for (const char* method : {"front-to-back", "hierarchical-z", "front-to-back-hierarchical-z", "midpoint-safe",
                                 "painter", "half-range"}) {
        for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{80, 17}) {
          const LookedAtFrame other = drawn(staging, request(method, kView, rows));
          // Sub-ranges have two bits fewer, which only the fog's distances show.
          if (fog && std::string_view(method) == "half-range") continue;
          EXPECT_EQ(differing(plain.pixels, other.pixels), 0) << method << ' ' << rows << ' ' << fog;
        }
      }
    }
  }
}

// What it draws is coloured like the plain z-buffer's; what it takes to be nearest is its own fault, and sometimes a
// neighbour's fragment has the same code.
TEST(VisibilityEffects, MidpointColoursRightWhatItSeesRight) {
  for (const char* name : {"emissive", "specular", "punctual", "spheres"}) {
    const BuiltInFrame built_in(name);
    const LookedAtFrame plain = drawn(built_in.staging(), request("zbuffer", kView));
    const LookedAtFrame other = drawn(built_in.staging(), request("midpoint", kView));
    std::size_t same = 0, covered = 0, others = 0;
    for (std::size_t i = 0; i < plain.depth.size(); ++i) {
      covered += plain.depth[i] != 0 ? 1U : 0U;
      if (plain.depth[i] == 0 || plain.depth[i] != other.depth[i]) continue;
      ++same;
      others += plain.pixels[i] != other.pixels[i] ? 1U : 0U;
    }
    EXPECT_LE(others, same / 100) << name;
    EXPECT_GT(same, covered * 3 / 4) << name;
  }
}

// Runs of texels and fog begin at the whole triangle's left end, whatever piece a pixel lies in.
TEST(VisibilityEffects, PiecesDrawTheWholeTrianglesTexelsAndFog) {
  for (const char* name : {"room", "cube", "fog", "bilinear", "mask", "blend"}) {
    const BuiltInFrame built_in(name, 5);
    const View view{160, 120, PixelFormat::rgb565};
    const LookedAtFrame plain = drawn(built_in.staging(), request("zbuffer", view));
    for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{120, 33, 8, 1}) {
      for (const std::uint8_t iterations : std::initializer_list<std::uint8_t>{0, 2, 6}) {
        MethodRequest safe = request("midpoint-safe", view, rows);
        safe.options.iterations = iterations;
        safe.budget.strip_columns = rows == 33 ? 40 : 0;
        const LookedAtFrame other = drawn(built_in.staging(), safe);
        EXPECT_EQ(differing(plain.pixels, other.pixels), 0) << name << ' ' << rows << ' ' << int{iterations};
        EXPECT_EQ(plain.depth, other.depth) << name << ' ' << rows;
      }
    }
  }
}

TEST(VisibilityEffects, SubRangesDifferByTheirTwoBitsAtMost) {
  for (const char* name : kEffectScenes) {
    const BuiltInFrame built_in(name);
    const LookedAtFrame plain = drawn(built_in.staging(), request("zbuffer", kView));
    const LookedAtFrame ranged = drawn(built_in.staging(), request("half-range", kView, 16));
    // Fog changes by a step of RGB565, and where surfaces meet another one may be nearer.
    EXPECT_LE(differing(plain.pixels, ranged.pixels), 16) << name;
  }
}

TEST(VisibilityEffects, OverdrawCountsWhatIsWrittenAndNotWhatIsDiscarded) {
  const Layers layers(window());
  for (const char* method : {"front-to-back", "hierarchical-z", "painter"}) {
    const LookedAtFrame frame = drawn(layers.staging(), request(method, kView));
    std::uint64_t overdraw = 0;
    for (const std::uint8_t times : frame.overdraw) overdraw += times;
    EXPECT_EQ(overdraw, frame.visibility.writes) << method;
    EXPECT_EQ(frame.visibility.writes, frame.statistics.depth_passes) << method;
    EXPECT_LT(frame.visibility.writes, frame.statistics.fragments) << method;  // the lattice has holes
  }
}

// What blends is never drawn first, whatever was seen before.
TEST(VisibilityEffects, GlassThatWasSeenBeforeStillComesLast) {
  const Layers layers(window());
  const LookedAtFrame plain = drawn(layers.staging(), request("zbuffer", kView));
  for (const std::uint32_t bits : {0U, 0x55U, 0xAAU, 0xFFU}) {
    std::vector<std::uint32_t> seen(2, bits);
    MethodRequest coherent = request("hierarchical-z", kView, 24);
    coherent.effects = coherent.effects | method::culling;
    coherent.options.seen_before = seen;
    EXPECT_EQ(plain.pixels, drawn(layers.staging(), coherent).pixels) << bits;
  }
}

/// Materials of every rule over each other; some of them bring cells farther.
std::vector<Layers::Layer> ruled() {
  Material over = opaque(250, 240, 30), later = opaque(30, 200, 60), decal = opaque(255, 255, 255),
           ghost = opaque(10, 10, 10), behind = opaque(120, 0, 120);
  over.depth_test = DepthTest::always;
  decal.depth_test = DepthTest::nearer_or_equal;
  decal.depth_bias = 2;
  ghost.depth_write = false;
  behind.depth_test = DepthTest::farther;
  return {{0, opaque(200, 60, 30)},
          {-3, opaque(1, 2, 3)},
          {-4, over, 1},
          {-2, later, 2},
          {-3.5, opaque(50, 60, 70), 1},
          {-2, decal, 3},
          {-1, ghost, 4},
          {-1.5, opaque(0, 90, 90), 3},
          {-3.9, behind, -4},
          {-2.2, opaque(9, 99, 199), -3}};
}

TEST(VisibilityEffects, HierarchicalZForgetsWhereARuleBringsCellsFarther) {
  const Layers layers(ruled());
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Staging staging = layers.staging(projection);
    for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{80, 19}) {
      const LookedAtFrame plain = drawn(staging, request("zbuffer", kView, rows));
      const LookedAtFrame bounded = drawn(staging, request("hierarchical-z", kView, rows));
      EXPECT_EQ(plain.pixels, bounded.pixels) << rows;
      EXPECT_EQ(plain.depth, bounded.depth) << rows;
      EXPECT_GT(bounded.visibility.run_pixels, 0U);  // the usual ones are still hidden
      std::vector<std::uint32_t> seen(2, 0xFFFFFFF0);
      MethodRequest coherent = request("hierarchical-z", kView, rows);
      coherent.effects = coherent.effects | method::culling;
      coherent.options.seen_before = seen;
      EXPECT_EQ(plain.pixels, drawn(staging, coherent).pixels) << rows;
      EXPECT_EQ(plain.pixels, drawn(staging, with_culling(request("zbuffer", kView, rows))).pixels) << rows;
    }
  }
}

struct Refusal {
  const char* method;
  const char* scene;   ///< of the built-in ones; null: ruled()
  const char* effect;  ///< as the message names it
  const char* able;    ///< the last of those that can
};

TEST(VisibilityEffects, WhatAMethodCannotDrawIsNamedWithTheMethod) {
  const Layers rules(ruled());
  std::vector<Refusal> refusals{{"painter", "spheres", "quadrics", "midpoint-safe"}};
  for (const char* method : {"painter", "painter-newell", "painter-bsp", "front-to-back", "midpoint", "midpoint-safe",
                             "front-to-back-hierarchical-z"}) {
    refusals.push_back({method, nullptr, "depth_state", "zbuffer, half-range, hierarchical-z"});
  }
  for (const char* method : {"painter-newell", "painter-bsp"}) {
    refusals.push_back({method, "spheres", "quadrics", "midpoint-safe"});
    for (const char* const effect : {"fog", "emissive", "specular", "bilinear", "environment"}) {
      refusals.push_back({method, effect, effect, "zbuffer, painter, half-range, front-to-back"});
    }
    refusals.push_back({method, "punctual", "punctual_lights", "painter"});
    refusals.push_back({method, "mask", "alpha_test", "painter"});
    refusals.push_back({method, "mask", "texture_alpha", "painter"});
    refusals.push_back({method, "blend", "blending", "painter"});
  }
  for (const Refusal& refusal : refusals) {
    const BuiltInFrame built_in(refusal.scene != nullptr ? refusal.scene : "cube");
    const Staging staging = refusal.scene != nullptr ? built_in.staging() : rules.staging();
    const Result<LookedAtFrame> frame = draw_looked_at(staging, request(refusal.method, kView));
    ASSERT_FALSE(frame) << refusal.method << ' ' << refusal.effect;
    EXPECT_EQ(frame.failure().status, ExitStatus::usage);
    const std::string& message = frame.failure().message;
    for (const char* part : {refusal.method, refusal.effect, "these can: ", refusal.able}) {
      EXPECT_NE(message.find(part), std::string::npos) << message << " lacks " << part;
    }
    // The library says the same in a value.
    const Effects effects = effects_of(staging.scene, staging.camera) | effect::bins |
                            parse_visibility(std::string(refusal.method))->effects;
    EXPECT_FALSE(methods_agree(effects));
    EXPECT_EQ(plan(count(staging.scene), kView, effects, {}).status.error, Error::visibility) << message;
  }
}

TEST(VisibilityEffects, EveryOtherPairIsDrawn) {
  for (const VisibilityMethod& method : visibility_methods()) {
    for (const char* name : kEffectScenes) {
      const BuiltInFrame built_in(name);
      const Effects effects = effects_of(built_in.staged.scene, built_in.staged.camera) | method.effects;
      const Result<LookedAtFrame> frame = draw_looked_at(built_in.staging(), request(method.name, kView));
      EXPECT_EQ(static_cast<bool>(frame), methods_agree(effects)) << method.name << ' ' << name;
      if (frame) {
        EXPECT_GT(frame->statistics.depth_passes, 300U) << method.name << ' ' << name;
      }
    }
  }
}

TEST(VisibilityEffects, CullingBesideOtherDepthFormatsIsRefusedByTheHost) {
  const BuiltInFrame cube("cube");
  for (const Effects format : {effect::depth_24, effect::depth_ranges}) {
    MethodRequest culled = with_culling(request("zbuffer", kView));
    culled.effects = culled.effects | format;
    const Result<LookedAtFrame> frame = draw_looked_at(cube.staging(), culled);
    ASSERT_FALSE(frame);
    EXPECT_NE(frame.failure().message.find("z16"), std::string::npos) << frame.failure().message;
    EXPECT_EQ(frame.failure().status, ExitStatus::usage);
  }
}

}  // namespace
}  // namespace zstrip::sim::test
