// A picture of the renderer compared with the truth: the perceived difference of each pixel in colours, and its
// maximum.
#include "accuracy/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/perceived.hpp"
#include "accuracy/truth.hpp"
#include "image/to_rgb.hpp"

namespace zstrip::sim {
namespace {

constexpr float kNoticeable = 1;

HeatFigures figures_of(const std::vector<float>& differences, std::uint32_t width) {
  HeatFigures figures;
  double sum = 0;
  std::size_t seen = 0, worst = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    sum += differences[i];
    if (differences[i] > kNoticeable) ++seen;
    if (differences[i] > differences[worst]) worst = i;
  }
  const auto all = static_cast<double>(differences.size());
  figures.mean = sum / all;
  figures.worst = differences[worst];
  figures.worst_x = static_cast<std::uint32_t>(worst % width);
  figures.worst_y = static_cast<std::uint32_t>(worst / width);
  figures.seen_percent = 100 * static_cast<double>(seen) / all;
  return figures;
}

std::uint16_t rgb565(const std::array<std::uint8_t, 3>& rgb) {
  return static_cast<std::uint16_t>((rgb[0] >> 3) << 11 | (rgb[1] >> 2) << 5 | rgb[2] >> 3);
}

}  // namespace

std::array<std::uint8_t, 3> heat_colour(float difference) {
  const float t = std::min(std::sqrt(difference / 20), 1.0F) * 3;
  const auto part = [&](float from) { return static_cast<std::uint8_t>(255 * std::clamp(t - from, 0.0F, 1.0F)); };
  return {part(0), part(1), part(2)};
}

std::string in_words(const HeatFigures& figures) {
  return fmt::format("worst {:.3g} at {},{}; {:.1f} % of pixels are seen to differ; mean {:.2g}", figures.worst,
                     figures.worst_x, figures.worst_y, figures.seen_percent, figures.mean);
}

Result<HeatMap> draw_heat_map(const Staging& staging, const Origins& origins, const View& view,
                              std::span<const std::byte> pixels) {
  Scene scene = staging.scene;
  scene.edges = {};
  if (const Result<Done> checked = check_truth(scene, staging.camera, origins); !checked) return checked.failure();
  const Result<MeanPicture> truth = draw_mean(scene, staging.camera, view);
  if (!truth) return truth.failure();
  const RgbImage drawn = rgb_image_of(view, pixels);
  MeanPicture shown(truth->size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) shown[i][c] = drawn.rgb[3 * i + c];
  }
  const std::vector<float> differences = perceived_difference(view.width, view.height, shown, *truth);
  HeatMap map{{}, figures_of(differences, view.width)};
  for (const float difference : differences) map.pixels.push_back(rgb565(heat_colour(difference)));
  return map;
}

}  // namespace zstrip::sim
