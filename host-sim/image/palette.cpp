// Median cut over the histogram of the texels; all decisions are of integers.
#include "image/palette.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace zstrip::sim {
namespace {

/// Colours with the number of their texels.
using Histogram = std::map<std::uint16_t, std::uint32_t>;
using Counted = std::pair<std::uint16_t, std::uint32_t>;
using Channels = std::array<int, 3>;

constexpr Channels levels(std::uint16_t colour) { return {colour >> 11, colour >> 5 & 63, colour & 31}; }
/// 0..255 each, the upper bits repeated below.
constexpr Channels channels(std::uint16_t colour) {
  const auto [r, g, b] = levels(colour);
  return {r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2};
}

int squared_distance(std::uint16_t a, std::uint16_t b) {
  const Channels x = channels(a), y = channels(b);
  int sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (x[i] - y[i]) * (x[i] - y[i]);
  return sum;
}

/// Different colours and the box around them.
struct Box {
  std::vector<Counted> colours;
  std::size_t axis = 0;      ///< along its longest side
  int side = 0, middle = 0;  ///< of that side; 0 long if there is one colour

  explicit Box(std::vector<Counted> all) : colours(std::move(all)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [least, greatest] = std::minmax_element(
          colours.begin(), colours.end(),
          [i](const Counted& a, const Counted& b) { return channels(a.first)[i] < channels(b.first)[i]; });
      const int low = channels(least->first)[i], length = channels(greatest->first)[i] - low;
      if (length > side) side = length, middle = low + length / 2, axis = i;
    }
  }
  /// Keeps the lower half and gives the upper one; neither is empty if the side is longer than 0.
  Box split() {
    const auto upper = std::stable_partition(colours.begin(), colours.end(), [this](const Counted& colour) {
      return channels(colour.first)[axis] <= middle;
    });
    Box other({upper, colours.end()});
    *this = Box({colours.begin(), upper});
    return other;
  }
  std::uint16_t mean() const {
    std::uint64_t texels = 0, sums[3] = {};
    for (const auto& [colour, times] : colours) {
      texels += times;
      for (std::size_t i = 0; i < 3; ++i) sums[i] += std::uint64_t{times} * static_cast<unsigned>(levels(colour)[i]);
    }
    const auto rounded = [&](std::size_t i) { return (sums[i] + texels / 2) / texels; };
    return static_cast<std::uint16_t>(rounded(0) << 11 | rounded(1) << 5 | rounded(2));
  }
};

std::vector<std::uint16_t> palette_of(const Histogram& histogram, std::size_t entries) {
  std::vector<std::uint16_t> palette;
  if (histogram.size() <= entries) {
    for (const auto& [colour, times] : histogram) palette.push_back(colour);
    return palette;
  }
  std::vector<Box> boxes{Box({histogram.begin(), histogram.end()})};
  while (boxes.size() < entries) {
    const auto longest =
        std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.side < b.side; });
    Box other = longest->split();
    boxes.push_back(std::move(other));
  }
  for (const Box& box : boxes) palette.push_back(box.mean());
  return palette;
}

}  // namespace

IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format) {
  const std::size_t bits = index_bits(format), entries = std::size_t{1} << bits, in_word = 16 / bits;
  Histogram histogram;
  for (const std::uint16_t texel : texels) ++histogram[texel];
  IndexedTexels indexed{palette_of(histogram, entries), {}};
  std::map<std::uint16_t, std::size_t> index_of;
  for (const auto& [colour, times] : histogram) {
    const auto nearest = std::min_element(indexed.words.begin(), indexed.words.end(),
                                          [colour = colour](std::uint16_t a, std::uint16_t b) {
                                            return squared_distance(a, colour) < squared_distance(b, colour);
                                          });
    index_of[colour] = static_cast<std::size_t>(nearest - indexed.words.begin());
    for (std::size_t i = 0; i < 3; ++i) {
      const int off = std::abs(channels(*nearest)[i] - channels(colour)[i]);
      indexed.errors.largest[i] = std::max(indexed.errors.largest[i], off);
      indexed.errors.mean[i] += static_cast<double>(off) * times / static_cast<double>(texels.size());
    }
  }
  indexed.words.resize(entries + (texels.size() + in_word - 1) / in_word);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    std::uint16_t& word = indexed.words[entries + i / in_word];
    word = static_cast<std::uint16_t>(word | index_of[texels[i]] << (bits * (i % in_word)));
  }
  return indexed;
}

}  // namespace zstrip::sim
