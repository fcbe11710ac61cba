// Finds the cheapest settings within limits of error, memory and time.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/journal.hpp"
#include "accuracy/measure.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct Limits {
  std::optional<double> wrong_pixels{};  ///< %, of the pixels that the truth covers
  std::optional<double> perceived{};     ///< CIELAB
  std::optional<std::uint32_t> ram{};    ///< bytes, arena and one strip of pixels
  std::optional<std::uint32_t> flash{};  ///< bytes of the scene
  std::optional<double> frames{};        ///< frames a second, minimum; on boards the minimum that is predicted
};

/// Returns the minimum of a point's frames a second; nothing if the board has too little RAM.
std::optional<double> frames_per_second(const AccuracyPoint& point);

struct Tuned {
  std::optional<AccuracyPoint> best;  ///< nothing if no settings hold all limits
  std::vector<std::string> broken;    ///< then: the best value for each limit within the other limits, and the
                                      ///< difference
  std::size_t candidates = 0;         ///< settings whose error and memory were found
  std::size_t timed = 0;              ///< settings that were timed on the target
};

/// Returns the boards' programs that tuning within these limits may run, for displays of this format.
Result<std::vector<std::string>> programs_to_tune(const AccuracyScene& scene, const Limits& limits,
                                                  std::string_view format);

/// `format`: of the display, which is given here.
Result<Tuned> tune(const AccuracyScene& scene, const Limits& limits, std::string_view format, unsigned jobs,
                   const std::function<void(std::size_t done, std::size_t all)>& progress);

/// Returns the settings as a [quality] table of a scene's TOML file, as JSON, and as a header for firmware.
std::string quality_toml(const AccuracyPoint& point);
std::string quality_json(const AccuracyPoint& point);
std::string quality_header(const AccuracyPoint& point, const View& size);

}  // namespace zstrip::sim
