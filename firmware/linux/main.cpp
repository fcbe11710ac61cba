// zstrip-panel: plays a baked scene on a screen or panel of a Linux machine.
#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>

#include "machine_list.hpp"
#include "open_display.hpp"
#include "play.hpp"

namespace {

using zstrip::panel::ExitStatus;
using zstrip::panel::Failure;

struct Arguments {
  std::string scene;
  std::string display;
  zstrip::panel::PlayOptions play{.frames_per_turn = 64};
  bool hold = false;
  bool list = false;
  bool quiet = false;
};

constexpr const char* kFooter = R"(Displays, KIND:[DEVICE,]KEY=VALUE,...:
  fbdev:/dev/fb0          size=WxH, depth=16|24|32
  drm:/dev/dri/card0      size=WxH, connector=NAME (as --list shows) or all, format=rgb565|xrgb8888
  sdl:WxH@SCALE           a window of the desktop; without WxH as large as the scene was baked, SCALE 1 to 8
  st7789: ili9341: st7735: gc9a01: st7796: ili9342: ili9488: ssd1351: ssd1306: ssd0323:
    panels on SPI; docs/linux.md has all keys
    spidev=/dev/spidev0.0,speed=HZ  or bit by bit  clock=LINE,data=LINE[,select=LINE][,miso=LINE]
    dc=LINE[,reset=LINE][,backlight=LINE]
    id  reads the id of all but the ssd ones before anything is sent, where they have a wire to answer
  ssd1306:i2c=/dev/i2c-1[,address=0x3D][,reset=LINE]   on I2C, at 0x3c unless told
A LINE is CHIP:OFFSET (gpiochip0:25) or the line's name.

Exit status: 0 shown, or stopped by a signal (SIGINT, SIGTERM, SIGHUP and others) or a closed window; 1 bug;
2 command line; 3 device missing, busy or not permitted; 4 scene; 5 too little memory; 6 the display or standard output
failed.)";

int fail(const Failure& failure) {
  std::fprintf(stderr, "zstrip-panel: %s\n", failure.message.c_str());
  return static_cast<int>(failure.status);
}

int say(const std::string& words) {
  if (std::fputs(words.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return static_cast<int>(ExitStatus::ok);
  return fail({ExitStatus::output, std::string("standard output takes no words: ") + std::strerror(errno) +
                                       "; --quiet plays without them"});
}

int run(const Arguments& arguments, zstrip::panel::StopSignals& stop) {
  auto scene = zstrip::panel::SceneFile::open(arguments.scene);
  if (!scene) return fail({ExitStatus::input, scene.fault().message});
  auto opened = zstrip::panel::open_display(arguments.display, scene->size());
  if (const Failure* failure = std::get_if<Failure>(&opened)) return fail(*failure);
  zstrip::panel::AnyDisplay& display = *std::get<zstrip::panel::DisplayPointer>(opened);
  stop.watch(display.is_closed());

  zstrip::panel::Played played;
  if (const auto failure = zstrip::panel::play(*scene, display, arguments.play, stop, played)) return fail(*failure);
  if (!arguments.quiet) {
    char words[128];
    std::snprintf(words, sizeof words, "%u frames of %ux%u in %.2f s, %.1f a second\n", played.frames, display.width(),
                  display.height(), played.seconds, played.seconds > 0 ? played.frames / played.seconds : 0.0);
    if (const int status = say(words); status != 0) return status;
  }
  if (arguments.hold) stop.wait();
  return static_cast<int>(ExitStatus::ok);
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Plays a baked scene (zstrip bake SCENE -o scene.zsc) on a screen or panel of this machine.",
               "zstrip-panel");
  app.footer(kFooter);
  app.add_option("scene", arguments.scene, "The baked scene, .zsc");
  app.add_option("--display", arguments.display, "Where to show it; see below");
  app.add_option("--frames", arguments.play.frames, "Frames to show; 0: until stopped (default)");
  app.add_option("--turn", arguments.play.frames_per_turn, "Frames of a full turn of the scene (default: 64)")
      ->check(CLI::Range(1U, 1'000'000U));
  app.add_option("--fps", arguments.play.frames_per_second, "Frames a second at most (default: no limit)")
      ->check(CLI::Range(0.01, 1000.0));
  app.add_flag("--hold", arguments.hold, "Leave the last frame on the display until stopped");
  app.add_flag("--list", arguments.list, "List screens, SPI and I2C devices and GPIO lines of this machine, and end");
  app.add_flag("--quiet", arguments.quiet, "Say nothing but warnings and errors");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail({ExitStatus::usage, error.what()});
  }
  if (std::isnan(arguments.play.frames_per_second))  // a test of the range does not reject NaN
    return fail({ExitStatus::usage, "--fps must be a number from 0.01 to 1000"});
  try {
    // Before any device is opened, so that a signal finds all objects able to close.
    zstrip::panel::StopSignals stop;
    if (arguments.list) return say(zstrip::panel::machine_list());
    if (arguments.scene.empty() || arguments.display.empty())
      return fail(
          {ExitStatus::usage, "name a scene and a --display; --list shows what there is, --help how to name it"});
    return run(arguments, stop);
  } catch (const std::exception& error) {
    return fail({ExitStatus::internal, error.what()});
  }
}
