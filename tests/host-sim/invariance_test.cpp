// The same pixels for every strip height and memory budget, on real models and on one that exceeds 16-bit indices.
#include <nlohmann/json.hpp>

#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class Invariance : public FolderTest {
 protected:
  /// Checksums of three frames.
  std::vector<std::string> crcs(const std::string& model, std::vector<std::string> options) {
    std::vector<std::string> arguments{"render", model, "-o", "frames", "--frames", "3", "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(ZSTRIP_COMMAND, arguments, path(""));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::vector<std::string> result;
    if (outcome.status != 0) return result;
    const auto json = nlohmann::json::parse(outcome.out);
    for (const auto& frame : json.at("frames")) {
      EXPECT_GT(frame.at("statistics").at("fragments"), 1000);
      result.push_back(frame.at("crc32"));
    }
    return result;
  }
  void expect_same_pixels(const std::string& model) {
    const auto crcs = [&](std::vector<std::string> options) { return this->crcs(model, std::move(options)); };
    const std::vector<std::string> whole = crcs({"--strip-rows", "240"});
    ASSERT_EQ(whole.size(), 3U);
    EXPECT_NE(whole[0], whole[1]) << "the model turns";
    EXPECT_EQ(crcs({"--strip-rows", "1"}), whole);
    EXPECT_EQ(crcs({"--strip-rows", "7"}), whole);
    EXPECT_EQ(crcs({"--ram", "40K"}), whole);
  }
  void expect_same_pixels_of_package_model(const char* name) {
    const std::filesystem::path models = GLMARK2_MODELS;
    if (models.empty()) GTEST_SKIP() << "package glmark2-data is not installed";
    expect_same_pixels((models / name).string());
  }
};

/// Every depth format draws in strips what it draws at once, and a convex model the same as every other.
TEST_F(Invariance, DepthFormats) {
  const std::string model = file("sphere.obj", sphere_obj(40, 25));
  const std::vector<std::string> z16 = crcs(model, {});
  ASSERT_EQ(z16.size(), 3U);
  for (const char* format : {"z16", "float", "z24"}) {
    EXPECT_EQ(crcs(model, {"--depth-format", format}), z16) << format;
    EXPECT_EQ(crcs(model, {"--depth-format", format, "--strip-rows", "7"}), z16) << format;
  }
}

TEST_F(Invariance, Bunny) { expect_same_pixels_of_package_model("bunny.obj"); }
TEST_F(Invariance, Horse) { expect_same_pixels_of_package_model("horse.3ds"); }
TEST_F(Invariance, Cat) { expect_same_pixels_of_package_model("cat.3ds"); }
TEST_F(Invariance, HundredThousandVertices) { expect_same_pixels(file("sphere.obj", sphere_obj(400, 250))); }

}  // namespace
}  // namespace zstrip::sim::test
