// What is looked at: which frame, from where, as what, and what a device would take for it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/heat_map.hpp"
#include "bench/board_model.hpp"
#include "bench/strip_timeline.hpp"
#include "cli/drawing_arguments.hpp"
#include "cli/scene_drawer.hpp"
#include "image/rgb_image.hpp"
#include "result.hpp"
#include "view/look.hpp"
#include "view/orbiting.hpp"

namespace zstrip::sim {

/// What the window is to show.
struct ViewRequest {
  DrawingArguments drawing;
  std::uint32_t frames = 64;          ///< of the animation, or of a turn
  bool smooth = false;                ///< more frames where an animation would have less than 30 a second
  const BoardModel* board = nullptr;  ///< whose speed is shown; or none
  double bus_mhz = 0;                 ///< of that board's SPI
};

/// About how many frames a board shows in a second, by its own bus.
struct BoardRate {
  std::string_view board;
  double frames;
};

/// A frame, and how a device would come to it.
struct ViewedFrame {
  RgbImage picture;
  std::vector<std::uint8_t> png;  ///< the file that `zstrip render` writes
  FrameReport report;
  std::vector<Rect> strips;           ///< in the picture's pixels; empty on a panel that turns or mirrors them
  std::vector<StripTimes> times;      ///< of each strip; only with a board
  std::uint64_t flash_bytes = 0;      ///< of the scene, without the program
  std::uint64_t instructions = 0;     ///< about, on a Cortex-M3
  std::vector<std::string> left_out;  ///< effects whose instructions are not among them
  std::vector<BoardRate> rates;       ///< of all boards
  std::optional<HeatFigures> heat;    ///< of Look::accuracy
  std::vector<std::string> text;      ///< lines for people
};

/// Not thread-safe.
class Viewer {
 public:
  /// Reads the scene. Failures as of `zstrip render`.
  static Result<Viewer> open(const ViewRequest& request);
  /// Reads the scene again; after a failure the old one is still there.
  Result<Done> reload();

  /// By so many frames, around the end.
  void step(std::int64_t frames);
  /// Degrees about the scene, as Orbiting has them.
  void turn(double yaw, double pitch);
  /// Positive: closer.
  void zoom(double steps);
  /// Back to the scene's own camera.
  void reset_camera() { orbiting_ = {}; }
  /// `look`, or colour if that is how it is looked at.
  Look look() const { return look_; }
  void toggle(Look look) { look_ = look_ == look ? Look::colour : look; }

  std::uint32_t frame() const { return frame_; }
  std::uint32_t frames() const { return frames_; }
  /// Whether anything moves by itself; a turn does not.
  bool moves() const;
  /// Of the animation, or of a turn.
  std::uint32_t milliseconds() const { return milliseconds_of(drawer_->stage()); }

  Result<ViewedFrame> draw();

 private:
  explicit Viewer(const ViewRequest& request) : request_(request) {}
  std::vector<std::string> text(const ViewedFrame& viewed) const;

  ViewRequest request_;
  std::unique_ptr<Drawing> drawing_;  // stays where it is: the drawer refers to it
  std::unique_ptr<VisibleSetFile> sets_;
  std::optional<SceneDrawer> drawer_;
  std::uint32_t frame_ = 0, frames_ = 1;
  Orbiting orbiting_;
  Look look_ = Look::colour;
};

}  // namespace zstrip::sim
