// The page as a browser sees it: whole without its script, and with it what clicking and filtering do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "support.hpp"

namespace zstrip::sim {
namespace {

class Page : public test::FolderTest {
 protected:
  void SetUp() override {
    outcome_ = test::run(ZSTRIP_COMMAND,
                         {"accuracy", "cube", "teapot", "--size", "64x48", "--frames", "1", "--knobs",
                          "depth,shading,perspective,strips", "--singles", "-o", "out"},
                         path(""));
    ASSERT_EQ(outcome_.status, 0) << outcome_.err;
    html_ = test::read(path("out/index.html"));
  }
  static std::size_t count(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    return static_cast<std::size_t>(std::distance(std::sregex_iterator(text.begin(), text.end(), expression), {}));
  }
  test::Outcome outcome_;
  std::string html_;
};

TEST_F(Page, HoldsEverythingWithoutItsScript) {
  const auto results = nlohmann::json::parse(test::read(path("out/accuracy.json")));
  ASSERT_EQ(results.size(), 2U);
  std::size_t points = 0, causes = 0;
  for (const auto& scene : results) points += scene["points"].size(), causes += scene["causes"].size();
  EXPECT_EQ(count(html_, "<circle data-point="), points);
  EXPECT_EQ(count(html_, "<tr data-point="), points);
  EXPECT_EQ(count(html_, "<code>zstrip accuracy "), points);
  EXPECT_EQ(count(html_, "<svg "), 2U);
  EXPECT_EQ(count(html_, "class=\"recommended\""), 2U);
  // Nothing is fetched.
  EXPECT_EQ(count(html_, "(src|href)=\"?http"), 0U);
  EXPECT_GT(causes, 2 * 6);
  EXPECT_EQ(count(html_, "<tr data-cause="), causes);
  for (const auto& [file, lines] : {std::pair{"out/accuracy.csv", points}, std::pair{"out/causes.csv", causes}}) {
    const std::string csv = test::read(path(file));
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), lines + 1) << file;
  }
}

TEST_F(Page, RunsAgainWithoutMeasuring) {
  const std::string before = test::read(path("out/accuracy.csv"));
  const test::Outcome again = test::run(ZSTRIP_COMMAND,
                                        {"accuracy", "cube", "teapot", "--size", "64x48", "--frames", "1", "--knobs",
                                         "depth,shading,perspective,strips", "--singles", "-o", "out"},
                                        path(""));
  EXPECT_NE(again.out.find(", 0 measured now"), std::string::npos) << again.out;
  EXPECT_EQ(test::read(path("out/accuracy.csv")), before);
}

using AccuracyCommand = test::FolderTest;

TEST_F(AccuracyCommand, NamesTheProgramsOfEachCore) {
  const test::Outcome outcome = test::run(
      ZSTRIP_COMMAND, {"accuracy", "--target", "host,m0,m3", "cube", "--only", "default", "--list-programs"}, path(""));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "zstrip_scene_m0_00000000000008\nzstrip_scene_m3_00000000000008\n");
}

TEST_F(AccuracyCommand, MeasuresOnlyTheDefaultOnSomeTargets) {
  const test::Outcome outcome = test::run(
      ZSTRIP_COMMAND,
      {"accuracy", "--target", "m3", "--default-on", "m0", "cube", "--knobs", "depth", "--singles", "--list-programs"},
      path(""));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("zstrip_scene_m0_00000000000008\nzstrip_scene_m3_00000000000008\n"))
      << outcome.out;
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 1 + 4) << outcome.out;
}

// Words for a browser: what a person would do, and what is then on the page.
constexpr const char* kDoings = R"(<script>
addEventListener('load', async () => {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  await wait(300);
  const seen = {};
  const section = document.querySelector('section.scene');
  const shown = (selector) => [...section.querySelectorAll(selector)].filter((e) => e.style.display !== 'none').length;
  seen.circles = shown('circle[data-point]');
  seen.rows = shown('tbody tr[data-point]');
  const row = [...section.querySelectorAll('tbody tr[data-point]')].find((r) => r.dataset.group === 'perspective');
  const circle = section.querySelector(`circle[data-point="${row.dataset.point}"]`);
  circle.dispatchEvent(new PointerEvent('pointermove', { bubbles: true, pageX: 10, pageY: 10 }));
  seen.tip = document.getElementById('tip').hidden ? '' : document.getElementById('tip').textContent;
  circle.dispatchEvent(new MouseEvent('click', { bubbles: true }));
  await wait(300);
  seen.chosen = section.querySelector('.detail').dataset.shown;
  seen.words = section.querySelector('.detail p').textContent;
  seen.canvases = [...section.querySelectorAll('.detail canvas')].map((c) => {
    const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
    return new Set(new Uint32Array(data.buffer)).size;
  });
  document.querySelector('label[data-filter="depth"] input').click();
  seen.rowsWithoutDepth = shown('tbody tr[data-point]');
  seen.depthRows = [...section.querySelectorAll('tbody tr[data-point]')].filter((r) => r.dataset.group === 'depth').length;
  document.querySelector('label[data-filter="depth"] input').click();
  document.querySelector('label[data-filter="only the front"] input').click();
  seen.front = shown('tbody tr[data-point]');
  seen.frontMarked = [...section.querySelectorAll('tbody tr[data-point]')].filter((r) => r.dataset.front === '1').length;
  const select = document.querySelector('nav select');
  select.value = 'texture';
  select.dispatchEvent(new Event('change'));
  seen.axis = section.querySelector('svg text[transform]').textContent;
  const result = document.createElement('pre');
  result.id = 'seen';
  result.textContent = 'SEEN' + JSON.stringify(seen) + 'NEES';
  document.body.append(result);
});
</script>)";

TEST_F(Page, ShowsPicturesOnAClickAndFilters) {
  const std::string browser = ZSTRIP_CHROMIUM;
  if (browser.empty()) GTEST_SKIP() << "chromium was not there when this was configured";
  std::ofstream(path("acted.html")) << html_ << kDoings;
  const test::Outcome outcome = test::run(browser,
                                          {"--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=8000",
                                           "--dump-dom", "file://" + path("acted.html")},
                                          path(""));
  const std::size_t begin = outcome.out.rfind("SEEN{"), end = outcome.out.rfind("}NEES");
  ASSERT_NE(begin, std::string::npos) << outcome.err.substr(0, 2000);
  const auto seen = nlohmann::json::parse(outcome.out.substr(begin + 4, end + 1 - begin - 4));
  EXPECT_GT(seen["circles"], 10);
  EXPECT_EQ(seen["circles"], seen["rows"]);
  EXPECT_NE(seen["tip"].get<std::string>().find("perspective="), std::string::npos);
  EXPECT_NE(seen["chosen"].get<std::string>().find("perspective="), std::string::npos);
  EXPECT_NE(seen["words"].get<std::string>().find("each cause alone: aliasing "), std::string::npos) << seen["words"];
  ASSERT_EQ(seen["canvases"].size(), 6U);  // picture, truth, error; and each where it is worst
  for (const auto& colours : seen["canvases"]) EXPECT_GT(colours, 4);
  EXPECT_GT(seen["depthRows"], 0);
  EXPECT_EQ(seen["rowsWithoutDepth"].get<int>(), seen["rows"].get<int>() - seen["depthRows"].get<int>());
  EXPECT_EQ(seen["front"], seen["frontMarked"]);
  EXPECT_EQ(seen["axis"], "texture, texels");
}

}  // namespace
}  // namespace zstrip::sim
