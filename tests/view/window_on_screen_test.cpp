// What a person sees of `zstrip view` on a desktop of X11: small and large screens, with and without a window manager.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include "colour_picture.hpp"
#include "command_fixture.hpp"
#include "started_program.hpp"
#include "x11_desktop.hpp"

namespace zstrip::sim::test {
namespace {

using namespace std::chrono_literals;
using boards::ColourPicture;
using linux_window::StartedProgram;
using linux_window::X11Desktop;

const std::string kScenes = ZSTRIP_SCENE_FILES;

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

/// Whether `window` has the picture in the middle of its columns, each pixel a square of `scale` pixels.
bool has_copy(const ColourPicture& window, const ColourPicture& picture, int scale) {
  const int width = picture.width * scale, height = picture.height * scale, left = (window.width - width) / 2;
  const auto has_row = [&](int top, int y) {
    for (int x = 0; x < width; ++x) {
      if (window.at(left + x, top + y) != picture.at(x / scale, y / scale)) return false;
    }
    return true;
  };
  if (left < 0) return false;
  for (int top = 0; top + height <= window.height; ++top) {
    int y = 0;
    // From the middle on: the first rows are of one colour, and many rows of a window are like them.
    while (y < height && has_row(top, (y + height / 2) % height)) ++y;
    if (y == height) return true;
  }
  return false;
}

class ViewOnScreen : public Command {
 protected:
  void SetUp() override {
    if (!is_installed("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
  }
  void desktop(const std::string& size, const std::string& manager = {}) {
    desktop_.reset();
    desktop_ = std::make_unique<X11Desktop>(size, manager);
  }
  std::unique_ptr<StartedProgram> view(const std::string& scene, std::vector<std::string> options = {},
                                       std::vector<std::string> variables = {}) {
    title_ = "zstrip: " + scene;
    options.insert(options.begin(), {ZSTRIP_COMMAND, "view", scene});
    variables.insert(variables.end(), {desktop_->variable(), "SDL_VIDEODRIVER=x11"});
    return std::make_unique<StartedProgram>(options, variables);
  }
  ColourPicture rendered(const std::string& scene, const std::string& size) const {
    EXPECT_EQ(zstrip({"render", scene, "-o", "frame.ppm", "--size", size, "--quiet"}).status, 0);
    return boards::read_ppm(path("frame.ppm"));
  }
  /// Whether it becomes true soon. Windows are shown some time after they are drawn.
  static bool soon(const auto& is_true) {
    const auto deadline = std::chrono::steady_clock::now() + 15s;
    while (!is_true()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::sleep_for(50ms);
    }
    return true;
  }
  bool shows(const ColourPicture& picture, int scale) {
    return soon([&] { return has_copy(desktop_->seen(title_), picture, scale); });
  }

  std::unique_ptr<X11Desktop> desktop_;
  std::string title_;
};

/// It stood hundreds of pixels too high, below it was black, and the window was larger than the screen, until a key.
TEST_F(ViewOnScreen, TheFirstPictureIsWholeAndTheWindowLiesWithinTheScreen) {
  const ColourPicture picture = rendered("teapot", "240x240");
  const struct {
    std::string size;
    int width, height, scale;
  } screens[] = {{"640x480", 640, 480, 1}, {"1024x600", 1024, 600, 1}, {"1920x1080", 1920, 1080, 3}};
  for (const std::string manager : {"", "openbox"}) {
    if (!manager.empty() && !is_installed(manager)) continue;
    for (const auto& screen : screens) {
      SCOPED_TRACE(screen.size + " " + manager);
      desktop(screen.size, manager);
      const auto program = view("teapot", {"--size", "240x240"});
      EXPECT_TRUE(shows(picture, screen.scale));
      const X11Desktop::Place place = desktop_->place(title_);
      EXPECT_GE(place.left, 0);
      EXPECT_GE(place.top, 0);
      EXPECT_LE(place.right, screen.width);
      EXPECT_LE(place.bottom, screen.height);
      desktop_->close(title_);
      EXPECT_EQ(program->wait(), 0);
    }
  }
}

TEST_F(ViewOnScreen, EveryRendererOfSdlShowsTheSamePixels) {
  const ColourPicture picture = rendered("teapot", "240x240");
  for (const std::string renderer : {"software", "opengl", "opengles2"}) {
    for (const std::string acceleration : {"0", "1"}) {
      SCOPED_TRACE(renderer + " " + acceleration);
      desktop("1280x1024", is_installed("openbox") ? "openbox" : "");
      const auto program = view("teapot", {"--size", "240x240"},
                                {"SDL_RENDER_DRIVER=" + renderer, "SDL_FRAMEBUFFER_ACCELERATION=" + acceleration});
      EXPECT_TRUE(shows(picture, 3));
    }
  }
}

TEST_F(ViewOnScreen, TheDesktopMayGiveTheWindowAnotherSize) {
  const ColourPicture picture = rendered("teapot", "240x240");
  desktop("1280x1024", is_installed("openbox") ? "openbox" : "");
  const auto program = view("teapot", {"--size", "240x240"});
  ASSERT_TRUE(shows(picture, 3));
  desktop_->resize(title_, 500, 700);
  EXPECT_TRUE(shows(picture, 2));
  desktop_->resize(title_, 300, 400);
  EXPECT_TRUE(shows(picture, 1));
  desktop_->resize(title_, 1100, 900);
  EXPECT_TRUE(shows(picture, 3));
}

TEST_F(ViewOnScreen, APictureLargerThanTheScreenIsReduced) {
  desktop("640x480");
  const ColourPicture picture = rendered("teapot", "1200x900");
  const auto program = view("teapot", {"--size", "1200x900"});
  const auto lit_columns = [](const ColourPicture& image, int rows) {
    int columns = 0;
    for (int x = 0; x < image.width; ++x) {
      bool lit = false;
      for (int y = 0; y < rows; ++y) lit = lit || image.at(x, y)[0] > 16;
      columns += lit;
    }
    return columns;
  };
  const int whole = lit_columns(picture, picture.height);
  // Of a third of the picture's size, 300 rows; the text is below.
  const auto reduced = [&] { return lit_columns(desktop_->seen(title_), 290); };
  EXPECT_TRUE(soon([&] { return std::abs(reduced() - whole / 3) < 4; })) << reduced() << " of " << whole;
  EXPECT_LE(desktop_->place(title_).bottom, 480);
}

TEST_F(ViewOnScreen, ASceneWithMotionPlaysByItselfAndOneWithoutRests) {
  desktop("1024x768");
  const std::string robot = kScenes + "/gallery/robot.toml";
  const auto playing = view(robot);
  EXPECT_EQ(playing->read_line().substr(0, 12), "zstrip view ");
  EXPECT_NE(playing->read_line(), "");
  const ColourPicture first = desktop_->seen(title_);
  EXPECT_TRUE(soon([&] { return desktop_->seen(title_) != first; }));

  const ColourPicture picture = rendered("teapot", "240x240");
  const auto resting = view("teapot", {"--size", "240x240"});
  EXPECT_TRUE(shows(picture, 2));
  std::this_thread::sleep_for(500ms);
  EXPECT_TRUE(has_copy(desktop_->seen(title_), picture, 2));
}

TEST_F(ViewOnScreen, TheStartNamesTheKeys) {
  desktop("640x480");
  const auto program = view("teapot");
  std::string words;
  while (words.find("quit") == std::string::npos) words += program->read_line() + "\n";
  for (const char* const key : {"drag", "Space", "Right", "k, F1", "q, Escape"}) {
    EXPECT_NE(words.find(key), std::string::npos) << key;
  }
  const Outcome help = zstrip({"view", "--help"});
  EXPECT_NE(help.out.find("k, F1"), std::string::npos) << help.out;
}

/// A display that takes the connection and never says a word.
class SilentDisplay {
 public:
  SilentDisplay() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    for (number_ = 100; number_ < 1000; ++number_) {
      sockaddr_in address{};
      address.sin_family = AF_INET;
      address.sin_port = htons(static_cast<std::uint16_t>(6000 + number_));
      address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) break;
    }
    ::listen(socket_, 4);
  }
  ~SilentDisplay() { ::close(socket_); }
  SilentDisplay(const SilentDisplay&) = delete;
  SilentDisplay& operator=(const SilentDisplay&) = delete;
  std::string name() const { return "127.0.0.1:" + std::to_string(number_); }

 private:
  int socket_, number_ = 0;
};

/// It waited without an end.
TEST_F(Command, ViewWithoutADisplayThatAnswersSaysSoAndWhatToDo) {
  ::unsetenv("SDL_VIDEODRIVER");
  ::unsetenv("WAYLAND_DISPLAY");
  ::setenv("XDG_RUNTIME_DIR", path("").c_str(), 1);
  const SilentDisplay silent;
  for (const std::string& display : {std::string(), std::string("127.0.0.1:999"), silent.name()}) {
    SCOPED_TRACE(display);
    if (display.empty()) {
      ::unsetenv("DISPLAY");
    } else {
      ::setenv("DISPLAY", display.c_str(), 1);
    }
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = run("/usr/bin/timeout", {"25", ZSTRIP_COMMAND, "view", "cube"}, path(""));
    EXPECT_LT(std::chrono::steady_clock::now() - start, 20s);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err.find("zstrip: no window can be opened: "), 0U) << outcome.err;
    EXPECT_NE(outcome.err.find("ssh -X"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("zstrip render SCENE -o"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
