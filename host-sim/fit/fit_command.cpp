// Options of `zstrip fit`.
#include "fit/fit_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "cli/bake_kind.hpp"
#include "cli/board_arguments.hpp"
#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "cli/picture_arguments.hpp"
#include "cli/print.hpp"
#include "cli/sibling_program.hpp"
#include "fit/fit_report.hpp"
#include "image/inputs.hpp"
#include "image/write_file.hpp"
#include "import/reduction.hpp"
#include "text/progress.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

struct Arguments {
  std::string scene, board;
  ViewArguments view{.size = "240x240", .format = "rgb565_swapped"};
  CameraArguments camera;
  std::optional<std::string> flash, ram, output, html, json;
  std::optional<double> frames;
  std::optional<std::uint32_t> choose;
  bool quiet = false;
};

Result<FitLimits> parse_limits(const Arguments& arguments, const BoardModel& board) {
  FitLimits limits{.flash = {}, .ram = board.ram_bytes - kReservedRam, .frames = arguments.frames};
  if (limits.frames && !(std::isfinite(*limits.frames) && *limits.frames > 0)) {
    return usage("--fps must be more than 0");
  }
  if (arguments.flash) {
    const Result<std::uint32_t> bytes = parse_bytes(*arguments.flash, "--flash");
    if (!bytes) return bytes.failure();
    limits.flash = *bytes;
  } else if (board.flash_bytes > 0) {
    limits.flash = board.flash_bytes - reserved_flash(board);
  }
  if (arguments.ram) {
    const Result<std::uint32_t> bytes = parse_bytes(*arguments.ram);
    if (!bytes) return bytes.failure();
    if (*bytes > limits.ram) {
      return usage(fmt::format("--ram {}: {} has {} for arena and pixels", *arguments.ram, board.name, limits.ram));
    }
    limits.ram = *bytes;
  }
  return limits;
}

/// Returns the bake of the whole model.
BakeArguments whole_bake(const Arguments& arguments, const BoardModel& board, const FitLimits& limits) {
  BakeArguments whole;
  whole.scene = arguments.scene;
  whole.output = arguments.output.value_or("scene.zsc");
  whole.plan.view = arguments.view;
  whole.plan.memory.ram = std::to_string(limits.ram);
  whole.plan.strip_buffers = board.dma ? 2 : 1;
  whole.camera = arguments.camera;
  whole.quiet = true;
  return whole;
}

Result<Done> write_text_file(const std::string& path, const std::string& text, const char* option) {
  if (const Result<Done> checked = check_no_input(path, option); !checked) return checked.failure();
  return write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, option);
}

/// Refuses two outputs at one place.
Result<Done> check_outputs(const Arguments& arguments) {
  std::set<std::filesystem::path> places;
  for (const std::optional<std::string>& output : {arguments.output, arguments.html, arguments.json}) {
    if (!output || *output == "-") continue;
    std::error_code ignored;  // absolute: the canonical path of what does not exist stays relative
    const std::filesystem::path place = std::filesystem::absolute(*output, ignored);
    if (!places.insert(std::filesystem::weakly_canonical(place, ignored)).second) {
      return usage(fmt::format("'{}' is the file of two of -o, --html and --json; name another one", *output));
    }
  }
  return Done{};
}

Result<Done> run(const Arguments& arguments) {
  const Result<const BoardModel*> named = parse_board(arguments.board);
  if (!named) return named.failure();
  const BoardModel* const board = *named;
  if (kind_of_scene(arguments.scene) != SceneKind::model) {
    return usage(fmt::format("fit makes model files smaller; '{}' is not a model file", arguments.scene));
  }
  const Result<FitLimits> limits = parse_limits(arguments, *board);
  if (!limits) return limits.failure();
  BakeArguments whole = whole_bake(arguments, *board, *limits);
  const Result<BakeKind> kind = bake_kind(whole.output);
  if (!kind) return kind.failure();
  if (*kind == BakeKind::pico) {
    if (arguments.board != "pico" && arguments.board != "pico2") {
      return usage("-o FILE.uf2 is for --board pico or pico2");
    }
    whole.plan.memory.board = arguments.board;
  }
  if (const Result<Done> distinct = check_outputs(arguments); !distinct) return distinct.failure();
  Result<FitSearch> found = [&] {
    Progress progress(1, !arguments.quiet, "combination");
    return search(whole, *board, *limits, [&](std::uint32_t done, std::uint32_t all) { progress.show(done, all); });
  }();
  if (!found) return found.failure();
  if (found->choices.empty()) {
    const std::string stay =
        found->triangles_stay ? fmt::format("; more than half of the triangles stay: {}", kTrianglesStay) : "";
    return Failure{ExitStatus::budget,
                   fmt::format("none of {} combinations fits: {}{}", found->tried, found->nearest, stay)};
  }
  const std::size_t chosen = arguments.choose.value_or(1) - 1;
  if (chosen >= found->choices.size()) {
    return usage(fmt::format("--choose {}: there are {} choices", chosen + 1, found->choices.size()));
  }
  if (arguments.output) {
    if (const Result<Done> written = bake(found->choices[chosen].arguments); !written) return written.failure();
  }
  if (arguments.html) {
    const Result<std::string> page = fit_page(*found, *board, chosen);
    if (!page) return page.failure();
    if (const Result<Done> written = write_text_file(*arguments.html, *page, "--html"); !written) {
      return written.failure();
    }
  }
  const bool json_on_stdout = arguments.json == "-";
  if (json_on_stdout) write_text(stdout, fit_json(*found, *board, chosen));
  if (arguments.json && !json_on_stdout) {
    const Result<Done> written = write_text_file(*arguments.json, fit_json(*found, *board, chosen), "--json");
    if (!written) return written.failure();
  }
  if (!arguments.quiet) write_text(json_on_stdout ? stderr : stdout, fit_table(*found, *board, chosen));
  return Done{};
}

}  // namespace

void add_fit_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(kFitCommand.name, kFitCommand.description);
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("model", a.scene, "A model (.obj .gltf .glb .stl .ply .3ds .dae ...)")
      ->required()
      ->type_name("MODEL");
  command
      ->add_option("--board", a.board, fmt::format("The board that it is for: {}", fmt::join(names_of_boards(), ", ")))
      ->required()
      ->type_name("NAME");
  command->add_option("--size", a.view.size, "Size of the picture (default: 240x240)")
      ->transform(lower_case())
      ->type_name("WxH");
  add_quality_options(*command, a.view);
  command->get_option("--format")
      ->description("Pixels of the display: rgb565_swapped (default), rgb565, gray4, mono, rgb666, rgb444, xrgb8888");
  for (const char* option : {"--samples", "--edges"}) {
    CLI::Option* const added = command->get_option(option);
    added->description(added->get_description() + "; pictures without it are tried, too");
  }
  command
      ->add_option(
          "--flash", a.flash,
          "Limit for the scene's flash without code, in bytes, K and M allowed (default: the board's less 64K for "
          "code, or less half of it if that is smaller; no limit if the flash is a separate chip)")
      ->type_name("BYTES");
  command
      ->add_option("--ram", a.ram,
                   "Limit for arena, strip buffers and skins in bytes (default: the board's, less 4,096)")
      ->type_name("BYTES");
  command->add_option("--fps", a.frames, "The fewest frames a second, by the lower end of the estimate (default: any)")
      ->type_name("N");
  add_camera_options(*command, a.camera);
  command->add_option("--choose", a.choose, "The choice to write, by its number (default: 1, the best looking)")
      ->type_name("N")
      ->check(CLI::Range(1U, 1000U));
  command
      ->add_option(
          "-o,--output", a.output,
          "The file to write, as zstrip bake does; its flash is counted: .zsc (default, not written), .uf2, .hpp, "
          ".ino, .cpp")
      ->type_name("FILE");
  command->add_option("--html", a.html, "Write the choices with their pictures as a page")->type_name("FILE");
  command->add_option("--json", a.json, "Write the choices as JSON; - is standard output")->type_name("FILE|-");
  command->add_flag("--quiet", a.quiet, "No table and no progress");
  command->footer(
      "Exit status 5 if nothing fits; the message names the nearest combination, and the limit that it "
      "breaks.\nExamples:\n"
      "  zstrip fit truck.glb --board pico --flash 1M --html sheet.html\n"
      "  zstrip fit truck.glb --board bluepill --size 160x128 --samples 4\n"
      "  zstrip fit truck.glb --board pico --flash 512K --fps 20 --choose 3 -o truck.zsc\n"
      "  zstrip fit truck.glb --board pico -o truck.uf2");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
