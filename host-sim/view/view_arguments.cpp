// The options that select the view: drawing, number of frames, and a board.
#include "view/view_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "cli/board_arguments.hpp"
#include "cli/one_of.hpp"
#include "cli/parse.hpp"

namespace zstrip::sim {
void add_view_options(CLI::App& command, ViewOptions& options) {
  add_drawing_options(command, options.drawing);
  command
      .add_option("--frames", options.frames,
                  "Frames of the animation, or of a full rotation, 1 to 10000 (default: 64, or 30 a second of an "
                  "animation in the window if that is more)")
      ->option_text("N")
      ->check(CLI::Range(1U, 10000U));
  command
      .add_option("--board", options.board,
                  fmt::format("Show the picture about as fast as this board draws it: {}; --bus is then its bus",
                              fmt::join(names_of_boards(), ", ")))
      ->transform(lower_case())
      ->type_name("NAME");
}

Result<ViewRequest> parse_view_request(const ViewOptions& options) {
  ViewRequest request{.drawing = options.drawing, .frames = options.frames.value_or(64)};
  if (!options.board) return request;
  const Result<const BoardModel*> board = parse_board(*options.board);
  if (!board) return board.failure();
  request.board = *board;
  request.bus_mhz = (*board)->spi_mhz;
  // A panel has its own bus; without a panel the board's bus is used.
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

}  // namespace zstrip::sim
