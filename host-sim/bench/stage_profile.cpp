// Joins execution counts with the compiler's line tables.
#include "bench/stage_profile.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/child_process.hpp"
#include "bench/drawing.hpp"
#include "bench/elf_symbols.hpp"
#include "bench/execution_profile.hpp"
#include "bench/workloads.hpp"
#include "render/render_frame.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCore = "core/zstrip/";
constexpr std::string_view kUnknown = "??";
constexpr std::string_view kLibrary = "libgcc ";  // the part without line tables in a program that has them

using Counts = std::map<std::uint32_t, std::uint64_t>;  // executions by address

Counts executions(const ExecutionProfile& profile) {
  Counts counts;
  for (const ExecutedRegion& region : profile.regions) {
    for (const BlockExecutions& executed : region.blocks) {
      const ExecutedBlock& block = profile.blocks[executed.block];
      for (std::uint32_t i = 0; i < block.count; ++i) {
        counts[profile.instructions[block.first + i].address] += executed.executions;
      }
    }
  }
  return counts;
}

/// Returns the source file of an instruction: of nested inlined calls the innermost file of the core outside of base/,
/// which has only arithmetic.
std::string source_of(const std::vector<std::string>& innermost_first) {
  for (const std::string& file : innermost_first) {
    const std::size_t at = file.rfind(kCore);
    if (at == std::string::npos) continue;
    std::string inside = file.substr(at + kCore.size());
    if (!inside.starts_with("base/")) return inside;
  }
  for (const std::string& file : innermost_first) {
    if (file.find("portable/memory.cpp") != std::string::npos) return "memset and memcpy";
    if (file.rfind(kCore) != std::string::npos) return file.substr(file.rfind(kCore) + kCore.size());
  }
  return std::string(kUnknown);
}

/// Code without line tables gets the name of its function instead.
Result<std::map<std::uint32_t, std::string>> named_by_function(const fs::path& program,
                                                               std::map<std::uint32_t, std::string> by_address) {
  const Result<std::vector<ElfFunction>> functions = elf_functions(program);
  if (!functions) return functions.failure();
  for (auto& [address, source] : by_address) {
    if (source != kUnknown) continue;
    const auto behind = std::ranges::upper_bound(*functions, address, {}, &ElfFunction::address);
    if (behind != functions->begin()) source = fmt::format("{}{}", kLibrary, std::prev(behind)->name);
  }
  return by_address;
}

/// Returns the source of each address.
Result<std::map<std::uint32_t, std::string>> sources(const fs::path& program, const Counts& counts) {
  const fs::path words = fs::temp_directory_path() / fmt::format("zstrip_addresses_{}.txt", getpid());
  {
    std::ofstream out(words);
    for (const auto& [address, count] : counts) out << fmt::format("0x{:08x}\n", address);
  }
  const Result<ChildOutput> output =
      run_program({"arm-none-eabi-addr2line", "-e", program.string(), "-a", "-i", fmt::format("@{}", words.string())},
                  std::chrono::seconds{120});
  std::error_code ignored;
  fs::remove(words, ignored);
  if (!output) return output.failure();
  std::map<std::uint32_t, std::string> result;
  std::istringstream lines(output->text);
  std::vector<std::string> files;
  std::uint32_t address = 0;
  bool any = false;
  const auto finish = [&] {
    if (!files.empty()) result[address] = source_of(files);
    any |= !files.empty() && result[address] != kUnknown;
    files.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("0x")) {
      finish();
      address = static_cast<std::uint32_t>(std::stoul(line, nullptr, 16));
    } else {
      files.push_back(line.substr(0, line.rfind(':')));
    }
  }
  finish();
  if (any) return named_by_function(program, std::move(result));
  return Failure{ExitStatus::environment,
                 program.string() + " holds no line tables: host-sim/bench/stages compiles programs that do"};
}

PipelineStage stage_of(const std::string& source, std::uint64_t executions, const Statistics& work,
                       std::uint32_t frames) {
  using enum PipelineStage;
  const auto is = [&source](std::string_view beginning) { return source.starts_with(beginning); };
  const std::uint64_t drawn = work.drawn + work.drawn / 50;  // both are counted on whole frames, but by two programs
  const bool once_a_frame = executions <= std::max<std::uint64_t>(16 * frames, 2);
  if (is("memset") || is("resolve/resolve")) return clear;
  if (is("resolve/")) return resolve;
  if (is("geometry/light")) return shade;
  if (is("geometry/clip") || is("raster/polygon")) return clip;
  const bool is_kernel = is("kernels/");
  if (is("geometry/") || (is_kernel && source.find("/transform") != std::string::npos)) {
    // The reciprocal of 1/w is used for vertices and runs of texels.
    if (executions > 4 * std::uint64_t{work.vertices}) return spans;
    return 2 * executions >= work.vertices ? transform : begin;
  }
  if (is("raster/assemble") || (is("scene/") && !once_a_frame)) return executions > drawn ? cull : setup;
  if (is("raster/") || is("pixels/") || is_kernel)
    return executions <= drawn ? setup : 8 * executions < work.fragments ? spans : pixels;
  return is(kLibrary) ? library : begin;
}

Result<Statistics> count_work(const BenchCase& bench_case) {
  const scenes::BuiltIn& built_in = *find_workload(bench_case.workload)->built_in();
  const Result<Drawing> drawing = Drawing::prepare(bench_case);
  if (!drawing) return drawing.failure();
  FrameRenderer renderer(bench_case.view, bench_case.budget);
  scenes::Staged staged;
  Statistics sum;
  for (std::uint32_t frame = 0; frame < bench_case.frames; ++frame) {
    scenes::stage_workload(built_in, staged, frame);
    const Result<FrameReport> report = renderer.render(Staging{staged.scene, staged.camera}, drawing->plan());
    if (!report) return report.failure();
    const Statistics& s = report->statistics;
    sum.triangles += s.triangles;
    sum.drawn += s.drawn;
    sum.clipped += s.clipped;
    sum.covering += s.covering;
    sum.vertices += s.vertices;
    sum.fragments += s.fragments;
    sum.depth_passes += s.depth_passes;
    for (std::size_t kind = 0; kind < kWorkKinds; ++kind) sum.work.of[kind] += s.work.of[kind];
  }
  return sum;
}

/// Returns the unit of a stage, as a number and a name; 0 if there is none.
std::pair<std::uint64_t, const char*> unit_of(PipelineStage stage, const StageProfile& p) {
  using enum PipelineStage;
  switch (stage) {
    case transform:
    case shade: return {p.work.vertices, "a vertex"};
    case cull: return {p.work.triangles, "a triangle"};
    case setup: return {p.work.drawn, "a drawn triangle"};
    case pixels: return {p.work.fragments, "a fragment"};
    case clear:
      return {std::uint64_t{p.bench_case.view.width} * p.bench_case.view.height * p.bench_case.frames,
              "a pixel of the picture"};
    default: return {0, ""};
  }
}

}  // namespace

std::string_view name(PipelineStage stage) {
  constexpr std::string_view kNames[] = {"begin_frame", "clear", "transform", "shade",   "cull",   "clip",
                                         "set-up",      "spans", "pixels",    "resolve", "library"};
  return kNames[static_cast<std::size_t>(stage)];
}

Result<StageProfile> profile_stages(const BenchCase& bench_case, const std::string& firmware) {
  const Result<Statistics> work = count_work(bench_case);
  if (!work) return work.failure();
  const Result<ProfiledCase> profiled = profile_on_board(bench_case, FlashCacheShape{}, firmware);
  if (!profiled) return profiled.failure();
  const Counts counts = executions(profiled->profile);
  const auto files = sources(profiled->program, counts);
  if (!files) return files.failure();

  StageProfile profile{.bench_case = bench_case, .work = *work, .by_stage{}, .by_source{}};
  for (const auto& [address, count] : counts) {
    const auto found = files->find(address);
    const std::string source = found == files->end() ? std::string(kUnknown) : found->second;
    profile.instructions += count;
    profile.by_source[source] += count;
    profile.by_stage[stage_of(source, count, *work, bench_case.frames)] += count;
  }
  return profile;
}

std::string stage_text(const StageProfile& p) {
  const auto frames = static_cast<double>(p.bench_case.frames);
  const auto per_frame = [frames](std::uint64_t count) { return static_cast<double>(count) / frames; };
  std::string text = fmt::format("{} on {}, {}x{}: {:.0f} instructions a frame, mean of {}\n", p.bench_case.workload,
                                 p.bench_case.target, p.bench_case.view.width, p.bench_case.view.height,
                                 per_frame(p.instructions), p.bench_case.frames);
  text += fmt::format("  a frame: {:.0f} vertices, {:.0f} triangles, {:.0f} drawn, {:.0f} fragments\n",
                      per_frame(p.work.vertices), per_frame(p.work.triangles), per_frame(p.work.drawn),
                      per_frame(p.work.fragments));
  const auto share = [&p](std::uint64_t count) {
    return 100 * static_cast<double>(count) / static_cast<double>(p.instructions);
  };
  for (const auto& [stage, count] : p.by_stage) {
    text += fmt::format("  {:<12} {:>10.0f} {:>5.1f} %", name(stage), per_frame(count), share(count));
    const auto [units, unit] = unit_of(stage, p);
    if (units != 0) text += fmt::format(" {:>8.2f} {}", static_cast<double>(count) / static_cast<double>(units), unit);
    text += '\n';
  }
  text += "  by source\n";
  std::vector<std::pair<std::string, std::uint64_t>> by_source(p.by_source.begin(), p.by_source.end());
  std::ranges::sort(by_source, std::ranges::greater{}, &std::pair<std::string, std::uint64_t>::second);
  for (const auto& [source, count] : by_source) {
    if (share(count) < 0.5) break;
    text += fmt::format("    {:<38} {:>10.0f} {:>5.1f} %\n", source, per_frame(count), share(count));
  }
  return text;
}

std::string stage_json(const std::vector<StageProfile>& profiles) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const StageProfile& p : profiles) {
    nlohmann::ordered_json stages, by_source;
    for (const auto& [stage, count] : p.by_stage) stages[std::string(name(stage))] = count / p.bench_case.frames;
    for (const auto& [source, count] : p.by_source) by_source[source] = count / p.bench_case.frames;
    list.push_back(
        {{"workload", p.bench_case.workload},
         {"target", p.bench_case.target},
         {"config",
          {{"width", p.bench_case.view.width}, {"height", p.bench_case.view.height}, {"frames", p.bench_case.frames}}},
         {"instructions_per_frame", p.instructions / p.bench_case.frames},
         {"stages", stages},
         {"sources", by_source}});
  }
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
