// `zstrip fit`: what it states is what is written, what it chooses fits and looks alike, and what does not fit is said.
#include <string>

#include "reduced_model.hpp"

namespace zstrip::sim::test {
namespace {

class Fit : public ReducedModel {
 protected:
  std::string sphere() {
    texture("colours.tga", 256);
    return textured_sphere(24, 12);
  }
  Json fit(const std::string& model, std::vector<std::string> options) {
    options.insert(options.begin(), {"fit", model, "--board", "pico", "--size", "160x160"});
    return report(options);
  }
};

TEST_F(Fit, ATexturedModelFitsAFlashThatItDidNotFitAndLooksAlike) {
  const std::string model = sphere();
  EXPECT_GT(report({"bake", model, "-o", "whole.zsc"}).at("flash_bytes").at("total"), 128 * 1024);
  const Json found = fit(model, {"--flash", "24K", "-o", "small.zsc", "--html", "sheet.html"});
  const Json& choice = found.at("choices").at(0);
  EXPECT_LE(choice.at("flash_bytes"), 24 * 1024);
  EXPECT_EQ(choice.at("flash_bytes"), read(path("small.zsc")).size());
  EXPECT_EQ(found.at("chosen"), 1);
  EXPECT_LT(choice.at("rms"), 6);
  EXPECT_LT(mean_difference(picture(model, {}), picture("small.zsc", {})), 3);
  for (const Json& other : found.at("choices")) EXPECT_GE(other.at("rms"), choice.at("rms"));

  const std::string page = read(path("sheet.html"));
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<img src=\"data:image/png;base64,"); at != std::string::npos;
       at = page.find("<img src=\"data:image/png;base64,", at + 1)) {
    ++pictures;
  }
  EXPECT_EQ(pictures, found.at("choices").size() + 1);
  EXPECT_EQ(page.find("http"), std::string::npos) << "it needs no other file";
}

TEST_F(Fit, MemoryIsThatOfTheBakeOfTheSameOptions) {
  const std::string model = sphere();
  const Json found = fit(model, {"--ram", "24K", "--choose", "2", "-o", "scene.hpp"});
  EXPECT_EQ(found.at("chosen"), 2);
  const Json& choice = found.at("choices").at(1);
  std::vector<std::string> options{
      "bake",           model,   "-o",  "same.hpp",        "--size", "160x160",    "--format",
      "rgb565_swapped", "--ram", "24K", "--strip-buffers", "2",      "--textures", choice.at("textures")};
  if (!choice.at("texture_size").is_null()) {
    options.insert(options.end(), {"--texture-size", std::to_string(choice.at("texture_size").get<int>())});
  }
  options.insert(options.end(), {"--triangles", choice.at("triangles_option")});
  const Json baked = report(options);
  EXPECT_EQ(read(path("same.hpp")), read(path("scene.hpp")));
  EXPECT_EQ(choice.at("flash_bytes"), baked.at("flash_bytes").at("total"));
  const Json& ram = baked.at("plan").at("ram_bytes");
  const std::uint64_t bytes = ram.at("arena").get<std::uint64_t>() + 2 * ram.at("strip_pixels").get<std::uint64_t>();
  EXPECT_EQ(choice.at("ram_bytes"), bytes);
  EXPECT_LE(bytes, 24 * 1024U);
}

TEST_F(Fit, WhatFitsNothingSaysWhichLimitAndHowNear) {
  const std::string model = sphere();
  const Outcome flash = zstrip({"fit", model, "--board", "pico", "--size", "64x48", "--flash", "100"});
  EXPECT_EQ(flash.status, 5);
  EXPECT_NE(flash.err.find("of flash, and 100 are allowed"), std::string::npos) << flash.err;
  EXPECT_EQ(std::ranges::count(flash.err, '\n'), 1) << flash.err;
  const Outcome frames = zstrip({"fit", model, "--board", "pico", "--size", "64x48", "--fps", "100000"});
  EXPECT_EQ(frames.status, 5);
  EXPECT_NE(frames.err.find("frames a second, and 100000 are asked for"), std::string::npos) << frames.err;
  EXPECT_EQ(zstrip({"fit", model, "--board", "pico", "--size", "64x48", "--ram", "100"}).status, 5);
  EXPECT_EQ(files(), (std::vector<std::string>{"colours.tga", "sphere.mtl", "sphere.obj"}));
}

TEST_F(Fit, OptionsThatMeanNothingAreUsageErrors) {
  const std::string model = sphere();
  const auto status = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"fit", model, "--size", "64x48"});
    return zstrip(options).status;
  };
  EXPECT_EQ(status({}), 2) << "no board";
  EXPECT_EQ(status({"--board", "pica"}), 2);
  EXPECT_EQ(status({"--board", "pico", "--fps", "0"}), 2);
  EXPECT_EQ(status({"--board", "pico", "--ram", "1M"}), 2) << "more than the board has";
  EXPECT_EQ(status({"--board", "pico", "--choose", "999"}), 2);
  EXPECT_EQ(status({"--board", "bluepill", "-o", "scene.uf2"}), 2);
  EXPECT_EQ(status({"--board", "pico", "--html", "a.html", "--json", "./a.html"}), 2);
  EXPECT_EQ(zstrip({"fit", "teapot", "--board", "pico"}).status, 2);
  EXPECT_EQ(zstrip({"fit", file("broken.glb", "glTF"), "--board", "pico"}).status, 4);
}

}  // namespace
}  // namespace zstrip::sim::test
