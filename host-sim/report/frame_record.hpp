// The record of a run, in words and as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/heat_map.hpp"
#include "render/pick_pixel.hpp"
#include "render/render_frame.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The work of a simulated panel's bus for a frame.
struct BusUse {
  std::uint64_t bytes = 0;
  std::int64_t nanoseconds = 0;
};

struct FrameRecord {
  std::string file;
  FrameReport report;
  BusUse bus{};                          ///< only with a panel
  std::optional<std::uint32_t> wrong{};  ///< pixels that the judge of visibility finds wrong, where it was used
  std::optional<HeatFigures> heat{};     ///< against the truth, where that was drawn
  std::optional<PickedPixel> picked{};   ///< of --pick
};

/// The panel of a run, in words.
struct PanelRecord {
  std::string name;
  std::string bus;   ///< "SPI at 40 MHz"
  int rotation = 0;  ///< degrees, clockwise
  bool mirrored = false;
  bool changes = false;  ///< only what changed is sent
};

struct RunRecord {
  std::string scene;
  View view;
  std::vector<std::string> warnings;
  std::vector<FrameRecord> frames;
  std::optional<PanelRecord> panel{};
};

/// Returns "mono", or "mono dithered, 4 samples a pixel".
std::string format_words(const View& view);
/// Returns "streamed" or "binned".
const char* name(Mode mode);

/// Returns some lines for a person. The run must have at least one frame.
std::string summary(const RunRecord& run);

/// One JSON object with a line end; keys are documented in README.md.
std::string to_json(const RunRecord& run);

}  // namespace zstrip::sim
