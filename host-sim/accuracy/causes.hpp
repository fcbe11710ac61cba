// The causes of the error: each stage of drawing alone with the renderer's precision, all others exact.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "accuracy/measure.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// `aliasing` compares one exact sample in the middle of a pixel with the mean of 16; the others compare one coarse
/// stage with one exact sample.
enum class Cause : std::uint8_t { aliasing, snapping, transform, interpolation, depth, colour };
inline constexpr std::size_t kCauses = 6;

struct CauseInfo {
  Cause cause;
  std::string_view name;
  std::string_view meaning;
  std::vector<Knob> knobs;  ///< the knobs that change this cause
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

/// Returns each cause with the default, then with each value of `turned` that changes it; colours also with dithering
/// in each format.
std::vector<CauseCase> cause_cases(const AccuracyScene& scene, const std::vector<Knob>& turned);

/// Returns the figures of ErrorSum. Depth in codes is the effect of this cause alone, in codes of the settings' format.
Result<Errors> errors_of(const AccuracyScene& scene, const CauseCase& wanted);
/// Computes the errors of all these cases, in parallel.
Result<std::vector<CauseErrors>> errors_of(const AccuracyScene& scene, const std::vector<CauseCase>& wanted,
                                           unsigned jobs);

}  // namespace zstrip::sim
