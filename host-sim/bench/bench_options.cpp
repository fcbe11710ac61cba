// The names, limits and help of the options of `zstrip bench`.
#include "bench/bench_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <span>

#include "bench/board_prediction.hpp"
#include "bench/dynamic_z_table.hpp"
#include "bench/visibility_table.hpp"
#include "bench/workloads.hpp"
#include "cli/camera_arguments.hpp"
#include "cli/one_of.hpp"
#include "cli/picture_arguments.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

std::vector<std::string> workload_names() {
  std::vector<std::string> names;
  for (const std::span<const Workload> all : {workloads(), model_workloads()}) {
    for (const Workload& workload : all) names.emplace_back(workload.name);
  }
  return names;
}

std::vector<std::string> board_names() {
  std::vector<std::string> names;
  for (const BoardModel& board : boards_with_core_model()) names.emplace_back(board.name);
  return names;
}

std::vector<std::string> sides_of_pictures() {
  std::vector<std::string> sides;
  for (const DynamicZPicture& picture : dynamic_z_pictures()) sides.push_back(std::to_string(picture.side));
  return sides;
}

std::vector<std::string> tables() {
  std::vector<std::string> names{"dynamic-z"};
  names.insert(names.end(), visibility_tables().begin(), visibility_tables().end());
  names.emplace_back(kBoardTable);
  return names;
}

std::string footer() {
  std::string text = "Workloads:\n";
  for (const std::span<const Workload> all : {workloads(), model_workloads()}) {
    for (const Workload& each : all) {
      text += fmt::format("  {:<5} {} ({}x{})\n", each.name, each.description, each.width, each.height);
    }
  }
  return text +
         "Examples:\n"
         "  zstrip bench                                  all workloads on this machine\n"
         "  zstrip bench --target host,m3 --workload K5   the same frames here and on an emulated Cortex-M3\n"
         "  zstrip bench --workload CT --strip-rows 8 --json results.json\n"
         "  zstrip bench --workload R50,R10k --size 1920x1080\n"
         "  zstrip bench --board bluepill,pico --workload K5M,CT --frames 6\n"
         "                                                frames a second that real boards would draw\n"
         "  zstrip bench --board pico model.glb --size 240x240 --frames 1\n"
         "                                                the same of your model, as zstrip bake bakes it\n"
         "  zstrip bench --peers                          Allegro 4 and OSMesa on the same workloads\n"
         "  zstrip bench --table dynamic-z                a published table, next to figures of this renderer\n"
         "  zstrip bench --table thesis                   painter, z-buffer and both; likewise midpoint and "
         "depth-bits\n"
         "  zstrip bench --table boards                   visibility methods on emulated boards";
}

void add_board_options(CLI::App& command, BenchOptions& options, CLI::Option* target) {
  auto* const board =
      command
          .add_option(
              "--board", options.boards,
              "Predict frames a second of real boards, separated by commas; zstrip plan estimates those of more boards")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->transform(one_of(board_names()))
          ->excludes(target)
          ->excludes("--peers");
  command.add_option("--spi-mhz", options.spi_mhz, "Clock of the display's bus instead of the board's fastest")
      ->check(CLI::Range(0.01, 1000.0))
      ->needs(board);
  command.add_option("--core-mhz", options.core_mhz, "Clock of the core instead of the board's own")
      ->check(CLI::Range(0.01, 10000.0))
      ->needs(board);
  command.add_option("--cores", options.cores, "Number of cores that draw, each the next strip when it is free")
      ->check(CLI::Range(std::uint32_t{1}, std::uint32_t{2}))
      ->needs(board);
  command.add_option("--wait-states", options.wait_states, "Wait states of the flash instead of the board's own")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{1000}))
      ->needs(board);
}

void add_scene_options(CLI::App& command, BenchOptions& options) {
  BakeArguments& bake = options.bake;
  command
      .add_option("scene", bake.scene,
                  "A model, a scene file or a built-in scene, which is baked as zstrip bake does, or a baked scene "
                  "(.zsc): drawn in place of the workloads. A frame alone is the picture as baked; several show its "
                  "motion")
      ->needs("--board")
      ->excludes("--workload")
      ->type_name("SCENE");
  const std::size_t before = command.get_options().size();
  add_quality_options(command, bake.plan.view);
  add_camera_options(command, bake.camera);
  add_reduction_options(command, bake.camera.reduction);
  command.add_option("--textures", bake.textures, "As of zstrip bake: rgb565 (default), auto, palette8 or palette4")
      ->option_text("FORMAT")
      ->transform(one_of({"rgb565", "auto", "palette8", "palette4"}));
  for (CLI::Option* option : command.get_options()) options.of_bake.push_back(option);
  options.of_bake.erase(options.of_bake.begin(), options.of_bake.begin() + static_cast<std::ptrdiff_t>(before));
}

}  // namespace

void add_bench_options(CLI::App& command, BenchOptions& options) {
  command.footer(footer());
  auto* const table =
      command.add_option("--table", options.table, "Reproduce a published table instead")->transform(one_of(tables()));
  command
      .add_option("--picture", options.pictures, "Sides of the table's pictures, separated by commas (default: all)")
      ->delimiter(',')
      ->transform(one_of(sides_of_pictures()))
      ->needs(table);
  auto* const target =
      command
          .add_option("--target", options.targets, "Where to draw, separated by commas; boards are emulated by QEMU")
          ->delimiter(',')
          ->transform(one_of({"host", "m0", "m3", "m4f", "m7", "m33", "m55", "rv32"}))
          ->capture_default_str();
  command.add_option("--workload", options.workloads, "What to draw, separated by commas")
      ->delimiter(',')
      ->transform(one_of(workload_names()))
      ->capture_default_str();
  command.add_option("--size", options.size, "Size of the picture, each side 1 to 4096 (default: the workload's own)")
      ->transform(lower_case())
      ->type_name("WxH");
  command.add_option("--strip-rows", options.strip_rows, "Rows of a strip (default: auto, as many as fit)")
      ->transform(lower_case())
      ->type_name("N|auto");
  command
      .add_option("--strip-columns", options.strip_columns,
                  "Pixels of a strip's row, a multiple of 8 (default: the picture's width)")
      ->transform(lower_case())
      ->type_name("N|auto");
  command.add_option("--mode", options.mode, "Transform geometry again for each strip, or once and bin it")
      ->transform(one_of({"streamed", "binned"}))
      ->capture_default_str();
  command.add_option("--depth", options.depth, "Depth on boards; formats other than z16 for R50 only")
      ->transform(one_of({"z16", "state", "ranges", "float", "z24"}))
      ->capture_default_str();
  command.add_option("--ram", options.ram, "Renderer's memory at most, K and M allowed (default: no limit)")
      ->type_name("BYTES");
  command.add_option("--frames", options.frames, "Frames to average over")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{1}, std::uint32_t{100000}))
      ->capture_default_str();
  command
      .add_option("--firmware", options.firmware, "Folder of the boards' programs (default: where the build puts them)")
      ->type_name("DIR");
  command.add_flag("--list-programs", options.programs,
                   "Print the names of the boards' programs that would be run, and end");
  command
      .add_flag("--stages", options.stages, "Show which stage takes a board's instructions; see host-sim/bench/stages")
      ->needs(target);
  command.add_flag("--peers", options.peers, "Other renderers of this machine on the same workloads, and ratios")
      ->excludes(target);
  add_board_options(command, options, target);
  add_scene_options(command, options);
  command.add_option("--json", options.json, "Write the results to this file as JSON; - is standard output")
      ->type_name("FILE|-");
  command.add_option("--depth-memory", options.depth_memory)->needs(table)->group("");
  command.add_option("--table-row", options.table_row)->needs(table)->group("");
  command.add_option("--draw-each", options.draw_each)
      ->check(CLI::Range(std::uint32_t{1}, std::uint32_t{100}))
      ->group("");
  for (const char* of_workloads : {"--target", "--workload", "--size", "--strip-rows", "--strip-columns", "--mode",
                                   "--depth", "--ram", "--frames", "--board", "--peers"}) {
    table->excludes(command.get_option(of_workloads));
  }
}

}  // namespace zstrip::sim
