// The options for pictures of a scene, shared by the commands that draw them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/camera_arguments.hpp"
#include "cli/panel_arguments.hpp"
#include "cli/picture_arguments.hpp"
#include "cli/visibility_arguments.hpp"
#include "panel/simulated_panel.hpp"
#include "plan/ram_limit.hpp"
#include "result.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/view.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct DrawingArguments {
  std::string scene;
  ViewArguments view{};
  MemoryArguments memory{};
  std::optional<std::string> depth_format{};
  std::optional<std::string> perspective{};
  PanelArguments panel{};
  CameraArguments camera{};
  VisibilityArguments visibility{};
};

/// The parsed options.
struct Drawing {
  ModelOptions model;
  std::optional<PanelRequest> panel;
  View view;
  std::optional<bool> edges;  ///< for with_edges
  bool lod = false;           ///< for with_levels
  DepthFormat depth_format = DepthFormat::z16;
  std::string_view depth_given;  ///< the option that chose it, for messages
  Effects perspective;
  Budget budget;
  RamLimit ram_limit = RamLimit::given;
  CameraOptions camera;
  VisibilityRequest visibility;

  /// Returns the options in addition to scene, view and method.
  Effects effects() const { return depth_effect(depth_format) | perspective; }
};

/// Adds the scene and the options; `arguments` must live as long as the command.
void add_drawing_options(CLI::App& command, DrawingArguments& arguments);

/// `settings`, those of the scene file, apply where the command line has no option.
Result<Drawing> parse_drawing(const DrawingArguments& arguments, const PictureSettings& settings);

}  // namespace zstrip::sim
