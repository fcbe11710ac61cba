// The window, without a display: what it shows is what `zstrip render` writes.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>

#include "command_fixture.hpp"
#include "view/view_loop.hpp"

namespace zstrip::sim::test {
namespace {

class ViewCommand : public Command {
 protected:
  ViewCommand() { ::setenv("SDL_VIDEODRIVER", "dummy", 1); }
  Outcome view(const std::string& scene, const std::string& keys, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"view", scene, "--press", keys});
    return zstrip(options);
  }
};

TEST_F(ViewCommand, ShowsWhatRenderWrites) {
  const struct {
    std::string scene, stem;
    std::vector<std::string> options;
  } cases[] = {
      {"teapot", "teapot", {"--size", "64x48", "--ram", "12K"}},
      {"teapot", "teapot", {"--size", "64x48", "--format", "mono", "--dither"}},
      {"cube", "cube", {"--panel", "st7789", "--rotation", "90"}},
      {"room", "room", {"--size", "70x50", "--samples", "4"}},
      {std::string(ZSTRIP_SCENE_FILES) + "/overlay.toml", "overlay", {"--size", "80x60"}},
      {"teapot", "teapot", {"--size", "64x48", "--board", "pico", "--bus", "spi@40MHz", "--strip-rows", "16"}},
      {"knot", "knot", {"--size", "64x48", "--show", "depth"}},
  };
  for (const auto& [scene, stem, options] : cases) {
    for (const std::string& name : files()) std::filesystem::remove_all(path(name));
    std::vector<std::string> viewed = options;
    viewed.insert(viewed.end(), {"--frames", "6", "--scale", "3"});
    const Outcome outcome = view(scene, "s,right,s,S,q", viewed);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, stem + "-1.png\n" + stem + "-2.png\n" + stem + "-3.png\n");
    std::vector<std::string> rendered{"render", scene, "-o", "frames/", "--frames", "6", "--quiet"};
    for (std::size_t i = 0; i < options.size(); ++i) {
      if (options[i] == "--board" || options[i] == "--bus")
        ++i;
      else
        rendered.push_back(options[i]);
    }
    ASSERT_EQ(zstrip(rendered).status, 0);
    EXPECT_TRUE(read(path(stem + "-1.png")) == read(path("frames/frame_0000.png")));
    EXPECT_TRUE(read(path(stem + "-2.png")) == read(path("frames/frame_0001.png")));
    EXPECT_TRUE(read(path(stem + "-1.png")) != read(path(stem + "-2.png"))) << scene;
    const RgbImage window = picture(stem + "-3.png"), frame = picture(stem + "-2.png");
    std::uint32_t different = 0;
    const std::uint32_t left = (window.width - 3 * frame.width) / 2;
    for (std::uint32_t y = 0; y < 3 * frame.height; ++y) {
      for (std::uint32_t x = 0; x < 3 * frame.width; ++x) {
        const std::uint8_t* const pixel = window.pixel(left + x, y);
        different += !std::equal(pixel, pixel + 3, frame.pixel(x / 3, y / 3));
      }
    }
    EXPECT_EQ(different, 0U) << scene;
  }
}

TEST_F(ViewCommand, ShowsAClipOfABlobAsRenderDoes) {
  const std::string figure = std::string(ZSTRIP_SCENE_FILES) + "/figure/figure.gltf";
  ASSERT_EQ(zstrip({"bake", figure, "-o", path("figure.zsc"), "--size", "60x90", "--quiet"}).status, 0);
  const Outcome outcome = view(path("figure.zsc"), "s,right,s,q", {"--animation", "wave", "--frames", "6"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(zstrip({"render", path("figure.zsc"), "-o", "frames/", "--animation", "wave", "--frames", "6"}).status, 0);
  for (const char* const number : {"1", "2"}) {
    const std::string frame = "frames/frame_000" + std::to_string(number[0] - '1') + ".png";
    EXPECT_TRUE(read(path("figure-" + std::string(number) + ".png")) == read(path(frame))) << number;
  }
  EXPECT_TRUE(read(path("figure-1.png")) != read(path("figure-2.png"))) << "it moves";
}

TEST_F(ViewCommand, KeysAndTheMouseChangeWhatIsSeenAndBack) {
  const std::vector<std::string> options{"--size", "64x48", "--frames", "5"};
  const Outcome outcome =
      view("teapot", "s,drag=60:20,s,wheel=3,s,c,s,w,s,w,s,d,s,o,s,o,s,left,s,right,s,b,s,b,space,space,c,+,-,t,t,a,q",
           options);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto shot = [&](int number) { return read(path("teapot-" + std::to_string(number) + ".png")); };
  // Of its kind each is another picture; those of equal views are equal.
  const std::string first = shot(1);
  for (const int same : {4, 6, 9, 11, 12}) EXPECT_TRUE(shot(same) == first) << same;
  for (const int other : {2, 3, 5, 7, 8, 10}) EXPECT_TRUE(shot(other) != first) << other;
  EXPECT_TRUE(shot(2) != shot(3));
  EXPECT_TRUE(shot(7) != shot(8));
  ASSERT_EQ(zstrip({"render", "teapot", "-o", "all.apng", "--frames", "5", "--size", "64x48", "--quiet"}).status, 0);
  EXPECT_TRUE(read(path("teapot-1.apng")) == read(path("all.apng")));
}

/// Without text the window has the picture's pixels.
TEST_F(ViewCommand, AClickNamesThePartAndTriangleThatRenderPicks) {
  const std::string train = std::string(ZSTRIP_SCENE_FILES) + "/gallery/train.toml";
  for (const std::string& scene : {std::string("room"), train}) {
    const std::vector<std::string> size{"--size", "320x240"};
    std::vector<std::string> options = size;
    options.insert(options.end(), {"--scale", "1", "--frames", "4"});
    const Outcome clicked = view(scene, "t,click=160:150,right,click=100:140,click=400:3,q", options);
    ASSERT_EQ(clicked.status, 0) << clicked.err;
    EXPECT_EQ(clicked.err, "");
    for (const auto& [frame, place] :
         {std::pair{std::size_t{0}, std::string("160,150")}, {std::size_t{1}, std::string("100,140")}}) {
      std::vector<std::string> rendered{"render", scene, "-o",     "frames/",     "--frames", "4",
                                        "--pick", place, "--json", "picked.json", "--quiet"};
      rendered.insert(rendered.end(), size.begin(), size.end());
      ASSERT_EQ(zstrip(rendered).status, 0);
      const auto picked = nlohmann::json::parse(read(path("picked.json"))).at("frames").at(frame).at("picked");
      ASSERT_EQ(picked.at("shown"), "instance") << scene;
      const std::string name = picked.contains("name") ? " (" + picked.at("name").get<std::string>() + ")" : "";
      const std::string expected = place + ": instance " + std::to_string(picked.at("index").get<int>()) + name +
                                   ", triangle " + std::to_string(picked.at("triangle").get<int>());
      EXPECT_EQ(name.empty(), scene == "room");
      // After them the material and the place in its texture, if it has any.
      const std::size_t begin = clicked.out.find(place);
      ASSERT_NE(begin, std::string::npos) << clicked.out;
      EXPECT_EQ(clicked.out.substr(begin, expected.size()), expected);
    }
    EXPECT_EQ(std::ranges::count(clicked.out, '\n'), 2) << "a click beside the picture says nothing: " << clicked.out;
  }
}

/// They wrote beyond pictures of one sample in rgb565, failed for methods that keep no depth, and stayed on.
TEST_F(ViewCommand, LooksAreThoseOfAPlainPicture) {
  const auto rendered = [&](const std::string& what) {
    EXPECT_EQ(zstrip({"render", "knot", "-o", what + ".png", "--size", "64x48", "--show", what, "--quiet"}).status, 0);
    return read(path(what + ".png"));
  };
  const std::string depth = rendered("depth"), overdraw = rendered("overdraw");
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{"--samples", "4"},
                                                                                       {"--samples", "2"},
                                                                                       {"--format", "mono"},
                                                                                       {"--format", "rgb444"},
                                                                                       {"--format", "xrgb8888"},
                                                                                       {"--edges"},
                                                                                       {"--visibility", "painter"},
                                                                                       {"--visibility", "half-range"},
                                                                                       {"--depth-format", "z24"}}) {
    for (const std::string& name : files()) std::filesystem::remove_all(path(name));
    std::vector<std::string> all{"--frames", "1", "--size", "64x48"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = view("knot", "s,d,s,o,s,w,s,w,s,q", all);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(read(path("knot-2.png")) == depth) << options[0] << options.back();
    EXPECT_TRUE(read(path("knot-3.png")) == overdraw) << options[0] << options.back();
    EXPECT_TRUE(read(path("knot-5.png")) == read(path("knot-1.png")));
  }
  const Outcome panel = view("knot", "d,S,o,w,q", {"--panel", "st7789", "--rotation", "90", "--frames", "2"});
  EXPECT_EQ(panel.status, 0);
  EXPECT_EQ(panel.err, "");
}

TEST_F(ViewCommand, TheHeatMapIsOfThePictureAsItIs) {
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
           {}, {"--samples", "4"}, {"--format", "gray4", "--dither"}, {"--edges"}, {"--visibility", "painter"}}) {
    for (const std::string& name : files()) std::filesystem::remove_all(path(name));
    std::vector<std::string> rendered{"render", "knot",   "-o",       "heat.png", "--size",
                                      "64x48",  "--show", "accuracy", "--quiet"};
    std::vector<std::string> all{"--frames", "1", "--size", "64x48"};
    rendered.insert(rendered.end(), options.begin(), options.end());
    all.insert(all.end(), options.begin(), options.end());
    ASSERT_EQ(zstrip(rendered).status, 0);
    const Outcome outcome = view("knot", "s,h,s,h,s,q", all);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(read(path("knot-2.png")) == read(path("heat.png"))) << (options.empty() ? "" : options[0]);
    EXPECT_TRUE(read(path("knot-2.png")) != read(path("knot-1.png")));
    EXPECT_TRUE(read(path("knot-3.png")) == read(path("knot-1.png")));
  }
  EXPECT_EQ(view("knot", "h,S,q", {"--panel", "st7789", "--rotation", "90", "--frames", "2"}).err, "");
  // What has no truth keeps its colours.
  const Outcome lit = view(std::string(ZSTRIP_SCENE_FILES) + "/point.toml", "s,h,s,q", {"--size", "64x48"});
  EXPECT_EQ(lit.status, 0);
  EXPECT_NE(lit.err.find("no truth can be drawn"), std::string::npos) << lit.err;
  EXPECT_TRUE(read(path("point-2.png")) == read(path("point-1.png")));
}

/// A drag is held back at the scene's limits, with edges or without, and further drags do nothing.
TEST_F(ViewCommand, ASceneFileLimitsTheCamera) {
  for (const char* const edges : {"false", "true"}) {
    file("s.toml", std::string("camera = { r = 6, theta = 70, orbit = { yaw = [-20, 0], pitch = [0, 0], distance = "
                               "[0.5, 1] } }\npicture = { size = [64, 48], edges = ") +
                       edges + " }\n[[model]]\nname = 'k'\nbuilt_in = 'cube'\n[[instance]]\nmodel = 'k'\n");
    const Outcome outcome = view(
        "s.toml", "s,drag=0:30,s,drag=60:0,s,drag=-60:0,drag=-400:0,s,drag=-400:0,s,c,wheel=-5,s,q", {"--frames", "1"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    std::vector<std::string> shots;
    for (int i = 1; i <= 6; ++i) shots.push_back(read(path("s-" + std::to_string(i) + ".png")));
    EXPECT_TRUE(shots[1] == shots[0]) << "pitch, edges = " << edges;
    EXPECT_TRUE(shots[2] == shots[0]) << "to the right, edges = " << edges;
    EXPECT_TRUE(shots[3] != shots[0]) << "to the left, edges = " << edges;
    EXPECT_TRUE(shots[4] == shots[3]) << "farther to the left, edges = " << edges;
    EXPECT_TRUE(shots[5] == shots[0]) << "away, edges = " << edges;
    for (int i = 1; i <= 6; ++i) std::filesystem::remove(path("s-" + std::to_string(i) + ".png"));
  }
}

/// A person saves the model in another program.
TEST_F(ViewCommand, ASceneThatIsSavedIsReadAgain) {
  const std::string name = file("a.obj", kTriangleObj);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(path(""));
  Result<Viewer> viewer = Viewer::open({.drawing = {.scene = name, .view = {.size = "32x24"}}, .frames = 1});
  ASSERT_TRUE(viewer);
  Result<Window> window = Window::open("test");
  ASSERT_TRUE(window) << window.failure().message;
  std::thread person([&] {
    const auto shot = [&](int number) { return path("a-" + std::to_string(number) + ".png"); };
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    const auto press = [&](const char* key) { window->inject(*parse_input(key)); };
    int shots = 0;
    const auto take = [&] {
      press("s");
      ++shots;
      while (!std::filesystem::exists(shot(shots)) && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    };
    take();
    file("a.obj", "not a model");
    std::filesystem::last_write_time(name, std::filesystem::last_write_time(name) + std::chrono::seconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    take();
    EXPECT_TRUE(read(shot(2)) == read(shot(1))) << "the last picture stays";
    file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 5 0\nf 1 2 3\n");
    std::filesystem::last_write_time(name, std::filesystem::last_write_time(name) + std::chrono::seconds(9));
    do {
      take();
    } while (read(shot(shots)) == read(shot(1)) && std::chrono::steady_clock::now() < deadline);
    press("q");
  });
  ::testing::internal::CaptureStdout();
  const Result<Done> done = run_view_loop(*viewer, *window, name, WatchedFiles(name), {});
  person.join();
  ::testing::internal::GetCapturedStdout();
  std::filesystem::current_path(before);
  ASSERT_TRUE(done) << done.failure().message;
  ASSERT_EQ(zstrip({"render", "a.obj", "-o", "r.png", "--size", "32x24", "--quiet"}).status, 0);
  int last = 1;
  while (std::filesystem::exists(path("a-" + std::to_string(last + 1) + ".png"))) ++last;
  EXPECT_TRUE(read(path("a-" + std::to_string(last) + ".png")) == read(path("r.png")));
}

TEST_F(ViewCommand, SaysWhatIsWrong) {
  const auto says = [&](const Outcome& outcome, int status, const std::string& words) {
    EXPECT_EQ(outcome.status, status);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  };
  says(view("tepot", "q"), 4, "teapot");
  says(view("teapot", "q,jump"), 2, "--press 'jump'");
  says(view("teapot", "q", {"--board", "pica"}), 2, "pico");
  says(view("teapot", "q", {"--board", "pico", "--bus", "spi@fast"}), 2, "spi@40MHz");
  says(view("teapot", "q", {"--bus", "spi@40MHz"}), 2, "--panel");
  says(view("teapot", "q", {"--board", "pico", "--bus", "i2c@400kHz"}), 2, "SPI");
  says(view("teapot", "q", {"--frames", "0"}), 2, "--frames");
  says(view("teapot", "q", {"--ram", "100"}), 5, "bytes");
  ::setenv("SDL_VIDEODRIVER", "nothing", 1);
  says(view("teapot", "q"), 3, "zstrip render");
}

}  // namespace
}  // namespace zstrip::sim::test
