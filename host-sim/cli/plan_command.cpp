// `zstrip plan`: how much memory a picture takes, for what, and what more or less of it would cost in time.
#include "cli/plan_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/plan_arguments.hpp"
#include "cli/print.hpp"
#include "plan/alternatives.hpp"
#include "render/stage.hpp"
#include "report/plan_report.hpp"
#include "report/text.hpp"

namespace zstrip::sim {
namespace {

struct Arguments {
  std::string scene;
  PlanArguments plan;
  bool json = false;
};

Result<Done> run(const Arguments& arguments) {
  const Result<PlanRequest> request = parse_plan(arguments.plan);
  if (!request) return request.failure();
  const Result<std::unique_ptr<Stage>> stage = open_stage(arguments.scene, UpAxis::plus_y, {}, request->view, 1);
  if (!stage) return stage.failure();
  for (const std::string& warning : (*stage)->warnings()) print_warning(warning);
  const Result<Staging> staging = (*stage)->place(0, 1);
  if (!staging) return staging.failure();
  const Result<PlanChoice> choice = choose_plan(*staging, *request);
  if (!choice) return choice.failure();
  write_text(stdout, arguments.json ? plan_json(arguments.scene, *request, *choice)
                                    : plan_table(arguments.scene, *request, *choice));  // main looks at the stream
  return Done{};
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("plan", "Show how much memory a picture takes, for what, and the alternatives");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("scene", a.scene, "A built-in scene, a model file or a baked scene (.zsc)")
      ->required()
      ->type_name("SCENE");
  add_plan_options(*command, a.plan);
  command->add_flag("--json", a.json, "JSON instead of a table");
  command->footer(
      "Examples:\n"
      "  zstrip plan teapot --size 240x240\n"
      "  zstrip plan model.glb --size 320x240 --ram 16K --split-columns\n"
      "  zstrip plan knot_meshlets --ram 48K --strip-buffers 2 --json");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
