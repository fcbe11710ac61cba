// `zstrip view`: options, the window.
#include "view/view_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/parse.hpp"
#include "cli/print.hpp"
#include "cli/sibling_program.hpp"
#include "text/step_report.hpp"
#include "text/text.hpp"
#include "view/view_arguments.hpp"
#include "view/view_loop.hpp"
#include "view/viewer.hpp"
#include "view/watched_files.hpp"
#include "view/window.hpp"

namespace zstrip::sim {
namespace {

struct ViewCommandLine {
  ViewOptions options;
  std::uint32_t scale = 0;
  bool no_watch = false;
  std::string press;
};

Result<std::vector<Input>> parse_inputs(const std::string& words) {
  std::vector<Input> inputs;
  std::istringstream stream(words);
  for (std::string word; std::getline(stream, word, ',');) {
    const std::optional<Input> input = parse_input(word);
    if (!input) return usage(fmt::format("--press '{}' is not a key, drag=X:Y, click=X:Y or wheel=N", word));
    inputs.push_back(*input);
  }
  return inputs;
}

std::string help_on_keys() {
  std::string text = "Mouse and keys:\n";
  for (const std::string& line : view_keys()) text += "  " + line + "\n";
  return text;
}

/// Returns text for the user: the scene, and the keys.
std::string greeting(const std::string& scene, const Viewer& viewer) {
  const double seconds = viewer.milliseconds() / 1e3;
  return fmt::format("zstrip view {}: {}\n{}", printable(scene),
                     viewer.moves() ? fmt::format("an animation of {} seconds, which plays; Space stops it", seconds)
                                    : std::string("nothing moves; drag turns it, Space turns it by itself"),
                     help_on_keys());
}

Result<Done> view(const ViewCommandLine& arguments) {
  Result<ViewRequest> request = parse_view_request(arguments.options);
  if (!request) return request.failure();
  request->smooth = !arguments.options.frames;
  Result<std::vector<Input>> inputs = parse_inputs(arguments.press);
  if (!inputs) return inputs.failure();
  const std::string& scene = arguments.options.drawing.scene;
  WatchedFiles files(scene);
  std::optional<StepReport> steps(std::in_place, true);
  Result<Viewer> viewer = Viewer::open(*request);
  steps.reset();
  if (!viewer) return viewer.failure();
  Result<Window> window = Window::open("zstrip: " + scene);
  if (!window) return window.failure();
  const bool for_a_person = inputs->empty();
  if (for_a_person) write_text(stdout, greeting(scene, *viewer));
  return run_view_loop(*viewer, *window, scene, std::move(files),
                       {.scale = arguments.scale,
                        .watch = !arguments.no_watch,
                        .playing = for_a_person && viewer->moves(),
                        .inputs = std::move(*inputs)});
}

}  // namespace

void add_view_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(kViewCommand.name, kViewCommand.description);
  const auto arguments = std::make_shared<ViewCommandLine>();
  ViewCommandLine& a = *arguments;
  add_view_options(*command, a.options);
  command
      ->add_option("--scale", a.scale,
                   "The window's pixels for one of the picture, 1 to 8, if the screen has them (default: as fits)")
      ->option_text("N")
      ->check(CLI::Range(1U, 8U));
  command->add_flag("--no-watch", a.no_watch, "The scene is not read again when its files change");
  command
      ->add_option("--press", a.press,
                   "Keys that are pressed at the beginning, for scripts: right,drag=40:0,wheel=2,click=120:80,s,q; "
                   "nothing plays")
      ->type_name("KEYS");
  command->footer(help_on_keys() +
                  "Examples:\n"
                  "  zstrip view teapot\n"
                  "  zstrip view robot.glb --ram 20K\n"
                  "  zstrip view teapot --board pico --bus spi@40MHz --strip-rows 40\n"
                  "  zstrip view teapot --panel ssd1306 --dither\n"
                  "  SDL_VIDEODRIVER=dummy zstrip view teapot --press right,s,q");
  command->callback([arguments, &exit_code] {
    const Result<Done> viewed = view(*arguments);
    exit_code = viewed ? static_cast<int>(ExitStatus::ok) : print_failure(viewed.failure());
  });
}

}  // namespace zstrip::sim
