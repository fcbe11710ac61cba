// Median cut over the histogram of the texels; all decisions use integers.
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
/// Returns 0..255 for each channel; the upper bits are repeated in the lower ones.
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

/// A set of different colours and the box around them.
struct Box {
  std::vector<Counted> colours;
  std::size_t axis = 0;      ///< axis of its longest side
  int side = 0, middle = 0;  ///< length and middle of that side; the length is 0 if there is one colour

  explicit Box(std::vector<Counted> all) : colours(std::move(all)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [least, greatest] = std::minmax_element(
          colours.begin(), colours.end(),
          [i](const Counted& a, const Counted& b) { return channels(a.first)[i] < channels(b.first)[i]; });
      const int low = channels(least->first)[i], length = channels(greatest->first)[i] - low;
      if (length > side) side = length, middle = low + length / 2, axis = i;
    }
  }
  /// Keeps the lower half and returns the upper one; neither is empty if the side is longer than 0.
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
  const std::size_t level = texels.size();
  return index_texels(texels, format, {&level, 1});
}

IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format,
                           std::span<const std::size_t> levels) {
  const std::size_t entries = std::size_t{1} << index_bits(format);
  Histogram histogram;
  for (const std::uint16_t texel : texels) ++histogram[texel];
  IndexedTexels indexed{palette_of(histogram, entries), {}};
  std::map<std::uint16_t, std::uint8_t> index_of;
  for (const auto& [colour, times] : histogram) {
    const std::uint8_t nearest = index_of[colour] = nearest_entry(indexed.words, colour);
    for (std::size_t i = 0; i < 3; ++i) {
      const int off = std::abs(channels(indexed.words[nearest])[i] - channels(colour)[i]);
      indexed.errors.largest[i] = std::max(indexed.errors.largest[i], off);
      indexed.errors.mean[i] += static_cast<double>(off) * times / static_cast<double>(texels.size());
    }
  }
  indexed.words.resize(entries);
  std::size_t first = 0;
  for (const std::size_t size : levels) {
    std::vector<std::uint8_t> indices;
    for (const std::uint16_t texel : texels.subspan(first, size)) indices.push_back(index_of[texel]);
    append_packed(indices, index_bits(format), indexed.words);
    first += size;
  }
  return indexed;
}

std::uint8_t nearest_entry(std::span<const std::uint16_t> palette, std::uint16_t colour) {
  const auto nearest = std::min_element(palette.begin(), palette.end(), [colour](std::uint16_t a, std::uint16_t b) {
    return squared_distance(a, colour) < squared_distance(b, colour);
  });
  return static_cast<std::uint8_t>(nearest - palette.begin());
}

void append_packed(std::span<const std::uint8_t> values, std::uint32_t bits, std::vector<std::uint16_t>& words) {
  const std::size_t in_word = 16 / bits;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % in_word == 0) words.push_back(0);
    words.back() = static_cast<std::uint16_t>(words.back() | unsigned{values[i]} << (bits * (i % in_word)));
  }
}

}  // namespace zstrip::sim
