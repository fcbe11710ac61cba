// Every scene file that comes with the command has its picture, by a checksum: in strips of any height, on any threads,
// and baked.
#include <algorithm>
#include <filesystem>

#include "command_fixture.hpp"
#include "measured/table.hpp"

namespace zstrip::sim::test {
namespace {

/// Those of this repository, by name and folder: picture size and checksum.
const measured::Table& recorded() {
  static const measured::Table table = measured::read_table(
      ZSTRIP_SCENE_CHECKSUMS,
      {.part = "checksums", .columns = {{"scene"}, {"size", measured::kExact}, {"crc32", measured::kExact}}});
  return table;
}

class SceneChecksum : public Command, public testing::WithParamInterface<std::string> {};

std::vector<std::string> scene_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ZSTRIP_SCENE_FILES)) {
    if (entry.path().extension() != ".toml") continue;
    names.push_back(entry.path().lexically_relative(ZSTRIP_SCENE_FILES).replace_extension().string());
  }
  return names;
}

TEST_P(SceneChecksum, IsThatOfThePicture) {
  const std::string scene = std::string(ZSTRIP_SCENE_FILES "/").append(GetParam()).append(".toml");
  const measured::Row* const row = recorded().find({GetParam()});
  ASSERT_NE(row, nullptr) << "a scene file without a checksum: give it a line of " << ZSTRIP_SCENE_CHECKSUMS;
  const std::string size = row->at(1), golden = checksum(scene, {"--size", size});
  EXPECT_EQ(complaint(recorded(), {GetParam(), size, golden}), "");
  EXPECT_EQ(checksum(scene, {"--size", size, "--strip-rows", "1"}), golden);
  EXPECT_EQ(checksum(scene, {"--size", size, "--strip-rows", "7", "--strip-columns", "24"}), golden);
  EXPECT_EQ(checksum(scene, {"--size", size, "--threads", "3", "--strip-rows", "5"}), golden);
  // A blob bends its skin or smooths edges, not both.
  std::vector<std::string> options{"--size", size};
  const auto bake = [&] {
    std::vector<std::string> arguments{"bake", scene, "-o", "p.zsc"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return zstrip(arguments);
  };
  Outcome baked = bake();
  if (baked.err.find("with --edges a blob has no skins") != std::string::npos) {
    options.emplace_back("--no-edges");
    baked = bake();
  }
  EXPECT_EQ(baked.status, 0);
  EXPECT_EQ(checksum("p.zsc", {"--size", size}), checksum(scene, options));
  // Several frames may have another camera, and what does not move by itself turns in them, or stands still.
  options.insert(options.end(), {"--frames", "3"});
  EXPECT_EQ(checksums("p.zsc", {"--size", size, "--frames", "3"}), checksums(scene, options));
}

INSTANTIATE_TEST_SUITE_P(Files, SceneChecksum, testing::ValuesIn(scene_files()),
                         [](const testing::TestParamInfo<std::string>& scene) {
                           std::string name = scene.param;  // "gallery/chess"
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace zstrip::sim::test
