// The frames that every target draws.
#pragma once

#include <cstdint>

#include "picture_summary.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"
#include "zstrip_scenes/built_in.hpp"

namespace zstrip::targets {

enum class Motion : std::uint8_t {
  turntable,  ///< scenes::stage, kFramesPerTurn frames a turn
  workload,   ///< scenes::stage_workload
};

inline constexpr std::uint32_t kFramesPerTurn = 100;

struct Case;

/// A built-in scene with the renderer for exactly its effects.
struct Subject {
  const scenes::BuiltIn* built_in;
  Status (*draw)(const Case&, PictureSummary&);
  const char* depth = "";  ///< how the renderer keeps depth if not as z16: with an underscore before it
};

/// Frames of one scene; its name in the table is made of all of this.
struct Case {
  const Subject* subject;
  Motion motion;
  View view;
  std::uint16_t strip_rows;  ///< 0: the whole picture is one strip
  std::uint32_t first_frame;
  std::uint32_t frames;
};

/// Calls `run(case)` for every case, always in the same order, until it returns false. Returns what it returned last.
bool for_each_case(bool (*run)(const Case&));

}  // namespace zstrip::targets
