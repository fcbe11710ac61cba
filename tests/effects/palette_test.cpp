// Textures with palettes: every texel is its entry, and a palette changes no pixel of what has the same colours without
// one, whatever else the fragments do.
#include <array>

#include "drawn.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test::palette_test {
namespace {

/// 32x16 texels of 16 or 256 colours, as RGB565 and with a palette: written here from the definition of the format.
struct Texels {
  static constexpr std::uint8_t kLog2Width = 5, kLog2Height = 4;
  std::vector<std::uint16_t> colours, words;
  TextureFormat format;

  explicit Texels(TextureFormat f) : format(f) {
    const std::size_t entries = f == TextureFormat::palette8 ? 256 : 16, in_word = f == TextureFormat::palette8 ? 2 : 4;
    for (std::size_t i = 0; i < entries; ++i) words.push_back(static_cast<std::uint16_t>(i * 40503 + 977));
    for (std::size_t i = 0; i < std::size_t{1} << (kLog2Width + kLog2Height); ++i) {
      const std::size_t index = (i * i / 3 + 5 * i) % entries;
      colours.push_back(words[index]);
      if (i % in_word == 0) words.push_back(0);
      words.back() = static_cast<std::uint16_t>(words.back() | index << (16 / in_word * (i % in_word)));
    }
  }
  Texture plain() const { return {colours, kLog2Width, kLog2Height}; }
  Texture indexed() const { return {words, kLog2Width, kLog2Height, format}; }
};

/// The boxes of the effects' tests with a texture; all materials have a finish.
struct Boxes {
  Material materials[2];
  Finish finishes[2];
  Texture texture;
  Fog fog{.colour = {150, 165, 180, 255}, .start = 0, .end = fixed(8)};
  Instance instances[2] = {scenes::block(0, 0.9, 0.6, 0.7, -0.3, 0, -0.6),
                           scenes::block(1, 0.5, 0.7, 0.5, 0.4, 0.1, 0.5)};
  Scene scene;

  Boxes(const Texture& of, bool lit, bool smooth) : texture(of) {
    for (std::uint8_t i = 0; i < 2; ++i) {
      materials[i] = {.colour = {250, 240, 230, 160}, .texture = 0, .lit = lit, .smooth = smooth, .finish = i};
    }
    scene.meshes = scenes::kRoomMeshes;
    scene.materials = materials;
    scene.textures = {&texture, 1};
    scene.instances = instances;
    scene.lights = scenes::kRoomLights;
    scene.finishes = finishes;
  }
};

constexpr View kView{90, 70, PixelFormat::rgb565}, kIcon{24, 18, PixelFormat::rgb565};

Drawn drawn(const Boxes& boxes, const Camera& camera, const View& view, const Budget& budget = {}, Effects more = {}) {
  return draw_any(effects_of(boxes.scene, camera) | more, boxes.scene, camera, view, budget);
}

template <class Change>
void expect_no_difference(const Camera& camera, const Change& change) {
  for (const TextureFormat format : {TextureFormat::palette8, TextureFormat::palette4}) {
    const Texels texels(format);
    for (const bool lit : {false, true}) {
      for (const bool smooth : {false, true}) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(format) << lit << smooth);
        Boxes plain(texels.plain(), lit, smooth), indexed(texels.indexed(), lit, smooth);
        change(plain);
        change(indexed);
        EXPECT_FALSE(effects_of(plain.scene, camera).has(effect::texture_palettes));
        EXPECT_TRUE(effects_of(indexed.scene, camera).has(effect::texture_palettes));
        for (const View& view : {kView, kIcon}) {  // small triangles have a way of their own
          const Drawn expected = drawn(plain, camera, view);
          const auto painted = std::ranges::count_if(expected.pixels, [](std::uint16_t pixel) { return pixel != 0; });
          EXPECT_GT(painted, view.width * view.height / 8);
          EXPECT_EQ(drawn(indexed, camera, view), expected);
          EXPECT_EQ(drawn(indexed, camera, view, {.strip_rows = 7, .strip_columns = 16}), expected);
          EXPECT_EQ(drawn(indexed, camera, view, {.strip_rows = 9, .modes = Modes::binned}, effect::bins), expected);
        }
      }
    }
  }
}

const Camera kCamera = scenes::turntable_camera(4.0, 20, 2.2);
Camera parallel() {
  Camera camera = kCamera;
  camera.projection = Projection::orthographic;
  camera.focal = fixed(0.7);
  return camera;
}

TEST(Palettes, ChangeNoPixelOfTexturesAlone) {
  expect_no_difference(kCamera, [](Boxes&) {});
  expect_no_difference(parallel(), [](Boxes&) {});
}
TEST(Palettes, ChangeNoPixelInFog) {
  expect_no_difference(kCamera, [](Boxes& boxes) { boxes.scene.fog = &boxes.fog; });
}
TEST(Palettes, ChangeNoPixelOfFilteredTexels) {
  expect_no_difference(kCamera, [](Boxes& boxes) { boxes.finishes[1].filter = TextureFilter::bilinear; });
}
TEST(Palettes, ChangeNoPixelOfBlending) {
  expect_no_difference(kCamera, [](Boxes& boxes) { boxes.finishes[1].alpha_mode = AlphaMode::blend; });
}

TEST(Palettes, TheExactPipelineDrawsWhatTheHostsDoes) {
  const Texels texels(TextureFormat::palette4);
  const Boxes boxes(texels.indexed(), true, true);
  constexpr Effects kExact = effect::lighting | effect::gouraud | effect::textures | effect::texture_palettes;
  const Camera camera = kCamera;
  ASSERT_EQ(without_shades(effects_of(boxes.scene, camera)), kExact);
  EXPECT_EQ(draw<kExact>(boxes.scene, camera, kView), drawn(boxes, camera, kView));
  EXPECT_EQ(draw<kExact>(boxes.scene, camera, kView, {.strip_rows = 3}), drawn(boxes, camera, kView));
}

TEST(Palettes, DitheredPicturesAreThoseOfTheColours) {
  const Texels texels(TextureFormat::palette8);
  constexpr View kDithered{90, 70, PixelFormat::rgb565, true};
  for (const bool smooth : {false, true}) {
    const Boxes plain(texels.plain(), true, smooth), indexed(texels.indexed(), true, smooth);
    const auto picture = [&](const Boxes& boxes) {
      return draw_any(effects_of(boxes.scene, kCamera) | effects_of(kDithered), boxes.scene, kCamera, kDithered);
    };
    EXPECT_EQ(picture(indexed), picture(plain));
  }
}

TEST(Palettes, ARendererThatCannotDitherDrawsThePictureUndithered) {
  const Texels texels(TextureFormat::palette4);
  constexpr Effects kExact = effect::lighting | effect::gouraud | effect::textures | effect::texture_palettes;
  const Boxes boxes(texels.indexed(), true, true);
  EXPECT_EQ(draw<kExact>(boxes.scene, kCamera, {90, 70, PixelFormat::rgb565, true}),
            draw<kExact>(boxes.scene, kCamera, kView));
}

TEST(Palettes, AreRefusedWhereTheyWouldBeReadAsColours) {
  const Texels texels(TextureFormat::palette4);
  Boxes boxes(texels.indexed(), true, true);
  EXPECT_TRUE(validate(boxes.scene));
  boxes.materials[1].finish = kNoFinish;
  EXPECT_EQ(validate(boxes.scene), (Status{.error = Error::material, .needed = 1}));
  boxes.materials[1].finish = 0;
  const Quadric quadric{.material = 0};
  boxes.scene.quadrics = {&quadric, 1};
  EXPECT_EQ(validate(boxes.scene).error, Error::quadric);
}

TEST(Palettes, NeedAllTheirWords) {
  for (const TextureFormat format : {TextureFormat::palette8, TextureFormat::palette4}) {
    const Texels texels(format);
    Boxes boxes(texels.indexed(), true, true);
    EXPECT_EQ(texels.words.size(), format == TextureFormat::palette8 ? 256U + 256U : 16U + 128U);
    boxes.texture.texels = std::span(texels.words).first(texels.words.size() - 1);
    EXPECT_EQ(validate(boxes.scene), (Status{.error = Error::texture, .needed = 0}));
  }
  const std::uint16_t one[17] = {};
  Boxes single(Texture{one, 0, 0, TextureFormat::palette4}, true, true);
  EXPECT_TRUE(validate(single.scene)) << "of one texel, in a word of its own";
  single.texture.texels = std::span(one).first(16);
  EXPECT_FALSE(validate(single.scene));
}

}  // namespace
}  // namespace effects_test::palette_test
