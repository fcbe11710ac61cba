// The options for the visibility method, and for pictures of its work.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compose/scene_file.hpp"
#include "result.hpp"
#include "visibility/show.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/visibility.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct VisibilityArguments {
  std::optional<std::string> method;
  std::optional<std::uint32_t> iterations;
  std::optional<std::string> key;
  std::vector<std::string> cull;  ///< empty: not given
  std::string sets;               ///< a file that `zstrip bake` wrote; empty: none
  std::string show;               ///< empty: the picture
};

struct VisibilityRequest {
  Effects method;
  VisibilityOptions options;
  std::string sets;       ///< a file, or empty
  bool temporal = false;  ///< VisibilityOptions::seen_before is kept from frame to frame
  Show show = Show::colour;
};

/// Adds the options; `arguments` must live as long as the command.
void add_visibility_options(CLI::App& command, VisibilityArguments& arguments);

/// `settings`: those of the scene file; each applies if the command line does not have the option.
Result<VisibilityRequest> parse_visibility(const VisibilityArguments& arguments, const VisibilitySettings& settings);

}  // namespace zstrip::sim
