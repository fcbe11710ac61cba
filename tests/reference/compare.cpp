// Verdicts pixel by pixel; see compare.hpp.
#include "compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sliver.hpp"

namespace zstrip::reference {
namespace {

using Channels = std::array<double, 3>;

constexpr std::array<unsigned, 3> kChannelBits{5, 6, 5};

std::array<unsigned, 3> split(unsigned pixel) { return {pixel >> 11, pixel >> 5 & 63, pixel & 31}; }

Channels channels(const Sample& sample) {
  const auto clamped = [](float channel) { return std::clamp(static_cast<double>(channel), 0.0, 255.0); };
  return {clamped(sample.r), clamped(sample.g), clamped(sample.b)};
}

/// The upper bits repeated below.
unsigned widened(unsigned code, unsigned bits) { return code << (8 - bits) | code >> (2 * bits - 8); }

/// A box of colours.
struct Hull {
  Channels low{255, 255, 255}, high{0, 0, 0};

  void add(const Sample& sample) {
    const Channels colour = channels(sample);
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], colour[c]);
      high[c] = std::max(high[c], colour[c]);
    }
  }
  /// How far the box is from the colours that truncate to `pixel`; the channel that is worst.
  double excess(std::uint16_t pixel) const {
    const std::array<unsigned, 3> codes = split(pixel);
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double step = 1 << (8 - kChannelBits[c]);
      const double first = codes[c] * step;
      worst = std::max({worst, first - high[c], low[c] - (first + step)});
    }
    return worst;
  }
};

/// The difference of two pixels, 8 bits a channel.
std::array<unsigned, 3> error(std::uint16_t pixel, std::uint16_t expected) {
  const std::array<unsigned, 3> a = split(pixel), b = split(expected);
  std::array<unsigned, 3> result{};
  for (std::size_t c = 0; c < 3; ++c) {
    const unsigned wide_a = widened(a[c], kChannelBits[c]), wide_b = widened(b[c], kChannelBits[c]);
    result[c] = std::max(wide_a, wide_b) - std::min(wide_a, wide_b);
  }
  return result;
}

/// Decides what each pixel is.
class Judge {
 public:
  Judge(const RendererPicture& picture, const ReferencePicture& reference, double excess)
      : picture_(picture),
        reference_(reference),
        excess_(excess),
        triangles_(on_screen(reference.geometry, reference.view)) {}

  Verdict verdict(std::size_t pixel) const {
    const Verdict by_samples = verdict_by_samples(pixel);
    return by_samples >= Verdict::foreign && shows_sliver(pixel) ? Verdict::sliver : by_samples;
  }

  /// Whether the sample at the centre alone could be what the renderer shows.
  bool shows_centre(std::size_t pixel) const { return fits(reference_.centres()[pixel], pixel); }

  /// Of the surface at the centre, by all colours that it has within reach.
  double excess(std::size_t pixel) const {
    Hull hull;
    for (const Layers& layers : reference_.layers) hull.add(layers.nearest[pixel]);
    return hull.excess(picture_.pixels[pixel]);
  }

 private:
  Verdict verdict_by_samples(std::size_t pixel) const {
    if (!is_certain(pixel)) return is_plausible(pixel) ? Verdict::plausible : Verdict::foreign;
    const bool drawn = reference_.centres()[pixel].drawn();
    if (drawn != (picture_.drawn[pixel] != 0)) return Verdict::coverage;
    if (!drawn) return Verdict::background;
    return excess(pixel) <= excess_ ? Verdict::certain : Verdict::shading;
  }

  /// Whether every sample shows the same, with nothing close behind it.
  bool is_certain(std::size_t pixel) const {
    const Sample& centre = reference_.centres()[pixel];
    const auto same = [&](const Layers& layers) {
      return layers.nearest[pixel].same_surface(centre) && !layers.contender[pixel].drawn();
    };
    const auto same_texel = [&](const Samples& samples) {
      return samples[pixel].triangle != centre.triangle || samples[pixel].texel == centre.texel;
    };
    return std::all_of(reference_.layers.begin(), reference_.layers.end(), same) &&
           std::all_of(reference_.drifts.begin(), reference_.drifts.end(), same_texel);
  }

  /// Whether some sample could be what the renderer shows.
  bool is_plausible(std::size_t pixel) const {
    const auto in_reach = [&](const Layers& layers) {
      if (picture_.drawn[pixel] == 0) return !layers.nearest[pixel].drawn();
      return fits(layers.nearest[pixel], pixel) || fits(layers.contender[pixel], pixel);
    };
    const auto of_triangle_in_reach = [&](const Samples& samples) {
      return fits(samples[pixel], pixel) &&
             std::any_of(reference_.layers.begin(), reference_.layers.end(), [&](const Layers& layers) {
               return layers.nearest[pixel].triangle == samples[pixel].triangle;
             });
    };
    return std::any_of(reference_.layers.begin(), reference_.layers.end(), in_reach) ||
           std::any_of(reference_.drifts.begin(), reference_.drifts.end(), of_triangle_in_reach);
  }

  bool fits(const Sample& sample, std::size_t pixel) const {
    if (!sample.drawn() || picture_.drawn[pixel] == 0) return false;
    Hull hull;
    hull.add(sample);
    return hull.excess(picture_.pixels[pixel]) <= excess_;
  }

  /// Whether a triangle of the pixel's colour, not hidden, comes within reach of the centre.
  bool shows_sliver(std::size_t pixel) const {
    if (picture_.drawn[pixel] == 0) return false;
    const double x = static_cast<double>(pixel % reference_.view.width) + 0.5;
    const double y = static_cast<double>(pixel / reference_.view.width) + 0.5;
    double depth = reference_.centres()[pixel].depth;
    for (const Layers& layers : reference_.layers) depth = std::min<double>(depth, layers.nearest[pixel].depth);
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const ScreenTriangle& triangle) {
      if (triangle.nearest < depth - kDepthTolerance || distance(triangle, x, y) > std::sqrt(2.0) * kReach)
        return false;
      Hull hull;
      for (std::size_t k = 0; k < 3; ++k)
        hull.add({triangle.corners[k].r, triangle.corners[k].g, triangle.corners[k].b});
      if (triangle.textured) hull.low = {0, 0, 0};  // some texel
      return hull.excess(picture_.pixels[pixel]) <= excess_;
    });
  }

  const RendererPicture& picture_;
  const ReferencePicture& reference_;
  double excess_;
  std::vector<ScreenTriangle> triangles_;
};

/// Whether `drawn` says yes of a pixel or one of its eight neighbours.
template <class Drawn>
bool near_drawn(const View& view, std::size_t pixel, const Drawn& drawn) {
  const int x = static_cast<int>(pixel % view.width), y = static_cast<int>(pixel / view.width);
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, view.height - 1); ++row) {
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, view.width - 1); ++column) {
      if (drawn(static_cast<std::size_t>(row) * view.width + static_cast<std::size_t>(column))) return true;
    }
  }
  return false;
}

}  // namespace

std::uint16_t truncated(const Sample& sample) {
  const Channels colour = channels(sample);
  constexpr double kRounding = 1.0 / 1024;  // of OpenGL's float: whole numbers stay themselves
  const auto code = [&](std::size_t c) {
    return static_cast<unsigned>(colour[c] + kRounding) >> (8 - kChannelBits[c]);
  };
  return static_cast<std::uint16_t>(code(0) << 11 | code(1) << 5 | code(2));
}

Comparison compare(const RendererPicture& picture, const ReferencePicture& reference, double excess) {
  const Judge judge(picture, reference, excess);
  const Samples& centres = reference.centres();
  const auto in_picture = [&](std::size_t i) { return picture.drawn[i] != 0; };
  const auto in_reference = [&](std::size_t i) { return centres[i].drawn(); };
  Comparison result;
  double sum = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Verdict verdict = judge.verdict(i);
    result.verdicts.push_back(verdict);
    ++result.count[static_cast<std::size_t>(verdict)];
    if (in_reference(i)) {
      ++result.drawn;
      if (judge.shows_centre(i)) ++result.exact;
    }
    if (in_picture(i) != in_reference(i)) {
      ++result.silhouette_differs;
      const bool close =
          in_picture(i) ? near_drawn(reference.view, i, in_reference) : near_drawn(reference.view, i, in_picture);
      if (!close) ++result.silhouette_strays;
    }
    if (verdict != Verdict::certain && verdict != Verdict::shading) continue;
    result.worst_excess = std::max(result.worst_excess, judge.excess(i));
    for (const unsigned channel : error(picture.pixels[i], truncated(centres[i]))) {
      sum += channel;
      result.worst_error = std::max<double>(result.worst_error, channel);
    }
  }
  const std::uint32_t shaded = result.of(Verdict::certain) + result.of(Verdict::shading);
  if (shaded != 0) result.mean_error = sum / (3.0 * shaded);
  return result;
}

std::ostream& operator<<(std::ostream& out, const Comparison& comparison) {
  constexpr const char* kNames[kVerdicts] = {"background", "certain",  "plausible", "sliver",
                                             "foreign",    "coverage", "shading"};
  for (std::size_t i = 0; i < kVerdicts; ++i) out << kNames[i] << ' ' << comparison.count[i] << ", ";
  return out << "drawn " << comparison.drawn << ", exact " << comparison.exact << ", silhouette differs "
             << comparison.silhouette_differs << ", strays " << comparison.silhouette_strays << ", mean error "
             << comparison.mean_error << ", worst " << comparison.worst_error << ", excess " << comparison.worst_excess
             << '\n';
}

}  // namespace zstrip::reference
