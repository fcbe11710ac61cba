// `zstrip render --panel`: what is seen is the picture, turned; the bus takes the time that its bytes need; and words
// for what cannot be.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "image/decode.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class PanelCommand : public FolderTest {
 protected:
  Outcome zstrip(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "teapot"});
    return run(ZSTRIP_COMMAND, arguments, path(""));
  }
  RgbImage picture(const std::string& name) const {
    const std::string bytes = read(path(name));
    const auto image = decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_TRUE(image);
    return *image;
  }
};

/// The bits that the panel's format keeps, where pixel (x, y) of the picture is seen.
template <class Seen>
void expect_same(const RgbImage& picture, const RgbImage& panel, const std::vector<int>& bits, Seen seen) {
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const auto [column, row] = seen(x, y);
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(panel.pixel(column, row)[i] >> (8 - bits[i]), picture.pixel(x, y)[i] >> (8 - bits[i]))
            << x << ',' << y << " channel " << i;
      }
    }
  }
}

using Pixel = std::pair<std::uint32_t, std::uint32_t>;

TEST_F(PanelCommand, ShowsThePictureTurned) {
  ASSERT_EQ(zstrip({"-o", "plain.png", "--size", "320x240"}).status, 0);
  const Outcome turned = zstrip({"-o", "panel.png", "--panel", "ili9341", "--rotation", "90", "--size", "320x240",
                                 "--strip-rows", "7", "--bus", "spi@10MHz"});
  ASSERT_EQ(turned.status, 0) << turned.err;
  EXPECT_EQ(turned.err, "");
  const RgbImage plain = picture("plain.png"), panel = picture("panel.png");
  ASSERT_EQ(panel.width, 240U);
  ASSERT_EQ(panel.height, 320U);
  expect_same(plain, panel, {5, 6, 5}, [](std::uint32_t x, std::uint32_t y) { return Pixel{239 - y, x}; });
}

TEST_F(PanelCommand, GreysAndOneBit) {
  ASSERT_EQ(zstrip({"-o", "grey.png", "--size", "128x64", "--format", "gray4"}).status, 0);
  ASSERT_EQ(zstrip({"-o", "oled.png", "--panel", "ssd0323", "--mirror"}).status, 0);
  expect_same(picture("grey.png"), picture("oled.png"), {8, 8, 8}, [](std::uint32_t x, std::uint32_t y) {
    return Pixel{127 - x, y};
  });
  ASSERT_EQ(zstrip({"-o", "mono.png", "--size", "32x128", "--format", "mono"}).status, 0);
  ASSERT_EQ(
      zstrip({"-o", "panel.png", "--panel", "ssd1306", "--size", "32x128", "--rotation", "270", "--ram", "9K"}).status,
      0);
  expect_same(picture("mono.png"), picture("panel.png"), {8, 8, 8}, [](std::uint32_t x, std::uint32_t y) {
    return Pixel{y, 31 - x};
  });
}

TEST_F(PanelCommand, TheBusTakesTheTimeOfItsBytes) {
  const Outcome outcome = zstrip(
      {"-o", "panel.png", "--panel", "st7789", "--bus", "spi@40MHz", "--strip-rows", "30", "--json", "-", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("25 ns"), std::string::npos) << "faster than the data sheet allows";
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["panel"]["name"], "st7789");
  EXPECT_EQ(report["panel"]["bus"], "SPI at 40 MHz");
  EXPECT_EQ(report["warnings"].size(), 1U);
  constexpr int kBytes = 240 * 240 * 2 + 8 * (5 + 5 + 1);  // columns, rows and the command to write for each strip
  EXPECT_EQ(report["frames"][0]["bus"]["bytes"], kBytes);
  EXPECT_EQ(report["frames"][0]["bus"]["time_ns"], kBytes * 8 * 25);
}

TEST_F(PanelCommand, EveryPanelShowsFrames) {
  for (const char* panel : {"st7789", "ili9341", "st7735", "gc9a01", "st7796", "ili9342", "ili9488", "ssd1351",
                            "ssd1306", "ssd0323", "ssd1680", "co5300", "sh8601", "st77916", "st7262"}) {
    const Outcome outcome = zstrip({"-o", panel, "--frames", "2", "--panel", panel});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "") << panel;
    EXPECT_NE(outcome.out.find("frames/s"), std::string::npos) << outcome.out;
    EXPECT_NE(read(path(std::string(panel) + "/frame_0000.png")), read(path(std::string(panel) + "/frame_0001.png")));
  }
}

TEST_F(PanelCommand, AnRgbPanelTakesARefreshForEachFrame) {
  const Outcome outcome = zstrip({"-o", "rgb", "--panel", "st7262", "--bus", "rgb@9MHz", "--frames", "2", "--json", "-",
                                  "--quiet", "--strip-rows", "16"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["panel"]["bus"], "RGB at 9.009 MHz");
  for (const auto& frame : report["frames"]) {
    EXPECT_EQ(frame["bus"]["bytes"], 480 * 272 * 2);
    EXPECT_NEAR(frame["bus"]["time_ns"].get<double>(), 535 * 296 * 111, 2000);
  }
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--rotation", "90"},
                                                                                     {"--changes"},
                                                                                     {"--bus", "spi"},
                                                                                     {"--strip-rows", "12"},
                                                                                     {"--strip-columns", "64"},
                                                                                     {"--size", "480x270"}}) {
    std::vector<std::string> all{"-o", "a.png", "--panel", "st7262"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(zstrip(all).status, 2) << words[0];
  }
  const Outcome slow = zstrip({"-o", "a.png", "--panel", "st7262", "--bus", "rgb@6MHz"});
  EXPECT_NE(slow.err.find("the pixel clock has 167 ns"), std::string::npos) << slow.err;
}

// Strips of panels that take groups of rows had one group, whatever the RAM.
TEST_F(PanelCommand, StripsOfGroupsOfRowsAreAsHighAsTheRamAllows) {
  const auto rows = [&](const char* panel, const char* ram) {
    const Outcome outcome = zstrip({"-o", "a.png", "--panel", panel, "--ram", ram, "--json", "-", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out)["frames"][0]["strip_rows"].get<int>();
  };
  for (const auto& [panel, step] : {std::pair{"co5300", 2}, {"sh8601", 2}, {"ssd1306", 8}, {"st7262", 8}}) {
    const int least = rows(panel, "30K"), most = rows(panel, "200K");
    EXPECT_EQ(least % step, 0) << panel;
    EXPECT_EQ(most % step, 0) << panel;
    EXPECT_GE(most, std::string(panel) == "ssd1306" ? least : least + 4 * step) << panel;
  }
  EXPECT_EQ(rows("ssd1306", "200K"), 64);
}

TEST_F(PanelCommand, TheSlowestPixelClockThatIsNamedIsFastEnough) {
  EXPECT_EQ(zstrip({"-o", "a.png", "--panel", "st7262", "--bus", "rgb@172kHz", "--quiet"}).status, 0);
  EXPECT_EQ(zstrip({"-o", "a.png", "--panel", "st7262", "--bus", "rgb@171kHz", "--quiet"}).status, 2);
}

TEST_F(PanelCommand, ASizeIsNotAdvisedToBeRotatedWhereThePanelCannot) {
  EXPECT_EQ(zstrip({"--panel", "st7262", "--size", "480x100"}).err.find("--rotation"), std::string::npos);
  EXPECT_NE(zstrip({"--panel", "st7789", "--size", "480x100"}).err.find("--rotation"), std::string::npos);
}

TEST_F(PanelCommand, WithChangesTheSameFramesTakeFewerBytes) {
  for (const char* panel : {"st7789", "gc9a01", "ssd1351", "ssd1306"}) {
    const auto report = [&](const char* folder, const std::vector<std::string>& more) {
      std::vector<std::string> words{"-o",           folder, "--frames", "4", "--panel", panel,
                                     "--strip-rows", "16",   "--json",   "-", "--quiet"};
      words.insert(words.end(), more.begin(), more.end());
      return nlohmann::json::parse(zstrip(words).out);
    };
    const auto whole = report("whole", {}), changes = report("changes", {"--changes"});
    EXPECT_FALSE(whole["panel"]["changes"]);
    EXPECT_TRUE(changes["panel"]["changes"]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string name = "/frame_000" + std::to_string(i) + ".png";
      EXPECT_EQ(read(path("whole" + name)), read(path("changes" + name))) << panel << " frame " << i;
      const auto all = whole["frames"][i]["bus"]["bytes"].get<int>(),
                 sent = changes["frames"][i]["bus"]["bytes"].get<int>();
      EXPECT_GT(sent, 0);
      if (i > 0) {
        EXPECT_LT(sent, all) << panel << " frame " << i;
      }
    }
  }
}

TEST_F(PanelCommand, SaysWhatCannotBeAndWhatIsNearest) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--panel", "st778"}, "did you mean st7789?"},
      {{"--panel", "ssd306"}, "did you mean ssd1306?"},
      {{"--panel", ""}, "did you mean"},
      {{"--panel", "ssd1306", "--bus", "i2x"}, "did you mean i2c?"},
      {{"--panel", "st7735", "--bus", "i2c"}, "no I2C"},
      {{"--panel", "st7735", "--bus", "qspi"}, "no QSPI, only SPI"},
      {{"--panel", "co5300", "--bus", "spi@40MHz"}, "no SPI, only QSPI"},
      {{"--panel", "co5300", "--strip-rows", "7"}, "multiples of 2"},
      {{"--panel", "co5300", "--rotation", "90"}, "a co5300 cannot show"},
      {{"--panel", "sh8601", "--rotation", "180"}, "a sh8601 cannot show"},
      {{"--panel", "st7735", "--bus", "spi@"}, "spi@40MHz"},
      {{"--panel", "st7735", "--bus", "spi@nanMHz"}, "spi@40MHz"},
      {{"--panel", "st7735", "--bus", "spi@-1MHz"}, "spi@40MHz"},
      {{"--panel", "st7735", "--bus", "spi@40"}, "spi@40MHz"},
      {{"--panel", "st7735", "--rotation", "91"}, "0, 90, 180 or 270"},
      {{"--panel", "st7735", "--size", "160x128"}, "128x160"},
      {{"--panel", "st7262", "--bus", "rgb@1kHz"},
       "--bus rgb@1khz: the st7262 has to read a strip within 100 ms, which takes at least 172kHz"},
      {{"--panel", "ili9341", "--format", "rgb444"}, "rgb565_swapped or rgb666"},
      {{"--panel", "st7789", "--size", "135x240", "--format", "rgb444"}, "an even width (or rotation 90, 270)"},
      {{"--panel", "ssd1306", "--strip-rows", "12"}, "multiples of 8"},
      {{"--bus", "spi@1MHz"}, "--panel"},
      {{"--rotation", "90"}, "--panel"},
      {{"--mirror"}, "--panel"},
      {{"--changes"}, "--panel"}};
  for (const auto& [arguments, words] : cases) {
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 2) << words;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
