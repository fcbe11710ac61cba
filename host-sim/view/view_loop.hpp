// The life of the window: what a person does changes what is drawn, time changes what is shown.
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
  std::uint32_t scale = 0;      ///< window's pixels for one of the picture; 0: as fits
  bool watch = true;            ///< reload when a file of the scene changes
  bool playing = false;         ///< from the first frame on
  std::vector<Input> inputs{};  ///< happen one after the other, each when the one before is shown
};

/// What the mouse and the keys do, a line each.
std::vector<std::string> view_keys();

/// Until the window is closed. `files`: of the scene, made before `viewer` read it. Fails where the first frame cannot
/// be drawn; later failures are printed, and the last picture stays.
Result<Done> run_view_loop(Viewer& viewer, Window& window, const std::string& scene, WatchedFiles files,
                           const ViewLoopOptions& options);

}  // namespace zstrip::sim
