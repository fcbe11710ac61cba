// What is told about a run, in words and as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/render_frame.hpp"
#include "zstrip/scene/view.hpp"

namespace zstrip::sim {

struct FrameRecord {
  std::string file;
  FrameReport report;
  std::optional<std::uint32_t> wrong{};  ///< pixels that the judge of visibility finds wrong, where it was asked
};

struct RunRecord {
  std::string scene;
  View view;
  std::vector<std::string> warnings;
  std::vector<FrameRecord> frames;
};

/// As the enumerators: "rgb565", "gray4" ...
const char* name(PixelFormat format);
/// "streamed", "binned".
const char* name(Mode mode);

/// Some lines for a person; at least one frame.
std::string summary(const RunRecord& run);

/// One JSON object with a line end; keys are documented in README.md.
std::string to_json(const RunRecord& run);

}  // namespace zstrip::sim
