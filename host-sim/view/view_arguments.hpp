// The options that select the view: drawing, number of frames, and a board.
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

/// The options as given on the command line.
struct ViewOptions {
  DrawingArguments drawing;
  std::optional<std::uint32_t> frames;
  std::optional<std::string> board;
};

/// Adds the scene and the options; `options` must live as long as the command.
void add_view_options(CLI::App& command, ViewOptions& options);

/// Converts the options to a request; the scene is not read yet.
Result<ViewRequest> parse_view_request(const ViewOptions& options);

}  // namespace zstrip::sim
