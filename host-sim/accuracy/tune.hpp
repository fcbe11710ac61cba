// The cheapest settings that keep within limits of error, memory and time.
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
  std::optional<double> frames{};        ///< a second, at least; on boards the least that is predicted
};

/// Frames a second of a point, the least; nothing where the board has too little RAM.
std::optional<double> frames_per_second(const AccuracyPoint& point);

struct Tuned {
  std::optional<AccuracyPoint> best;  ///< nothing where no settings keep all limits
  std::vector<std::string> broken;    ///< then: for each limit what is the best within the others, and by how much
  std::size_t candidates = 0;         ///< settings whose error and memory were looked at
  std::size_t timed = 0;              ///< of these measured on the target
};

/// The boards' programs that tuning within these limits may run, of displays of this format.
Result<std::vector<std::string>> programs_to_tune(const AccuracyScene& scene, const Limits& limits,
                                                  std::string_view format);

/// `format`: of the display, which is no matter of choice here.
Result<Tuned> tune(const AccuracyScene& scene, const Limits& limits, std::string_view format, unsigned jobs,
                   const std::function<void(std::size_t done, std::size_t all)>& progress);

/// The settings as a [quality] table of a scene's TOML file, as JSON, and as a header for firmware.
std::string quality_toml(const AccuracyPoint& point);
std::string quality_json(const AccuracyPoint& point);
std::string quality_header(const AccuracyPoint& point, const View& size);

}  // namespace zstrip::sim
