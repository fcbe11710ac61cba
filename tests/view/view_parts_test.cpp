// What a window is made of: files that are watched, wires, enlarged pixels and borders, words for keys.
#include <chrono>
#include <cstring>
#include <filesystem>

#include "support.hpp"
#include "view/viewer.hpp"
#include "view/watched_files.hpp"
#include "view/window.hpp"
#include "view/window_picture.hpp"
#include "view/wireframe.hpp"

namespace zstrip::sim::test {
namespace {

class ViewWatchedFiles : public FolderTest {
 protected:
  /// As if `name` was saved later.
  void touch(const std::string& name) const {
    const std::filesystem::path path = this->path(name);
    std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(5));
  }
};

TEST_F(ViewWatchedFiles, AreThoseThatTheSceneNamesAndThoseThatTheyName) {
  std::filesystem::create_directory(path("parts"));
  file("scene.toml", "[[model]]\nname = 'a'\nfile = 'parts/a.obj'\n");
  file("parts/a.obj", "mtllib a.mtl\n" + kTriangleObj);
  file("parts/a.mtl", "newmtl m\nmap_Kd skin.png\n");
  file("parts/skin.png", "a picture");
  file("parts/other.png", "another");
  WatchedFiles files(path("scene.toml"));
  EXPECT_FALSE(files.changed());
  for (const char* const name : {"scene.toml", "parts/a.obj", "parts/a.mtl", "parts/skin.png"}) {
    touch(name);
    EXPECT_TRUE(files.changed()) << name;
    EXPECT_FALSE(files.changed()) << name;
  }
  touch("parts/other.png");
  EXPECT_FALSE(files.changed());
}

TEST_F(ViewWatchedFiles, AFileThatIsBeingReplacedChangesWhenItIsBack) {
  const std::string name = file("a.obj", kTriangleObj);
  WatchedFiles files(name);
  std::filesystem::rename(name, path("aside"));
  EXPECT_FALSE(files.changed());
  std::filesystem::rename(path("aside"), name);
  EXPECT_FALSE(files.changed());
  touch("a.obj");
  EXPECT_TRUE(files.changed());
}

TEST_F(ViewWatchedFiles, NeedNotBeThere) {
  EXPECT_FALSE(WatchedFiles("teapot").changed());
  WatchedFiles files(path("missing.obj"));
  EXPECT_FALSE(files.changed());
  file("missing.obj", kTriangleObj);
  EXPECT_TRUE(files.changed());
  EXPECT_FALSE(files.changed());
}

TEST(ViewWindowPicture, EnlargesPixelsAndMarksStrips) {
  RgbImage picture{.width = 3, .height = 2, .rgb = {}};
  for (std::uint8_t i = 0; i < 18; ++i) picture.rgb.push_back(i);
  const auto at = [](const RgbImage& image, std::uint32_t x, std::uint32_t y) {
    return std::vector<std::uint8_t>(image.pixel(x, y), image.pixel(x, y) + 3);
  };
  const RgbImage plain = window_picture(picture, 4, {}, {});
  ASSERT_EQ(plain.width, 12U);
  ASSERT_EQ(plain.height, 8U);
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 12; ++x) EXPECT_EQ(at(plain, x, y), at(picture, x / 4, y / 4));
  }

  const Rect strips[] = {{0, 0, 3, 1}, {0, 1, 3, 2}};
  const RgbImage marked = window_picture(picture, 4, {.strips = strips, .drawing = 1}, {});
  const auto grey = at(marked, 0, 0), lit = at(marked, 0, 4);
  EXPECT_NE(grey, lit);
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 12; ++x) {
      const bool inside = x % 11 != 0 && y % 4 != 0 && y % 4 != 3;
      EXPECT_EQ(at(marked, x, y), inside ? at(plain, x, y) : y < 4 ? grey : lit) << x << ' ' << y;
    }
  }
}

TEST(ViewWindowPicture, HasALineForEachText) {
  const RgbImage picture{.width = 2, .height = 1, .rgb = std::vector<std::uint8_t>(6, 7)};
  const std::string text[] = {"one", "two"};
  const RgbImage one = window_picture(picture, 1, {}, std::span(text, 1)), two = window_picture(picture, 1, {}, text);
  EXPECT_EQ(one.width, kTextWidth);
  EXPECT_GT(two.height, one.height);
  EXPECT_EQ(two.rgb.size(), std::size_t{3} * two.width * two.height);
  const auto lights = [](const RgbImage& image) { return std::ranges::count(image.rgb, 255); };
  EXPECT_GT(lights(one), 0);
  EXPECT_GT(lights(two), lights(one));
}

TEST(ViewWireframe, HasEveryEdgeOfEveryInstance) {
  for (const char* const name : {"cube", "knot", "environment"}) {
    const Result<std::unique_ptr<Stage>> stage = open_stage(name, {}, {}, {.width = 32, .height = 24}, 1);
    ASSERT_TRUE(stage);
    const Result<Staging> staging = (*stage)->place(0, 1);
    ASSERT_TRUE(staging);
    Wireframe wireframe;
    const std::span<const Instance> instances = staging->scene.instances;
    const Scene wires = wireframe.of(*staging).scene;
    const std::span<const LineSet> lines = wires.lines;
    EXPECT_TRUE(wires.instances.empty());
    ASSERT_FALSE(instances.empty());
    ASSERT_EQ(lines.size(), instances.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i].mesh, instances[i].mesh);
      EXPECT_EQ(std::memcmp(&lines[i].transform, &instances[i].transform, sizeof(Transform)), 0);
      // Of a closed mesh of triangles, each edge has two.
      EXPECT_EQ(2 * lines[i].segments.size(), 3 * staging->scene.meshes[lines[i].mesh].triangles.size()) << name;
    }
  }
}

TEST(ViewText, SaysWhichEffectsTheEstimateLeavesOut) {
  const auto last_line = [](const char* scene) {
    ViewRequest request;
    request.drawing.scene = scene;
    request.drawing.view.size = "64x48";
    Result<Viewer> viewer = Viewer::open(request);
    if (!viewer) return viewer.failure().message;
    const Result<ViewedFrame> drawn = viewer->draw();
    return drawn ? drawn->text.back() : drawn.failure().message;
  };
  EXPECT_EQ(last_line("fog"), "the estimate leaves out: fog");
  EXPECT_TRUE(last_line("teapot").starts_with("about/s: ")) << last_line("teapot");
}

TEST(ViewInput, IsWrittenAsWords) {
  const auto key = [](const char* word) { return parse_input(word) ? parse_input(word)->key : "none"; };
  EXPECT_EQ(key("w"), "w");
  EXPECT_EQ(key("S"), "S");
  EXPECT_EQ(key("right"), "Right");
  EXPECT_EQ(key("space"), "Space");
  EXPECT_EQ(key("="), "=");
  const std::optional<Input> drag = parse_input("drag=40:-10"), wheel = parse_input("wheel=-2");
  ASSERT_TRUE(drag && wheel);
  EXPECT_EQ(drag->kind, Input::Kind::drag);
  EXPECT_EQ(drag->x, 40);
  EXPECT_EQ(drag->y, -10);
  EXPECT_EQ(wheel->kind, Input::Kind::wheel);
  EXPECT_EQ(wheel->y, -2);
  for (const char* const wrong : {"", "nokey", "drag=1", "drag=a:b", "wheel=", "wheel=1x", "drag=1:2:3", "pan=1:2"}) {
    EXPECT_FALSE(parse_input(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
