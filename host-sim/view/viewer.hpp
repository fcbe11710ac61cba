// The state of the view: frame, camera, look, and the cost of the frame on a device.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/heat_map.hpp"
#include "bench/board_estimate.hpp"
#include "bench/board_model.hpp"
#include "bench/strip_timeline.hpp"
#include "cli/drawing_arguments.hpp"
#include "cli/scene_drawer.hpp"
#include "image/rgb_image.hpp"
#include "render/pick_pixel.hpp"
#include "result.hpp"
#include "view/look.hpp"
#include "view/orbiting.hpp"

namespace zstrip::sim {

/// The request for a view.
struct ViewRequest {
  DrawingArguments drawing;
  std::uint32_t frames = 64;          ///< of the animation, or of a rotation
  bool smooth = false;                ///< use more frames if an animation would have less than 30 a second
  const BoardModel* board = nullptr;  ///< the board whose speed is shown, or null
  double bus_mhz = 0;                 ///< of that board's SPI
};

/// A frame, and its cost on a device.
struct ViewedFrame {
  RgbImage picture;
  std::vector<std::uint8_t> png;  ///< the file that `zstrip render` writes, if asked for
  FrameReport report;
  std::vector<Rect> strips;           ///< in the picture's pixels; empty on a panel that rotates or mirrors them
  std::vector<StripTimes> times;      ///< of each strip; only with a board
  std::uint64_t flash_bytes = 0;      ///< of the scene, without the program
  std::uint64_t instructions = 0;     ///< approximately, on a Cortex-M3
  std::vector<std::string> left_out;  ///< effects whose instructions are not included
  std::vector<BoardRate> rates;       ///< of all boards
  std::optional<HeatFigures> heat;    ///< for Look::accuracy
  std::vector<std::string> text;      ///< lines for the user
};

/// Not thread-safe.
class Viewer {
 public:
  /// Reads the scene. Failures: those of `zstrip render`.
  static Result<Viewer> open(const ViewRequest& request);
  /// Reads the scene again; after a failure the old scene is kept.
  Result<Done> reload();

  /// Moves by so many frames, and wraps at the end.
  void step(std::int64_t frames);
  /// Rotates by degrees about the scene, as in Orbiting.
  void turn(double yaw, double pitch);
  /// Positive: closer.
  void zoom(double steps);
  /// Resets to the scene's own camera.
  void reset_camera() { orbiting_ = {}; }
  /// Returns the selected look.
  Look look() const { return look_; }
  void toggle(Look look) { look_ = look_ == look ? Look::colour : look; }

  std::uint32_t frame() const { return frame_; }
  std::uint32_t frames() const { return frames_; }
  /// True if the scene has an animation; a rotation of the whole scene does not count.
  bool moves() const;
  /// Returns the duration of the animation, or of a rotation.
  std::uint32_t milliseconds() const { return milliseconds_of(drawer_->stage()); }

  /// Says what a pixel of the picture shows, in words: "instance 2 (wheel), triangle 31". Failures: those of `zstrip
  /// render --pick`, and on a panel that rotates or mirrors its picture.
  Result<std::string> pick(PixelPlace pixel);

  /// `with_png`: also the file, which takes as long as some pictures.
  Result<ViewedFrame> draw(bool with_png = true);

 private:
  explicit Viewer(const ViewRequest& request) : request_(request) {}
  /// Returns the frame as the user's camera sees it.
  Result<Staging> placed();
  std::vector<std::string> text(const ViewedFrame& viewed) const;

  ViewRequest request_;
  std::unique_ptr<Drawing> drawing_;  // on the heap, because the drawer refers to it
  std::unique_ptr<VisibleSetFile> sets_;
  std::optional<SceneDrawer> drawer_;
  std::uint32_t frame_ = 0, frames_ = 1;
  Orbiting orbiting_;
  Look look_ = Look::colour;
};

}  // namespace zstrip::sim
