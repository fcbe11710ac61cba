// Starts QEMU for each case and reads the line of JSON that firmware/boards/mps2/bench.cpp prints.
#include "bench/board_bench.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "bake/scene_blob.hpp"
#include "bench/child_process.hpp"
#include "bench/elf_size.hpp"
#include "bench/workloads.hpp"
#include "image/temporary_file.hpp"
#include "image/write_file.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kCaseLimit{900};  // for each case; a hundred frames of the largest need a few minutes
constexpr int kBoardBudget = 5;                  // bench.cpp's exit status for too little memory

/// Returns the address where firmware/boards/mps2/scene_in_flash.hpp looks for a scene.
std::uint32_t scene_address(std::string_view target) { return target == "m33" ? 0x10100000 : 0x00100000; }

/// Returns the text with commas doubled, as QEMU's options want them.
std::string with_commas(const std::string& text) {
  std::string doubled;
  for (const char letter : text) doubled += letter == ',' ? ",," : std::string(1, letter);
  return doubled;
}

// Code for Cortex-M0 runs on the machine with a Cortex-M3.
const char* machine(std::string_view target) {
  if (target == "m4f") return "mps2-an386";
  if (target == "m7") return "mps2-an500";
  if (target == "m33") return "mps2-an505";
  if (target == "m55") return "mps3-an547";
  if (target == "rv32") return "virt";
  return "mps2-an385";
}

/// True if the scene is a file, which boards get into their flash.
bool is_of_model(const BenchCase& bench_case) {
  const Workload* workload = find_workload(bench_case.workload);
  return bench_case.program.empty() && workload != nullptr && workload->is_model();
}

// Separate programs, so that each has one pipeline.
const char* program_infix(const BenchCase& bench_case) {
  if (is_of_model(bench_case)) return "scene_";
  if (bench_case.depth != "z16") return "depth_";
  return bench_case.budget.modes == Modes::binned ? "bins_" : "";
}

std::vector<std::string> emulator_command(const BenchCase& bench_case, const fs::path& program) {
  const bool is_riscv = bench_case.target == "rv32";
  std::vector<std::string> command{is_riscv ? "qemu-system-riscv32" : "qemu-system-arm",
                                   "-M",
                                   machine(bench_case.target),
                                   "-bios",
                                   "none",
                                   "-icount",
                                   "shift=0",
                                   "-display",
                                   "none",
                                   "-monitor",
                                   "none",
                                   "-serial",
                                   "stdio",
                                   "-semihosting-config",
                                   "enable=on,target=native" + board_words(bench_case),
                                   "-kernel",
                                   program.string()};
  if (!bench_case.scene_file.empty()) {
    command.emplace_back("-device");
    command.push_back(fmt::format("loader,file={},addr={:#x},force-raw=on", with_commas(bench_case.scene_file),
                                  scene_address(bench_case.target)));
  }
  return command;
}

std::optional<std::uint32_t> hexadecimal(const std::string& text) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value, 16);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

// Throws nlohmann::json::exception if a member is missing or has another type.
std::optional<Measurement> read_line(const BenchCase& bench_case, const std::string& line) {
  const nlohmann::json object = nlohmann::json::parse(line);
  Measurement row{.bench_case = bench_case,
                  .mode = object.at("mode") == "binned" ? Mode::binned : Mode::streamed,
                  .strip_rows = object.at("strip_rows").get<std::uint16_t>(),
                  .strip_columns = object.at("strip_columns").get<std::uint16_t>(),
                  .ram_bytes = object.at("arena_bytes").get<std::uint64_t>() +
                               object.at("strip_pixel_bytes").get<std::uint64_t>() +
                               object.value("pose_bytes", std::uint64_t{0}),
                  .instructions_per_frame = object.at("instructions_per_frame").get<std::uint64_t>()};
  for (const nlohmann::json& frame : object.at("frames")) {
    const std::optional<std::uint32_t> sum = hexadecimal(frame.at("crc32").get<std::string>());
    if (!sum) return std::nullopt;
    row.frame_crc32.push_back(*sum);
  }
  if (row.frame_crc32.size() != bench_case.frames) return std::nullopt;
  return row;
}

/// Selects workloads with this depth format: from "K5/z16 CT/z16" returns "K5, CT".
std::string workloads_in(std::string_view names, std::string_view depth) {
  std::string list;
  std::istringstream words{std::string(names)};
  for (std::string word; words >> word;) {
    const std::size_t slash = word.find('/');
    if (std::string_view(word).substr(slash + 1) != depth) continue;
    if (!list.empty()) list += ", ";
    list += word.substr(0, slash);
  }
  return list;
}

/// Converts the status and the last line of a program to a failure (firmware/boards/mps2/bench_run.hpp).
Failure failure_of(const BenchCase& bench_case, int status, const std::string& line) {
  constexpr std::string_view kNeeded = ", needed ", kAvailable = ", available ";
  if (const std::size_t numbers = line.find(kNeeded); status == kBoardBudget && numbers != std::string::npos) {
    std::uint64_t needed = 0, available = 0;
    std::istringstream words(line.substr(numbers + kNeeded.size()));
    words >> needed;
    words.ignore(kAvailable.size());
    words >> available;
    return {ExitStatus::budget,
            fmt::format("{} needs {} of RAM on {} for arena and pixels, and has {}", bench_case.workload,
                        counted(needed, "byte"), bench_case.target, grouped(available))};
  }
  constexpr std::string_view kNoWorkload = "bench: no workload ", kThereAre = "; there are ";
  if (const std::size_t list = line.find(kThereAre); line.starts_with(kNoWorkload) && list != std::string::npos) {
    const std::string_view names = std::string_view(line).substr(list + kThereAre.size());
    return {ExitStatus::usage, fmt::format("the program for {} that draws {} has no {}; it has {}", bench_case.target,
                                           bench_case.depth != "z16" ? "with --depth " + bench_case.depth
                                           : bench_case.budget.modes == Modes::binned ? "binned"
                                                                                      : "streamed",
                                           bench_case.workload, workloads_in(names, bench_case.depth))};
  }
  return {ExitStatus::environment,
          fmt::format("{} on {} (status {}): {}", bench_case.workload, bench_case.target, status, line)};
}

}  // namespace

std::string board_words(const BenchCase& bench_case) {
  const bool plays_file = !bench_case.program.empty() && !bench_case.scene_file.empty();
  std::string words =
      fmt::format(",arg=workload={},arg=size={}x{},arg=frames={}", plays_file ? "scene" : bench_case.workload,
                  bench_case.view.width, bench_case.view.height, bench_case.frames);
  if (bench_case.depth != "z16") words += ",arg=depth=" + bench_case.depth;
  if (bench_case.budget.bytes != 0) words += fmt::format(",arg=ram={}", bench_case.budget.bytes);
  if (bench_case.budget.strip_buffers != 0) words += fmt::format(",arg=buffers={}", bench_case.budget.strip_buffers);
  if (bench_case.budget.strip_rows != 0) words += fmt::format(",arg=rows={}", bench_case.budget.strip_rows);
  if (bench_case.budget.strip_columns != 0) words += fmt::format(",arg=columns={}", bench_case.budget.strip_columns);
  if (bench_case.in_turns) words += ",arg=order=turns";
  if (bench_case.view.format != PixelFormat::rgb565) {
    words += bench_case.view.format == PixelFormat::gray4 ? ",arg=format=gray4" : ",arg=format=mono";
  }
  return words;
}

std::string board_program_of(const BenchCase& bench_case) {
  if (!bench_case.program.empty()) return bench_case.program;
  return fmt::format("zstrip_bench_{}{}", program_infix(bench_case), bench_case.target);
}

Result<fs::path> board_program(const BenchCase& bench_case, const std::string& firmware) {
  fs::path folder = firmware;
  if (folder.empty()) {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    if (error) return Failure{ExitStatus::environment, "cannot find this program's own file: " + error.message()};
    folder = self.parent_path().parent_path() / "firmware" / "bin";
  }
  const fs::path program = folder / (board_program_of(bench_case) + ".elf");
  std::error_code ignored;
  if (!fs::exists(program, ignored) && !bench_case.program.empty()) {
    return Failure{ExitStatus::environment,
                   fmt::format("{} is not there, the program with the pipeline of this scene: host-sim/run builds it "
                               "with arm-none-eabi-g++; or name the folder where it is with --firmware",
                               program.string())};
  }
  if (!fs::exists(program, ignored)) {
    return Failure{ExitStatus::environment,
                   fmt::format("{} is not there: build the boards' programs (tests/run does, or cmake --build --preset "
                               "host --target firmware), or name their folder with --firmware",
                               program.string())};
  }
  return program;
}

Result<Measurement> bench_on_board(const BenchCase& bench_case, const fs::path& program,
                                   const std::vector<std::string>& emulator_options) {
  if (bench_case.scene_file.empty() && is_of_model(bench_case)) {
    const Scene& scene = find_workload(bench_case.workload)->built_in()->scene;
    const Result<std::vector<std::uint8_t>> blob = to_scene_blob({scene, Camera{}, bench_case.view, {}});
    if (!blob) return blob.failure();
    const TemporaryFile file("zstrip_bench", ".zsc");
    if (const Result<Done> written = write_file(file.path(), *blob, "TMPDIR"); !written) return written.failure();
    BenchCase with_scene = bench_case;
    with_scene.scene_file = file.path();
    Result<Measurement> row = bench_on_board(with_scene, program, emulator_options);
    if (row) row->bench_case = bench_case;
    return row;
  }
  std::vector<std::string> command = emulator_command(bench_case, program);
  command.insert(command.end(), emulator_options.begin(), emulator_options.end());
  const Result<ChildOutput> output = run_program(command, kCaseLimit);
  if (!output) return output.failure();
  const std::string line = output->text.substr(0, output->text.find_last_not_of("\r\n") + 1);
  if (output->exit_status != 0) {
    return failure_of(bench_case, output->exit_status, line.substr(line.rfind('\n') + 1));
  }
  std::optional<Measurement> row;
  std::string why = "not one result for each frame";
  try {
    row = read_line(bench_case, line);
  } catch (const nlohmann::json::exception& error) {
    why = error.what();
  }
  if (!row) {
    return Failure{ExitStatus::internal, fmt::format("{} on {} printed something else than a result: {}",
                                                     bench_case.workload, bench_case.target, why)};
  }
  const Result<std::uint64_t> flash = elf_load_bytes(program);
  if (!flash) return flash.failure();
  row->flash_bytes = *flash;
  return std::move(*row);
}

Result<std::vector<Measurement>> bench_on_board(const std::vector<BenchCase>& cases, const std::string& firmware) {
  std::vector<Measurement> rows;
  for (const BenchCase& bench_case : cases) {
    const Result<fs::path> program = board_program(bench_case, firmware);
    if (!program) return program.failure();
    Result<Measurement> row = bench_on_board(bench_case, *program, {});
    if (!row) return row.failure();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace zstrip::sim
