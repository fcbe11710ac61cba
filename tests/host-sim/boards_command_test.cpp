// zstrip boards and zstrip blender as their users see them.
#include <nlohmann/json.hpp>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

/// Returns the names of a list of the report.
std::vector<std::string> names_in(const nlohmann::json& list) {
  std::vector<std::string> names;
  for (const auto& entry : list) names.push_back(entry.is_string() ? entry : entry.at("name"));
  return names;
}

TEST_F(Command, BoardsListsWhatOptionsName) {
  const Outcome outcome = zstrip({"boards", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  const std::string table = zstrip({"boards"}).out;
  for (const std::string& board : names_in(report.at("boards"))) {
    EXPECT_NE(table.find('\n' + board + ' '), std::string::npos) << board;
  }
  for (const auto& panel : report.at("panels")) {
    const std::string name = panel.at("name");
    EXPECT_NE(table.find('\n' + name + ' '), std::string::npos) << name;
    const auto size = panel.at("sizes").back();
    const std::string words = size[0].dump() + 'x' + size[1].dump();
    EXPECT_EQ(zstrip({"render", "cube", "-o", "p.png", "--quiet", "--panel", name, "--size", words, "--format",
                      panel.at("formats").front()})
                  .status,
              0)
        << name << ' ' << words;
  }
  for (const std::string& format : names_in(report.at("formats"))) {
    EXPECT_EQ(zstrip({"render", "cube", "-o", "p.png", "--quiet", "--size", "8x8", "--format", format}).status, 0)
        << format;
  }
  file("t.obj", kTriangleObj);
  for (const std::string& board : names_in(report.at("uf2_boards"))) {
    EXPECT_EQ(zstrip({"bake", "t.obj", "-o", "t.uf2", "--quiet", "--board", board}).status, 0) << board;
  }
}

TEST_F(Command, BoardsHaveTheMemoryAndTheBusOfTheirDataSheets) {
  const auto report = nlohmann::json::parse(zstrip({"boards", "--json"}).out);
  const auto named = [&](const char* list, const char* name) {
    for (const auto& entry : report.at(list)) {
      if (entry.at("name") == name) return entry;
    }
    return nlohmann::json();
  };
  const auto pico2 = named("boards", "pico2"), oled = named("panels", "ssd1306");
  EXPECT_EQ(pico2.at("ram_bytes"), 520 * 1024);
  EXPECT_EQ(pico2.at("core_mhz"), 150);
  EXPECT_EQ(oled.at("i2c_mhz"), 0.4);
  EXPECT_EQ(named("panels", "st7789").at("i2c_mhz"), nullptr) << "an ST7789 has no I2C";
}

TEST_F(Command, BlenderWritesTheSameZipEachTime) {
  ASSERT_EQ(zstrip({"blender", "-o", "a.zip", "--quiet"}).status, 0);
  EXPECT_EQ(zstrip({"blender"}).status, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.zip", "zstrip_blender.zip"}));
  EXPECT_EQ(read(path("a.zip")), read(path("zstrip_blender.zip")));
  EXPECT_NE(read(path("a.zip")).find("zstrip_blender/__init__.py"), std::string::npos);
}

TEST_F(Command, BlenderWritesNothingButAZip) {
  const Outcome outcome = zstrip({"blender", "-o", "add_on.txt"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("must end in .zip"), std::string::npos) << outcome.err;
  EXPECT_EQ(zstrip({"blender", "-o", "none/a.zip"}).status, 6);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace zstrip::sim::test
