// The summary of a run in words.
#include <fmt/format.h>

#include <algorithm>

#include "report/frame_record.hpp"
#include "report/plan_words.hpp"
#include "text/number.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

/// "1,234", or "1,000 to 2,000" where frames differ.
template <typename Value>
std::string range(const RunRecord& run, Value value) {
  const auto [low, high] = std::minmax_element(
      run.frames.begin(), run.frames.end(),
      [&](const FrameRecord& a, const FrameRecord& b) { return value(a.report) < value(b.report); });
  const std::uint64_t least = value(low->report);
  const std::uint64_t most = value(high->report);
  return least == most ? grouped(least) : fmt::format("{} to {}", grouped(least), grouped(most));
}

/// Returns the time of the bus for a frame, and how many frames a second it allows at most.
std::string panel(const RunRecord& run) {
  // If only changes are sent, the first frame is sent whole, and the others tell the speed.
  const std::span frames(run.frames);
  const BusUse& most = std::ranges::max_element(frames.subspan(run.panel->changes && frames.size() > 1 ? 1 : 0), {},
                                                [](const FrameRecord& frame) { return frame.bus.nanoseconds; })
                           ->bus;
  const double milliseconds = 1e-6 * static_cast<double>(most.nanoseconds);
  return fmt::format("{}{}{}, {}: {} in {:.2f} ms a frame, at most {:.1f} frames/s", run.panel->name,
                     run.panel->rotation != 0 ? fmt::format(" rotated by {}", run.panel->rotation) : "",
                     run.panel->mirrored ? " mirrored" : "", run.panel->bus, counted(most.bytes, "byte"), milliseconds,
                     1e3 / milliseconds);
}

std::string bounds(const RunRecord& run) {
  Rect all;
  for (const FrameRecord& frame : run.frames) {
    const Rect& rect = frame.report.bounds;
    if (rect.empty()) continue;
    if (all.empty()) all = rect;
    all = {std::min(all.left, rect.left), std::min(all.top, rect.top), std::max(all.right, rect.right),
           std::max(all.bottom, rect.bottom)};
  }
  if (all.empty()) return "nothing of the scene is in the picture";
  return fmt::format("x {} to {}, y {} to {} ({}x{} pixels)", all.left, all.right - 1, all.top, all.bottom - 1,
                     all.width(), all.height());
}

/// Describes the frame with the worst pixel.
std::string heat_words(const RunRecord& run) {
  const FrameRecord& worst = *std::ranges::max_element(
      run.frames, {}, [](const FrameRecord& frame) { return frame.heat ? frame.heat->worst : 0; });
  return in_words(*worst.heat);
}

}  // namespace

std::string summary(const RunRecord& run) {
  const FrameReport& first = run.frames.front().report;
  const FrameReport& fullest =
      std::max_element(run.frames.begin(), run.frames.end(), [](const FrameRecord& a, const FrameRecord& b) {
        return a.report.plan.bytes() < b.report.plan.bytes();
      })->report;
  std::int64_t nanoseconds = 0;
  for (const FrameRecord& frame : run.frames) nanoseconds += frame.report.nanoseconds;
  const double milliseconds = 1e-6 * static_cast<double>(nanoseconds) / static_cast<double>(run.frames.size());

  std::string text = fmt::format("{}: {} of {}x{}, {}\n", printable(run.scene), counted(run.frames.size(), "frame"),
                                 run.view.width, run.view.height, format_words(run.view));
  text += fmt::format("  triangles  {}, of which drawn {}\n", grouped(first.statistics.triangles),
                      range(run, [](const FrameReport& report) { return report.statistics.drawn; }));
  text += fmt::format("  fragments  {}, of which passed the depth test {}\n",
                      range(run, [](const FrameReport& report) { return report.statistics.fragments; }),
                      range(run, [](const FrameReport& report) { return report.statistics.depth_passes; }));
  text += fmt::format("  bounds     {}\n", bounds(run));
  text += fmt::format("  strips     {} of {}{}, {}\n", fullest.plan.strips, counted(fullest.plan.strip_rows, "row"),
                      fullest.plan.strip_columns < run.view.width
                          ? fmt::format(" and {}", counted(fullest.plan.strip_columns, "column"))
                          : "",
                      name(fullest.plan.mode));
  text += fmt::format("  RAM        {}\n", memory(fullest.plan, fullest.strip_pixel_bytes, fullest.method));
  if (first.method.methods != 0) {
    text += fmt::format("  visibility {}: {} comparisons of depth, {} writes\n", visibility_name(first.method),
                        range(run, [](const FrameReport& report) { return report.visibility.comparisons; }),
                        range(run, [](const FrameReport& report) { return report.visibility.writes; }));
  }
  if (run.frames.front().wrong) {
    std::uint64_t wrong = 0;
    for (const FrameRecord& frame : run.frames) wrong += frame.wrong.value_or(0);
    text += fmt::format("  wrong      {}\n", counted(wrong, "pixel"));
  }
  if (run.frames.front().heat) text += fmt::format("  differs    {}\n", heat_words(run));
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    if (!run.frames[i].picked) continue;
    const PickedPixel& pixel = *run.frames[i].picked;
    text += fmt::format("  picked     {}{},{}: {}\n", run.frames.size() > 1 ? fmt::format("frame {}, ", i + 1) : "",
                        pixel.place.x, pixel.place.y, words_of(pixel));
  }
  text += fmt::format("  time       {:.2f} ms a frame\n", milliseconds);
  if (run.panel) text += fmt::format("  panel      {}\n", panel(run));
  text += run.frames.front().file == run.frames.back().file
              ? fmt::format("  written    {}\n", printable(run.frames.front().file))
              : fmt::format("  written    {} to {}\n", printable(run.frames.front().file),
                            printable(run.frames.back().file));
  return text;
}

}  // namespace zstrip::sim
