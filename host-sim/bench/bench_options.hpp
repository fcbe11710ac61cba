// The options of `zstrip bench`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/bake_command.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace zstrip::sim {

/// The table that is measured on boards.
inline constexpr const char* kBoardTable = "boards";

/// The options as the user wrote them; the command parses their texts when it runs.
struct BenchOptions {
  std::vector<std::string> targets{"host"};
  std::vector<std::string> workloads{"K5", "CT", "R50", "R10k"};
  std::string size;              ///< empty: the workload's own
  std::string strip_rows;        ///< empty: the planner decides
  std::string strip_columns;     ///< empty: the picture's width
  std::string mode{"streamed"};  ///< of the plan
  std::string depth{"z16"};      ///< depth format or visibility method
  std::string ram;               ///< empty: no limit
  std::uint32_t frames = 60;
  std::string firmware;  ///< empty: the build's folder next to this program
  std::string json;
  bool stages = false;              ///< show the instructions of each stage, on boards
  bool peers = false;               ///< also measure other renderers, on this machine
  std::vector<std::string> boards;  ///< boards whose frames a second are predicted instead; empty: none
  std::optional<double> spi_mhz;    ///< used in place of the board's own
  std::optional<double> core_mhz;
  std::optional<std::uint32_t> wait_states;
  std::uint32_t cores = 1;              ///< number of cores of such a board that draw
  std::string table;                    ///< empty: measure the workloads; else the table to reproduce
  std::vector<std::uint32_t> pictures;  ///< pictures of the table; empty: all
  std::uint32_t draw_each = 0;          ///< not 0: the program was started by instruction_count.cpp
  std::string depth_memory;             ///< then: the row of the table to draw
  std::uint32_t table_row = 0;          ///< then: the row of a visibility table to draw
  bool programs = false;                ///< list the boards' programs instead of running them
  BakeArguments bake;                   ///< of a scene that is drawn in place of the workloads; empty: the workloads
  std::vector<CLI::Option*> of_bake;    ///< the options that are for a scene alone
};

/// Adds the options and the help to the command. Parsing fills `options`, which must outlive it.
void add_bench_options(CLI::App& command, BenchOptions& options);

}  // namespace zstrip::sim
