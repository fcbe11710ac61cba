// Draws the frames of a scene as the options ask, on one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "accuracy/heat_map.hpp"
#include "cli/drawing_arguments.hpp"
#include "image/encode.hpp"
#include "panel/simulated_panel.hpp"
#include "render/render_frame.hpp"
#include "render/stage.hpp"
#include "report/frame_record.hpp"
#include "result.hpp"
#include "visibility/show.hpp"
#include "visibility/visible_set_file.hpp"

namespace zstrip::sim {

/// The scene, with edges as asked for, and with the tree of all its frames where the method wants one. What the picture
/// lacks is printed.
Result<std::unique_ptr<Stage>> open_scene(const std::string& scene, const Drawing& drawing, std::uint32_t frames);

/// A frame, and what it took. `pixels` are the drawer's, until the next frame.
struct DrawnFrame {
  FrameReport report;
  BusUse bus;
  View view;                          ///< of `pixels`
  std::span<const std::byte> pixels;  ///< of the strips, or those of another Show
  std::optional<ShownFrame> shown;    ///< of another Show than colour and accuracy
  std::optional<HeatMap> heat = {};   ///< of Show::accuracy
};

class SceneDrawer {
 public:
  /// `drawing` and `sets` (null: none) must outlive the drawer. Fails where the panel does not start.
  static Result<SceneDrawer> open(const Drawing& drawing, std::unique_ptr<Stage> stage, const VisibleSetFile* sets,
                                  unsigned strip_threads);

  Stage& stage() { return *stage_; }
  const Stage& stage() const { return *stage_; }
  const SimulatedPanel* panel() const { return panel_.get(); }

  /// What stage().place() gave, perhaps with another camera.
  Result<DrawnFrame> draw(const Staging& staging, Show show);
  /// Of its pixels or, with a panel and colours, what is seen on its glass. Fails where the glass is dark.
  Result<std::vector<std::uint8_t>> encoded(ImageType type, const DrawnFrame& drawn) const;

 private:
  SceneDrawer(const Drawing& drawing, std::unique_ptr<Stage> stage, const VisibleSetFile* sets, unsigned strip_threads);

  const Drawing* drawing_;
  std::unique_ptr<Stage> stage_;
  const VisibleSetFile* sets_;
  std::unique_ptr<SimulatedPanel> panel_;  // or none
  FrameRenderer renderer_;
};

}  // namespace zstrip::sim
