// The options that place the camera and turn the model upright, shared by the commands that take them.
#pragma once

#include <optional>
#include <string>

#include "import/source_model.hpp"
#include "render/camera.hpp"
#include "render/stage.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// As given on the command line.
struct CameraArguments {
  std::optional<std::string> up;
  std::optional<std::string> animation;
  bool highlights = false;
  std::optional<std::string> camera;
  std::optional<std::string> eye;
  std::optional<std::string> look_at;
  std::optional<std::string> orbit;
  std::optional<double> field_of_view;
  bool orthographic = false;
};

/// Adds the options; `arguments` must live as long as the command.
void add_camera_options(CLI::App& command, CameraArguments& arguments);

/// `scene`: --camera is a usage error for those that are no model files.
Result<CameraOptions> parse_camera(const CameraArguments& arguments, const std::string& scene);

/// --up, --animation and --highlights. Usage errors for scenes that are no model files: those set such things
/// themselves.
Result<ModelOptions> parse_model(const CameraArguments& arguments, const std::string& scene);

}  // namespace zstrip::sim
