// Runs `zstrip bench --draw-each N` under valgrind's cachegrind and reads the total of instructions.
#include "bench/instruction_count.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>

#include "address_sanitizer.hpp"
#include "bench/child_process.hpp"

namespace zstrip::sim {
namespace {

constexpr std::chrono::seconds kProgramLimit{600};

// valgrind refuses programs built with AddressSanitizer.
constexpr bool kCanCount = !kAddressSanitizer;

// The number in "==123== I   refs:      1,234,567".
std::optional<std::uint64_t> instruction_total(const std::string& text) {
  std::size_t at = text.find("refs:");
  if (at == std::string::npos) return std::nullopt;
  std::string digits;
  for (at += 5; at < text.size() && text[at] != '\n'; ++at) {
    if (text[at] >= '0' && text[at] <= '9') digits += text[at];
  }
  std::uint64_t total = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), total);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return total;
}

// A setting of glibc; others ignore it.
constexpr const char* kVectorStores = "GLIBC_TUNABLES=glibc.cpu.x86_rep_stosb_threshold=4294967295";

struct CountedRun {
  const std::vector<std::string>& command;
  const std::vector<std::string>& environment;
  const std::string& what;
};

Result<std::uint64_t> total_of_run(const CountedRun& run, const char* draws) {
  std::vector<std::string> command{"env", kVectorStores};
  command.insert(command.end(), run.environment.begin(), run.environment.end());
  command.insert(command.end(), {"valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"});
  command.insert(command.end(), run.command.begin(), run.command.end());
  command.insert(command.end(), {"--draw-each", draws});

  const Result<ChildOutput> output = run_program(command, kProgramLimit);
  if (!output) return output.failure();
  const std::optional<std::uint64_t> total = instruction_total(output->text);
  if (output->exit_status != 0 || !total) {
    return Failure{ExitStatus::environment,
                   fmt::format("valgrind could not count the instructions of {} (status {}): {}", run.what,
                               output->exit_status, output->text.substr(0, output->text.find('\n')))};
  }
  return *total;
}

std::vector<std::string> options_of(const BenchCase& bench_case) {
  std::vector<std::string> options;
  const auto add = [&options](const char* option, const std::string& value) {
    options.emplace_back(option);
    options.push_back(value);
  };
  add("--workload", bench_case.workload);
  add("--size", fmt::format("{}x{}", bench_case.view.width, bench_case.view.height));
  add("--frames", std::to_string(bench_case.frames));
  if (bench_case.budget.bytes != 0) add("--ram", std::to_string(bench_case.budget.bytes));
  if (bench_case.budget.strip_columns != 0) add("--strip-columns", std::to_string(bench_case.budget.strip_columns));
  add("--mode", bench_case.budget.modes == Modes::binned ? "binned" : "streamed");
  if (bench_case.budget.strip_rows != 0) add("--strip-rows", std::to_string(bench_case.budget.strip_rows));
  return options;
}

}  // namespace

Result<std::optional<std::uint64_t>> count_draws(const std::vector<std::string>& command,
                                                 const std::vector<std::string>& environment, const std::string& what) {
  if (!kCanCount || !run_program({"valgrind", "--version"}, std::chrono::seconds{30}))
    return std::optional<std::uint64_t>{};
  const CountedRun run{command, environment, what};
  const Result<std::uint64_t> once = total_of_run(run, "1");
  if (!once) return once.failure();
  const Result<std::uint64_t> thrice = total_of_run(run, "3");
  if (!thrice) return thrice.failure();
  if (*thrice <= *once) return std::optional<std::uint64_t>{};  // draws differ, perhaps because of a JIT
  return std::optional{(*thrice - *once) / 2};
}

Result<std::optional<std::uint64_t>> count_draw(const std::vector<std::string>& options, const std::string& what) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return Failure{ExitStatus::environment, "cannot find this program's own file: " + error.message()};
  std::vector<std::string> command{self.string(), "bench"};
  command.insert(command.end(), options.begin(), options.end());
  return count_draws(command, {}, what);
}

Result<std::optional<std::uint64_t>> count_instructions(const BenchCase& bench_case) {
  Result<std::optional<std::uint64_t>> counted = count_draw(options_of(bench_case), bench_case.workload);
  if (counted && *counted) **counted /= bench_case.frames;
  return counted;
}

}  // namespace zstrip::sim
