// Each scene of docs/gallery.md fits: tables so small that with the code of its effects they stay below 81 KB of flash
// (which the page has, measured), 140 KB with a skin; arena, strip and moved vertices within the memory that the page
// plans them for.
#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>

#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class Gallery : public FolderTest {};

/// Bytes: what the effects' code leaves of 80 KB, beside shadows of 64 KB. A scene without light has the least code.
constexpr std::size_t kTables = 47'100, kTablesBesideShadows = 16'300, kTablesWithoutLight = 51'500;
/// A skin has joints, weights, and the keyframes of three clips and their fades.
constexpr std::size_t kTablesOfSkin = 97'000, kMovedBytes = std::size_t{9} * 1024;
constexpr std::size_t kRam = std::size_t{22} * 1024;

TEST_F(Gallery, ScenesFitIntoTheMemoryThatThePageSays) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ZSTRIP_SCENE_FILES "/gallery")) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const std::string scene = entry.path().string();
    const Outcome baked = run(ZSTRIP_COMMAND,
                              {"bake", scene, "-o", "scene.hpp", "--size", "240x240", "--format", "rgb565_swapped",
                               "--ram", std::to_string(kRam), "--quiet", "--json", "-"},
                              path(""));
    ASSERT_EQ(baked.status, 0) << baked.err;
    const auto report = nlohmann::json::parse(baked.out);
    const auto& ram = report.at("plan").at("ram_bytes");
    const bool shadows = baked.out.find("\"shadows\"") != std::string::npos;
    const bool light = baked.out.find("\"lighting\"") != std::string::npos;
    const auto moved = ram.value("moved_vertices", std::size_t{0}), joints = ram.value("joints", std::size_t{0});
    const bool skin = joints > 0;
    EXPECT_LE(moved + joints, skin ? kMovedBytes : 0U) << scene;
    EXPECT_LE(report.at("flash_bytes").at("total"), shadows ? kTablesBesideShadows
                                                    : skin  ? kTablesOfSkin
                                                    : light ? kTables
                                                            : kTablesWithoutLight)
        << scene;
    EXPECT_LE(ram.at("arena").get<std::size_t>() + ram.at("strip_pixels").get<std::size_t>(), kRam) << scene;
  }
  EXPECT_EQ(scenes, 8U);
}

}  // namespace
}  // namespace zstrip::sim::test
