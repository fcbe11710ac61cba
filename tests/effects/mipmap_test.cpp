// Mipmaps: which level each pixel shows and which texel of it, against derivatives in doubles; and that levels change
// nothing where there is nothing to choose.
#include <array>
#include <cmath>
#include <random>
#include <tuple>

#include "drawn.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test::mipmap_test {
namespace {

constexpr View kView{120, 90, PixelFormat::rgb565};
constexpr int kLog2Width = 6, kLog2Height = 5, kSmallerLevels = 6;

/// Each texel of each level is another colour, none of them 0: level, row, column.
constexpr std::uint16_t texel(int level, int column, int row) {
  return static_cast<std::uint16_t>((level + 1) << 11 | row << 6 | column);
}
std::vector<std::uint16_t> told_apart() {
  std::vector<std::uint16_t> texels;
  for (int level = 0; level <= kSmallerLevels; ++level) {
    const int width = std::max(1, 1 << kLog2Width >> level), height = std::max(1, 1 << kLog2Height >> level);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) texels.push_back(texel(level, column, row));
    }
  }
  return texels;
}

/// One triangle with a texture, seen by a camera in its default place.
struct TexturedTriangle {
  static constexpr double kHalfExtent = 20;
  static constexpr int kTexcoordBits = 8;
  std::array<Position, 3> positions{};
  std::array<TexCoord, 3> texcoords{};
  Triangle triangle{0, 1, 2};
  std::vector<std::uint16_t> texels = told_apart();
  Texture texture{texels, kLog2Width, kLog2Height, TextureFormat::rgb565, kSmallerLevels};
  Mesh mesh;
  Material material{.texture = 0, .lit = false, .smooth = false, .double_sided = true, .finish = 0};
  Finish finish;
  Instance instance;

  TexturedTriangle(const std::array<std::array<double, 3>, 3>& corners,
                   const std::array<std::array<double, 2>, 3>& places) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto grid = [&](std::size_t axis) {
        return static_cast<std::int16_t>(std::lround(corners[i][axis] / kHalfExtent * 32768));
      };
      positions[i] = {grid(0), grid(1), grid(2)};
      const auto part = [&](std::size_t axis) {
        return static_cast<std::int16_t>(std::lround(places[i][axis] * (1 << kTexcoordBits)));
      };
      texcoords[i] = {part(0), part(1)};
    }
  }
  Scene scene() {
    mesh.positions = positions;
    mesh.texcoords = texcoords;
    mesh.triangles = {&triangle, 1};
    mesh.half_extent = {fixed(kHalfExtent), fixed(kHalfExtent), fixed(kHalfExtent)};
    mesh.texcoord_bits = kTexcoordBits;
    Scene scene;
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.textures = {&texture, 1};
    scene.instances = {&instance, 1};
    scene.finishes = {&finish, 1};
    return scene;
  }
};

struct Place {
  double u, v;  ///< texels of the largest level
};

/// Where a ray through a point of the picture meets the plane of the triangle, in texture coordinates.
class Oracle {
 public:
  Oracle(const TexturedTriangle& subject, const Camera& camera)
      : orthographic_(camera.projection == Projection::orthographic), focal_(camera.focal / 65536.0) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Position& p = subject.positions[i];
      const double scale = TexturedTriangle::kHalfExtent / 32768;
      corners_[i] = {p.x * scale, p.y * scale, p.z * scale - camera.eye.z / 65536.0};
      const double one = 1 << TexturedTriangle::kTexcoordBits;
      places_[i] = {subject.texcoords[i].u / one * (1 << kLog2Width),
                    subject.texcoords[i].v / one * (1 << kLog2Height)};
    }
  }

  Place at(double x, double y) const {
    const double across = (x - kView.width / 2.0) / (kView.height / 2.0 * focal_);
    const double up = -(y - kView.height / 2.0) / (kView.height / 2.0 * focal_);
    using Vector = std::array<double, 3>;
    const Vector origin = orthographic_ ? Vector{across, up, 0} : Vector{0, 0, 0};
    const Vector ray = orthographic_ ? Vector{0, 0, -1} : Vector{across, up, -1};
    const auto minus = [](const Vector& a, const Vector& b) { return Vector{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
    const auto cross = [](const Vector& a, const Vector& b) {
      return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    // Moeller and Trumbore.
    const Vector first = minus(corners_[1], corners_[0]), second = minus(corners_[2], corners_[0]);
    const Vector normal = cross(ray, second), from = minus(origin, corners_[0]);
    const double scale = 1 / dot(first, normal);
    const Vector other = cross(from, first);
    const double s = dot(from, normal) * scale, t = dot(ray, other) * scale;
    const auto mean = [&](double a, double b, double c) { return a * (1 - s - t) + b * s + c * t; };
    return {mean(places_[0].u, places_[1].u, places_[2].u), mean(places_[0].v, places_[1].v, places_[2].v)};
  }

  /// Texels that a step to the right or downwards goes by, whichever is longer, as docs/conventions.md measures it.
  double footprint(double x, double y) const {
    constexpr double kSmall = 1.0 / 1024;
    const auto step = [&](double dx, double dy) {
      const Place a = at(x - dx, y - dy), b = at(x + dx, y + dy);
      const double u = std::abs(b.u - a.u) / (2 * kSmall), v = std::abs(b.v - a.v) / (2 * kSmall);
      return std::max(u, v) + std::min(u, v) / 2;
    };
    return std::max(step(kSmall, 0), step(0, kSmall));
  }

 private:
  bool orthographic_;
  double focal_;
  std::array<std::array<double, 3>, 3> corners_{};
  std::array<Place, 3> places_{};
};

/// What was compared.
struct Judged {
  std::array<int, kSmallerLevels + 1> pixels{};  ///< of each level
  int undecided = 0;                             ///< too near to the middle between two levels
};

/// Along an axis that repeats, how far a place lies outside a texel.
double outside(double place, int index, int size) {
  const double after = place - index;
  const double from_start = after - std::floor(after / size) * size;  // 0 .. size
  return from_start <= 1 ? 0 : std::min(from_start - 1, size - from_start);
}

/// Every pixel of the drawn triangle.
void judge(const Drawn& drawn, const Oracle& oracle, Judged& judged) {
  for (int y = 0; y < drawn.height; ++y) {
    int first = 0, end = drawn.width;
    while (first < end && drawn.at(first, y) == 0) ++first;
    while (end > first && drawn.at(end - 1, y) == 0) --end;
    if (first == 0 || end == drawn.width) continue;  // runs begin outside of the picture
    for (int run = first; run < end; run += 16) {
      const int last = std::min(run + 16, end - 1);  // where the run is exact again
      const double mean = (oracle.footprint(run + 0.5, y + 0.5) + oracle.footprint(last + 0.5, y + 0.5)) / 2;
      // Corners are snapped to 1/16 of a pixel.
      const auto level_of = [](double footprint) {
        return std::clamp(static_cast<int>(std::floor(std::log2(footprint) + 0.5)), 0, kSmallerLevels);
      };
      const int least = level_of(mean * 0.98), most = level_of(mean * 1.02);
      const Place from = oracle.at(run + 0.5, y + 0.5), to = oracle.at(last + 0.5, y + 0.5);
      for (int x = run; x < std::min(run + 16, end); ++x) {
        const int pixel = drawn.at(x, y), level = (pixel >> 11) - 1;
        ASSERT_GE(level, least) << x << ", " << y << ": " << mean;
        ASSERT_LE(level, most) << x << ", " << y << ": " << mean;
        ++judged.pixels[static_cast<std::size_t>(level)];
        judged.undecided += least != most ? 1 : 0;
        const double share = last == run ? 0 : static_cast<double>(x - run) / (last - run);
        const double scale = 1.0 / (1 << level);
        const double u = (from.u + (to.u - from.u) * share) * scale, v = (from.v + (to.v - from.v) * share) * scale;
        const int width = std::max(1, 1 << kLog2Width >> level), height = std::max(1, 1 << kLog2Height >> level);
        const double tolerance = 0.02 + 0.1 * mean * scale;
        if (width > 1) {
          ASSERT_LE(outside(u, pixel & 63, width), tolerance) << x << ", " << y << ": " << level;
        }
        if (height > 1) {
          ASSERT_LE(outside(v, pixel >> 6 & 31, height), tolerance) << x << ", " << y << ": " << level;
        }
        ASSERT_LT(pixel & 63, width);
        ASSERT_LT(pixel >> 6 & 31, height);
      }
    }
  }
}

constexpr Effects kMipmapped = effect::textures | effect::mipmaps;

/// A triangle that lies in the picture, about as large as it; up to 8 times as far away at one corner as at another.
TexturedTriangle random_triangle(std::mt19937& random, double focal, bool orthographic) {
  const auto between = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
  };
  std::array<std::array<double, 3>, 3> corners{};
  std::array<std::array<double, 2>, 3> places{};
  const double repeats = std::exp2(between(-3, 6.5));
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = 2 * 3.14159265 * (static_cast<double>(i) + between(-0.4, 0.4)) / 3;
    const double w = std::exp2(between(0, 3)), reach = orthographic ? 1 : w;
    corners[i] = {1.2 * std::cos(turn) / focal * reach, 0.9 * std::sin(turn) / focal * reach, 3 - w};
    places[i] = {repeats * between(0, 1), repeats * between(0, 1)};
  }
  return {corners, places};
}

void judge_random_triangles(bool orthographic) {
  Camera camera;
  camera.focal = fixed(1.7);
  if (orthographic) camera.projection = Projection::orthographic;
  std::mt19937 random(orthographic ? 26 : 25);
  Judged judged;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE(i);
    TexturedTriangle subject = random_triangle(random, 1.7, orthographic);
    const Oracle oracle(subject, camera);
    if (orthographic) {
      judge(draw<kMipmapped | effect::orthographic>(subject.scene(), camera, kView), oracle, judged);
    } else {
      judge(draw<kMipmapped>(subject.scene(), camera, kView), oracle, judged);
    }
    if (testing::Test::HasFatalFailure()) return;
  }
  int all = 0;
  for (const int pixels : judged.pixels) {
    EXPECT_GT(pixels, 1000);
    all += pixels;
  }
  EXPECT_LT(judged.undecided, all / 10);
}

TEST(Mipmaps, LevelAndTexelAreThoseOfTheDerivativesInPerspective) { judge_random_triangles(false); }
TEST(Mipmaps, LevelAndTexelAreThoseOfTheDerivativesInParallel) { judge_random_triangles(true); }

TEST(Mipmaps, AFloorShowsEveryLevelOnce) {
  // Towards the horizon: levels may only grow from below to above.
  TexturedTriangle floor({{{-6, -0.9, 2.2}, {6, -0.9, 2.2}, {0, -0.9, -19}}}, {{{0, 0}, {8, 0}, {4, 15}}});
  Camera camera;
  const Drawn drawn = draw<kMipmapped>(floor.scene(), camera, kView);
  int level = 0;
  for (int y = kView.height - 1; y >= 0; --y) {
    const int pixel = drawn.at(kView.width / 2, y);
    if (pixel == 0) continue;
    EXPECT_TRUE((pixel >> 11) - 1 == level || (pixel >> 11) - 2 == level) << y;
    level = (pixel >> 11) - 1;
  }
  EXPECT_GE(level, 4);
}

/// Strips, bins and streaming, on triangles whose left ends lie outside of the strip's columns.
TEST(Mipmaps, StripsAndBinsChangeNoLevel) {
  std::mt19937 random(4);
  Camera camera;
  camera.focal = fixed(1.7);
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    TexturedTriangle subject = random_triangle(random, 1.1, false);
    subject.finish.filter = i % 2 == 0 ? TextureFilter::nearest : TextureFilter::bilinear;
    const Scene scene = subject.scene();
    const Effects effects = effects_of(scene, camera);
    const Drawn whole = draw_any(effects, scene, camera, kView);
    EXPECT_EQ(draw_any(effects, scene, camera, kView, {.strip_rows = 7, .strip_columns = 24}), whole);
    EXPECT_EQ(draw_any(effects, scene, camera, kView, {.strip_rows = 1}), whole);
    EXPECT_EQ(draw_any(effects | effect::bins, scene, camera, kView,
                       {.strip_rows = 9, .strip_columns = 40, .modes = Modes::binned}),
              whole);
  }
}

/// All levels the same colours: whatever is chosen, the picture is that without levels.
TEST(Mipmaps, ChangeNoPixelWhereAllLevelsAreOfOneColour) {
  const std::vector<std::uint16_t> plain(341 * 3, 0xB5A7);
  std::vector<std::uint16_t> indexed(16 + 256);
  for (std::size_t i = 0; i < 16; ++i) indexed[i] = 0xB5A7;
  for (std::size_t i = 16; i < indexed.size(); ++i) indexed[i] = static_cast<std::uint16_t>(i * 40503);
  const Camera camera = scenes::turntable_camera(4.0, 20, 2.2);
  for (const bool lit : {false, true}) {
    for (const TextureFormat format : {TextureFormat::rgb565, TextureFormat::palette4}) {
      for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
        Texture texture{format == TextureFormat::rgb565 ? plain : indexed, 4, 4, format};
        const Finish finish{.filter = filter};
        const Material material{.texture = 0, .lit = lit, .smooth = true, .finish = 0};
        Scene scene;
        const Instance box = scenes::block(0, 0.9, 0.6, 0.7, -0.3, 0, -0.6);
        scene.meshes = scenes::kRoomMeshes;
        scene.materials = {&material, 1};
        scene.textures = {&texture, 1};
        scene.instances = {&box, 1};
        scene.lights = scenes::kRoomLights;
        scene.finishes = {&finish, 1};
        const Effects without_levels = effects_of(scene, camera);
        EXPECT_FALSE(without_levels.has(effect::mipmaps));
        const Drawn expected = draw_any(without_levels, scene, camera, kView);
        texture.smaller_levels = 4;
        EXPECT_EQ(without_shades(effects_of(scene, camera)), without_shades(without_levels) | effect::mipmaps);
        EXPECT_EQ(draw_any(effects_of(scene, camera), scene, camera, kView), expected);
      }
    }
  }
}

/// A renderer that could choose levels draws a texture without smaller ones as one that could not.
TEST(Mipmaps, ATextureOfOneLevelIsDrawnAsWithoutTheEffect) {
  const Camera camera;
  TexturedTriangle subject({{{-1, -1, 0}, {1.2, -0.7, 1}, {0, 1.1, -4}}}, {{{0, 0}, {3, 0.5}, {1, 4}}});
  subject.texture.smaller_levels = 0;
  EXPECT_EQ(without_shades(effects_of(subject.scene(), camera)), effect::textures);
  const Drawn expected = draw<effect::textures>(subject.scene(), camera, kView);
  EXPECT_EQ(draw<kMipmapped>(subject.scene(), camera, kView), expected);
  subject.texture.smaller_levels = kSmallerLevels;
  subject.material.finish = kNoFinish;
  EXPECT_EQ(without_shades(effects_of(subject.scene(), camera)), effect::textures)
      << "materials without a finish do not ask";
  EXPECT_EQ(draw<effect::textures>(subject.scene(), camera, kView), expected);
  subject.material.finish = 0;
  EXPECT_NE(draw<kMipmapped>(subject.scene(), camera, kView), expected);
}

TEST(Mipmaps, NeedAllTheirWordsAndEndAtOneTexel) {
  const std::vector<std::uint16_t> words(4096);
  for (const auto& [format, log2_width, log2_height, levels, needed] :
       {std::tuple{TextureFormat::rgb565, 3, 1, 0, 16},
        {TextureFormat::rgb565, 3, 1, 1, 20},
        {TextureFormat::rgb565, 3, 1, 3, 23},
        {TextureFormat::rgb565_alpha, 3, 1, 3, 24 + 6 + 3 + 2},
        {TextureFormat::palette8, 3, 1, 3, 256 + 8 + 2 + 1 + 1},
        {TextureFormat::palette4, 1, 3, 3, 16 + 4 + 1 + 1 + 1}}) {
    const Material material{.texture = 0, .finish = 0};
    const Finish finish;
    Texture texture{std::span(words).first(static_cast<std::size_t>(needed)), static_cast<std::uint8_t>(log2_width),
                    static_cast<std::uint8_t>(log2_height), format, static_cast<std::uint8_t>(levels)};
    Scene scene;
    scene.materials = {&material, 1};
    scene.textures = {&texture, 1};
    scene.finishes = {&finish, 1};
    EXPECT_TRUE(validate(scene)) << needed;
    texture.texels = texture.texels.first(texture.texels.size() - 1);
    EXPECT_EQ(validate(scene).error, Error::texture) << needed;
    texture.texels = words;
    for (const int hostile : {4, 5, 31, 32, 64, 255}) {
      texture.smaller_levels = static_cast<std::uint8_t>(hostile);
      EXPECT_EQ(validate(scene).error, Error::texture) << hostile;
    }
  }
}

}  // namespace
}  // namespace effects_test::mipmap_test
