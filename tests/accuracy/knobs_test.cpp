// Words of settings, presets, and the front of points.
#include "accuracy/knobs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <set>

#include "accuracy/journal.hpp"
#include "accuracy/pareto.hpp"
#include "accuracy/plot.hpp"
#include "support.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {
namespace {

TEST(Knobs, SettingsAreWhatTheirTextSays) {
  for (const KnobInfo& knob : knobs()) {
    for (std::uint8_t value = 0; value < knob.values.size(); ++value) {
      Settings settings;
      settings[knob.knob] = value;
      settings[Knob::fit] = 1;
      const Result<Settings> read = parse_settings(to_text(settings));
      ASSERT_TRUE(read) << to_text(settings);
      EXPECT_EQ(*read, settings);
    }
  }
  EXPECT_EQ(to_text(Settings{}), "default");
}

TEST(Knobs, ErrorsNameTheNearestWord) {
  EXPECT_NE(parse_settings("dept=z16").failure().message.find("nearest is 'depth'"), std::string::npos);
  EXPECT_NE(parse_settings("depth=z23").failure().message.find("nearest is 'z24'"), std::string::npos);
  EXPECT_NE(parse_settings("depth").failure().message.find("no value of depth"), std::string::npos);
  EXPECT_NE(parse_settings("samples=edges,samples=2").failure().message.find("twice"), std::string::npos);
  EXPECT_NE(parse_settings("exct").failure().message.find("did you mean exact?"), std::string::npos);
  EXPECT_NE(parse_knobs("strip").failure().message.find("nearest is 'strips'"), std::string::npos);
  EXPECT_EQ(parse_knobs("all")->size(), kKnobs);
  EXPECT_EQ(parse_knobs("samples,all")->size(), kKnobs);
  EXPECT_EQ(*parse_knobs("samples"), std::vector{Knob::samples});
}

TEST(Knobs, ASettingThatIsGoneIsRefusedWithWhatToDoInstead) {
  const std::string gone = parse_settings("reciprocal=table").failure().message;
  EXPECT_NE(gone.find("no knob is called 'reciprocal', it is gone, leave it out"), std::string::npos) << gone;
  const std::string format = parse_settings("depth=w16").failure().message;
  EXPECT_NE(format.find("no value of depth is called 'w16', it is gone, use z24"), std::string::npos) << format;
}

TEST(Knobs, DitheringIsThePicturesOwnEffect) {
  EXPECT_EQ(extra_effects(*parse_settings("dither=on")), effect::dithered_colours);
  EXPECT_EQ(extra_effects(*parse_settings("dither=on,format=mono")), effect::dithered_format);
  EXPECT_EQ(extra_effects(*parse_settings("filter=mipmapped_bilinear,samples=2")),
            effect::mipmaps | effect::bilinear | effect::supersampled);
}

// Fragments that have effects have their exact places at every 16th pixel.
TEST(Knobs, PlacesInTexturesAreForPixelsWithoutEffects) {
  for (const char* fragments : {"dither=on", "filter=bilinear", "filter=mipmapped"}) {
    EXPECT_FALSE(possible(extra_effects(*parse_settings(std::string("perspective=1,") + fragments)))) << fragments;
  }
  EXPECT_TRUE(possible(extra_effects(*parse_settings("perspective=1,dither=on,format=gray4"))));
  EXPECT_FALSE(possible(effect::perspective_1 | effect::pixel_shading));
}

// Edges compare depths of their own with codes of z16, and lie in what several samples would smooth.
TEST(Knobs, EdgesAreBlendedInPicturesOfOneSampleWithZ16) {
  const Settings edges = *parse_settings("samples=edges");
  EXPECT_EQ(extra_effects(edges), effect::edges);
  EXPECT_EQ(picture(edges, {64, 48}).samples, 1);
  for (const char* with : {"depth=float", "depth=z24", "depth=ranges"}) {
    EXPECT_FALSE(possible(extra_effects(*parse_settings(std::string("samples=edges,") + with)))) << with;
  }
  for (const char* with : {"strips=bins16", "perspective=1", "dither=on", "filter=mipmapped_bilinear", "fit=fixed"}) {
    EXPECT_TRUE(possible(extra_effects(*parse_settings(std::string("samples=edges,") + with)))) << with;
  }
  EXPECT_FALSE(possible(effect::edges | effect::outlines));
}

TEST(Knobs, PresetsOfTheLibraryAreThoseOfTheCommand) {
  ASSERT_EQ(named_settings().size(), std::size(quality::all));
  for (const NamedSettings& named : named_settings()) {
    const Quality* preset = find_quality(named.name);
    ASSERT_NE(preset, nullptr) << named.name;
    EXPECT_EQ(preset->effects, extra_effects(named.settings));
    EXPECT_EQ(preset->budget.strip_rows, budget(named.settings, 240).strip_rows);
    EXPECT_EQ(preset->budget.modes, budget(named.settings, 240).modes);
    EXPECT_EQ(preset->smooth, named.settings.name_of(Knob::shading) == "gouraud");
    EXPECT_EQ(static_cast<std::uint32_t>(preset->detail_percent), detail_percent(named.settings));
  }
  EXPECT_EQ(find_quality("best"), nullptr);
}

TEST(Knobs, EachHasAColourOfItsOwn) {
  std::set<std::string_view> colours;
  for (const KnobInfo& knob : knobs()) EXPECT_TRUE(colours.insert(colour_of_group(knob.name)).second) << knob.name;
}

TEST(Pareto, KeepsWhatNoOtherPointBeats) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> digit(0, 9);
  std::vector<Respects> points;
  for (int i = 0; i < 200; ++i) {
    points.push_back({double(digit(random)), double(digit(random)), double(digit(random))});
  }
  const std::vector<bool> front = pareto_front(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < points.size(); ++j) {
      const bool as_good = points[j][0] <= points[i][0] && points[j][1] <= points[i][1] && points[j][2] <= points[i][2];
      beaten = beaten || (as_good && (points[j] != points[i] || j < i));
    }
    EXPECT_EQ(front[i], !beaten);
  }
}

using JournalTest = test::FolderTest;

TEST_F(JournalTest, LosesOnlyTheLineThatWasNotWhole) {
  const std::string file = path("points.jsonl");
  AccuracyPoint point{
      .scene = "a,\"b", .target = "m3", .settings = *parse_settings("depth=z24"), .part = "", .errors = {}, .cost = {}};
  point.errors[Figure::psnr] = 31.25;
  point.errors[Figure::texture] = std::nan("");
  point.cost.instructions = 123456789012;
  {
    Result<Journal> journal = Journal::open(file);
    ASSERT_TRUE(journal);
    ASSERT_TRUE(journal->add("one", point));
    ASSERT_TRUE(journal->add("two", point));
  }
  const std::string whole = test::read(file);
  std::ofstream(file, std::ios::trunc) << whole.substr(0, whole.size() - 10);
  {
    Result<Journal> journal = Journal::open(file);
    ASSERT_TRUE(journal);
    EXPECT_FALSE(journal->find("two"));
    ASSERT_TRUE(journal->add("three", point));
  }
  const Result<Journal> journal = Journal::open(file);
  for (const char* key : {"one", "three"}) {
    const std::optional<AccuracyPoint> found = journal->find(key);
    ASSERT_TRUE(found) << key;
    EXPECT_EQ(found->scene, point.scene);
    EXPECT_EQ(found->settings, point.settings);
    EXPECT_EQ(found->errors[Figure::psnr], 31.25);
    EXPECT_TRUE(std::isnan(found->errors[Figure::texture]));
    EXPECT_EQ(found->cost.instructions, point.cost.instructions);
    EXPECT_FALSE(found->cost.least_fps);
  }
}

}  // namespace
}  // namespace zstrip::sim
