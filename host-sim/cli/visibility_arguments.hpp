// The options that say how visibility is found, and what of it is shown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "result.hpp"
#include "visibility/show.hpp"
#include "zstrip/scene/effects.hpp"
#include "zstrip/visibility/options.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// As given on the command line.
struct VisibilityArguments {
  std::optional<std::string> method;
  std::uint32_t iterations = VisibilityOptions{}.iterations;
  std::string key = "middle";
  std::vector<std::string> cull{"back-faces", "small"};
  std::string sets;  ///< a file that `zstrip bake` wrote; empty: none
  std::string show;  ///< empty: the picture
};

struct VisibilityRequest {
  Effects method;
  VisibilityOptions options;
  std::string sets;  ///< a file, or empty
  Show show = Show::colour;
};

/// Adds the options; `arguments` must live as long as the command.
void add_visibility_options(CLI::App& command, VisibilityArguments& arguments);

/// `setting`: the scene file's method, which counts where the command line names none.
Result<VisibilityRequest> parse_visibility(const VisibilityArguments& arguments,
                                           const std::optional<std::string>& setting);

}  // namespace zstrip::sim
