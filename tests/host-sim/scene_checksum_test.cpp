// Every scene file that comes with the command has its picture, by a checksum: in strips of any height, on any threads,
// and baked.
#include <filesystem>
#include <map>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

struct Golden {
  const char* checksum;
  const char* size = "160x120";
};

const std::map<std::string, Golden> kGolden{
    {"alpha_test", {"49752349"}},
    {"anti_aliasing", {"51440ae5"}},
    {"bilinear", {"e760ae50"}},
    {"billboards", {"c44c9bf8"}},
    {"csg", {"765f7528"}},
    {"directional", {"2ace3470"}},
    {"dithered", {"070a1f43", "128x64"}},
    {"edges", {"42f54a73"}},
    {"emissive", {"a7bf3535"}},
    {"environment", {"768b50c2"}},
    {"fog", {"9db11e6c"}},
    {"fog_linear", {"618f3bd2"}},
    {"lamp", {"5fa1a24c"}},
    {"lines", {"f825c53d"}},
    {"mipmaps", {"858e065e"}},
    {"outlines", {"332f5d3a"}},
    {"palette", {"7a55f4ee", "192x64"}},
    {"per_pixel", {"7c2b1221"}},
    {"perspective", {"a2e93321"}},
    {"point", {"6996af63"}},
    {"rooms", {"26388dc1"}},
    {"shading", {"14b91c98"}},
    {"shadows", {"e3e01f0c"}},
    {"specular", {"9ed36dec"}},
    {"spheres", {"5c454a4e"}},
    {"spot", {"aa1dbd22"}},
    {"table", {"844d9000"}},
    {"transparency", {"39b069f0"}},
};

class SceneChecksum : public Command, public testing::WithParamInterface<std::string> {};

std::vector<std::string> scene_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(ZSTRIP_SCENE_FILES)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  return names;
}

TEST_P(SceneChecksum, IsThatOfThePicture) {
  const auto found = kGolden.find(GetParam());
  ASSERT_NE(found, kGolden.end()) << "a scene file without a checksum";
  const Golden& golden = found->second;
  const std::string scene = std::string(ZSTRIP_SCENE_FILES "/").append(GetParam()).append(".toml");
  EXPECT_EQ(checksum(scene, {"--size", golden.size}), golden.checksum);
  EXPECT_EQ(checksum(scene, {"--size", golden.size, "--strip-rows", "1"}), golden.checksum);
  EXPECT_EQ(checksum(scene, {"--size", golden.size, "--strip-rows", "7", "--strip-columns", "24"}), golden.checksum);
  EXPECT_EQ(checksum(scene, {"--size", golden.size, "--threads", "3", "--strip-rows", "5"}), golden.checksum);
  EXPECT_EQ(zstrip({"bake", scene, "-o", "p.zsc", "--size", golden.size, "--quiet"}).status, 0);
  EXPECT_EQ(checksum("p.zsc", {"--size", golden.size}), golden.checksum);
  // Several frames may have another camera, and what does not move by itself turns in them, or stands still.
  EXPECT_EQ(checksums("p.zsc", {"--size", golden.size, "--frames", "3"}),
            checksums(scene, {"--size", golden.size, "--frames", "3"}));
}

INSTANTIATE_TEST_SUITE_P(Files, SceneChecksum, testing::ValuesIn(scene_files()),
                         [](const testing::TestParamInfo<std::string>& name) { return name.param; });

}  // namespace
}  // namespace zstrip::sim::test
