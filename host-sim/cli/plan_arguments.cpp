// The options for the picture and its memory.
#include "cli/plan_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/board_arguments.hpp"
#include "cli/one_of.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {

void add_plan_options(CLI::App& command, PlanArguments& arguments, const std::string& board_help) {
  PlanArguments& a = arguments;
  command
      .add_option("--size", a.view.size,
                  "Size of the picture, each side 1 to 4096 (default: 320x240, or what the scene was baked for)")
      ->transform(lower_case())
      ->type_name("WxH");
  add_quality_options(command, a.view);
  command.add_option("--ram", a.memory.ram, kRamHelp)->type_name("BYTES");
  add_board_option(command, a.memory.board, board_help);
  command
      .add_option("--strip-buffers", a.strip_buffers,
                  "Strip buffers: 2 if DMA sends one while the other is drawn (default: 1, or 2 if --board has DMA)")
      ->option_text("N")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{2}));
  command.add_option("--strip-rows", a.memory.strip_rows, "Rows of a strip (default: auto, the fastest number)")
      ->transform(lower_case())
      ->type_name("N|auto");
  command
      .add_option("--strip-columns", a.memory.strip_columns, "Pixels of a strip's row, a multiple of 8 (default: auto)")
      ->transform(lower_case())
      ->type_name("N|auto");
  command.add_flag("--split-columns", a.split_columns, "The display takes rectangles narrower than the picture");
  command
      .add_option("--mode", a.mode,
                  "Transform geometry for each strip (streamed), once (binned), or as is faster (any)")
      ->transform(one_of({"any", "streamed", "binned"}))
      ->capture_default_str();
  command
      .add_option("--visibility", a.visibility,
                  fmt::format("The visibility method: {} (default: zbuffer)", visibility_names()))
      ->transform(lower_case())
      ->type_name("METHOD");
}

Result<PlanRequest> parse_plan(const PlanArguments& arguments, const std::string& scene) {
  PlanRequest request;
  const Result<PictureSettings> settings = settings_of(scene);
  if (!settings) return settings.failure();
  const Result<View> view = parse_view(arguments.view, *settings);
  if (!view) return view.failure();
  request.view = *view;
  request.edges = parse_edges(arguments.view, *settings);
  const Result<RamLimit> ram_limit = parse_memory(arguments.memory, *settings, request.view, request.budget);
  if (!ram_limit) return ram_limit.failure();
  request.ram_limit = *ram_limit;
  request.depth_format = settings->depth_format.value_or(DepthFormat::z16);
  request.perspective = settings->perspective.value_or(Effects{});
  const Result<VisibilityMethod> method =
      parse_visibility(arguments.visibility.value_or(settings->visibility.method.value_or("zbuffer")));
  if (!method) return method.failure();
  request.method = method->effects;
  request.budget.split_columns = arguments.split_columns;
  request.budget.strip_buffers =
      static_cast<std::uint8_t>(arguments.strip_buffers.value_or(usual_strip_buffers(arguments.memory)));
  request.may_bin = arguments.mode != "streamed";
  request.budget.modes = arguments.mode == "binned" ? Modes::binned : Modes::any;
  return request;
}

}  // namespace zstrip::sim
