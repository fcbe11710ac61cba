// What tests of `zstrip bake` share: the command in a folder of its own, its reports, and pictures of blobs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support.hpp"

namespace zstrip::sim::test {

using Json = nlohmann::json;

class Bake : public FolderTest {
 protected:
  Outcome zstrip(const std::vector<std::string>& arguments) { return run(ZSTRIP_COMMAND, arguments, path("")); }
  Json report(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--quiet", "--json", "-"});
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? Json::parse(outcome.out) : Json{};
  }
  std::vector<std::string> crcs(const std::string& scene, std::vector<std::string> options, int frames) {
    std::vector<std::string> arguments{"render", scene, "-o", "frames", "--frames", std::to_string(frames)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::vector<std::string> result;
    const Json rendered = report(arguments);
    for (const Json& frame : rendered.at("frames")) {
      EXPECT_GT(frame.at("statistics").at("fragments"), 100) << scene;
      result.push_back(frame.at("crc32"));
    }
    return result;
  }
  /// The scene file as a blob has its pictures, and is baked again to the same bytes. Returns the materials that the
  /// report names for `effect`.
  Json same_as_a_blob(const std::string& name, const std::string& effect, const std::vector<std::string>& options,
                      int frames) {
    const std::string scene = ZSTRIP_SCENE_FILES "/" + name + ".toml";
    const auto bake = [&](const std::string& from, const std::string& to) {
      std::vector<std::string> arguments{"bake", from, "-o", to};
      arguments.insert(arguments.end(), options.begin(), options.end());
      return report(arguments);
    };
    const Json baked = bake(scene, "scene.zsc");
    EXPECT_EQ(crcs("scene.zsc", {}, frames), crcs(scene, {}, frames));
    bake("scene.zsc", "again.zsc");
    EXPECT_EQ(read(path("again.zsc")), read(path("scene.zsc")));
    const auto found = std::ranges::find_if(baked.at("effects"), [&](const Json& e) { return e.at("name") == effect; });
    if (found == baked.at("effects").end()) {
      ADD_FAILURE() << effect << " is not reported";
      return Json::array();
    }
    return found->at("materials");
  }
  /// The model and the blob that it is baked into draw the same.
  void expect_same_pictures(const std::string& model, const std::vector<std::string>& camera = {}) {
    for (const int frames : {1, 3}) {
      std::vector<std::string> bake{"bake", model, "-o", "scene.zsc", "--size", "160x120"};
      bake.insert(bake.end(), camera.begin(), camera.end());
      if (frames > 1) bake.push_back("--turntable");
      report(bake);
      std::vector<std::string> options = camera;
      options.insert(options.end(), {"--size", "160x120"});
      const std::vector<std::string> expected = crcs(model, options, frames);
      ASSERT_EQ(expected.size(), static_cast<std::size_t>(frames)) << model;
      EXPECT_EQ(crcs("scene.zsc", {"--size", "160x120"}, frames), expected) << model;
    }
  }
};

inline const std::string kHouseModel = std::string(BAKE_MODELS) + "/house.obj";
inline const std::string kColoursModel = std::string(BAKE_MODELS) + "/colours.ply";

}  // namespace zstrip::sim::test
