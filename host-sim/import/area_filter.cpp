// A texel of the result covers a rectangle of the source; texels at its borders count by the share that it covers.
#include "import/area_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "import/screen_channel.hpp"

namespace zstrip::sim {
namespace {

/// The texels of a source side that one texel of the result covers, at least partly.
class Covered {
 public:
  Covered(std::uint32_t index, std::uint32_t to, std::uint32_t from)
      : begin_(1.0 * from * index / to), end_(1.0 * from * (index + 1) / to), side_(from) {}

  std::uint32_t first() const { return static_cast<std::uint32_t>(begin_); }
  std::uint32_t last() const { return std::min(static_cast<std::uint32_t>(std::ceil(end_)), side_); }  ///< one beyond
  /// Returns the covered share of a texel, 0 to 1.
  double share(std::uint32_t texel) const {
    return std::max(std::min(end_, texel + 1.0) - std::max(begin_, 1.0 * texel), 0.0);
  }

 private:
  double begin_, end_;
  std::uint32_t side_;
};

/// Sums of the texels below a texel of the result.
struct Sums {
  std::array<double, 3> weighted{}, plain{};  ///< linear light, with and without alpha as its weight
  double alpha = 0;                           ///< 0 to 255 for each texel
  double area = 0;
};

}  // namespace

RgbImage shrink(const RgbImage& from, std::uint32_t width, std::uint32_t height) {
  std::array<double, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = from_screen_channel(static_cast<std::uint8_t>(i));
  RgbImage to{width, height, {}};
  to.rgb.reserve(3 * std::size_t{width} * height);
  std::vector<Sums> row(width);
  for (std::uint32_t y = 0; y < height; ++y) {
    std::ranges::fill(row, Sums{});
    const Covered rows(y, height, from.height);
    for (std::uint32_t v = rows.first(); v < rows.last(); ++v) {
      for (std::uint32_t x = 0; x < width; ++x) {
        Sums& sums = row[x];
        const Covered columns(x, width, from.width);
        for (std::uint32_t u = columns.first(); u < columns.last(); ++u) {
          const double area = rows.share(v) * columns.share(u);
          const double alpha = from.alpha.empty() ? 255 : from.alpha_at(u, v);
          const std::uint8_t* const pixel = from.pixel(u, v);
          for (std::size_t channel = 0; channel < 3; ++channel) {
            const double light = area * linear[pixel[channel]];
            sums.weighted[channel] += light * alpha;
            sums.plain[channel] += light;
          }
          sums.alpha += area * alpha;
          sums.area += area;
        }
      }
    }
    for (const Sums& sums : row) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double mean = sums.alpha > 0 ? sums.weighted[channel] / sums.alpha : sums.plain[channel] / sums.area;
        to.rgb.push_back(to_screen_channel(mean, true));
      }
      if (!from.alpha.empty()) to.alpha.push_back(static_cast<std::uint8_t>(std::lround(sums.alpha / sums.area)));
    }
  }
  return to;
}

}  // namespace zstrip::sim
