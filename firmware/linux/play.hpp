// Plays a scene on a display: frame after frame until enough of them were shown or a signal ends the program.
#pragma once

#include <cstdint>
#include <optional>

#include "any_display.hpp"
#include "exit_status.hpp"
#include "scene_file.hpp"
#include "stop_signals.hpp"

namespace zstrip::panel {

struct PlayOptions {
  std::uint32_t frames = 0;           ///< 0: until stopped
  std::uint32_t frames_per_turn = 1;  ///< at least 1; 1: the scene stands still
  double frames_per_second = 0;       ///< upper limit; 0: as many as the display takes
};

struct Played {
  std::uint32_t frames = 0;
  double seconds = 0;
};

/// Plays the scene. A frame that the display refuses is reported on standard error and drawn again; after ten refusals
/// in a row play() gives up. Returns none, or a failure: budget, input (the scene cannot be planned or drawn), output.
std::optional<Failure> play(SceneFile& scene, AnyDisplay& display, const PlayOptions& options, StopSignals& stop,
                            Played& played);

}  // namespace zstrip::panel
