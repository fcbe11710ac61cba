// Draws the frames of a scene with the options, on one thread.
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

/// Opens the scene, with the requested edges, and with the tree of all its frames if the method needs one. Prints the
/// features that are missing in the picture.
Result<std::unique_ptr<Stage>> open_scene(const std::string& scene, const Drawing& drawing, std::uint32_t frames);

/// A frame and its report. `pixels` belong to the drawer, and are valid until the next frame.
struct DrawnFrame {
  FrameReport report;
  BusUse bus;
  View view;                          ///< of `pixels`
  std::span<const std::byte> pixels;  ///< of the strips, or of another Show
  std::optional<ShownFrame> shown;    ///< for a Show other than colour and accuracy
  std::optional<HeatMap> heat = {};   ///< for Show::accuracy
};

class SceneDrawer {
 public:
  /// `drawing` and `sets` (null: none) must outlive the drawer. Fails if the panel does not start.
  static Result<SceneDrawer> open(const Drawing& drawing, std::unique_ptr<Stage> stage, const VisibleSetFile* sets,
                                  unsigned strip_threads);

  Stage& stage() { return *stage_; }
  const Stage& stage() const { return *stage_; }
  const SimulatedPanel* panel() const { return panel_.get(); }

  /// Draws the result of stage().place(), perhaps with another camera.
  Result<DrawnFrame> draw(const Staging& staging, Show show);
  /// Encodes its pixels or, with a panel and colours, the picture on the panel's glass. Fails if the glass is dark.
  Result<std::vector<std::uint8_t>> encoded(ImageType type, const DrawnFrame& drawn) const;

 private:
  SceneDrawer(const Drawing& drawing, std::unique_ptr<Stage> stage, const VisibleSetFile* sets, unsigned strip_threads);

  const Drawing* drawing_;
  std::unique_ptr<Stage> stage_;
  const VisibleSetFile* sets_;
  std::unique_ptr<SimulatedPanel> panel_;  // or null
  FrameRenderer renderer_;
};

}  // namespace zstrip::sim
