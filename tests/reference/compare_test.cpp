// The instruments before their readings: OpenGL draws what can be worked out by hand, and the comparison finds every
// kind of fault that it is there to find.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "compare.hpp"
#include "reference_picture.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::reference {
namespace {

constexpr std::int16_t kUnit = 16384;  // of a mesh whose half extent is 2

/// Quads of two triangles in planes z = const, seen by an orthographic camera: 8 x 8 pixels show -1..1, y upwards.
struct Quads {
  std::vector<Position> positions;
  std::vector<Colour> colours;
  std::vector<Normal> normals;
  std::vector<TexCoord> texcoords;
  std::vector<Triangle> triangles;
  std::array<Mesh, 1> meshes;
  std::array<Material, 1> materials{Material{.lit = false, .smooth = false}};
  std::array<Instance, 1> instances;
  std::array<DirectionalLight, 1> lights;
  std::array<std::uint16_t, 4> texels{0xF800, 0x07E0, 0x001F, 0xFFFF};
  std::array<Texture, 1> textures{Texture{texels, 1, 1}};

  void add(double left, double bottom, double right, double top, double z, const Colour& colour) {
    const auto first = static_cast<std::uint16_t>(positions.size());
    const auto at = [](double c) { return static_cast<std::int16_t>(std::lround(c * kUnit)); };
    for (const auto& [x, y] : {std::pair{left, bottom}, {right, bottom}, {right, top}, {left, top}}) {
      positions.push_back({at(x), at(y), at(z)});
      colours.push_back(colour);
    }
    const auto corner = [first](int i) { return static_cast<std::uint16_t>(first + i); };
    triangles.push_back({corner(0), corner(1), corner(2)});
    triangles.push_back({corner(0), corner(2), corner(3)});
  }

  sim::Staging staging() {
    meshes[0] = {.positions = positions,
                 .normals = normals,
                 .colours = colours,
                 .texcoords = texcoords,
                 .triangles = triangles,
                 .meshlets = {},
                 .half_extent = {2 * kFixedOne, 2 * kFixedOne, 2 * kFixedOne}};
    sim::Staging result;
    result.scene.meshes = meshes;
    result.scene.materials = materials;
    result.scene.textures = textures;
    result.scene.instances = instances;
    result.scene.lights = lights;
    result.camera.eye = {0, 0, 4 * kFixedOne};
    result.camera.focal = kFixedOne;
    result.camera.projection = Projection::orthographic;
    return result;
  }
};

constexpr View kSmall{.width = 8, .height = 8};
constexpr Colour kRed{200, 0, 0, 255}, kGreen{0, 200, 0, 255};

/// One letter a pixel: r, g, b, w by the strongest channel, '.' for the background.
std::string letters(const Samples& samples, const View& view) {
  std::string text;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    const char letter = !s.drawn()                 ? '.'
                        : s.r == s.g && s.g == s.b ? 'w'
                        : s.r >= s.g && s.r >= s.b ? 'r'
                        : s.g >= s.b               ? 'g'
                                                   : 'b';
    text += letter;
    if ((i + 1) % view.width == 0) text += '\n';
  }
  return text;
}

std::string centres(const sim::Staging& staging) {
  const auto reference = draw_reference(staging, kSmall, 0);
  return reference ? letters(reference->centres(), kSmall) : reference.failure().message;
}

TEST(ReferenceRenderer, PutsXRightAndYUp) {
  Quads quads;
  quads.add(0, 0.25, 0.5, 1, 0, kRed);
  EXPECT_EQ(centres(quads.staging()),
            "....rr..\n....rr..\n....rr..\n........\n........\n........\n........\n........\n");
}

TEST(ReferenceRenderer, TheNearerSurfaceHidesTheFartherInAnyOrder) {
  for (const bool near_first : {false, true}) {
    Quads quads;
    if (near_first) quads.add(-0.5, -0.5, 0.5, 0.5, 0.5, kRed);
    quads.add(-1, 0, 1, 1, 0, kGreen);
    if (!near_first) quads.add(-0.5, -0.5, 0.5, 0.5, 0.5, kRed);
    EXPECT_EQ(centres(quads.staging()),
              "gggggggg\ngggggggg\nggrrrrgg\nggrrrrgg\n..rrrr..\n..rrrr..\n........\n........\n");
  }
}

TEST(ReferenceRenderer, CullsTheBackUnlessDoubleSided) {
  Quads quads;
  quads.add(-1, -1, 1, 1, 0, kRed);
  for (Triangle& triangle : quads.triangles) std::swap(triangle.b, triangle.c);
  EXPECT_EQ(centres(quads.staging()).find('r'), std::string::npos);
  quads.materials[0].double_sided = true;
  EXPECT_EQ(centres(quads.staging()).find('.'), std::string::npos);
}

TEST(ReferenceRenderer, ThePartInFrontOfTheNearPlaneIsCut) {
  Quads quads;
  quads.add(-1, -1, 1, 1, 0, kRed);
  quads.positions[0].z = quads.positions[3].z = kUnit;  // the left side leans to distance 3, the right one is at 4
  sim::Staging staging = quads.staging();
  staging.camera.near_plane = 7 * kFixedOne / 2;
  EXPECT_EQ(centres(staging).substr(0, 9), "....rrrr\n");
}

TEST(ReferenceRenderer, TextureRowsRunDownwardsAndTexelsAreNearest) {
  Quads quads;
  quads.add(-1, -1, 1, 1, 0, {255, 255, 255, 255});
  quads.materials[0].texture = 0;
  constexpr std::int16_t kWhole = 1 << 12;
  quads.texcoords = {{0, kWhole}, {kWhole, kWhole}, {kWhole, 0}, {0, 0}};
  EXPECT_EQ(centres(quads.staging()),
            "rrrrgggg\nrrrrgggg\nrrrrgggg\nrrrrgggg\nbbbbwwww\nbbbbwwww\nbbbbwwww\nbbbbwwww\n");
}

// The right side is three times as far as the left one: half of the texture lies at a quarter of the screen's way.
TEST(ReferenceRenderer, TexturesAreCorrectInPerspective) {
  Quads quads;
  quads.add(-1, -1, 1, 1, 0, {255, 255, 255, 255});
  quads.positions = {{-kUnit / 2, -kUnit / 2, kUnit},
                     {3 * kUnit / 2, -3 * kUnit / 2, -kUnit},
                     {3 * kUnit / 2, 3 * kUnit / 2, -kUnit},
                     {-kUnit / 2, kUnit / 2, kUnit}};
  quads.materials[0].texture = 0;
  constexpr std::int16_t kWhole = 1 << 12;
  quads.texcoords = {{0, kWhole}, {kWhole, kWhole}, {kWhole, 0}, {0, 0}};
  sim::Staging staging = quads.staging();
  staging.camera.projection = Projection::perspective;
  staging.camera.eye = {0, 0, 2 * kFixedOne};  // distances 1 and 3
  staging.camera.focal = 2 * kFixedOne;        // from -1 to 1 on the screen
  EXPECT_EQ(centres(staging).substr(0, 9), "rrrrrrgg\n");
}

TEST(ReferenceRenderer, LightFollowsTheCosine) {
  Quads quads;
  quads.add(-1, -1, 1, 1, 0, {255, 255, 255, 255});
  quads.normals.assign(4, {0, 0, 127, 0});
  quads.materials[0].lit = true;
  quads.lights[0] = {.x = 28377, .y = 0, .z = 16384, .colour = {100, 100, 100, 255}};  // 60 degrees off
  sim::Staging staging = quads.staging();
  staging.scene.ambient = {30, 30, 30, 255};
  const auto reference = draw_reference(staging, kSmall, 0);
  ASSERT_TRUE(reference) << reference.failure().message;
  EXPECT_NEAR(reference->centres()[27].r, 30 + 100 * 0.5, 0.01);
}

/// The flat knot, which both draw alike.
class ReferenceComparison : public ::testing::Test {
 protected:
  void SetUp() override {
    stage(*scenes::find("knot_flat"), staged_, 0, 1, kView);
    const sim::Staging staging{staged_.scene, staged_.camera};
    auto picture = draw(staging, kView);
    ASSERT_TRUE(picture) << picture.failure().message;
    picture_ = std::move(*picture);
    auto reference = draw_reference(staging, kView, 0);
    ASSERT_TRUE(reference) << reference.failure().message;
    reference_ = std::move(*reference);
    const Comparison result = judged();
    ASSERT_EQ(faults(result), 0U);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      if (result.verdicts[i] == Verdict::certain) inside_ = i;
      if (result.verdicts[i] == Verdict::background) outside_ = i;
    }
  }
  Comparison judged() const { return compare(picture_, reference_, 0.001); }
  static std::uint32_t faults(const Comparison& result) {
    return result.of(Verdict::foreign) + result.of(Verdict::coverage) + result.of(Verdict::shading);
  }

  static constexpr View kView{.width = 96, .height = 72};
  RendererPicture picture_;
  ReferencePicture reference_;
  std::size_t inside_ = 0, outside_ = 0;  ///< the last pixel that is certain, the last one of the background

 private:
  scenes::Staged staged_;
};

TEST_F(ReferenceComparison, FindsAHole) {
  picture_.drawn[inside_] = 0;
  EXPECT_EQ(judged().of(Verdict::coverage), 1U);
}

TEST_F(ReferenceComparison, FindsAStray) {
  picture_.drawn[outside_] = 1;
  picture_.pixels[outside_] = 0xFFFF;
  const Comparison result = judged();
  EXPECT_EQ(result.of(Verdict::coverage), 1U);
  EXPECT_EQ(result.silhouette_strays, 1U);
}

TEST_F(ReferenceComparison, FindsOneCodeOfOneChannel) {
  for (const unsigned bit : {0x0001U, 0x0020U, 0x0800U}) {
    const std::uint16_t pixel = picture_.pixels[inside_];
    picture_.pixels[inside_] = static_cast<std::uint16_t>(pixel ^ bit);
    EXPECT_EQ(judged().of(Verdict::shading), 1U) << bit;
    picture_.pixels[inside_] = pixel;
  }
}

TEST_F(ReferenceComparison, FindsAPictureThatIsOnePixelAside) {
  std::rotate(picture_.pixels.begin(), picture_.pixels.begin() + 1, picture_.pixels.end());
  std::rotate(picture_.drawn.begin(), picture_.drawn.begin() + 1, picture_.drawn.end());
  const Comparison result = judged();
  EXPECT_GT(result.of(Verdict::coverage), 50U);
  EXPECT_GT(result.of(Verdict::foreign), 200U);
  EXPECT_EQ(result.silhouette_strays, 0U);
}

TEST_F(ReferenceComparison, FindsTheColourOfAnotherTriangle) {
  for (std::size_t i = 0; i < picture_.pixels.size(); ++i) {
    if (reference_.centres()[i].drawn() && truncated(reference_.centres()[i]) != picture_.pixels[inside_]) {
      picture_.pixels[inside_] = truncated(reference_.centres()[i]);
      break;
    }
  }
  EXPECT_EQ(judged().of(Verdict::shading), 1U);
}

}  // namespace
}  // namespace zstrip::reference
