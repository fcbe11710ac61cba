// Tries smaller versions of a model: the flash, memory and time of each, and how much its picture differs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/board_estimate.hpp"
#include "cli/bake_command.hpp"
#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct FitLimits {
  std::optional<std::uint64_t> flash;  ///< bytes of the scene, without code
  std::uint64_t ram = 0;               ///< bytes of arena, strip buffers and skins
  std::optional<double> frames;        ///< a second, the least of the estimate
};

/// The model with one combination of options.
struct FitChoice {
  BakeArguments arguments;
  std::string textures, triangles, smoothing;  ///< the options in words; smoothing: of edges
  std::uint64_t flash = 0, ram = 0, triangle_count = 0;
  double error_pixels = 0;  ///< how far removing triangles moved the surface, by the simplifier's measure
  BoardRate rate;
  double rms = 0;         ///< of a channel's difference to the whole model, 0 to 255
  std::uint64_t off = 0;  ///< pixels of which a channel differs by more than 24
  RgbImage picture;

  bool has_baked_light() const { return arguments.lighting == "baked"; }
};

/// The result of a search.
struct FitSearch {
  std::uint32_t tried = 0;
  RgbImage whole;                  ///< the picture of the model as it is
  std::vector<FitChoice> choices;  ///< keep all limits; no other one is better in flash, picture and time. The best
                                   ///< looking first
  bool triangles_stay = false;     ///< more than half of them, for kTrianglesStay
  std::string nearest;             ///< if there is none: the combination that comes nearest, and what it breaks
};

/// `base`: the arguments of the whole model, and the output whose flash counts.
Result<FitSearch> search(const BakeArguments& base, const BoardModel& board, const FitLimits& limits,
                         const std::function<void(std::uint32_t done, std::uint32_t all)>& progress);

}  // namespace zstrip::sim
