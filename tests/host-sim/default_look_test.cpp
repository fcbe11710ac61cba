// How a model is shown that says nothing about it, measured from the pixels.
#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Rgb colour_at(const RgbImage& image, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* const pixel = image.pixel(x, y);
  return {pixel[0], pixel[1], pixel[2]};
}

/// Pixels that have another colour than the upper left one.
struct Shown {
  std::uint32_t left = UINT32_MAX, top = UINT32_MAX, right = 0, bottom = 0;  ///< the box around them
  std::map<Rgb, std::uint32_t> colours;                                      ///< how many pixels each has
};

Shown shown(const RgbImage& image) {
  Shown found;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const Rgb colour = colour_at(image, x, y);
      if (colour == colour_at(image, 0, 0)) continue;
      ++found.colours[colour];
      found.left = std::min(found.left, x);
      found.top = std::min(found.top, y);
      found.right = std::max(found.right, x);
      found.bottom = std::max(found.bottom, y);
    }
  }
  return found;
}

/// How many of the colours have at least a twentieth of the model's pixels: a face of a cube has one.
std::ptrdiff_t faces(const Shown& model) {
  std::uint32_t all = 0;
  for (const auto& [colour, count] : model.colours) all += count;
  return std::ranges::count_if(model.colours, [&](const auto& each) { return each.second * 20 > all; });
}

class DefaultLook : public Command {
 protected:
  RgbImage drawn(const std::string& scene, std::vector<std::string> options) const {
    options.insert(options.begin(), {"render", scene, "-o", "p.png", "--quiet"});
    const Outcome outcome = zstrip(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return picture("p.png");
  }
};

TEST_F(DefaultLook, AModelAloneIsSeenFromThreeQuartersWithAMarginOnALightBackground) {
  file("cube.obj", cube_obj());
  for (const auto& [size, format] : {std::pair{"320x240", "rgb565"}, {"240x240", "rgb565"}, {"128x64", "gray4"}}) {
    const RgbImage image = drawn("cube.obj", {"--size", size, "--format", format});
    const Rgb background = colour_at(image, 0, 0);
    EXPECT_GE(*std::ranges::min_element(background), 190) << size;
    const Shown cube = shown(image);
    EXPECT_EQ(faces(cube), 3) << size << ": front, side and top";
    const std::uint32_t margin =
        std::min({cube.left, cube.top, image.width - 1 - cube.right, image.height - 1 - cube.bottom});
    EXPECT_GE(margin * 100, image.height * 4) << size;
    EXPECT_LE(margin * 100, image.height * 8) << size;
    // No face is darker than a third of the brightest one, of a grey of 60 %.
    std::uint8_t darkest = 255, brightest = 0;
    for (const auto& [colour, count] : cube.colours) {
      darkest = std::min(darkest, colour[1]);
      brightest = std::max(brightest, colour[1]);
    }
    EXPECT_GE(darkest * 3, brightest) << size;
    EXPECT_GE(brightest, 128) << size;
  }
}

/// A cube has the same outline after a quarter of a turn only if it turns about its vertical axis.
TEST_F(DefaultLook, AModelAloneTurnsAboutItsVerticalAxisWithinTheMargin) {
  file("cube.obj", cube_obj());
  ASSERT_EQ(zstrip({"render", "cube.obj", "-o", "turn", "--frames", "8", "--quiet"}).status, 0);
  std::vector<Shown> frames;
  for (int frame = 0; frame < 8; ++frame) {
    frames.push_back(shown(picture("turn/frame_000" + std::to_string(frame) + ".png")));
    const Shown& last = frames.back();
    EXPECT_GE(std::min({last.left, last.top, 319 - last.right, 239 - last.bottom}), 10U) << frame;
    if (frame < 2) continue;
    const Shown& quarter = frames[static_cast<std::size_t>(frame) - 2];
    EXPECT_EQ(std::tie(last.left, last.top, last.right, last.bottom),
              std::tie(quarter.left, quarter.top, quarter.right, quarter.bottom))
        << frame;
  }
  EXPECT_NE(frames[0].left, frames[1].left);
}

/// Where a pixel is black or white, a lit model would be as white as a light background.
TEST_F(DefaultLook, OneBitShowsAWhiteModelOnBlack) {
  file("cube.obj", cube_obj());
  const RgbImage image = drawn("cube.obj", {"--size", "128x64", "--format", "mono"});
  EXPECT_EQ(colour_at(image, 0, 0), (Rgb{0, 0, 0}));
  EXPECT_GE(shown(image).colours[(Rgb{255, 255, 255})], 500U);
}

TEST_F(DefaultLook, TheBackgroundOptionWins) {
  file("cube.obj", cube_obj());
  EXPECT_EQ(colour_at(drawn("cube.obj", {"--background", "000000"}), 0, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(colour_at(drawn("cube.obj", {"--background", "#FF0000"}), 0, 0), (Rgb{255, 0, 0}));
  EXPECT_EQ(colour_at(drawn("cube.obj", {"--background", "ffffff", "--format", "mono"}), 0, 0), (Rgb{255, 255, 255}));
  for (const char* wrong : {"red", "12345", "#1234567", "12345g", "-12345", "+1+2+3"}) {
    const Outcome outcome = zstrip({"render", "cube.obj", std::string("--background=") + wrong});
    EXPECT_EQ(outcome.status, static_cast<int>(ExitStatus::usage)) << wrong;
    EXPECT_NE(outcome.err.find("for example ced3d6"), std::string::npos) << outcome.err;
  }
}

/// The camera sees the front and the right side from slightly above.
TEST_F(DefaultLook, TheLightOptionMovesTheLight) {
  file("cube.obj", cube_obj());
  const auto drawn_from = [&](const char* light) { return drawn("cube.obj", {"--light", light}); };
  const Rgb right = colour_at(drawn_from("1,0,0"), 240, 120), left = colour_at(drawn_from("-1,0,0"), 240, 120);
  EXPECT_NE(right, left);
  EXPECT_EQ(drawn_from("0.1,0.8,0.6").rgb, drawn("cube.obj", {}).rgb);
  EXPECT_EQ(drawn_from("0.01,0.08,0.06").rgb, drawn("cube.obj", {}).rgb);
  for (const char* wrong : {"up", "1,2", "0,0,0", "nan,0,1"}) {
    const Outcome outcome = zstrip({"render", "cube.obj", std::string("--light=") + wrong});
    EXPECT_EQ(outcome.status, static_cast<int>(ExitStatus::usage)) << wrong;
    EXPECT_NE(outcome.err.find("--light"), std::string::npos) << outcome.err;
  }
}

TEST_F(DefaultLook, ASceneFileKeepsItsOwn) {
  file("cube.obj", cube_obj());
  const std::string model = "[[model]]\nname = 'cube'\nfile = 'cube.obj'\n[[instance]]\nmodel = 'cube'\n";
  file("own.toml", "background = '#214163'\n[camera]\neye = [0, 0, 9]\n" + model);
  const RgbImage own = drawn("own.toml", {"--format", "xrgb8888"});
  EXPECT_EQ(colour_at(own, 0, 0), (Rgb{0x21, 0x41, 0x63}));
  EXPECT_EQ(faces(shown(own)), 1) << "the front";
  file("plain.toml", model);
  const RgbImage plain = drawn("plain.toml", {});
  EXPECT_EQ(colour_at(plain, 0, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(faces(shown(plain)), 2) << "front and top";
  const Outcome refused = zstrip({"render", "own.toml", "--background", "ffffff"});
  EXPECT_EQ(refused.status, static_cast<int>(ExitStatus::usage));
  EXPECT_NE(refused.err.find("'own.toml' says it itself, in the key background"), std::string::npos) << refused.err;
  const Outcome unlit = zstrip({"render", "own.toml", "--light", "0,1,0"});
  EXPECT_EQ(unlit.status, static_cast<int>(ExitStatus::usage));
  EXPECT_NE(unlit.err.find("'own.toml' says it itself, in [[light]]"), std::string::npos) << unlit.err;
}

}  // namespace
}  // namespace zstrip::sim::test
