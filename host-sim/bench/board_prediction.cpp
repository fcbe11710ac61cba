// Profiles the frames on the emulated core and applies the board's model to each region.
#include "bench/board_prediction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/execution_profile.hpp"
#include "text/number.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {
namespace {

double sending_seconds(const BoardModel& board, const Plan& shape, const View& view, std::uint16_t strip) {
  const Rect area = shape.strip_area(strip, view);
  const std::uint64_t bytes = kWindowBytes + static_cast<std::uint64_t>(area.height()) *
                                                 bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format);
  return static_cast<double>(8 * bytes) / (board.spi_mhz * 1e6);
}

Cycles cycles_of(const ProfiledCase& profiled, const ExecutedRegion& region, const BoardModel& board,
                 BoardPrediction& sums) {
  const Cycles core = core_cycles(profiled.profile, region, *find_core(board.core));
  const Cycles flash = flash_cycles(region, board.flash);
  sums.core += core;
  sums.flash += flash;
  sums.instructions += instruction_count(profiled.profile, region);
  sums.mix += mix_of(profiled.profile, region);
  return {core.low + flash.low, core.high + flash.high};
}

/// Explains a lack of memory by the board's RAM.
Failure with_board(const Failure& failure, const BoardModel& board, const BenchCase& bench_case, std::uint32_t cores) {
  if (failure.status != ExitStatus::budget) return failure;
  const std::string where = bench_case.budget.bytes != 0
                                ? "--ram allows no more"
                                : fmt::format("{} has {}, of which {} are for other variables and the stack{}",
                                              board.name, grouped(board.ram_bytes), grouped(kReservedRam),
                                              cores == 2 ? ", and each of two cores has half of the others" : "");
  return {failure.status, fmt::format("{}: {}", failure.message, where)};
}

}  // namespace

Result<BoardPrediction> predict(const BoardModel& board, const BenchCase& bench_case, std::uint32_t cores,
                                const std::string& firmware) {
  BenchCase on_board = bench_case;
  on_board.target = board.target;
  // Each of two cores gets half. Three buffers of pixels fit, because they need less than four.
  if (on_board.budget.bytes == 0) on_board.budget.bytes = (board.ram_bytes - kReservedRam) / cores;
  on_board.budget.strip_buffers = board.dma ? 2 : 1;
  // Data that a strip keeps in the bins for the next strip are lost if the other core draws the next strip.
  on_board.in_turns = cores == 2 && on_board.budget.modes == Modes::binned;
  const Result<ProfiledCase> profiled = profile_on_board(on_board, board.flash.cache, firmware);
  if (!profiled) return with_board(profiled.failure(), board, bench_case, cores);

  const Measurement& measured = profiled->measurement;
  const View& view = on_board.view;
  Plan shape;
  shape.strip_rows = measured.strip_rows;
  shape.strip_columns = measured.strip_columns;
  const std::size_t strips = shape.columns_of_strips(view) * shape.rows_of_strips(view);
  const std::vector<ExecutedRegion>& regions = profiled->profile.regions;
  if (regions.size() != on_board.frames * (1 + strips)) {
    return Failure{ExitStatus::internal, fmt::format("{} regions were counted in {} frames of {} strips",
                                                     regions.size(), on_board.frames, strips)};
  }
  BoardPrediction prediction{
      .board = board, .cores = cores, .measurement = measured, .mix{}, .core{}, .flash{}, .frames{}};
  auto region = regions.begin();
  for (std::uint32_t i = 0; i < on_board.frames; ++i) {
    PredictedFrame frame;
    frame.begin = cycles_of(*profiled, *region++, board, prediction);
    frame.strips.resize(strips);
    const std::size_t step = on_board.in_turns ? 2 : 1;
    for (std::size_t first = 0; first < step; ++first) {
      for (std::size_t strip = first; strip < strips; strip += step) {
        frame.strips[strip] = cycles_of(*profiled, *region++, board, prediction);
      }
    }
    for (std::uint16_t strip = 0; strip < strips; ++strip) {
      frame.sending.push_back(sending_seconds(board, shape, view, strip));
    }
    prediction.frames.push_back(std::move(frame));
  }
  return prediction;
}

namespace {

std::vector<StripTimes> timeline(const BoardPrediction& prediction, const PredictedFrame& frame, bool slow) {
  const BoardModel& board = prediction.board;
  const auto seconds = [&](const Cycles& cycles) { return (slow ? cycles.high : cycles.low) / (board.core_mhz * 1e6); };
  std::vector<StripWork> work;
  for (std::size_t i = 0; i < frame.strips.size(); ++i) work.push_back({seconds(frame.strips[i]), frame.sending[i]});
  if (prediction.cores == 2) return two_core_timeline(seconds(frame.begin), work);
  return strip_timeline(seconds(frame.begin), work, board.dma);
}

}  // namespace

std::vector<StripTimes> slowest_timeline(const BoardPrediction& prediction) {
  return timeline(prediction, prediction.frames.front(), true);
}

double frame_seconds(const BoardPrediction& prediction, bool slow) {
  double sum = 0;
  for (const PredictedFrame& frame : prediction.frames) sum += timeline(prediction, frame, slow).back().send_end;
  return sum / static_cast<double>(prediction.frames.size());
}

}  // namespace zstrip::sim
