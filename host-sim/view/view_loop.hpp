// The event loop of the window: input changes the drawing, and time selects the frame.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "result.hpp"
#include "view/viewer.hpp"
#include "view/watched_files.hpp"
#include "view/window.hpp"

namespace zstrip::sim {

struct ViewLoopOptions {
  std::uint32_t scale = 0;      ///< the window's pixels for one pixel of the picture; 0: the largest that fits
  bool watch = true;            ///< reload when a file of the scene changes
  bool playing = false;         ///< play from the first frame on
  std::vector<Input> inputs{};  ///< applied one after the other, each when the result of the one before is shown
};

/// Returns the help for mouse and keys, one line each.
std::vector<std::string> view_keys();

/// Runs until the window is closed. `files`: the scene's files, created before `viewer` read it. Fails if the first
/// frame cannot be drawn; later failures are printed, and the last picture stays.
Result<Done> run_view_loop(Viewer& viewer, Window& window, const std::string& scene, WatchedFiles files,
                           const ViewLoopOptions& options);

}  // namespace zstrip::sim
