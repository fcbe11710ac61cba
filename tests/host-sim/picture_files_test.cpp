// Picture files that other programs show: animations, taken apart by Debian's apngdis, and JPEG.
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

class PictureFiles : public Command {
 protected:
  /// What apngdis finds: pictures apngframe1.png and so on; returns the milliseconds of each.
  std::vector<int> take_apart(const std::string& animation, int frames) const {
    EXPECT_EQ(run(APNGDIS, {animation}, path("")).status, 0);
    std::vector<int> times;
    for (int frame = 1; frame <= frames; ++frame) {
      const std::string delay = read(path("apngframe" + std::to_string(frame) + ".txt"));
      int time = 0, unit = 0;
      EXPECT_EQ(std::sscanf(delay.c_str(), "delay=%d/%d", &time, &unit), 2) << delay;
      EXPECT_EQ(unit, 1000);
      times.push_back(time);
    }
    EXPECT_FALSE(std::filesystem::exists(path("apngframe" + std::to_string(frames + 1) + ".png")));
    return times;
  }
};

TEST_F(PictureFiles, AnAnimationHasTheFramesOfTheFolder) {
  if (std::string_view(APNGDIS).empty()) GTEST_SKIP() << "package apngdis is not installed";
  for (const std::string format : {"rgb565", "gray4", "mono"}) {
    const std::vector<std::string> options{"--size", "41x30", "--frames", "5", "--format", format};
    const std::vector<std::string> sums = checksums("teapot", options, format + "/");
    EXPECT_EQ(checksums("teapot", options, format + ".apng"), sums);
    EXPECT_EQ(take_apart(format + ".apng", 5), std::vector<int>(5, 800)) << "a turn takes four seconds";
    for (int frame = 0; frame < 5; ++frame) {
      EXPECT_EQ(picture("apngframe" + std::to_string(frame + 1) + ".png").rgb,
                picture(format + "/frame_000" + std::to_string(frame) + ".png").rgb)
          << format << ' ' << frame;
    }
    EXPECT_EQ(picture(format + ".apng").rgb, picture(format + "/frame_0000.png").rgb) << "for what knows PNG alone";
  }
}

TEST_F(PictureFiles, AnAnimationTakesAsLongAsThatOfItsScene) {
  if (std::string_view(APNGDIS).empty()) GTEST_SKIP() << "package apngdis is not installed";
  file("scene.toml",
       "duration = 2\n[picture]\nsize = [24, 16]\nframes = 3\n[[model]]\nname = 'cube'\nbuilt_in = 'cube'\n"
       "[[instance]]\nmodel = 'cube'\nturntable = { turns = 1 }\n");
  const Outcome outcome = zstrip({"render", "scene.toml", "-o", "scene.apng", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("written    scene.apng\n"), std::string::npos) << outcome.err;
  const nlohmann::json frames = nlohmann::json::parse(outcome.out).at("frames");
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames.at(2).at("file"), "scene.apng");
  EXPECT_EQ(take_apart("scene.apng", 3), (std::vector<int>{666, 667, 667}));
}

TEST_F(PictureFiles, JpegIsThePictureRoughly) {
  for (const std::string format : {"rgb565", "gray4"}) {
    const std::vector<std::string> options{"--frames", "1", "--format", format};
    for (const char* name : {"t.png", "t.jpg"}) checksums("teapot", options, name);
    checksums("teapot", {"--frames", "1", "--format", format, "--image", "jpeg"}, "folder");
    const RgbImage exact = picture("t.png"), rough = picture("t.jpg");
    EXPECT_EQ(picture("folder/frame_0000.jpg").rgb, rough.rgb);
    ASSERT_EQ(rough.rgb.size(), exact.rgb.size());
    std::int64_t difference = 0;
    for (std::size_t i = 0; i < exact.rgb.size(); ++i) difference += std::abs(exact.rgb[i] - rough.rgb[i]);
    EXPECT_LT(difference, 2 * static_cast<std::int64_t>(exact.rgb.size())) << format << ": two steps in the mean";
  }
}

}  // namespace
}  // namespace zstrip::sim::test
