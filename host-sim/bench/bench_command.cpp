// The order of work of `zstrip bench`: cases, measurements, comparison, report.
#include "bench/bench_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/bench_options.hpp"
#include "bench/bench_report.hpp"
#include "bench/board_bench.hpp"
#include "bench/board_prediction.hpp"
#include "bench/board_visibility.hpp"
#include "bench/dynamic_z_table.hpp"
#include "bench/host_bench.hpp"
#include "bench/peer_bench.hpp"
#include "bench/scene_case.hpp"
#include "bench/stage_profile.hpp"
#include "bench/visibility_table.hpp"
#include "bench/workloads.hpp"
#include "cli/parse.hpp"
#include "cli/print.hpp"
#include "cli/sibling_program.hpp"
#include "image/write_file.hpp"
#include "result.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Targets with a program that draws a scene from a file.
constexpr std::string_view kTargetsOfModels[] = {"m0", "m3", "m4f", "m7"};

bool draws_models(std::string_view target) {
  return target == "host" || std::ranges::find(kTargetsOfModels, target) != std::end(kTargetsOfModels);
}

/// Returns the reason why a target does not draw a workload; the target is that of the board of this name unless it is
/// empty.
std::string no_model_on(std::string_view workload, const std::string& target, std::string_view board) {
  if (board.empty())
    return fmt::format("{} is for --target host, m0, m3, m4f and m7; {} has no program for it", workload, target);
  std::string boards;
  for (const BoardModel& other : boards_with_core_model()) {
    if (!draws_models(other.target)) continue;
    if (!boards.empty()) boards += ", ";
    boards += other.name;
  }
  return fmt::format("{} is for --board {}; {} has no program for it", workload, boards, board);
}

/// `board`: a board with the target `target`; empty: the user named the target.
Result<std::vector<BenchCase>> cases_for(const BenchOptions& options, const std::string& target,
                                         std::string_view board = {}) {
  Budget budget;
  if (!options.ram.empty()) {
    const Result<std::uint32_t> bytes = parse_bytes(options.ram);
    if (!bytes) return bytes.failure();
    budget.bytes = *bytes;
  }
  if (!options.strip_rows.empty()) {
    const Result<std::uint16_t> rows = parse_strip_rows(options.strip_rows);
    if (!rows) return rows.failure();
    budget.strip_rows = *rows;
  }
  if (!options.strip_columns.empty()) {
    const Result<std::uint16_t> columns = parse_strip_columns(options.strip_columns);
    if (!columns) return columns.failure();
    budget.strip_columns = *columns;
  }
  budget.modes = options.mode == "binned" ? Modes::binned : Modes::streamed;
  if (target == "rv32" && (budget.modes == Modes::binned || options.depth != "z16")) {
    return Failure{ExitStatus::usage, "rv32 has no program but for --mode streamed and --depth z16"};
  }
  if (options.depth != "z16") {
    const bool known =
        options.workloads == std::vector<std::string>{"R50"} && target != "host" && options.mode == "streamed";
    if (!known)
      return Failure{ExitStatus::usage,
                     "--depth is for R50 on boards, streamed: the boards' programs have nothing else"};
  }
  std::vector<BenchCase> cases;
  for (const std::string& name : options.workloads) {
    const Workload* workload = find_workload(name);
    if (workload->is_model() && target != "host" && options.mode == "binned") {
      return Failure{ExitStatus::usage, fmt::format("{} is drawn streamed on boards; leave out --mode binned", name)};
    }
    if (workload->is_model() && !draws_models(target)) {
      return Failure{ExitStatus::usage, no_model_on(name, target, board)};
    }
    if (workload->is_model() && options.peers) {
      return Failure{ExitStatus::usage,
                     fmt::format("{} cannot be drawn by the other renderers; leave out --peers", name)};
    }
    if (workload->built_in() == nullptr) {
      return Failure{ExitStatus::environment,
                     fmt::format("{} needs {}, which cannot be read (Debian: glmark2-data)", name, workload->scene)};
    }
    View view{workload->width, workload->height, PixelFormat::rgb565};
    if (!options.size.empty()) {
      const auto size = parse_size(options.size);
      if (!size) return size.failure();
      view.width = size->first;
      view.height = size->second;
    }
    cases.push_back({.workload = name,
                     .target = target,
                     .view = view,
                     .budget = budget,
                     .depth = options.depth,
                     .frames = options.frames});
  }
  return cases;
}

// Every target must draw the same pixels for the same workload; rows of one workload have the same size and frames.
Result<Done> compare_pictures(std::span<const Measurement> rows) {
  for (const Measurement& row : rows) {
    const auto first = std::ranges::find(rows, row.bench_case.workload,
                                         [](const Measurement& other) { return other.bench_case.workload; });
    const auto [here, there] = std::ranges::mismatch(row.frame_crc32, first->frame_crc32);
    if (here != row.frame_crc32.end() || there != first->frame_crc32.end()) {
      return Failure{ExitStatus::internal,
                     fmt::format("{} and {} draw frame {} of {} differently", first->bench_case.target,
                                 row.bench_case.target, here - row.frame_crc32.begin(), row.bench_case.workload)};
    }
  }
  return Done{};
}

Result<Done> report(const BenchOptions& options, const std::string& table, const std::string& json) {
  const bool json_on_stdout = options.json == "-";
  // main reports failures of standard output.
  if (!write_text(json_on_stdout ? stderr : stdout, table) && json_on_stdout) {
    return Failure{ExitStatus::output, "cannot write the table to standard error; is it closed, or the disk full?"};
  }
  if (options.json.empty()) return Done{};
  if (!json_on_stdout) {
    return write_file(options.json, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()}, "--json");
  }
  write_text(stdout, json);
  return Done{};
}

Result<Done> run_dynamic_z(const BenchOptions& options) {
  std::vector<DynamicZPicture> pictures;
  for (const DynamicZPicture& picture : dynamic_z_pictures()) {
    if (options.pictures.empty() || std::ranges::count(options.pictures, picture.side) != 0) {
      pictures.push_back(picture);
    }
  }
  if (options.draw_each != 0) {
    const auto* memory = std::ranges::find(kDepthMemories, options.depth_memory, [](DepthMemory m) { return name(m); });
    if (memory == std::end(kDepthMemories)) return Failure{ExitStatus::usage, "--draw-each needs --depth-memory"};
    return draw_dynamic_z_only(pictures.front(), *memory, options.draw_each);
  }
  const Result<std::vector<DynamicZRow>> rows = measure_dynamic_z(pictures);
  if (!rows) return rows.failure();
  if (Result<Done> written = report(options, dynamic_z_text(*rows), dynamic_z_json(*rows)); !written) return written;
  const auto wrong = std::ranges::find_if(
      *rows, [](const DynamicZRow& row) { return !row.right && row.memory != DepthMemory::classic; });
  if (wrong == rows->end()) return Done{};
  return Failure{ExitStatus::internal, fmt::format("the picture of {0}x{0} with memory \"{1}\" has wrong pixels",
                                                   wrong->picture.side, name(wrong->memory))};
}

Result<Done> run_visibility(const BenchOptions& options) {
  if (!options.pictures.empty()) return Failure{ExitStatus::usage, "--picture is for --table dynamic-z"};
  if (options.draw_each != 0) return draw_visibility_row_only(options.table, options.table_row, options.draw_each);
  const Result<std::vector<VisibilityRow>> rows = measure_visibility(options.table);
  if (!rows) return rows.failure();
  return report(options, visibility_text(options.table, *rows), visibility_json(options.table, *rows));
}

Result<Done> run_board_visibility(const BenchOptions& options) {
  if (!options.pictures.empty()) return Failure{ExitStatus::usage, "--picture is for --table dynamic-z"};
  const Result<std::vector<Measurement>> rows = measure_board_visibility(options.firmware);
  if (!rows) return rows.failure();
  return report(options, board_visibility_text(*rows), board_visibility_json(*rows));
}

/// Returns the bake of the scene, with the options that workloads have, too.
Result<BakeArguments> parse_bake(const BenchOptions& options) {
  BakeArguments bake = options.bake;
  const auto given =
      std::ranges::find_if(options.of_bake, [](const CLI::Option* option) { return option->count() > 0; });
  const bool is_baked = kind_of_scene(bake.scene) == SceneKind::baked;
  if (given != options.of_bake.end() && is_baked) {
    return usage(fmt::format("{}: '{}' is baked already", (*given)->get_name(), bake.scene));
  }
  if (is_baked && !options.size.empty()) {
    return usage(fmt::format("--size: '{}' is baked already, for a picture of its own size", bake.scene));
  }
  if (options.depth != "z16") return usage("--depth is for R50; a scene file has a key for it");
  if (!options.size.empty()) bake.plan.view.size = options.size;
  if (!options.ram.empty()) bake.plan.memory.ram = options.ram;
  if (!options.strip_rows.empty()) bake.plan.memory.strip_rows = options.strip_rows;
  if (!options.strip_columns.empty()) bake.plan.memory.strip_columns = options.strip_columns;
  bake.plan.mode = options.mode;
  return bake;
}

Result<std::vector<SceneCase>> scene_cases(const BenchOptions& options) {
  const Result<BakeArguments> bake = parse_bake(options);
  if (!bake) return bake.failure();
  std::vector<SceneCase> cases;
  for (const std::string& name : options.boards) {
    Result<SceneCase> made = scene_case(*bake, *find_board(name), options.cores, options.frames);
    if (!made) return made.failure();
    cases.push_back(std::move(*made));
  }
  return cases;
}

Result<Done> run_predictions(const BenchOptions& options) {
  std::vector<BoardPrediction> predictions;
  std::string text;
  Result<std::vector<SceneCase>> scenes = std::vector<SceneCase>();
  if (!options.bake.scene.empty()) scenes = scene_cases(options);
  if (!scenes) return scenes.failure();
  for (const std::string& name : options.boards) {
    BoardModel board = *find_board(name);
    board.spi_mhz = options.spi_mhz.value_or(board.spi_mhz);
    board.core_mhz = options.core_mhz.value_or(board.core_mhz);
    board.flash.wait_states = options.wait_states.value_or(board.flash.wait_states);
    if (options.cores > board.cores) {
      return Failure{ExitStatus::usage, fmt::format("--cores {}: {} has one", options.cores, name)};
    }
    Result<std::vector<BenchCase>> cases = std::vector<BenchCase>();
    if (scenes->empty()) {
      cases = cases_for(options, std::string(board.target), name);
    } else {
      cases->push_back((*scenes)[static_cast<std::size_t>(&name - options.boards.data())].bench_case);
    }
    if (!cases) return cases.failure();
    for (const BenchCase& bench_case : *cases) {
      Result<BoardPrediction> prediction = predict(board, bench_case, options.cores, options.firmware);
      if (!prediction) return prediction.failure();
      text += prediction_text(*prediction);
      predictions.push_back(std::move(*prediction));
    }
  }
  return report(options, text, prediction_json(predictions));
}

/// Lists the boards' programs that the options run, one name a line; host-sim/run builds them.
Result<Done> list_programs(const BenchOptions& options) {
  std::vector<std::pair<std::string, std::string_view>> places;  // target and board
  for (const std::string& name : options.boards) places.emplace_back(find_board(name)->target, name);
  if (places.empty() && options.table.empty() && !options.peers) {
    for (const std::string& target : options.targets) places.emplace_back(target, "");
  }
  std::vector<BenchCase> all;
  if (options.table == kBoardTable) all = board_visibility_cases();
  if (!options.bake.scene.empty()) {
    const Result<std::vector<SceneCase>> scenes = scene_cases(options);
    if (!scenes) return scenes.failure();
    for (const SceneCase& scene : *scenes) all.push_back(scene.bench_case);
    places.clear();
  }
  for (const auto& [target, board] : places) {
    if (target == "host") continue;
    const Result<std::vector<BenchCase>> cases = cases_for(options, target, board);
    if (!cases) return cases.failure();
    all.insert(all.end(), cases->begin(), cases->end());
  }
  std::set<std::string> names;
  for (const BenchCase& bench_case : all) names.insert(board_program_of(bench_case));
  write_text(stdout, fmt::format("{}{}", fmt::join(names, "\n"), names.empty() ? "" : "\n"));
  return Done{};
}

Result<Done> run_peers(const BenchOptions& options) {
  const Result<std::vector<BenchCase>> cases = cases_for(options, "host");
  if (!cases) return cases.failure();
  const Result<PeerComparison> comparison = compare_with_peers(*cases);
  if (!comparison) return comparison.failure();
  return report(options, peer_table(*comparison), peer_json(*comparison));
}

Result<Done> run_stages(const BenchOptions& options) {
  std::vector<StageProfile> profiles;
  std::string text;
  for (const std::string& target : options.targets) {
    if (target == "host")
      return Failure{ExitStatus::usage, "--stages is for boards: --target m0, m3, m4f, m7, m33 or m55"};
    const Result<std::vector<BenchCase>> cases = cases_for(options, target);
    if (!cases) return cases.failure();
    for (const BenchCase& bench_case : *cases) {
      Result<StageProfile> profile = profile_stages(bench_case, options.firmware);
      if (!profile) return profile.failure();
      text += stage_text(*profile);
      profiles.push_back(std::move(*profile));
    }
  }
  return report(options, text, stage_json(profiles));
}

Result<Done> run(const BenchOptions& options) {
  const bool given =
      std::ranges::any_of(options.of_bake, [](const CLI::Option* option) { return option->count() > 0; });
  if (given && options.bake.scene.empty()) return usage("options of a bake are for a scene; name one");
  if (options.programs) return list_programs(options);
  if (options.stages) return run_stages(options);
  if (options.peers) return run_peers(options);
  if (!options.boards.empty()) return run_predictions(options);
  if (!options.table.empty() && options.table != kBoardTable && !options.firmware.empty()) {
    return Failure{ExitStatus::usage, fmt::format("--table {} runs no firmware; leave out --firmware", options.table)};
  }
  if (options.table == "dynamic-z") return run_dynamic_z(options);
  if (options.table == kBoardTable) return run_board_visibility(options);
  if (!options.table.empty()) return run_visibility(options);
  std::vector<Measurement> rows;
  for (const std::string& target : options.targets) {
    const Result<std::vector<BenchCase>> cases = cases_for(options, target);
    if (!cases) return cases.failure();
    if (options.draw_each != 0) {
      for (const BenchCase& bench_case : *cases) {
        if (Result<Done> drawn = draw_only(bench_case, options.draw_each); !drawn) return drawn;
      }
      continue;
    }
    const Result<std::vector<Measurement>> measured =
        target == "host" ? bench_on_host(*cases) : bench_on_board(*cases, options.firmware);
    if (!measured) return measured.failure();
    rows.insert(rows.end(), measured->begin(), measured->end());
  }
  if (options.draw_each != 0) return Done{};
  if (Result<Done> written = report(options, bench_table(rows), bench_json(rows)); !written) return written;
  return compare_pictures(rows);
}

}  // namespace

void add_bench_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand(kBenchCommand.name, kBenchCommand.description);
  add_bench_options(*command, *options);
  command->callback([options, &exit_code] {
    const Result<Done> done = run(*options);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
