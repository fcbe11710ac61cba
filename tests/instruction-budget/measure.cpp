// The command line of a row, and the JSON or the number that it gives.
#include "measure.hpp"

#include <unistd.h>

#include <cctype>
#include <charconv>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/elf_size.hpp"
#include "bench/workloads.hpp"

namespace zstrip::instruction_budget {
namespace {

std::uint64_t code_bytes(const Case& row, const Programs& programs) {
  std::string workload = row.workload;
  for (char& letter : workload) letter = static_cast<char>(std::tolower(letter));
  const auto bytes =
      sim::elf_load_bytes(programs.firmware / ("zstrip_pipeline_" + workload + "_" + row.target + ".elf"));
  if (!bytes) throw std::runtime_error(bytes.failure().message);
  return *bytes;
}

/// All instructions of the program that draws each frame so many times.
std::uint64_t emulated_total(const Case& row, const std::string& times) {
  const auto output =
      sim::run_program({"qemu-aarch64", "-cpu", "cortex-a72", "-plugin", ZSTRIP_TOTAL_PLUGIN, ZSTRIP_AARCH64_WORKLOADS,
                        row.workload, row.size, std::to_string(row.frames), times},
                       std::chrono::seconds{300});
  if (!output) throw std::runtime_error(output.failure().message);
  std::uint64_t total = 0;
  const char* const end = output->text.data() + output->text.size();
  if (output->exit_status != 0 || std::from_chars(output->text.data(), end, total).ec != std::errc{}) {
    throw std::runtime_error(row.name + " on an emulated AArch64: " + output->text);
  }
  return total;
}

/// The difference of two runs: without start-up, as host-sim/bench/instruction_count.hpp counts on the host.
std::optional<std::uint64_t> emulated_instructions(const Case& row) {
  if (row.mode != "streamed" || row.strip_rows != "auto" || row.depth != "z16") {
    throw std::runtime_error(row.name + ": on AArch64 there are one strip and z16 alone");
  }
  if (!std::filesystem::exists(ZSTRIP_AARCH64_WORKLOADS)) return std::nullopt;
  return (emulated_total(row, "3") - emulated_total(row, "1")) / 2 / row.frames;
}

}  // namespace

std::optional<std::uint64_t> measure(const Case& row, const Programs& programs) {
  if (row.mode == kCode) return code_bytes(row, programs);
  if (row.target == kAarch64) return emulated_instructions(row);
  const sim::Workload* const workload = sim::find_workload(row.workload);
  if (workload != nullptr && workload->is_model() && !std::filesystem::exists(workload->scene)) return std::nullopt;
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
