// Where the error comes from: each stage of drawing alone as coarse as the renderer's, all others exact.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "accuracy/measure.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// `aliasing` is one exact sample in the middle of a pixel against the mean of 16; the others are one coarse stage
/// against one exact sample.
enum class Cause : std::uint8_t { aliasing, snapping, transform, interpolation, depth, colour };
inline constexpr std::size_t kCauses = 6;

struct CauseInfo {
  Cause cause;
  std::string_view name;
  std::string_view meaning;
  std::vector<Knob> knobs;  ///< those that change it
};
/// In the order of Cause.
const std::vector<CauseInfo>& causes();
inline const CauseInfo& info(Cause cause) { return causes()[static_cast<std::size_t>(cause)]; }

/// A cause with settings of its own knobs.
struct CauseCase {
  Cause cause;
  Settings settings;
};
struct CauseErrors {
  CauseCase of;
  Errors errors;
};

/// Each cause at the default; then each with one value of `turned` as far as that changes it, colours with dithering in
/// each format, too.
std::vector<CauseCase> cause_cases(const AccuracyScene& scene, const std::vector<Knob>& turned);

/// The figures of ErrorSum. Depth in codes is what the cause alone does to it, in codes of the settings' format.
Result<Errors> errors_of(const AccuracyScene& scene, const CauseCase& wanted);
/// Of all of these, in parallel.
Result<std::vector<CauseErrors>> errors_of(const AccuracyScene& scene, const std::vector<CauseCase>& wanted,
                                           unsigned jobs);

}  // namespace zstrip::sim
