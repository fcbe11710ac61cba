// `zstrip plan`: shows the memory of a picture by purpose, and the time with more or less memory.
#include "cli/plan_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "bake/flash_bytes.hpp"
#include "bake/stage_skins.hpp"
#include "cli/camera_arguments.hpp"
#include "cli/parse.hpp"
#include "cli/plan_arguments.hpp"
#include "cli/print.hpp"
#include "plan/alternatives.hpp"
#include "render/edged_stage.hpp"
#include "render/levelled_stage.hpp"
#include "render/stage.hpp"
#include "report/plan_report.hpp"
#include "text/step_report.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"
#include "visibility/prepared_scene.hpp"
#include "zstrip/frame/pipeline.hpp"

namespace zstrip::sim {
namespace {

constexpr const char* kChosen = "auto";
constexpr std::uint32_t kFramesOfTurn = 8;  // enough to show all sides of a rotating scene

struct PlanCommandLine {
  std::string scene;
  PlanArguments plan;
  std::optional<std::string> depth_format;  // kChosen: the planner chooses
  std::optional<double> separation;
  CameraArguments camera;
  bool static_layer = false;
  bool json = false;
};

Result<PlanRequest> parse(const PlanCommandLine& arguments) {
  Result<PlanRequest> request = parse_plan(arguments.plan, arguments.scene);
  if (!request) return request.failure();
  if (arguments.depth_format == kChosen) {
    request->depth_format = DepthFormat::z16;  // until distances are known
  } else if (arguments.depth_format) {
    const Result<DepthFormat> depth_format = parse_depth_format(*arguments.depth_format);
    if (!depth_format) return depth_format.failure();
    request->depth_format = *depth_format;
  }
  const bool wide = depth_bytes(request->depth_format) > sizeof(std::uint16_t);
  if (arguments.static_layer && (wide || request->view.format != PixelFormat::rgb565)) {
    return Failure{ExitStatus::usage, "a static layer keeps depth of 16 bits and pixels of --format rgb565"};
  }
  if (arguments.static_layer && request->view.samples != 1) {
    return Failure{ExitStatus::usage, "a static layer keeps pixels of one sample; use --samples 1"};
  }
  if (arguments.static_layer && request->method != Effects{}) {
    return Failure{ExitStatus::usage,
                   fmt::format("--static-layer keeps the z-buffer of the plain method, not of --visibility {}",
                               visibility_name(request->method))};
  }
  const Result<Done> checked =
      check_visibility(request->method | depth_effect(request->depth_format) | edge_effects(request->edges),
                       depth_option(arguments.depth_format));
  if (!checked) return checked.failure();
  if (arguments.separation && !(std::isfinite(*arguments.separation) && *arguments.separation > 0)) {
    return Failure{ExitStatus::usage, "--separation is a length greater than 0"};
  }
  return request;
}

/// Returns the effects of the scene with everything that is requested.
Result<Effects> all_effects(Stage& stage, const PlanRequest& request) {
  const Result<Staging> staging = stage.place(0, 1);
  if (!staging) return staging.failure();
  return effects_of(staging->scene, staging->camera) | request.method | depth_effect(request.depth_format);
}

Result<Done> run_plan(const PlanCommandLine& arguments) {
  Result<PlanRequest> request = parse(arguments);
  if (!request) return request.failure();
  const Result<ModelOptions> model = parse_model(arguments.camera, arguments.scene, request->view.format);
  if (!model) return model.failure();
  const Result<CameraOptions> camera = parse_camera(arguments.camera, arguments.scene);
  if (!camera) return camera.failure();
  std::optional<StepReport> steps(std::in_place, true);
  Result<std::unique_ptr<Stage>> stage = open_stage(arguments.scene, *model, *camera, request->view, 1);
  if (stage && arguments.camera.reduction.lod) stage = with_levels(std::move(*stage), request->view);
  if (stage) stage = with_edges(std::move(*stage), request->edges, request->view);
  steps.reset();
  if (!stage) return stage.failure();
  const Result<Effects> effects = all_effects(**stage, *request);
  if (!effects) return effects.failure();
  const DepthFormat kept_format =
      depth_bytes(request->depth_format) == sizeof(std::uint16_t) ? request->depth_format : DepthFormat::z16;
  // Before anything is printed: the command without it is replaced by zstrip-any.
  pipeline_for(without(Effects{effects->bits}, effect::depth_formats | effect::depth_ranges) |
               depth_effect(kept_format));
  for (const std::string& warning : (*stage)->warnings()) print_warning(warning);
  const Result<Done> checked = check_visibility(*effects, depth_option(arguments.depth_format));
  if (!checked) return checked.failure();
  const bool edged = effects->has(effect::edges);
  if (arguments.static_layer && edged) {
    return Failure{ExitStatus::usage, "a static layer keeps pixels as they were drawn; use --no-edges"};
  }
  const Result<KeptFrames> kept =
      keep_frames(**stage, request->view, kept_format, kFramesOfTurn, arguments.static_layer);
  if (!kept) return kept.failure();
  if (arguments.static_layer && !kept->possible) {
    return Failure{
        ExitStatus::usage,
        "a static layer keeps the z-buffer, which shadows use up; leave out --static-layer, or the key shadow "
        "of the light"};
  }
  if (arguments.static_layer) request->budget.layer = kept->layer();
  // After keep_frames, which rotated the stage: a placed frame is valid only until the next one is placed.
  const Result<Staging> staging = (*stage)->place(0, 1);
  if (!staging) return staging.failure();
  const Result<PreparedScene> prepared = PreparedScene::of(*staging, request->method);
  if (!prepared) return prepared.failure();
  std::optional<DepthAdvice> advice;
  if (kept->nearest > 0 && !request->method.has(method::painter)) {
    advice = advise_depth(*kept, staging->camera, request->view, arguments.separation);
    // Only z16 can blend edges.
    if (arguments.depth_format == kChosen && !edged) request->depth = advice->need(*kept);
  }
  *request = with_enough_ram(prepared->staging(), *request);
  Result<PlanChoice> choice = choose_plan(prepared->staging(), *request);
  if (!choice) return choice.failure();
  choice->kept = *kept;
  choice->flash_bytes = scene_flash(**stage, prepared->staging());
  if (!staging->levels.empty()) choice->level_bytes = staging->scene.instances.size_bytes();
  const SceneBlob* const blob = (*stage)->blob();
  choice->moved_bytes = (blob == nullptr ? skin_ram(skins_of(**stage))
                                         : skin_ram(blob->moved.skinnings, blob->moved.pose.size(), blob->morphs.meshes,
                                                    blob->morphs.weights.size()))
                            .total();
  choice->depth = advice;
  write_text(stdout, arguments.json ? plan_json(arguments.scene, *request, *choice)
                                    : plan_table(arguments.scene, *request, *choice));  // main checks the stream
  return Done{};
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("plan", "Show how much memory a picture takes, for what, and the alternatives");
  const auto arguments = std::make_shared<PlanCommandLine>();
  PlanCommandLine& a = *arguments;
  command->add_option("scene", a.scene, "A built-in scene, a model, a scene file (.toml) or a baked scene (.zsc)")
      ->required()
      ->type_name("SCENE");
  add_plan_options(*command, a.plan);
  add_camera_options(*command, a.camera);
  add_reduction_options(*command, a.camera.reduction);
  command
      ->add_option("--depth-format", a.depth_format,
                   "Depth in the z-buffer: z16 (default), float, z24, or auto: the cheapest that sorts and fits")
      ->type_name("FORMAT");
  command
      ->add_option("--separation", a.separation,
                   "The smallest distance between surfaces that must sort, in world units (default: a pixel)")
      ->type_name("LENGTH");
  command->add_flag("--static-layer", a.static_layer, "Keep the picture as a static layer; --ram includes it");
  command->add_flag("--json", a.json, "JSON instead of a table");
  command->footer(
      "Examples:\n"
      "  zstrip plan teapot --size 240x240\n"
      "  zstrip plan model.glb --size 320x240 --ram 16K --split-columns\n"
      "  zstrip plan model.glb --size 240x240 --camera Camera\n"
      "  zstrip plan model.glb --size 240x240 --board bluepill\n"
      "  zstrip plan knot_meshlets --ram 48K --strip-buffers 2 --json\n"
      "  zstrip plan room --ram 8K --depth-format auto --separation 0.0001\n"
      "  zstrip plan random50 --visibility painter --size 128x64\n"
      "  zstrip plan teapot --size 240x240 --ram 64K --samples 4\n"
      "  zstrip plan room --size 128x64 --ram 32K --static-layer --separation 0.01");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run_plan(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
