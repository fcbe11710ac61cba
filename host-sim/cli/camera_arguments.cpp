// The options that say how a scene is looked at: camera, background and a model's upward axis.
#include "cli/camera_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>

#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {
void add_camera_options(CLI::App& command, CameraArguments& arguments) {
  CameraArguments& a = arguments;
  command
      .add_option("--up", a.up, "A model's axis that points upwards: x, -x, y, -y, z, -z (default: as its format says)")
      ->transform(lower_case())
      ->type_name("AXIS");
  command
      .add_option(
          "--animation", a.animation,
          "An animation of a glTF 2.0 file or a baked scene, by its name (default: the first; a blob keeps all)")
      ->type_name("NAME");
  command.add_flag("--highlights", a.highlights,
                   "Highlights of a glTF 2.0 file's materials, by their roughness and metal (default: none)");
  command.add_flag(
      "--plain-materials", a.plain_materials,
      "Draws smooth metals matt, which takes less flash and time, and leaves out normal and occlusion maps (default: "
      "metals mirror a studio, maps are painted into textures)");
  command.add_option("--camera", a.camera, "A camera of a glTF 2.0 file, by its name")->type_name("NAME");
  command.add_option("--eye", a.eye, "Place of the camera, in the model's units")->type_name("X,Y,Z");
  command.add_option("--look-at", a.look_at, "The point that the camera looks at (default: the model's centre)")
      ->type_name("X,Y,Z");
  command
      .add_option("--orbit", a.orbit,
                  "Camera on a sphere around that point: radius, degrees from the front, from above")
      ->type_name("R,PHI,THETA");
  command
      .add_option("--fov", a.field_of_view,
                  "Vertical field of view, 1 to 170 (default: 30, or a built-in or baked scene's own)")
      ->type_name("DEGREES");
  command.add_flag("--ortho", a.orthographic, "Parallel instead of perspective projection");
  command
      .add_option("--background", a.background, "Colour behind a model (default: ced3d6, a light grey; mono: 000000)")
      ->type_name("RRGGBB");
  command
      .add_option("--light", a.light,
                  "Where the light of a model without lights comes from (default: 0.1,0.8,0.6, above the viewer)")
      ->type_name("X,Y,Z");
}

Result<CameraOptions> parse_camera(const CameraArguments& arguments, const std::string& scene) {
  CameraOptions camera;
  const auto vector = [](const char* option, const std::optional<std::string>& text,
                         std::optional<std::array<double, 3>>& to) -> Result<Done> {
    if (!text) return Done{};
    const Result<std::array<double, 3>> parsed = parse_vector(option, *text);
    if (!parsed) return parsed.failure();
    to = *parsed;
    return Done{};
  };
  std::optional<std::array<double, 3>> orbit;
  for (const Result<Done>& parsed :
       {vector("--eye", arguments.eye, camera.eye), vector("--look-at", arguments.look_at, camera.look_at),
        vector("--orbit", arguments.orbit, orbit)}) {
    if (!parsed) return parsed.failure();
  }
  if (orbit) camera.orbit = Orbit{(*orbit)[0], (*orbit)[1], (*orbit)[2]};
  if (camera.orbit && !(camera.orbit->radius > 0)) return usage("--orbit: the radius must be greater than 0");
  if (camera.eye && camera.orbit) return usage("--eye and --orbit both place the camera; give one of them");
  if (camera.look_at && !camera.placed()) return usage("--look-at needs --eye or --orbit");
  camera.field_of_view = arguments.field_of_view;
  if (camera.field_of_view && !(*camera.field_of_view >= 1 && *camera.field_of_view <= 170)) {
    return usage("--fov must be 1 to 170 degrees");
  }
  camera.orthographic = arguments.orthographic;
  camera.name = arguments.camera;
  if (camera.name && (camera.placed() || camera.field_of_view || camera.orthographic)) {
    return usage("--camera says all about the camera; leave --eye, --orbit, --fov and --ortho out");
  }
  if (camera.name && kind_of_scene(scene) != SceneKind::model) {
    return usage(fmt::format("--camera is for model files; '{}' is not one", scene));
  }
  return camera;
}

Result<ModelOptions> parse_model(const CameraArguments& arguments, const std::string& scene, PixelFormat format) {
  const Result<std::optional<UpAxis>> up = parse_up_axis(arguments.up);
  if (!up) return up.failure();
  ModelOptions options{.up = *up,
                       .animation = arguments.animation,
                       .highlights = arguments.highlights ? Highlights::of_materials : Highlights::none,
                       .style = arguments.plain_materials ? MaterialStyle::plain : MaterialStyle::rich,
                       .look = look_for_people(format)};
  if (arguments.background) {
    const Result<Colour> background = parse_colour("--background", *arguments.background);
    if (!background) return background.failure();
    options.look.background = *background;
  }
  if (arguments.light) {
    const Result<std::array<double, 3>> towards = parse_vector("--light", *arguments.light);
    if (!towards) return towards.failure();
    const auto [x, y, z] = *towards;
    const double length = std::hypot(x, y, z);
    if (!(length > 0)) return usage("--light: the direction must not be 0,0,0");
    const auto q15 = [length](double value) { return static_cast<std::int16_t>(std::lround(value / length * 32767)); };
    options.look.light = {q15(x), q15(y), q15(z), options.look.light.colour};
  }
  const Result<Reduction> reduction = parse_reduction(arguments.reduction, scene);
  if (!reduction) return reduction.failure();
  options.reduction = *reduction;
  const char* const option = arguments.up                ? "--up"
                             : arguments.animation       ? "--animation"
                             : arguments.highlights      ? "--highlights"
                             : arguments.plain_materials ? "--plain-materials"
                             : arguments.background      ? "--background"
                             : arguments.light           ? "--light"
                                                         : nullptr;
  if (kind_of_scene(scene) == SceneKind::model || option == nullptr) return options;
  if (kind_of_scene(scene) == SceneKind::baked && option == std::string_view("--animation")) return options;
  switch (kind_of_scene(scene)) {
    case SceneKind::built_in:
      return usage(fmt::format("{} is for model files; '{}' is a built-in scene", option, scene));
    case SceneKind::baked: return usage(fmt::format("{} is for model files; '{}' is a baked scene", option, scene));
    case SceneKind::composed:
      return usage(fmt::format("{} is for model files; '{}' says it itself, in {}", option, scene,
                               arguments.up || arguments.animation                 ? "[[model]]"
                               : arguments.highlights || arguments.plain_materials ? "[[material]]"
                               : arguments.light                                   ? "[[light]]"
                                                                                   : "the key background"));
    case SceneKind::model: break;
  }
  return options;
}

}  // namespace zstrip::sim
