// Predictions as text with a timeline, and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/board_prediction.hpp"
#include "report/frame_record.hpp"

namespace zstrip::sim {
namespace {

constexpr int kTimelineColumns = 72;

/// Returns the bytes of the arenas and of all buffers of a strip's pixels.
std::uint64_t ram_bytes(const BoardPrediction& p) {
  const Measurement& m = p.measurement;
  const std::uint64_t strip = m.strip_rows * bytes_per_row(m.strip_columns, m.bench_case.view.format);
  return p.cores * m.ram_bytes + (p.board.dma ? strip : 0);  // the measurement includes one buffer
}

double milliseconds(double seconds) { return 1e3 * seconds; }

std::string assumptions(const BoardPrediction& p) {
  const BoardModel& board = p.board;
  std::string text = fmt::format("  core: {} at {} MHz; cycles of each instruction: {}\n", find_core(board.core)->name,
                                 board.core_mhz, find_core(board.core)->source);
  text +=
      fmt::format("  flash: {}, {} wait states; code and constants lie there, all else in RAM without wait states\n",
                  board.flash.description, board.flash.wait_states);
  text += fmt::format(
      "  bus: SPI at {} MHz, {}; {} bytes of window commands a strip are in it, the panel's own limit is not\n",
      board.spi_mhz,
      board.dma ? "DMA sends one strip while the next is drawn" : "no DMA: the core waits for each strip",
      kWindowBytes);
  text += fmt::format("  not in it: interrupts, preparing the next frame, {} taking turns at the RAM{}\n",
                      p.cores == 1 ? "DMA and core" : "DMA and both cores",
                      p.cores == 1 ? "" : " and the flash, whose cache each has for itself here");
  return text;
}

/// Returns "3.1", or "3.1 to 4.5" if they differ.
std::string range(double low, double high, int decimals) {
  const std::string first = fmt::format("{:.{}f}", low, decimals), last = fmt::format("{:.{}f}", high, decimals);
  return first == last ? first : first + " to " + last;
}

std::string mix_text(const BoardPrediction& p) {
  constexpr std::size_t kMaxColumns = 100;
  const auto frames = static_cast<double>(p.frames.size());
  std::string text = "  instructions a frame by class:\n", line;
  for (std::size_t i = 0; i < p.mix.count.size(); ++i) {
    if (p.mix.count[i] == 0) continue;
    std::string part =
        fmt::format(" {} {:.0f}", kInstructionClassNames[i], static_cast<double>(p.mix.count[i]) / frames);
    if (kInstructionClassNames[i] == "branch") {
      part += fmt::format(" (taken {:.0f})", static_cast<double>(p.mix.taken) / frames);
    }
    if (line.size() + part.size() > kMaxColumns) {
      text += "   " + line + '\n';
      line.clear();
    }
    line += part + ',';
  }
  line.pop_back();
  return text + "   " + line + '\n';
}

/// Draws `mark` from `begin` to `end`, at least one column if the time is not 0.
void draw_bar(std::string& line, double begin, double end, double scale, char mark) {
  const auto column = [scale](double seconds) { return static_cast<std::size_t>(std::lround(seconds * scale)); };
  if (end <= begin) return;
  const std::size_t first = std::min(column(begin), line.size() - 1);
  const std::size_t last = std::min(std::max(column(end), first + 1), line.size());
  std::fill(line.begin() + static_cast<std::ptrdiff_t>(first), line.begin() + static_cast<std::ptrdiff_t>(last), mark);
}

std::string timeline_text(const BoardPrediction& p) {
  const std::vector<StripTimes> times = slowest_timeline(p);
  const double scale = kTimelineColumns / times.back().send_end;
  std::string text =
      fmt::format("  first frame at its slowest; # draws, = sends, a column is {:.2f} ms\n", 1e3 / scale);
  const auto add = [&text](const std::string& name, const std::string& draw, const std::string& send) {
    text += fmt::format("  {:>9} |{}|\n  {:>9} |{}|\n", name, draw, "", send);
  };
  std::string line(kTimelineColumns, ' ');
  draw_bar(line, 0, times.front().draw_begin, scale, '#');
  text += fmt::format("  {:>9} |{}|\n", "begin", line);
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::string draw(kTimelineColumns, ' '), send(kTimelineColumns, ' ');
    draw_bar(draw, times[i].draw_begin, times[i].draw_end, scale, '#');
    draw_bar(send, times[i].send_begin, times[i].send_end, scale, '=');
    add(fmt::format("strip {}", i), draw, send);
  }
  return text;
}

}  // namespace

std::string prediction_text(const BoardPrediction& p) {
  const Measurement& m = p.measurement;
  const double fast = frame_seconds(p, false), slow = frame_seconds(p, true);
  const auto frames = static_cast<double>(p.frames.size());
  double bus = 0;
  for (const double seconds : p.frames.front().sending) bus += seconds;
  const double cycles_a_ms = 1e3 * p.board.core_mhz * frames;  // summed over all frames, for 1 ms of each frame
  std::string text = fmt::format("{} on {} ({}{}): {} frames a second predicted\n", m.bench_case.workload, p.board.name,
                                 p.board.description, p.cores == 2 ? ", both cores" : "", range(1 / slow, 1 / fast, 1));
  text += fmt::format("  picture: {}x{} {}, {} strips of {} rows, {}; arena and pixels {} of {} bytes of RAM\n",
                      m.bench_case.view.width, m.bench_case.view.height, format_words(m.bench_case.view),
                      p.frames.front().strips.size(), m.strip_rows, name(m.mode), ram_bytes(p), p.board.ram_bytes);
  text += fmt::format("  frame: {} ms; drawing {} ms, sending {:.1f} ms, mean of {} frames\n",
                      range(milliseconds(fast), milliseconds(slow), 1),
                      range((p.core.low + p.flash.low) / cycles_a_ms, (p.core.high + p.flash.high) / cycles_a_ms, 1),
                      milliseconds(bus), p.frames.size());
  text += fmt::format("  cycles a frame: {:.0f} instructions take {}, the flash {} more\n",
                      static_cast<double>(p.instructions) / frames, range(p.core.low / frames, p.core.high / frames, 0),
                      range(p.flash.low / frames, p.flash.high / frames, 0));
  return text + mix_text(p) + assumptions(p) + timeline_text(p);
}

std::string prediction_json(std::span<const BoardPrediction> predictions) {
  using Json = nlohmann::ordered_json;
  const auto bounds = [](const Cycles& cycles, double divisor) {
    return Json::array({cycles.low / divisor, cycles.high / divisor});
  };
  Json list = Json::array();
  for (const BoardPrediction& p : predictions) {
    const auto frames = static_cast<double>(p.frames.size());
    Json mix;
    for (std::size_t i = 0; i < p.mix.count.size(); ++i) {
      mix[std::string(kInstructionClassNames[i])] = static_cast<double>(p.mix.count[i]) / frames;
    }
    mix["branch_taken"] = static_cast<double>(p.mix.taken) / frames;
    Json strips = Json::array();
    for (const StripTimes& t : slowest_timeline(p)) {
      strips.push_back(
          {{"draw_ms", {1e3 * t.draw_begin, 1e3 * t.draw_end}}, {"send_ms", {1e3 * t.send_begin, 1e3 * t.send_end}}});
    }
    const Measurement& m = p.measurement;
    list.push_back({{"board", p.board.name},
                    {"workload", m.bench_case.workload},
                    {"config",
                     {{"width", m.bench_case.view.width},
                      {"height", m.bench_case.view.height},
                      {"mode", name(m.mode)},
                      {"strip_rows", m.strip_rows},
                      {"strips", p.frames.front().strips.size()},
                      {"frames", p.frames.size()}}},
                    {"ram_bytes", ram_bytes(p)},
                    {"assumptions",
                     {{"core", p.board.core},
                      {"cores", p.cores},
                      {"timings", find_core(p.board.core)->source},
                      {"core_mhz", p.board.core_mhz},
                      {"flash", p.board.flash.description},
                      {"wait_states", p.board.flash.wait_states},
                      {"spi_mhz", p.board.spi_mhz},
                      {"dma", p.board.dma}}},
                    {"frames_per_second", {1 / frame_seconds(p, true), 1 / frame_seconds(p, false)}},
                    {"instructions_per_frame", static_cast<double>(p.instructions) / frames},
                    {"instruction_mix", mix},
                    {"core_cycles_per_frame", bounds(p.core, frames)},
                    {"flash_cycles_per_frame", bounds(p.flash, frames)},
                    {"first_frame_slowest", strips}});
  }
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
