// The options for pictures of a scene, shared by the commands that draw them.
#include "cli/drawing_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "render/picture_display.hpp"
#include "visibility/methods.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace zstrip::sim {
namespace {

/// Returns a view that fills the panel.
View panel_view(const PanelRequest& panel) {
  const bool sideways = is_sideways(panel.orientation);
  const PanelModule& module = panel.module;
  return {sideways ? module.height : module.width, sideways ? module.width : module.height, core_format(panel.format)};
}

/// Some panels accept only whole groups of rows, others only whole rows.
Result<Done> check_strips_of_panel(const Drawing& drawing) {
  const std::uint16_t step = row_step(*drawing.panel);
  if (drawing.panel->bus == BusKind::rgb && (drawing.budget.strip_columns != 0 || drawing.budget.split_columns)) {
    return usage(fmt::format("--{}: a {} is read row by row, and takes strips of its width",
                             drawing.budget.split_columns ? "split-columns" : "strip-columns",
                             drawing.panel->kind->name));
  }
  if (drawing.budget.strip_rows % step != 0) {
    return usage(fmt::format("--strip-rows {}: a {} takes multiples of {} rows", drawing.budget.strip_rows,
                             drawing.panel->kind->name, step));
  }
  return Done{};
}

/// Pictures of depth, overdraw, tiles and errors have plain pixels, for any settings of a scene file's own picture.
Result<Done> prepare_show(Drawing& drawing, const ViewArguments& given) {
  if (drawing.visibility.show == Show::colour) return Done{};
  if (drawing.panel) return usage("--show and --panel exclude each other: a panel shows colours");
  if (shows_the_picture(drawing.visibility.show)) return Done{};
  const View plain{drawing.view.width, drawing.view.height};
  if (given.format && drawing.view.format != plain.format) {
    return usage("--show makes RGB565 pictures; leave out --format");
  }
  if (given.samples && drawing.view.samples != plain.samples) {
    return usage("--show shows pixels of one sample; use --samples 1");
  }
  if (given.edges.value_or(false)) return usage("--show shows pixels as they were drawn; leave out --edges");
  drawing.view = plain;
  return Done{};
}

}  // namespace

void add_drawing_options(CLI::App& command, DrawingArguments& arguments) {
  DrawingArguments& a = arguments;
  command
      .add_option("scene", a.scene,
                  "A built-in scene, a model (.obj .gltf .glb .stl .ply .3ds .dae ...), a scene file (.toml) or a "
                  "baked scene (.zsc)")
      ->required()
      ->type_name("SCENE");
  command
      .add_option(
          "--size", a.view.size,
          "Size of the picture, each side 1 to 4096 (default: 320x240, the panel's, or what the scene was baked for)")
      ->transform(lower_case())
      ->type_name("WxH");
  command.add_option("--ram", a.memory.ram, kRamHelp)->type_name("BYTES");
  command.add_option("--strip-rows", a.memory.strip_rows, "Rows of a strip (default: auto, as many as fit)")
      ->transform(lower_case())
      ->type_name("N|auto");
  command
      .add_option("--strip-columns", a.memory.strip_columns,
                  "Pixels of a strip's row, a multiple of 8 (default: auto, the picture's width)")
      ->transform(lower_case())
      ->type_name("N|auto");
  add_quality_options(command, a.view);
  command.add_option("--depth-format", a.depth_format, "Depth in the z-buffer: z16 (default), float or z24")
      ->transform(lower_case())
      ->type_name("FORMAT");
  command
      .add_option("--perspective", a.perspective,
                  "Textures are exact at every pixel (1), every 8th or 16th of a row (16 is the default), or only at a "
                  "triangle's corners (affine)")
      ->transform(lower_case())
      ->type_name("RUN");
  add_panel_options(command, a.panel);
  add_camera_options(command, a.camera);
  add_reduction_options(command, a.camera.reduction);
  add_visibility_options(command, a.visibility);
}

Result<Drawing> parse_drawing(const DrawingArguments& arguments, const PictureSettings& settings) {
  Drawing drawing;
  const auto panel = parse_panel(arguments.panel, arguments.view.size, arguments.view.format);
  if (!panel) return panel.failure();
  drawing.panel = *panel;
  const Result<View> view = drawing.panel ? parse_quality(arguments.view, settings, panel_view(*drawing.panel))
                                          : parse_view(arguments.view, settings);
  if (!view) return view.failure();
  drawing.view = *view;
  drawing.edges = parse_edges(arguments.view, settings);
  drawing.lod = arguments.camera.reduction.lod;
  const Result<DepthFormat> depth_format = parse_depth_format(arguments.depth_format, settings);
  if (!depth_format) return depth_format.failure();
  drawing.depth_format = *depth_format;
  drawing.depth_given = depth_option(arguments.depth_format);
  if (arguments.camera.orthographic && !effects_agree(depth_effect(*depth_format) | effect::orthographic)) {
    return usage("--depth-format float needs a perspective camera, not --ortho");
  }
  if (arguments.perspective) {
    const Result<Effects> perspective = parse_perspective(*arguments.perspective);
    if (!perspective) return perspective.failure();
    drawing.perspective = *perspective;
  } else {
    drawing.perspective = settings.perspective.value_or(Effects{});
  }
  const Result<RamLimit> ram_limit = parse_memory(arguments.memory, settings, drawing.view, drawing.budget);
  if (!ram_limit) return ram_limit.failure();
  drawing.ram_limit = *ram_limit;
  drawing.budget.strip_buffers = drawing.panel ? 2 : usual_strip_buffers(arguments.memory);
  if (drawing.panel) {
    if (const Result<Done> fitted = check_strips_of_panel(drawing); !fitted) return fitted.failure();
  }
  const Result<VisibilityRequest> visibility = parse_visibility(arguments.visibility, settings.visibility);
  if (!visibility) return visibility.failure();
  drawing.visibility = *visibility;
  const Result<Done> checked = check_visibility(drawing.effects() | drawing.visibility.method, drawing.depth_given);
  if (!checked) return checked.failure();
  if (const Result<Done> shown = prepare_show(drawing, arguments.view); !shown) return shown.failure();
  const Result<ModelOptions> model = parse_model(arguments.camera, arguments.scene, drawing.view.format);
  if (!model) return model.failure();
  drawing.model = *model;
  const Result<CameraOptions> camera = parse_camera(arguments.camera, arguments.scene);
  if (!camera) return camera.failure();
  drawing.camera = *camera;
  return drawing;
}

}  // namespace zstrip::sim
