// `zstrip fit`: what it states is what is written, what it chooses fits and looks alike, and what does not fit is said.
#include <cmath>
#include <filesystem>
#include <numbers>
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

TEST_F(Fit, TheBakeThatEachChoiceNamesTakesItsFlashAndItsRam) {
  const std::string model = sphere();
  const Json found = fit(
      model, {"--ram", "24K", "--choose", "2", "-o", "scene.hpp", "--edges", "--orbit", "5,-20,70", "--light=-1,1,1"});
  EXPECT_EQ(found.at("chosen"), 2);
  const std::string chosen = read(path("scene.hpp"));
  ASSERT_GE(found.at("choices").size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& choice = found.at("choices").at(i);
    const Json baked = report(choice.at("bake").get<std::vector<std::string>>());
    EXPECT_EQ(read(path("scene.hpp")) == chosen, i == 1);
    EXPECT_EQ(choice.at("flash_bytes"), baked.at("flash_bytes").at("total"));
    const Json& ram = baked.at("plan").at("ram_bytes");
    const std::uint64_t bytes = ram.at("arena").get<std::uint64_t>() + 2 * ram.at("strip_pixels").get<std::uint64_t>();
    EXPECT_EQ(choice.at("ram_bytes"), bytes);
    EXPECT_LE(bytes, 24 * 1024U);
  }
}

TEST_F(Fit, FlashAndRamOfModelsOfAllKindsAreThoseOfTheirBakes) {
  for (const char* name : {"aniso.obj",
                           "blend_opaque.gltf",
                           "blender.dae",
                           "blender.fbx",
                           "c_avatar.vrm",
                           "geo_4e6.gltf",
                           "instancing.gltf",
                           "m_production.3mf",
                           "octahedron.obj",
                           "one_key.gltf",
                           "p_face.ply",
                           "palette3.gltf",
                           "rgba.obj",
                           "root_with_parent.gltf",
                           "s_ls.stl",
                           "s_mag.stl",
                           "scale_zero.gltf",
                           "skin_small.gltf",
                           "specgloss_gold.gltf",
                           "../../bake/models/colours.ply",
                           "../../bake/models/house.obj"}) {
    const std::string model = (std::filesystem::path(SMALL_MODELS) / name).string();
    for (const char* output : {"scene.zsc", "scene.hpp"}) {
      const Json found = report({"fit", model, "--board", "pico", "--size", "48x48", "-o", output});
      const Json& choice = found.at("choices").at(0);
      const std::string written = read(path(output));
      if (std::string(output) == "scene.zsc") {
        EXPECT_EQ(choice.at("flash_bytes"), written.size()) << model;
      }
      const Json baked = report(choice.at("bake").get<std::vector<std::string>>());
      EXPECT_EQ(read(path(output)), written) << model;
      EXPECT_EQ(choice.at("flash_bytes"), baked.at("flash_bytes").at("total")) << model;
      const Json& ram = baked.at("plan").at("ram_bytes");
      std::uint64_t bytes = ram.at("arena").get<std::uint64_t>() + 2 * ram.at("strip_pixels").get<std::uint64_t>();
      for (const char* key : {"moved_vertices", "joints"}) bytes += ram.value(key, std::uint64_t{0});
      EXPECT_EQ(choice.at("ram_bytes"), bytes) << model;
    }
  }
}

TEST_F(Fit, EdgesAndSamplesAreLeftOffWhereTheyDoNotFit) {
  const std::string model = sphere();
  const auto has = [](const Json& found, const char* key, const Json& value) {
    return std::ranges::any_of(found.at("choices"), [&](const Json& choice) { return choice.at(key) == value; });
  };
  const Json samples = fit(model, {"--samples", "4"});
  EXPECT_TRUE(has(samples, "samples", 4));
  EXPECT_TRUE(has(samples, "samples", 1)) << "faster";
  const double rate = samples.at("choices").at(0).at("frames_per_second").at(0);
  const Json fast = fit(model, {"--samples", "4", "--fps", std::to_string(rate * 1.5)});
  EXPECT_TRUE(has(fast, "samples", 1));
  const Json edges = fit(model, {"--edges", "--flash", "200K"});
  EXPECT_TRUE(has(edges, "edges", true));
  EXPECT_TRUE(has(edges, "edges", false));
}

TEST_F(Fit, ATextureGoesWhereColoursOfVerticesLookAlike) {
  const std::string model = sphere();
  const Json found = fit(model, {"--html", "sheet.html"});
  const auto at =
      std::ranges::find_if(found.at("choices"), [](const Json& one) { return one.at("texture_size") == 0; });
  ASSERT_NE(at, found.at("choices").end());
  EXPECT_LT(at->at("rms"), 8);
  EXPECT_GT(at->at("frames_per_second").at(0), found.at("choices").at(0).at("frames_per_second").at(0));
  EXPECT_EQ(report(at->at("bake").get<std::vector<std::string>>()).at("flash_bytes").at("total"),
            at->at("flash_bytes"));
  EXPECT_NE(read(path("sheet.html")).find("textures none: vertices"), std::string::npos);
}

TEST_F(Fit, LightGoesIntoColoursOfVerticesWhereThatTakesLessFlash) {
  const Json found = fit(sphere(), {"--fps", "1"});
  const Json* baked = nullptr;
  for (const Json& choice : found.at("choices")) {
    if (choice.at("lighting") == "baked" && choice.at("triangles_option") == "100%") baked = &choice;
  }
  ASSERT_NE(baked, nullptr);
  EXPECT_EQ(baked->at("texture_size"), 0) << "textures stay lit";
  const auto drawn = std::ranges::find_if(found.at("choices"), [&](const Json& choice) {
    return choice.at("lighting") == "drawn" && choice.at("texture_size") == 0 && choice.at("rms") == baked->at("rms");
  });
  ASSERT_NE(drawn, found.at("choices").end()) << "light that follows what moves is not given up unasked";
  EXPECT_LT(baked->at("flash_bytes"), drawn->at("flash_bytes"));
  EXPECT_EQ(report(baked->at("bake").get<std::vector<std::string>>()).at("flash_bytes").at("total"),
            baked->at("flash_bytes"));
}

TEST_F(Fit, BakedLightThatSavesNothingIsNotListed) {
  sphere();
  const std::string model = file("plain.obj", read(path("sphere.obj")) +
                                                  "newmtl plain\nusemtl plain\nv 0 0 0\nv 0 .1 0\nv .1 0 0\n"
                                                  "f -3 -2 -1\n");
  const Json found = fit(model, {"--fps", "1"});
  for (const Json& choice : found.at("choices")) {
    EXPECT_TRUE(choice.at("lighting") == "drawn" || choice.at("texture_size") == 0) << choice;
  }
}

TEST_F(Fit, FlatFacesThatStaySayWhatToDo) {
  std::string text = "v 0 0 1\nv 0 0 -1\n";
  for (int i = 0; i < 40; ++i) {
    const double angle = i * 2 * std::numbers::pi / 40;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
  }
  for (int i = 0; i < 40; ++i) {
    const double angle = (i + 0.5) * 2 * std::numbers::pi / 40;
    for (int side = 0; side < 2; ++side) {
      text += "vn " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " " +
              (side == 0 ? "1\n" : "-1\n");
      const std::string normal = "//" + std::to_string(2 * i + side + 1) + " ";
      const int here = i + 3, next = (i + 1) % 40 + 3;
      text += "f " + std::to_string(side + 1) + normal + std::to_string(side == 0 ? here : next) + normal +
              std::to_string(side == 0 ? next : here) + normal + "\n";
    }
  }
  const std::string model = file("flat.obj", text);
  const Outcome none = zstrip({"fit", model, "--board", "pico", "--size", "64x48", "--flash", "1K"});
  EXPECT_EQ(none.status, 5);
  EXPECT_NE(none.err.find("more than half of the triangles stay: three or more materials, flat faces"),
            std::string::npos)
      << none.err;
  EXPECT_EQ(none.err.find("textures whole"), std::string::npos) << "it has none: " << none.err;
  const Outcome listed = zstrip({"fit", model, "--board", "pico", "--size", "64x48"});
  EXPECT_NE(listed.out.find("a modeller can shade faces smooth"), std::string::npos) << listed.out;
}

TEST_F(Fit, BlenderExportsAFileOnce) {
  file("blender",
       "#!/bin/sh\n"
       "[ \"$1\" = --version ] && exit 0\n"
       "echo run >>" +
           path("runs") +
           "\n"
           "for last; do :; done\n"
           "cp " ZSTRIP_SCENE_FILES "/clips/planet.glb \"$last\"\n");
  std::filesystem::permissions(path("blender"), std::filesystem::perms::owner_all);
  const std::string model = file("planet.blend", "BLENDER-v304RENDH");
  const Outcome outcome =
      run("/usr/bin/env",
          {"PATH=" + path("") + ":/usr/bin:/bin", ZSTRIP_COMMAND, "fit", model, "--board", "pico", "--size", "48x48"},
          path(""));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(read(path("runs")), "run\n");
}

TEST_F(Fit, TheFlashOfTheBoardIsTheLimitWhereNoneIsGiven) {
  texture("colours.tga", 256);
  const std::string model = textured_sphere(24, 12);
  const Json found = report({"fit", model, "--board", "bluepill", "--size", "64x48"});
  for (const Json& choice : found.at("choices")) EXPECT_LE(choice.at("flash_bytes"), 32 * 1024);
}

TEST_F(Fit, TheSameModelGivesTheSameChoices) {
  const std::string model = sphere();
  EXPECT_EQ(fit(model, {"--flash", "24K", "-o", "a.zsc"}), fit(model, {"--flash", "24K", "-o", "a.zsc"}));
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
