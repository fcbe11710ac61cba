// The options that say what is viewed: those of drawing, of how many frames there are, and of a board.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/drawing_arguments.hpp"
#include "result.hpp"
#include "view/viewer.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// As given on the command line.
struct ViewOptions {
  DrawingArguments drawing;
  std::optional<std::uint32_t> frames;
  std::optional<std::string> board;
};

/// Adds the scene and the options; `options` must live as long as the command.
void add_view_options(CLI::App& command, ViewOptions& options);

/// What they ask for; the scene is not read yet.
Result<ViewRequest> parse_view_request(const ViewOptions& options);

}  // namespace zstrip::sim
