// `zstrip bake`.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "bake/baked_scene.hpp"
#include "bake/scene_header.hpp"
#include "cli/camera_arguments.hpp"
#include "cli/pico_arguments.hpp"
#include "cli/plan_arguments.hpp"
#include "cli/project_arguments.hpp"
#include "render/stage.hpp"
#include "report/bake_report.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct BakeArguments {
  std::string scene;
  std::string output;
  PlanArguments plan{.mode = "streamed"};
  CameraArguments camera;
  bool turntable = false;
  std::string name_space = kDefaultNamespace;
  std::optional<std::string> visible_sets;
  std::optional<std::string> cells;
  std::string textures = "rgb565";
  std::string mipmaps = "auto";
  std::string clipping = "auto";
  std::string lighting = "drawn";
  PicoArguments pico;
  ProjectArguments project;
  std::optional<std::string> json;
  bool quiet = false;
};

/// A bake that writes no file and prints no warning.
struct BakeTrial {
  std::unique_ptr<Stage>* stage;  ///< if null, becomes the scene that the arguments read; else used instead of it
  std::function<Result<Done>(const BakedScene& scene, const BakeRecord& record)> see;
};

/// Reads the scene, plans and writes it. With a trial the failures are the same, except those of writing.
Result<Done> bake(const BakeArguments& arguments, const BakeTrial* trial = nullptr);

/// Adds the subcommand; when it runs, it stores the exit status.
void add_bake_command(CLI::App& app, int& exit_code);

}  // namespace zstrip::sim
