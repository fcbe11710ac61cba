// Surfaces, silhouettes, depth, texture coordinates, colour, flicker.
#include "accuracy/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "accuracy/flip.hpp"
#include "accuracy/perceived.hpp"

namespace zstrip::sim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<FigureInfo, kFigures> kInfo{{
    {"wrong_pixels", "%", "pixels with a wrong surface or silhouette, of those that the truth covers"},
    {"wrong_surface", "pixels", "covered in both, but by a surface that the truth does not show there"},
    {"silhouette", "pixels", "covered in one of them only"},
    {"depth_codes", "codes",
     "depth against the planes through snapped corners: interpolation and format alone; 99.9 % of pixels below"},
    {"depth_view", "units",
     "depth against the truth, snapping included, in the scene's lengths; 99.9 % of pixels below"},
    {"texture", "texels", "texture coordinates, 99.9 % of pixels below"},
    {"colour_mean", "of 255", "mean of the channels"},
    {"colour_p999", "of 255", "99.9 % of the channels below"},
    {"colour_worst", "of 255", "the worst channel"},
    {"psnr", "dB", "of the whole picture, sampled in the middle of pixels", true},
    {"psnr_16x", "dB", "the same against 16 samples a pixel", true},
    {"perceived", "Lab", "mean visible difference to 16 samples a pixel; 1 is just noticeable"},
    {"flip", "of 1", "mean of LDR-FLIP at 67 pixels a degree, against 16 samples a pixel"},
    {"flicker", "of 255", "brightness that changes otherwise than in truth while the scene turns by half a degree"},
}};

/// Returns the quantile `part` of the values; reorders them.
double quantile(std::vector<float> values, double part) {
  if (values.empty()) return kNone;
  const auto index = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + index);
  return values[static_cast<std::size_t>(index)];
}

double luma(const std::array<float, 3>& c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; }

double ratio_in_db(double squares, std::uint64_t count) {
  if (count == 0) return kNone;
  // Equal pictures get the figure of an error of a hundredth of a step everywhere.
  return 10 * std::log10(255.0 * 255.0 / std::max(squares / static_cast<double>(count), 1e-4));
}

/// Returns the distance of the truth's place from the texel that was drawn; textures repeat.
float texture_error(const TexelSeen& seen, const TruthSample& truth) {
  const auto along = [](double drawn, double true_place, double size) {
    const double off = std::remainder(true_place - drawn, size);
    return std::max(std::abs(off) - 0.5, 0.0);
  };
  return static_cast<float>(std::max(along(seen.u, truth.u, seen.width), along(seen.v, truth.v, seen.height)));
}

/// The least-squares line through points.
struct Line {
  double offset = 0, slope = 0;
};
std::optional<Line> line_through(const std::vector<std::array<double, 2>>& points) {
  if (points.size() < 3) return std::nullopt;
  double mean_x = 0, mean_y = 0;
  for (const auto& [x, y] : points) mean_x += x, mean_y += y;
  mean_x /= static_cast<double>(points.size());
  mean_y /= static_cast<double>(points.size());
  double xx = 0, xy = 0;
  for (const auto& [x, y] : points) xx += (x - mean_x) * (x - mean_x), xy += (x - mean_x) * (y - mean_y);
  if (!(xx > 0) || xy == 0) return std::nullopt;
  return Line{mean_y - xy / xx * mean_x, xy / xx};
}

}  // namespace

std::span<const FigureInfo> figures() { return kInfo; }

ErrorSum::ErrorSum(const View& view, const Camera& camera, const DepthScale& depth, bool simplified)
    : view_(view), pixel_at_one_(2 * 65536.0 / camera.focal / view.height), depth_(depth), simplified_(simplified) {}

void ErrorSum::add(const Observation& drawn, const Truth& truth) {
  add_surfaces(drawn, truth);
  add_depth(drawn, truth);
  add_colour(drawn, truth);
}

void ErrorSum::add_surfaces(const Observation& drawn, const Truth& truth) {
  const std::uint32_t width = view_.width, height = view_.height;
  std::vector<bool> right(drawn.label.size(), false);
  const auto is_drawn = [&](std::size_t i) { return drawn.label[i] != 0; };

  // Distances of drawn pixels are read with the scale of the codes, which is fitted to correct pixels.
  std::vector<std::array<double, 2>> points;
  const bool linear_in_w = depth_.orthographic;
  const auto abscissa = [&](double w) { return linear_in_w ? w : 1 / w; };
  for (std::size_t i = 0; i < right.size(); ++i) {
    const TruthSample& sample = truth.centres.samples[i];
    if (sample.triangle == kNoTriangle || !is_drawn(i)) continue;
    if (!simplified_ && drawn.label[i] != label_of(sample.triangle)) continue;
    points.push_back({abscissa(sample.w), drawn.depth[i].value});
  }
  const std::optional<Line> line = line_through(points);

  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::size_t i = std::size_t{y} * width + x;
      const TruthSample& sample = truth.centres.samples[i];
      const bool covered = sample.triangle != kNoTriangle;
      if (covered) ++shown_;
      if (covered != is_drawn(i)) ++silhouette_;
      if (!covered || !is_drawn(i)) continue;
      bool found = !simplified_ && drawn.label[i] == label_of(sample.triangle);
      right[i] = found;
      if (!found && !simplified_) {
        for (const std::uint32_t other : truth.triangles[i])
          found = found || (other != kNoTriangle && label_of(other) == drawn.label[i]);
      }
      double nearest = sample.w, farthest = sample.w;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const std::int64_t at_x = std::int64_t{x} + dx, at_y = std::int64_t{y} + dy;
          if (at_x < 0 || at_y < 0 || at_x >= width || at_y >= height) continue;
          const TruthSample& near_by =
              truth.centres.at(static_cast<std::uint32_t>(at_x), static_cast<std::uint32_t>(at_y));
          if (near_by.triangle == kNoTriangle) continue;
          found = found || (!simplified_ && label_of(near_by.triangle) == drawn.label[i]);
          nearest = std::min(nearest, near_by.w);
          farthest = std::max(farthest, near_by.w);
        }
      }
      if (!found && simplified_ && line) {
        const double at = (drawn.depth[i].value - line->offset) / line->slope;
        const double w = linear_in_w ? at : 1 / at;
        const double size = pixel_at_one_ * (depth_.orthographic ? 1 : sample.w);
        found = w >= nearest - size && w <= farthest + size;
      }
      if (!found) ++wrong_surface_;
      if (right[i] && !drawn.texel.empty() && drawn.texel[i].width > 0)
        texels_.push_back(texture_error(drawn.texel[i], sample));
    }
  }
  if (!line) return;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (!right[i]) continue;
    const double w = truth.centres.samples[i].w;
    const double wrong = drawn.depth[i].value - line->offset - line->slope * abscissa(w);
    distances_.push_back(static_cast<float>(std::abs(wrong / line->slope) * (linear_in_w ? 1 : w * w)));
  }
}

void ErrorSum::add_depth(const Observation& drawn, const Truth& truth) {
  if (simplified_) return;
  const bool linear_in_w = depth_.orthographic;
  std::vector<std::array<double, 2>> points;
  std::vector<double> steps;
  for (std::size_t i = 0; i < drawn.label.size(); ++i) {
    const TruthSample& sample = truth.snapped.samples[i];
    if (sample.triangle == kNoTriangle || drawn.label[i] != label_of(sample.triangle)) continue;
    points.push_back({linear_in_w ? sample.w : 1 / sample.w, drawn.depth[i].value});
    steps.push_back(drawn.depth[i].step);
  }
  const std::optional<Line> line = line_through(points);
  if (!line) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double wrong = points[i][1] - line->offset - line->slope * points[i][0];
    codes_.push_back(static_cast<float>(std::abs(wrong) / steps[i]));
  }
}

void ErrorSum::add_colour(const Observation& drawn, const Truth& truth) {
  const std::vector<std::array<float, 3>>& picture = drawn.rgb;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const TruthSample& sample = truth.centres.samples[i];
    const bool shown = sample.triangle != kNoTriangle || drawn.label[i] != 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double off = std::abs(picture[i][c] - sample.rgb[c]);
      const double off_16x = picture[i][c] - truth.mean[i][c];
      squares_ += off * off;
      squares_16x_ += off_16x * off_16x;
      ++channels_;
      if (shown) colours_.push_back(static_cast<float>(off));
    }
  }
  const std::vector<float> difference = perceived_difference(view_.width, view_.height, picture, truth.mean);
  for (const float d : difference) perceived_ += d;
  for (const float d : flip(view_.width, view_.height, truth.mean, picture)) flip_ += d;
  looked_at_ += difference.size();
  if (heat_.empty()) heat_ = difference;
}

void ErrorSum::add_flicker(const Observation& first, const Truth& first_truth, const Observation& next,
                           const Truth& next_truth) {
  for (std::size_t i = 0; i < first.rgb.size(); ++i) {
    if (first.label[i] == 0 && next.label[i] == 0) continue;
    const double drawn = luma(next.rgb[i]) - luma(first.rgb[i]);
    const double real = luma(next_truth.mean[i]) - luma(first_truth.mean[i]);
    flicker_ += std::abs(drawn - real);
    ++flicker_pixels_;
  }
}

Errors ErrorSum::take() const {
  Errors errors;
  const auto mean = [](double sum, std::uint64_t count) {
    return count == 0 ? kNone : sum / static_cast<double>(count);
  };
  double colour_sum = 0;
  for (const float c : colours_) colour_sum += c;
  errors[Figure::wrong_pixels] = mean(100.0 * static_cast<double>(wrong_surface_ + silhouette_), shown_);
  errors[Figure::wrong_surface] = static_cast<double>(wrong_surface_);
  errors[Figure::silhouette] = static_cast<double>(silhouette_);
  errors[Figure::depth_codes] = quantile(codes_, 0.999);
  errors[Figure::depth_view] = quantile(distances_, 0.999);
  errors[Figure::texture] = quantile(texels_, 0.999);
  errors[Figure::colour_mean] = mean(colour_sum, colours_.size());
  errors[Figure::colour_p999] = quantile(colours_, 0.999);
  errors[Figure::colour_worst] = quantile(colours_, 1);
  errors[Figure::psnr] = ratio_in_db(squares_, channels_);
  errors[Figure::psnr_16x] = ratio_in_db(squares_16x_, channels_);
  errors[Figure::perceived] = mean(perceived_, looked_at_);
  errors[Figure::flip] = mean(flip_, looked_at_);
  errors[Figure::flicker] = mean(flicker_, flicker_pixels_);
  return errors;
}

}  // namespace zstrip::sim
