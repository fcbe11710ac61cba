// How many frames a second a real board would draw: instructions as the emulated core executed them, cycles of a model.
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

/// Sent before each strip: column and row addresses and the command to write, as most controllers of colour displays
/// take them (MIPI DCS).
inline constexpr std::uint32_t kWindowBytes = 11;

struct PredictedFrame {
  Cycles begin;                 ///< begin_frame
  std::vector<Cycles> strips;   ///< draw_strip
  std::vector<double> sending;  ///< seconds
};

struct BoardPrediction {
  BoardModel board;
  std::uint32_t cores = 1;  ///< that draw
  Measurement measurement;
  InstructionMix mix;              ///< of all frames
  std::uint64_t instructions = 0;  ///< likewise
  Cycles core, flash;              ///< likewise
  std::vector<PredictedFrame> frames;
};

/// The case's target and budget are the board's own: arena and two strips of pixels (one without DMA) in its RAM; with
/// two cores an arena more and three strips. `cores`: that draw, up to the board's, with DMA.
/// `bench_case` brings workload, view, frames, strip rows and mode. Failures as those of profile_on_board().
Result<BoardPrediction> predict(const BoardModel& board, const BenchCase& bench_case, std::uint32_t cores,
                                const std::string& firmware);

/// The first frame, drawn as slowly as the model allows.
std::vector<StripTimes> slowest_timeline(const BoardPrediction& prediction);
/// Of all frames, the time of a picture from begin_frame to the end of its last transfer; seconds, a mean.
double frame_seconds(const BoardPrediction& prediction, bool slow);

/// For people: the prediction, the assumptions, and the first frame's timeline.
std::string prediction_text(const BoardPrediction& prediction);
/// An array with one object a prediction; the keys are documented in bench/README.md.
std::string prediction_json(std::span<const BoardPrediction> predictions);

}  // namespace zstrip::sim
