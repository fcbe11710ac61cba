// What a window is made of: files that are watched, wires, enlarged pixels and borders, words for keys.
#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <numeric>

#include "bench/board_model.hpp"
#include "support.hpp"
#include "view/view_loop.hpp"
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

using Pixel = std::array<std::uint8_t, 3>;

Pixel at(const RgbImage& image, std::uint32_t x, std::uint32_t y) {
  return {image.pixel(x, y)[0], image.pixel(x, y)[1], image.pixel(x, y)[2]};
}

TEST(ViewWindowPicture, EnlargesPixelsAndMarksStrips) {
  RgbImage picture{.width = 3, .height = 2, .rgb = {}};
  for (std::uint8_t i = 0; i < 18; ++i) picture.rgb.push_back(i);
  ASSERT_EQ(wanted_window({3, 2}, 4, {}, {100, 100}), (WindowSize{12, 8}));
  const RgbImage plain = window_picture(picture, {}, {}, {12, 8});
  ASSERT_EQ(plain.width, 12U);
  ASSERT_EQ(plain.height, 8U);
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 12; ++x) EXPECT_EQ(at(plain, x, y), at(picture, x / 4, y / 4));
  }

  const Rect strips[] = {{0, 0, 3, 1}, {0, 1, 3, 2}};
  const RgbImage marked = window_picture(picture, {.strips = strips, .drawing = 1}, {}, {12, 8});
  const Pixel grey = at(marked, 0, 0), lit = at(marked, 0, 4);
  EXPECT_NE(grey, lit);
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 12; ++x) {
      const bool inside = x % 11 != 0 && y % 4 != 0 && y % 4 != 3;
      EXPECT_EQ(at(marked, x, y), inside ? at(plain, x, y) : y < 4 ? grey : lit) << x << ' ' << y;
    }
  }
}

TEST(ViewWindowPicture, LiesInTheMiddleOfALargerWindow) {
  const RgbImage picture{.width = 2, .height = 1, .rgb = {9, 9, 9, 7, 7, 7}};
  const RgbImage window = window_picture(picture, {}, {}, {7, 5});
  for (std::uint32_t y = 0; y < 5; ++y) {
    for (std::uint32_t x = 0; x < 7; ++x) {
      const std::uint8_t expected = y < 1 || y > 3 || x > 5 ? 0 : x < 3 ? 9 : 7;
      EXPECT_EQ(at(window, x, y), (Pixel{expected, expected, expected})) << x << ' ' << y;
    }
  }
}

TEST(ViewWindowPicture, IsReducedToTheMeanOfItsPixelsWhereItIsTooLarge) {
  const RgbImage picture{.width = 5, .height = 2, .rgb = {1, 2, 3, 3, 4, 5, 50, 60, 70, 50, 60, 70, 9, 9, 9,  //
                                                          5, 6, 7, 7, 8, 9, 50, 60, 70, 50, 60, 70, 9, 9, 9}};
  const Rect strips[] = {{0, 0, 5, 1}, {0, 1, 5, 2}};
  EXPECT_EQ(scale_in({3, 3}, {5, 2}, {}), (PictureScale{.reduced = 2}));
  const RgbImage window = window_picture(picture, {}, {}, {3, 3});
  EXPECT_EQ(at(window, 0, 1), (Pixel{4, 5, 6}));
  EXPECT_EQ(at(window, 1, 1), (Pixel{50, 60, 70}));
  for (std::uint32_t width = 1; width < 9; ++width) {
    for (std::uint32_t height = 1; height < 9; ++height) {
      EXPECT_EQ(window_picture(picture, {.strips = strips, .drawing = 1}, {}, {width, height}).rgb.size(),
                std::size_t{3} * width * height);
    }
  }
}

/// Of the rows from `top` on: the light of all pixels, which stays the same when letters move.
std::uint64_t light(const RgbImage& image, std::uint32_t top) {
  return std::accumulate(image.rgb.begin() + std::ptrdiff_t{3} * top * image.width, image.rgb.end(), std::uint64_t{0});
}

/// The last line, of boards, was cut off at the right border.
TEST(ViewWindowPicture, ItsTextIsWholeInANarrowWindow) {
  const RgbImage picture{.width = 100, .height = 50, .rgb = std::vector<std::uint8_t>(15000)};
  const std::string text[] = {
      "a line of words that is longer than a window of seven hundred and twenty pixels is wide, ", "short",
      "aWordThatIsLongerThanAnyLineOfANarrowWindowIs"};
  const std::uint64_t whole = light(window_picture(picture, {}, text, {4000, 400}), 0);
  EXPECT_GT(whole, 0U);
  for (const std::uint32_t width : {120U, 300U, 500U, 719U, 720U}) {
    const WindowSize window = wanted_window({100, 50}, 1, text, {width, 900});
    EXPECT_EQ(window.width, width);
    EXPECT_EQ(light(window_picture(picture, {}, text, window), 0), whole) << width;
  }
}

TEST(ViewWindowPicture, ItsWindowFitsTheRoomAndIsAsLargeAsAskedForWhereItCanBe) {
  const std::string text[] = {"one", "two"};
  for (const WindowSize room : {WindowSize{300, 200}, {640, 480}, {1024, 600}, {1920, 1080}}) {
    for (const WindowSize picture : {WindowSize{64, 48}, {240, 240}, {128, 16}, {800, 600}, {4000, 30}, {30, 4000}}) {
      std::uint32_t last = 0;
      for (std::uint32_t scale = 1; scale <= 8; ++scale) {
        const WindowSize window = wanted_window(picture, scale, text, room);
        EXPECT_LE(window.width, room.width);
        EXPECT_LE(window.height, room.height);
        const PictureScale found = scale_in(window, picture, text);
        EXPECT_TRUE(found.enlarged == scale || found.enlarged == std::max(last, 1U)) << picture.width << ' ' << scale;
        last = found.enlarged;
      }
    }
  }
  EXPECT_EQ(scale_in(wanted_window({240, 240}, 3, text, {1920, 1080}), {240, 240}, text).enlarged, 3U);
  EXPECT_EQ(scale_in(wanted_window({240, 240}, 3, text, {1024, 600}), {240, 240}, text).enlarged, 2U);
}

/// Every pixel of the window shows the picture's pixel that a click on it names, or none.
TEST(ViewWindowPicture, AClickHitsThePixelThatIsSeenThere) {
  RgbImage picture{.width = 5, .height = 3, .rgb = std::vector<std::uint8_t>(45)};
  for (std::size_t i = 0; i < 15; ++i) picture.rgb[3 * i] = static_cast<std::uint8_t>(i + 1);
  const std::vector<std::string> lines{"text"};
  for (const WindowSize size : {WindowSize{23, 14}, {5, 3}, {60, 90}, {40, 31}}) {
    const RgbImage window = window_picture(picture, {}, {}, size), with_text = window_picture(picture, {}, lines, size);
    for (std::uint32_t y = 0; y < size.height; ++y) {
      for (std::uint32_t x = 0; x < size.width; ++x) {
        const auto pixel = pixel_at(size, {5, 3}, {}, x, y);
        EXPECT_EQ(window.pixel(x, y)[0], pixel ? 5 * pixel->y + pixel->x + 1 : 0U) << x << ", " << y;
        const auto below_text = pixel_at(size, {5, 3}, lines, x, y);
        if (!below_text) continue;
        EXPECT_EQ(with_text.pixel(x, y)[0], 5 * below_text->y + below_text->x + 1) << x << ", " << y;
      }
    }
  }
  EXPECT_EQ(pixel_at({10, 10}, {5, 3}, {}, -1, 3), std::nullopt);
  EXPECT_EQ(pixel_at({10, 10}, {5, 3}, {}, 3, 10), std::nullopt);
  // Of a picture that is reduced to a half, the first of two pixels.
  EXPECT_EQ(pixel_at({50, 30}, {100, 60}, {}, 49, 29), (PicturePixel{98, 58}));
}

TEST(ViewWindowPicture, ThePageOfKeysIsWholeOnASmallScreen) {
  const std::vector<std::string> keys = view_keys();
  const std::uint64_t large = light(text_page(keys, 13, {4000, 400}), 0);
  EXPECT_EQ(light(text_page(keys, 13, {626, 440}), 0), large);
  EXPECT_EQ(light(text_page(keys, 13, {480, 480}), 0), large);
  const std::uint64_t small = light(text_page(keys, 13, {1000, 130}), 0);
  EXPECT_NE(small, large);
  EXPECT_EQ(light(text_page(keys, 13, {320, 240}), 0), small);
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
  EXPECT_EQ(last_line(ZSTRIP_SCENE_FILES "/csg.toml"), "the estimate leaves out: csg");
  EXPECT_TRUE(last_line("teapot").starts_with("about fps: ")) << last_line("teapot");
}

/// The micro:bit's 16 KB got 3 frames a second of a picture that takes 230 KB.
TEST(ViewText, ABoardThatThePlanDoesNotFitSaysWhatItNeeds) {
  const auto drawn = [](const char* board, const char* ram) {
    ViewRequest request;
    request.drawing.scene = "teapot_meshlets";
    request.drawing.memory.ram = ram == nullptr ? std::nullopt : std::optional<std::string>(ram);
    request.board = find_board(board);
    request.bus_mhz = request.board->spi_mhz;
    Result<Viewer> viewer = Viewer::open(request);
    if (!viewer) return viewer.failure().message;
    const Result<ViewedFrame> frame = viewer->draw();
    return frame ? frame->text.back() : frame.failure().message;
  };
  EXPECT_TRUE(drawn("microbit", "max").starts_with("microbit: needs ")) << drawn("microbit", "max");
  EXPECT_TRUE(drawn("microbit", "max").ends_with(" KB of RAM, has 16 KB")) << drawn("microbit", "max");
  EXPECT_TRUE(drawn("microbit", nullptr).ends_with(" fps"))
      << "is planned for its memory: " << drawn("microbit", nullptr);
  EXPECT_TRUE(drawn("pico", nullptr).ends_with(" fps")) << drawn("pico", nullptr);
}

TEST(ViewText, RatesHaveNoExponentAndNoRangeOfOneNumber) {
  const auto words = [](double least, double most) {
    return BoardRate{.board = "a board", .least = least, .most = most}.words();
  };
  EXPECT_EQ(words(86, 157), "86 to 157");
  EXPECT_EQ(words(0.917, 2.06), "0.92 to 2.1");
  EXPECT_EQ(words(99.7, 150), "100 to 150");
  EXPECT_EQ(words(25.9, 26.2), "26");
  EXPECT_EQ(words(2.917, 2.917), "2.92");
  EXPECT_EQ(words(999.7, 999.7), "1000");
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
  const std::optional<Input> click = parse_input("click=120:80");
  ASSERT_TRUE(click);
  EXPECT_EQ(click->kind, Input::Kind::click);
  EXPECT_EQ(click->x, 120);
  EXPECT_EQ(click->y, 80);
  for (const char* const wrong :
       {"", "nokey", "drag=1", "drag=a:b", "wheel=", "wheel=1x", "drag=1:2:3", "click=1", "click=a:1", "pan=1:2"}) {
    EXPECT_FALSE(parse_input(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
