// Texels, alpha and blending on squares that face an orthographic camera, pixel by pixel.
#include <array>
#include <cmath>

#include "drawn.hpp"

namespace effects_test::fragment_test {
namespace {

constexpr int kSize = 64, kTexels = 16, kScale = kSize / kTexels;
constexpr View kView{kSize, kSize, PixelFormat::rgb565};

Camera facing() {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.focal = kFixedOne;  // from -1 to 1
  return camera;
}

/// Squares that fill the picture, one behind the other.
struct Squares {
  std::array<Position, 4> positions{{{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}}};
  std::array<TexCoord, 4> texcoords{{{0, 4096}, {4096, 4096}, {4096, 0}, {0, 0}}};
  std::array<Triangle, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
  std::array<std::uint16_t, kTexels * kTexels * 3 / 2> texels{};
  Mesh mesh;
  Texture texture{{}, 4, 4, TextureFormat::rgb565_alpha};
  std::vector<Material> materials;
  std::vector<Finish> finishes;
  std::vector<Instance> instances;

  Squares() {
    for (std::size_t i = 0; i < kTexels * kTexels; ++i) {
      texels[i] = static_cast<std::uint16_t>(i * 40503);
      texels[kTexels * kTexels + i / 2] |= static_cast<std::uint16_t>((i * 89 & 0xFF) << (8 * (i & 1)));
    }
  }
  void add(const Material& material, const Finish& finish, double z) {
    materials.push_back(material);
    materials.back().finish = static_cast<std::uint8_t>(finishes.size());
    finishes.push_back(finish);
    Instance instance;
    instance.material = static_cast<std::uint16_t>(materials.size() - 1);
    instance.transform.m[2][3] = static_cast<Fixed>(z * 65536);
    instances.push_back(instance);
  }
  Scene scene() {
    mesh.half_extent = {fixed(1.00004), fixed(1.00004), 0};
    mesh.positions = positions;
    mesh.texcoords = texcoords;
    mesh.triangles = triangles;
    texture.texels = texels;
    Scene scene;
    scene.meshes = {&mesh, 1};
    scene.materials = materials;
    scene.textures = {&texture, 1};
    scene.instances = instances;
    scene.finishes = finishes;
    scene.background = {0, 0, 255, 255};
    return scene;
  }
  int alpha(int x, int y) const { return (y * kTexels + x) * 89 & 0xFF; }
  std::uint16_t texel(int x, int y) const { return texels[static_cast<std::size_t>(y * kTexels + x)]; }
};

constexpr std::uint16_t kBackground = 0x001F;

TEST(EffectsFragments, AMaskDrawsTexelsOfEnoughAlphaAndLeavesTheOthersDepth) {
  Squares squares;
  squares.add({.texture = 0, .lit = false}, {.alpha_mode = AlphaMode::mask, .alpha_cutoff = 100}, 0.5);
  const auto masked = [&] {
    return draw<effect::orthographic | effect::textures | effect::alpha_test | effect::texture_alpha>(squares.scene(),
                                                                                                      facing(), kView);
  };
  Drawn drawn = masked();
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const int u = x / kScale, v = y / kScale;
      EXPECT_EQ(drawn.at(x, y), squares.alpha(u, v) >= 100 ? squares.texel(u, v) : kBackground) << x << ", " << y;
    }
  }
  // What lies behind is seen through the holes although it is drawn later.
  squares.add({.colour = {255, 255, 255, 255}, .lit = false}, {}, -0.5);
  drawn = masked();
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const int u = x / kScale, v = y / kScale;
      EXPECT_EQ(drawn.at(x, y), squares.alpha(u, v) >= 100 ? squares.texel(u, v) : 0xFFFF) << x << ", " << y;
    }
  }
}

double channel(std::uint16_t pixel, int which) {
  switch (which) {
    case 0: return (pixel >> 11) * 255 / 31.0;
    case 1: return (pixel >> 5 & 63) * 255 / 63.0;
    default: return (pixel & 31) * 255 / 31.0;
  }
}

TEST(EffectsFragments, BilinearTexelsAreTheMeanOfFour) {
  Squares squares;
  squares.add({.texture = 0, .lit = false}, {.filter = TextureFilter::bilinear}, 0);
  const Drawn drawn =
      draw<effect::orthographic | effect::textures | effect::bilinear>(squares.scene(), facing(), kView);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double u = (x + 0.5) / kScale - 0.5, v = (y + 0.5) / kScale - 0.5;
      const int u0 = static_cast<int>(std::floor(u)), v0 = static_cast<int>(std::floor(v));
      for (int which = 0; which < 3; ++which) {
        const auto at = [&](int i, int j) { return channel(squares.texel((u0 + i) & 15, (v0 + j) & 15), which); };
        const double upper = at(0, 0) * (1 - (u - u0)) + at(1, 0) * (u - u0);
        const double lower = at(0, 1) * (1 - (u - u0)) + at(1, 1) * (u - u0);
        const double expected = upper * (1 - (v - v0)) + lower * (v - v0);
        // RGB565 drops up to 7 (green 3) of 255; a sixteenth of a texel of the coordinates' snapping.
        EXPECT_NEAR(channel(drawn.at(x, y), which), expected, which == 1 ? 6 : 10) << x << ", " << y << ' ' << which;
      }
    }
  }
}

TEST(EffectsFragments, BlendingMixesFromFarToNearWhateverTheOrder) {
  struct Pane {
    Colour colour;
    double z;
  };
  std::vector<Pane> panes{
      {{255, 0, 0, 100}, -0.6}, {{0, 255, 0, 140}, 0.0}, {{255, 255, 0, 60}, 0.6}, {{0, 0, 0, 200}, 1.2}};
  // The last but one is opaque and hides what is farther.
  double expected[3] = {120, 130, 140};
  const auto mix = [&](const Colour& c) {
    const double share = c.a / 255.0;
    const double own[3] = {double(c.r), double(c.g), double(c.b)};
    for (int i = 0; i < 3; ++i) expected[i] = own[i] * share + expected[i] * (1 - share);
  };
  mix(panes[1].colour), mix(panes[2].colour), mix(panes[3].colour);
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  Drawn first;
  do {
    Squares squares;
    for (const std::size_t i : order) {
      if (i == 4) {
        squares.add({.colour = {120, 130, 140, 255}, .lit = false}, {}, -0.3);
      } else {
        squares.add({.colour = panes[i].colour, .lit = false}, {.alpha_mode = AlphaMode::blend}, panes[i].z);
      }
    }
    const Drawn drawn =
        draw<effect::orthographic | effect::blending>(squares.scene(), facing(), kView, {.strip_rows = 24});
    if (first.pixels.empty()) {
      first = drawn;
      for (int which = 0; which < 3; ++which) {
        EXPECT_NEAR(channel(drawn.at(30, 30), which), expected[which], which == 1 ? 8 : 16)
            << which;  // three times RGB565
      }
    }
    ASSERT_EQ(drawn, first);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(EffectsFragments, ATextureWithoutItsAlphaIsRefused) {
  Squares squares;
  squares.add({.texture = 0, .lit = false}, {.alpha_mode = AlphaMode::mask}, 0);
  EXPECT_TRUE(validate(squares.scene()));
  Scene scene = squares.scene();
  Texture short_one = squares.texture;
  short_one.texels = short_one.texels.first(short_one.texels.size() - 1);
  scene.textures = {&short_one, 1};
  EXPECT_EQ(validate(scene).error, Error::texture);
  short_one = {squares.texels, 4, 4, TextureFormat{4}};
  EXPECT_EQ(validate(scene).error, Error::texture);
}

}  // namespace
}  // namespace effects_test::fragment_test
