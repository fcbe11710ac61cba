// The command line of a row, and the JSON that it gives.
#include "measure.hpp"

#include <unistd.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/child_process.hpp"

namespace zstrip::instruction_budget {

std::optional<std::uint64_t> measure(const BudgetRow& row, const Programs& programs) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("zstrip_" + row.name + "_" + std::to_string(getpid()) + ".json");
  std::vector<std::string> command{programs.zstrip.string(),
                                   "bench",
                                   "--workload",
                                   row.workload,
                                   "--target",
                                   row.target,
                                   "--size",
                                   row.size,
                                   "--mode",
                                   row.mode,
                                   "--strip-rows",
                                   row.strip_rows,
                                   "--depth",
                                   row.depth,
                                   "--frames",
                                   std::to_string(row.frames),
                                   "--json",
                                   file.string()};
  if (row.target != "host") command.insert(command.end(), {"--firmware", programs.firmware.string()});
  const auto output = sim::run_program(command, std::chrono::seconds{900});
  if (!output) throw std::runtime_error(output.failure().message);
  if (output->exit_status != 0) throw std::runtime_error(output->text);
  std::ifstream stream(file);
  const auto rows = nlohmann::json::parse(stream);
  std::filesystem::remove(file);
  const auto& instructions = rows.at(0).at("instructions_per_frame");
  if (instructions.is_null()) return std::nullopt;
  return instructions.get<std::uint64_t>();
}

}  // namespace zstrip::instruction_budget
