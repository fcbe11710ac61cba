// The options that say how a scene is looked at: camera, background and a model's upward axis, shared by the commands
// that accept them.
#pragma once

#include <optional>
#include <string>

#include "cli/reduction_arguments.hpp"
#include "import/source_model.hpp"
#include "render/camera.hpp"
#include "render/stage.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct CameraArguments {
  std::optional<std::string> up;
  std::optional<std::string> animation;
  bool highlights = false;
  bool plain_materials = false;
  std::optional<std::string> camera;
  std::optional<std::string> eye;
  std::optional<std::string> look_at;
  std::optional<std::string> orbit;
  std::optional<double> field_of_view;
  bool orthographic = false;
  std::optional<std::string> background;
  std::optional<std::string> light;
  ReductionArguments reduction;  ///< its options are add_reduction_options'
};

/// Adds the options; `arguments` must live as long as the command.
void add_camera_options(CLI::App& command, CameraArguments& arguments);

/// `scene`: --camera is a usage error unless it is a model file.
Result<CameraOptions> parse_camera(const CameraArguments& arguments, const std::string& scene);

/// Parses --up, --animation, --highlights, --plain-materials, --background, --light and the reduction. They are usage
/// errors unless the scene is a model file: other scenes have their own settings. `format`: of the picture.
Result<ModelOptions> parse_model(const CameraArguments& arguments, const std::string& scene, PixelFormat format);

}  // namespace zstrip::sim
