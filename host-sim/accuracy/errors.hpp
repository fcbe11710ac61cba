// The errors of a picture compared with the truth: separate figures, and a figure for each pixel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "accuracy/observation.hpp"
#include "accuracy/truth.hpp"

namespace zstrip::sim {

/// The figures. "Shown" pixels are pixels where the picture or the truth shows a surface.
enum class Figure : std::uint8_t {
  wrong_pixels,
  wrong_surface,
  silhouette,
  depth_codes,
  depth_view,
  texture,
  colour_mean,
  colour_p999,
  colour_worst,
  psnr,
  psnr_16x,
  perceived,
  flip,
  flicker
};
inline constexpr std::size_t kFigures = 14;

struct FigureInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  bool more_is_better = false;
};
std::span<const FigureInfo> figures();

/// NaN if a figure is not defined, such as texture coordinates of a scene without textures.
struct Errors {
  std::array<double, kFigures> value{};
  double operator[](Figure figure) const { return value[static_cast<std::size_t>(figure)]; }
  double& operator[](Figure figure) { return value[static_cast<std::size_t>(figure)]; }
};

/// Selects the quantity that the codes of the z-buffer are linear in.
struct DepthScale {
  DepthFormat format = DepthFormat::z16;
  bool orthographic = false;
};

/// Accumulates the errors of several frames.
class ErrorSum {
 public:
  /// `simplified`: triangles have other numbers than in the truth. A surface is then wrong if it is more than a pixel's
  /// size in front of or behind all surfaces that the truth shows at the pixel and its neighbours.
  ErrorSum(const View& view, const Camera& camera, const DepthScale& depth, bool simplified);

  void add(const Observation& drawn, const Truth& truth);
  /// Adds the flicker between two frames with slightly different poses.
  void add_flicker(const Observation& first, const Truth& first_truth, const Observation& next,
                   const Truth& next_truth);
  Errors take() const;
  /// Returns the perceived difference of each pixel of the frame that was added first.
  const std::vector<float>& heat() const { return heat_; }

 private:
  void add_surfaces(const Observation& drawn, const Truth& truth);
  void add_depth(const Observation& drawn, const Truth& truth);
  void add_colour(const Observation& drawn, const Truth& truth);

  View view_;
  double pixel_at_one_;  ///< size of a pixel at distance 1
  DepthScale depth_;
  bool simplified_;
  std::uint64_t shown_ = 0, wrong_surface_ = 0, silhouette_ = 0, flicker_pixels_ = 0, looked_at_ = 0;
  double squares_ = 0, squares_16x_ = 0, perceived_ = 0, flip_ = 0, flicker_ = 0;
  std::uint64_t channels_ = 0;
  std::vector<float> codes_, distances_, texels_, colours_;
  std::vector<float> heat_;
};

}  // namespace zstrip::sim
