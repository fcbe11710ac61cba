// `zstrip view`: options, the window.
#include "view/view_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "bench/board_model.hpp"
#include "cli/nearest_name.hpp"
#include "cli/parse.hpp"
#include "cli/print.hpp"
#include "cli/sibling_program.hpp"
#include "view/view_loop.hpp"
#include "view/viewer.hpp"
#include "view/watched_files.hpp"
#include "view/window.hpp"

namespace zstrip::sim {
namespace {

struct ViewCommandLine {
  DrawingArguments drawing;
  std::uint32_t frames = 64;
  std::optional<std::string> board;
  std::uint32_t scale = 0;
  bool no_watch = false;
  std::string press;
};

Result<const BoardModel*> parse_board(const std::string& text) {
  if (const BoardModel* const board = find_board(text)) return board;
  std::vector<std::string_view> names;
  for (const BoardModel& board : board_models()) names.push_back(board.name);
  return usage(unknown_name("--board", text, names));
}

Result<ViewRequest> parse(const ViewCommandLine& arguments) {
  ViewRequest request{.drawing = arguments.drawing, .frames = arguments.frames};
  if (!arguments.board) return request;
  const Result<const BoardModel*> board = parse_board(*arguments.board);
  if (!board) return board.failure();
  request.board = *board;
  request.bus_mhz = (*board)->spi_mhz;
  // A panel has a bus of its own; without one it is the board's.
  std::optional<std::string>& bus = request.drawing.panel.bus;
  if (!bus) return request;
  const Result<double> hertz = parse_bus_hertz(*bus);
  if (!hertz) return hertz.failure();
  request.bus_mhz = *hertz / 1e6;
  if (!request.drawing.panel.panel) {
    if (!bus->starts_with("spi@")) return usage(fmt::format("--bus '{}': the bus of a board is SPI, spi@40MHz", *bus));
    bus.reset();
  }
  return request;
}

Result<std::vector<Input>> parse_inputs(const std::string& words) {
  std::vector<Input> inputs;
  std::istringstream stream(words);
  for (std::string word; std::getline(stream, word, ',');) {
    const std::optional<Input> input = parse_input(word);
    if (!input) return usage(fmt::format("--press '{}' is no key, drag=X:Y or wheel=N", word));
    inputs.push_back(*input);
  }
  return inputs;
}

Result<Done> view(const ViewCommandLine& arguments) {
  const Result<ViewRequest> request = parse(arguments);
  if (!request) return request.failure();
  Result<std::vector<Input>> inputs = parse_inputs(arguments.press);
  if (!inputs) return inputs.failure();
  WatchedFiles files(arguments.drawing.scene);
  Result<Viewer> viewer = Viewer::open(*request);
  if (!viewer) return viewer.failure();
  Result<Window> window = Window::open("zstrip: " + arguments.drawing.scene);
  if (!window) return window.failure();
  return run_view_loop(*viewer, *window, arguments.drawing.scene, std::move(files),
                       {.scale = arguments.scale, .watch = !arguments.no_watch, .inputs = std::move(*inputs)});
}

}  // namespace

void add_view_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(kViewCommand.name, kViewCommand.description);
  const auto arguments = std::make_shared<ViewCommandLine>();
  ViewCommandLine& a = *arguments;
  add_drawing_options(*command, a.drawing);
  command->add_option("--frames", a.frames, "Frames of the animation, or of a full turn, 1 to 10000 (default: 64)")
      ->option_text("N")
      ->check(CLI::Range(1U, 10000U));
  std::vector<std::string_view> boards;
  for (const BoardModel& board : board_models()) boards.push_back(board.name);
  command
      ->add_option("--board", a.board,
                   fmt::format("As slow as this board is about: {}; --bus is then its bus", fmt::join(boards, ", ")))
      ->type_name("NAME");
  command->add_option("--scale", a.scale, "The window's pixels for one of the picture, 1 to 8 (default: as fits)")
      ->option_text("N")
      ->check(CLI::Range(1U, 8U));
  command->add_flag("--no-watch", a.no_watch, "The scene is not read again when its files change");
  command
      ->add_option("--press", a.press,
                   "Keys that are pressed at the beginning, for scripts: right,drag=40:0,wheel=2,s,q")
      ->type_name("KEYS");
  command->footer(view_keys() +
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
