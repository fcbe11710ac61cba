// Starts the emulator with the counting plugin and reads its file.
#include "bench/execution_profile.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "bench/board_bench.hpp"
#include "bench/elf_symbols.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

// zstrip::board::InstructionCounter::resume() and pause(), between which the benchmark draws.
constexpr std::string_view kResume = "_ZN6zstrip5board18InstructionCounter6resumeEv";
constexpr std::string_view kPause = "_ZN6zstrip5board18InstructionCounter5pauseEv";
constexpr std::uint32_t kRam = 0x20000000;  // of the MPS2 boards; below it is what would be flash

Result<fs::path> plugin_file() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) return Failure{ExitStatus::environment, "cannot find this program's own file: " + error.message()};
  const fs::path plugin = self.parent_path() / "zstrip_counting_plugin.so";
  if (fs::exists(plugin)) return plugin;
  return Failure{ExitStatus::environment, plugin.string() + " is not there: the build puts it beside this program"};
}

Result<std::string> function_argument(const std::vector<ElfFunction>& functions, const char* key,
                                      std::string_view name) {
  const auto function = std::ranges::find(functions, name, &ElfFunction::name);
  if (function == functions.end()) return Failure{ExitStatus::internal, fmt::format("no function {}", name)};
  return fmt::format(",{}={:x}:{:x}", key, function->address, function->bytes);
}

Result<std::string> plugin_option(const fs::path& program, const FlashCacheShape& cache, const fs::path& out) {
  const Result<fs::path> plugin = plugin_file();
  if (!plugin) return plugin.failure();
  const Result<std::vector<ElfFunction>> functions = elf_functions(program);
  if (!functions) return functions.failure();
  const Result<std::string> resume = function_argument(*functions, "resume", kResume);
  if (!resume) return resume.failure();
  const Result<std::string> pause = function_argument(*functions, "pause", kPause);
  if (!pause) return pause.failure();
  const std::string data =
      cache.shared ? "shared" : fmt::format("{}:{}:{}", cache.data_lines, cache.data_ways, cache.line_bytes);
  return fmt::format("{},out={}{}{},ram={:x},code={}:{}:{},data={}", plugin->string(), out.string(), *resume, *pause,
                     kRam, cache.code_lines, cache.code_ways, cache.line_bytes, data);
}

class ProfileReader {
 public:
  /// Returns false if the line has another format than the plugin's.
  bool read(const std::string& line) {
    std::istringstream words(line.substr(line.empty() ? 0 : 1));
    switch (line.empty() ? '\0' : line[0]) {
      case 'i': return instruction(words);
      case 'b': return block(words);
      case 'x': return executions(words);
      case 'r': return region(words);
      default: return false;
    }
  }
  /// Returns nothing if the file ended inside a region.
  std::optional<ExecutionProfile> finish() {
    if (!region_.blocks.empty()) return std::nullopt;
    return std::move(profile_);
  }

 private:
  bool instruction(std::istringstream& words) {
    ExecutedInstruction instruction;
    words >> std::hex >> instruction.address >> std::dec >> instruction.bytes >> std::ws;
    std::getline(words, instruction.text);
    if (words.bad() || instruction.text.empty()) return false;
    by_address_[instruction.address] = std::move(instruction);
    return true;
  }
  bool block(std::istringstream& words) {
    std::uint32_t number = 0, address = 0, count = 0;
    if (!(words >> number >> std::hex >> address >> std::dec >> count) || number != profile_.blocks.size())
      return false;
    profile_.blocks.push_back({static_cast<std::uint32_t>(profile_.instructions.size()), count});
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto found = by_address_.find(address);
      if (found == by_address_.end()) return false;
      profile_.instructions.push_back(found->second);
      address += found->second.bytes;
    }
    return true;
  }
  bool executions(std::istringstream& words) {
    BlockExecutions executed;
    if (!(words >> executed.block >> executed.executions >> executed.taken)) return false;
    if (executed.block >= profile_.blocks.size()) return false;
    region_.blocks.push_back(executed);
    return true;
  }
  bool region(std::istringstream& words) {
    std::uint64_t reads = 0;
    if (!(words >> region_.jump_misses >> region_.sequential_misses >> reads >> region_.data_misses)) return false;
    profile_.regions.push_back(std::move(region_));
    region_ = {};
    return true;
  }

  std::map<std::uint32_t, ExecutedInstruction> by_address_;
  ExecutionProfile profile_;
  ExecutedRegion region_;
};

}  // namespace

std::uint64_t instruction_count(const ExecutionProfile& profile, const ExecutedRegion& region) {
  std::uint64_t sum = 0;
  for (const BlockExecutions& executed : region.blocks)
    sum += executed.executions * profile.blocks[executed.block].count;
  return sum;
}

Result<ExecutionProfile> read_profile(const fs::path& file) {
  std::ifstream stream(file);
  ProfileReader reader;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!reader.read(line)) {
      return Failure{ExitStatus::internal,
                     fmt::format("the counting plugin wrote something else in line {}: {}", number, line)};
    }
  }
  std::optional<ExecutionProfile> profile = reader.finish();
  if (!profile || profile->regions.empty()) {
    return Failure{ExitStatus::environment,
                   "QEMU counted nothing: it was built without TCG plugins, or takes another version of them"};
  }
  return std::move(*profile);
}

Result<ProfiledCase> profile_on_board(const BenchCase& bench_case, const FlashCacheShape& cache,
                                      const std::string& firmware) {
  const Result<fs::path> program = board_program(bench_case, firmware);
  if (!program) return program.failure();
  static std::atomic<unsigned> number{0};  // several may be profiled at once
  const fs::path out = fs::temp_directory_path() / fmt::format("zstrip_profile_{}_{}.txt", getpid(), number++);
  const Result<std::string> option = plugin_option(*program, cache, out);
  if (!option) return option.failure();
  Result<Measurement> measured = bench_on_board(bench_case, *program, {"-plugin", *option});
  Result<ExecutionProfile> profile = measured ? read_profile(out) : Result<ExecutionProfile>(measured.failure());
  std::error_code ignored;
  fs::remove(out, ignored);
  if (!profile) return profile.failure();
  return ProfiledCase{std::move(*measured), std::move(*profile), *program};
}

}  // namespace zstrip::sim
