// What a frame takes on a Cortex-M3, estimated from what it did on this machine.
#pragma once

#include <cstdint>

#include "zstrip/base/statistics.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Instructions of begin_frame and all strips. `effects`: of the scene and of the view. Fitted to the workloads of
/// `zstrip bench` in strips of 8 to 480 rows, 97 % of which are within 15 % (docs/performance.md,
/// "Estimates"); effects that none of them has are not in it, but for samples.
std::uint64_t estimated_instructions(const SceneCounts& counts, Effects effects, const Statistics& done,
                                     const View& view, const Plan& plan);

}  // namespace zstrip::sim
