// Passes baked scenes to the boards' program that has only their pipeline.
#include "accuracy/board_cost.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "bake/scene_blob.hpp"
#include "bench/board_bench.hpp"
#include "bench/board_prediction.hpp"
#include "image/temporary_file.hpp"
#include "image/write_file.hpp"

namespace zstrip::sim {

std::string_view board_of(std::string_view target) {
  if (target == "m0") return "microbit";
  return target == "m3" ? "bluepill" : "blackpill";
}

std::string board_program_name(std::string_view target, Effects effects) {
  return fmt::format("zstrip_scene_{}_{:014x}", target, effects.bits);
}

Result<Done> measure_on_board(const AccuracyRequest& request, const std::vector<Staging>& staged, const View& view,
                              Effects effects, const Budget& budget, Cost& cost) {
  const BoardModel& board = *find_board(board_of(request.target));
  std::uint64_t instructions = 0;
  double slow = 0, fast = 0;
  bool fits = true;
  for (const Staging& pose : staged) {
    const Result<std::vector<std::uint8_t>> blob = to_scene_blob({pose.scene, pose.camera, view, {}});
    if (!blob) return blob.failure();
    const TemporaryFile file("zstrip_accuracy", ".zsc");
    if (const Result<Done> written = write_file(file.path(), *blob, "TMPDIR"); !written) return written.failure();
    BenchCase bench_case{.workload = request.scene,
                         .target = request.target,
                         .view = view,
                         .budget = budget,
                         .frames = 1,
                         .program = board_program_name(request.target, effects),
                         .scene_file = file.path()};
    // The given strips are used; other code checks if they fit the board.
    if (fits && cost.ram_bytes <= board.ram_bytes - kReservedRam) {
      const Result<BoardPrediction> predicted = predict(board, bench_case, 1, request.firmware);
      if (predicted) {
        instructions += predicted->instructions;
        slow += frame_seconds(*predicted, true);
        fast += frame_seconds(*predicted, false);
        cost.program_bytes = predicted->measurement.flash_bytes;
        continue;
      }
      if (predicted.failure().status != ExitStatus::budget) return predicted.failure();
    }
    fits = false;
    const Result<std::filesystem::path> program = board_program(bench_case, request.firmware);
    if (!program) return program.failure();
    const Result<Measurement> measured = bench_on_board(bench_case, *program, {});
    if (!measured) return measured.failure();
    instructions += *measured->instructions_per_frame;
    cost.program_bytes = measured->flash_bytes;
  }
  cost.instructions = instructions / staged.size();
  if (fits) {
    cost.least_fps = static_cast<double>(staged.size()) / slow;
    cost.most_fps = static_cast<double>(staged.size()) / fast;
  }
  return Done{};
}

}  // namespace zstrip::sim
