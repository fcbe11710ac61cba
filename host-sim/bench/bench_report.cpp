// The columns of the table and the keys of the JSON rows.
#include "bench/bench_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/peers.hpp"
#include "report/frame_record.hpp"

namespace zstrip::sim {
namespace {

constexpr const char* kLine = "{:<9} {:<6} {:<10} {:<17} {:>13} {:>11} {:>10} {:>10}  {}\n";

std::string millions(double instructions) { return fmt::format("{:.3f} M", instructions / 1e6); }

std::string strips(const Measurement& row) {
  if (row.strip_columns == row.bench_case.view.width) return fmt::format("{}, {} rows", name(row.mode), row.strip_rows);
  return fmt::format("{}, {}x{}", name(row.mode), row.strip_columns, row.strip_rows);
}

std::string peer_column(const Measurement& row) {
  const Peer peer = best_peer(row.bench_case);
  if (peer.name.empty()) return "-";
  std::string text = fmt::format("{} {:.2f} M", peer.name, peer.million_instructions);
  if (row.instructions_per_frame) {
    const double ratio = static_cast<double>(*row.instructions_per_frame) / (peer.million_instructions * 1e6);
    text += fmt::format(" (zstrip: {:.0f} % of it)", 100 * ratio);
  }
  return text;
}

}  // namespace

std::string bench_table(std::span<const Measurement> rows) {
  std::string text = fmt::format(fmt::runtime(kLine), "workload", "target", "picture", "plan", "instructions", "time",
                                 "RAM bytes", "flash", "best of the others");
  bool any_peer = false, any_board = false;
  for (const Measurement& row : rows) {
    const View& view = row.bench_case.view;
    any_peer |= !best_peer(row.bench_case).name.empty();
    any_board |= row.bench_case.target != "host";
    text += fmt::format(
        fmt::runtime(kLine), row.bench_case.workload, row.bench_case.target,
        fmt::format("{}x{}", view.width, view.height), strips(row),
        row.instructions_per_frame ? millions(static_cast<double>(*row.instructions_per_frame)) : "not counted",
        row.nanoseconds_per_frame ? fmt::format("{:.3f} ms", *row.nanoseconds_per_frame / 1e6) : "-", row.ram_bytes,
        row.flash_bytes ? fmt::format("{}", *row.flash_bytes) : "-", peer_column(row));
  }
  text += "Instructions and time are those of one frame, set-up excluded.\n";
  if (any_board) text += "Boards are emulated: an instruction is not a cycle.\n";
  if (any_peer) text += "The others were measured side by side on the same workloads, drawing into whole buffers.\n";
  return text;
}

std::string bench_json(std::span<const Measurement> rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measurement& row : rows) {
    nlohmann::ordered_json entry{
        {"workload", row.bench_case.workload},
        {"target", row.bench_case.target},
        {"config",
         {{"width", row.bench_case.view.width},
          {"height", row.bench_case.view.height},
          {"mode", name(row.mode)},
          {"strip_rows", row.strip_rows},
          {"strip_columns", row.strip_columns},
          {"frames", row.bench_case.frames}}},
        {"instructions_per_frame", nullptr},
        {"ns_per_frame", nullptr},
        {"ram_bytes", row.ram_bytes},
        {"flash_bytes", nullptr},
        {"frame_crc32", nlohmann::ordered_json::array()},
    };
    for (const std::uint32_t sum : row.frame_crc32) entry["frame_crc32"].push_back(fmt::format("{:08x}", sum));
    if (row.instructions_per_frame) entry["instructions_per_frame"] = *row.instructions_per_frame;
    if (row.nanoseconds_per_frame) entry["ns_per_frame"] = *row.nanoseconds_per_frame;
    if (row.flash_bytes) entry["flash_bytes"] = *row.flash_bytes;
    if (const Peer peer = best_peer(row.bench_case); !peer.name.empty()) {
      entry["best_peer"] = {{"name", peer.name}, {"instructions_per_frame", peer.million_instructions * 1e6}};
    }
    list.push_back(std::move(entry));
  }
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
