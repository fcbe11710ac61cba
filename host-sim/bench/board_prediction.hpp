// Predicts the frames a second of a real board: instructions from the emulated core, cycles from a model.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/board_model.hpp"
#include "bench/measurement.hpp"
#include "bench/strip_timeline.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Sent before each strip: column and row addresses and the write command of most colour display controllers (MIPI
/// DCS).
inline constexpr std::uint32_t kWindowBytes = 11;

struct PredictedFrame {
  Cycles begin;                 ///< begin_frame
  std::vector<Cycles> strips;   ///< draw_strip
  std::vector<double> sending;  ///< seconds
};

struct BoardPrediction {
  BoardModel board;
  std::uint32_t cores = 1;  ///< number of cores that draw
  Measurement measurement;
  InstructionMix mix;              ///< of all frames
  std::uint64_t instructions = 0;  ///< of all frames
  Cycles core, flash;              ///< of all frames
  std::vector<PredictedFrame> frames;
};

/// Target and budget are those of the board: arena and two strips of pixels (one without DMA) in its RAM; with two
/// cores one more arena, and three strips. `cores`: number of cores that draw, up to the board's, with DMA.
/// `bench_case` has workload, view, frames, strip rows and mode. Failures: those of profile_on_board().
Result<BoardPrediction> predict(const BoardModel& board, const BenchCase& bench_case, std::uint32_t cores,
                                const std::string& firmware);

/// Returns the first frame, with the slowest times of the model.
std::vector<StripTimes> slowest_timeline(const BoardPrediction& prediction);
/// Returns the time of a picture from begin_frame to the end of its last transfer; seconds, the mean of all frames.
double frame_seconds(const BoardPrediction& prediction, bool slow);

/// Returns text for the user: the prediction, the assumptions, and the first frame's timeline.
std::string prediction_text(const BoardPrediction& prediction);
/// Returns an array with one object for each prediction; bench/README.md documents the keys.
std::string prediction_json(std::span<const BoardPrediction> predictions);

}  // namespace zstrip::sim
