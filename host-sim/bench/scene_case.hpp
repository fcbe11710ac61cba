// Makes a case of the benchmark from a scene of the user: a model or scene file, which is baked for a board, or a blob.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bench/board_model.hpp"
#include "bench/measurement.hpp"
#include "cli/bake_command.hpp"
#include "image/temporary_file.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// A blob for a board, and the case that draws it.
struct SceneCase {
  BenchCase bench_case;
  std::unique_ptr<TemporaryFile> baked{};  ///< the blob, unless the user has named one
};

/// `bake`: the scene and the options of its bake; `bake.output` is not used, and without `bake.plan.memory.ram` the
/// board's RAM is the limit, of which each of `cores` gets its share. A blob is drawn as it is. The plan is that of
/// `zstrip bake`. Failures: those of baking; usage errors for scenes that the boards' program does not draw.
Result<SceneCase> scene_case(const BakeArguments& bake, const BoardModel& board, std::uint32_t cores,
                             std::uint32_t frames);

}  // namespace zstrip::sim
