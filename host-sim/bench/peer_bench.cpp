// Runs the programs of peer_programs/ alternately with our own renderer.
#include "bench/peer_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "bench/child_process.hpp"
#include "bench/drawing.hpp"
#include "bench/host_bench.hpp"
#include "bench/instruction_count.hpp"
#include "bench/workloads.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPeerRounds = 5;
constexpr std::chrono::seconds kRoundLimit{300};  // of one round of one case

struct PeerProgram {
  std::string_view renderer;
  std::string_view program;
  std::string_view package;
  std::string_view driver;  ///< of Mesa; empty for others
};
constexpr std::array kPrograms{
    PeerProgram{"Allegro 4", "zstrip_peer_allegro", "liballegro4-dev", ""},
    PeerProgram{"OSMesa softpipe", "zstrip_peer_osmesa", "libosmesa6-dev", "softpipe"},
    PeerProgram{"OSMesa llvmpipe", "zstrip_peer_osmesa", "libosmesa6-dev", "llvmpipe"},
};

/// One renderer on one case, and its measurements so far.
struct Contestant {
  const PeerProgram* peer = nullptr;  ///< null: zstrip itself
  BenchCase bench_case{};
  std::vector<std::string> command{}, environment{};
  std::vector<double> nanoseconds{};
  std::uint64_t covered = 0;
};

Contestant contestant(const PeerProgram& peer, const BenchCase& bench_case, const fs::path& program) {
  Contestant c{.peer = &peer, .bench_case = bench_case};
  c.command = {program.string(), std::string(find_workload(bench_case.workload)->scene),
               std::to_string(bench_case.view.width), std::to_string(bench_case.view.height),
               std::to_string(bench_case.frames)};
  // One thread, and compiled in each run: a run that finds the code of the one before counts less.
  if (!peer.driver.empty()) {
    c.environment = {fmt::format("GALLIUM_DRIVER={}", peer.driver), "LP_NUM_THREADS=0",
                     "MESA_SHADER_CACHE_DISABLE=true"};
  }
  return c;
}

Result<Done> run_peer(Contestant& c) {
  std::vector<std::string> command{"env"};
  command.insert(command.end(), c.environment.begin(), c.environment.end());
  command.insert(command.end(), c.command.begin(), c.command.end());
  const Result<ChildOutput> output = run_program(command, kRoundLimit);
  if (!output) return output.failure();
  const nlohmann::json line = nlohmann::json::parse(output->text, nullptr, false);
  if (output->exit_status != 0 || !line.is_object()) {
    return Failure{ExitStatus::environment,
                   fmt::format("{} does not draw {}: {}", c.peer->renderer, c.bench_case.workload,
                               output->text.substr(0, output->text.find('\n')))};
  }
  c.nanoseconds.push_back(line.value("ns_per_frame", 0.0));
  c.covered = line.value("covered", std::uint64_t{0});
  return Done{};
}

std::uint64_t covered_pixels(std::span<const std::byte> pixels, std::uint16_t background) {
  std::uint64_t count = 0;
  for (std::size_t at = 0; at + 2 <= pixels.size(); at += 2) {
    std::uint16_t pixel = 0;
    std::memcpy(&pixel, pixels.data() + at, sizeof pixel);
    count += pixel != background ? 1 : 0;
  }
  return count;
}

Result<Done> run_zstrip(Contestant& c) {
  Result<Drawing> drawing = Drawing::prepare(c.bench_case);
  if (!drawing) return drawing.failure();
  const Result<double> time = nanoseconds_per_frame(*drawing, c.bench_case);
  if (!time) return time.failure();
  c.nanoseconds.push_back(*time);
  const Colour background = find_workload(c.bench_case.workload)->built_in()->scene.background;
  const auto colour =
      static_cast<std::uint16_t>((background.r >> 3) << 11 | (background.g >> 2) << 5 | background.b >> 3);
  c.covered = 0;
  drawing->stage(0);
  const Status drawn =
      drawing->draw([&](std::span<const std::byte> pixels) { c.covered += covered_pixels(pixels, colour); });
  if (!drawn) return Failure{ExitStatus::internal, std::string(message(drawn.error))};
  return Done{};
}

Result<PeerRow> row_of(Contestant& c) {
  std::ranges::sort(c.nanoseconds);
  PeerRow row{.workload = c.bench_case.workload,
              .renderer = c.peer == nullptr ? "zstrip" : std::string(c.peer->renderer),
              .width = c.bench_case.view.width,
              .height = c.bench_case.view.height,
              .nanoseconds_per_frame = c.nanoseconds[c.nanoseconds.size() / 2],
              .covered = c.covered};
  if (c.peer == nullptr) {
    const auto counted = count_instructions(c.bench_case);
    if (!counted) return counted.failure();
    row.instructions_per_frame = *counted;
  } else {
    const auto counted = count_draws(c.command, c.environment, row.renderer);
    if (!counted) return counted.failure();
    if (*counted) row.instructions_per_frame = **counted / c.bench_case.frames;
  }
  return row;
}

}  // namespace

Result<PeerComparison> compare_with_peers(const std::vector<BenchCase>& cases) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return Failure{ExitStatus::environment, "cannot find this program's own file: " + error.message()};
  PeerComparison comparison;
  std::vector<const PeerProgram*> present;
  for (const PeerProgram& peer : kPrograms) {
    if (fs::exists(folder / peer.program)) {
      present.push_back(&peer);
    } else {
      comparison.skipped.push_back(
          fmt::format("{} is skipped: this program was built without the package {}", peer.renderer, peer.package));
    }
  }
  std::vector<Contestant> contestants;
  for (const BenchCase& bench_case : cases) {
    contestants.push_back({.bench_case = bench_case});
    for (const PeerProgram* peer : present)
      contestants.push_back(contestant(*peer, bench_case, folder / peer->program));
  }
  for (std::size_t round = 0; round < kPeerRounds; ++round) {
    for (Contestant& c : contestants) {
      if (const Result<Done> done = c.peer == nullptr ? run_zstrip(c) : run_peer(c); !done) return done.failure();
    }
  }
  std::uint64_t ours = 0;
  for (Contestant& c : contestants) {
    if (c.peer == nullptr) ours = c.covered;
    if (c.covered > ours + ours / 50 || ours > c.covered + c.covered / 50) {
      return Failure{ExitStatus::internal, fmt::format("{} covers {} pixels of {}, zstrip {}: not the same picture",
                                                       c.peer->renderer, c.covered, c.bench_case.workload, ours)};
    }
    Result<PeerRow> row = row_of(c);
    if (!row) return row.failure();
    comparison.rows.push_back(std::move(*row));
  }
  return comparison;
}

std::string peer_table(const PeerComparison& comparison) {
  std::string text = fmt::format("{:<9} {:<10} {:<16} {:>14} {:>7} {:>12} {:>7}\n", "workload", "picture", "renderer",
                                 "instructions", "ratio", "time", "ratio");
  const PeerRow* ours = nullptr;
  for (const PeerRow& row : comparison.rows) {
    if (row.renderer == "zstrip") ours = &row;
    const bool counted = row.instructions_per_frame && ours->instructions_per_frame;
    text += fmt::format("{:<9} {:<10} {:<16} {:>14} {:>7} {:>12} {:>7.2f}\n", row.workload,
                        fmt::format("{}x{}", row.width, row.height), row.renderer,
                        counted ? fmt::format("{:.3f} M", static_cast<double>(*row.instructions_per_frame) / 1e6) : "-",
                        counted ? fmt::format("{:.2f}", static_cast<double>(*row.instructions_per_frame) /
                                                            static_cast<double>(*ours->instructions_per_frame))
                                : "-",
                        fmt::format("{:.3f} ms", row.nanoseconds_per_frame / 1e6),
                        row.nanoseconds_per_frame / ours->nanoseconds_per_frame);
  }
  for (const std::string& skipped : comparison.skipped) text += skipped + '\n';
  return text +
         "Ratios are to zstrip. One thread each, whole buffers, clears included, set-up excluded; times take turns.\n";
}

std::string peer_json(const PeerComparison& comparison) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PeerRow& row : comparison.rows) {
    nlohmann::ordered_json entry{{"workload", row.workload},
                                 {"renderer", row.renderer},
                                 {"config", {{"width", row.width}, {"height", row.height}}},
                                 {"instructions_per_frame", nullptr},
                                 {"ns_per_frame", row.nanoseconds_per_frame},
                                 {"covered_pixels", row.covered}};
    if (row.instructions_per_frame) entry["instructions_per_frame"] = *row.instructions_per_frame;
    list.push_back(std::move(entry));
  }
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
