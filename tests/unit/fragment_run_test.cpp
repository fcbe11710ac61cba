// The stages of fragments, pixel by pixel: each rounds every channel to the nearest whole number.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "zstrip/base/bayer.hpp"
#include "zstrip/kernels/fragment_run.hpp"
#include "zstrip/raster/run_texels.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::detail;

struct Channels {
  int r, g, b, a;
  bool operator==(const Channels&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Channels& c) {
  return out << c.r << ' ' << c.g << ' ' << c.b << ' ' << c.a;
}

Channels channels(std::uint32_t colour) {
  return {static_cast<int>(colour >> 16 & 255), static_cast<int>(colour >> 8 & 255), static_cast<int>(colour & 255),
          static_cast<int>(colour >> 24)};
}

/// 5 and 6 bits widened to 8 by their own upper bits.
Channels of_word(unsigned word, int alpha = 255) {
  const auto wide = [](unsigned value, int bits) {
    return static_cast<int>(value << (8 - bits) | value >> (2 * bits - 8));
  };
  return {wide(word >> 11, 5), wide(word >> 5 & 63, 6), wide(word & 31, 5), alpha};
}

int nearest(double value) { return static_cast<int>(std::floor(value + 0.5)); }
double share_of(int channel) { return (channel + channel / 128) / 256.0; }

class FragmentRuns : public testing::Test {
 protected:
  std::mt19937 random{5};

  std::uint32_t word() { return static_cast<std::uint32_t>(random()); }
  int below(int end) { return static_cast<int>(word() % static_cast<unsigned>(end)); }

  /// Random colours, of which the first `count` are of the run.
  struct Colours {
    RunColours now;
    std::array<Channels, kPerspectiveRun> before;
    int count;
  };
  Colours colours() {
    Colours made{{}, {}, 1 + below(kPerspectiveRun)};
    for (int i = 0; i < kPerspectiveRun; ++i) {
      made.now[i] = below(4) == 0 ? (below(2) == 0 ? 0xFFFFFFFF : 0) : word();
      made.before[static_cast<std::size_t>(i)] = channels(made.now[i]);
    }
    return made;
  }
  /// Light that stays within 0 .. 255 over a run.
  RunLight light() {
    const auto from = [this] { return static_cast<std::uint32_t>(below(256 << 16)); };
    RunLight made{from(), from(), from(), 0, 0, 0};
    const auto step = [this](std::uint32_t start) {
      const int end = below(256 << 16);
      return static_cast<std::uint32_t>((end - static_cast<int>(start)) / kPerspectiveRun);
    };
    made.step_r = step(made.r), made.step_g = step(made.g), made.step_b = step(made.b);
    return made;
  }
  static Channels light_at(const RunLight& light, int i) {
    const auto at = [i](std::uint32_t start, std::uint32_t step) {
      return static_cast<int>((start + step * static_cast<std::uint32_t>(i)) >> 16);
    };
    return {at(light.r, light.step_r), at(light.g, light.step_g), at(light.b, light.step_b), 255};
  }
  /// Compares with expected(i, colour before) and checks that nothing behind the run has changed.
  template <class Expected>
  static void expect(const Colours& colours, const Expected& expected) {
    for (int i = 0; i < kPerspectiveRun; ++i) {
      const Channels& before = colours.before[static_cast<std::size_t>(i)];
      ASSERT_EQ(channels(colours.now[i]), i < colours.count ? expected(i, before) : before) << i;
    }
  }
};

TEST_F(FragmentRuns, LightMultipliesAndWhiteChangesNothing) {
  for (int round = 0; round < 2000; ++round) {
    Colours c = colours();
    const RunLight by = round % 5 == 0 ? RunLight{255 << 16, 255 << 16, 255 << 16, 0, 0, 0} : light();
    std::uint16_t lit[kPerspectiveRun + 1] = {}, packed[kPerspectiveRun + 1] = {};
    write_lit(by, c.now, lit, c.count);
    multiply_by_light(by, c.now, c.count);
    write_packed(c.now, packed, c.count);
    for (int i = 0; i <= kPerspectiveRun; ++i) ASSERT_EQ(lit[i], packed[i]) << round << ' ' << i;
    expect(c, [&](int i, const Channels& before) {
      if (round % 5 == 0) return before;
      const Channels l = light_at(by, i);
      return Channels{nearest(before.r * share_of(l.r)), nearest(before.g * share_of(l.g)),
                      nearest(before.b * share_of(l.b)), before.a};
    });
    Colours d = colours();
    RunColours factors;
    for (std::uint32_t& factor : factors) factor = word();
    multiply_by_colours(factors, d.now, d.count);
    expect(d, [&](int i, const Channels& before) {
      const Channels l = channels(factors[i]);
      return Channels{nearest(before.r * share_of(l.r)), nearest(before.g * share_of(l.g)),
                      nearest(before.b * share_of(l.b)), before.a};
    });
    Colours e = colours();
    set_to_light(by, e.now, e.count);
    expect(e, [&](int i, const Channels&) { return light_at(by, i); });
  }
}

TEST_F(FragmentRuns, FogAndWhatLiesBehindAreMixedByTheirShare) {
  for (int round = 0; round < 2000; ++round) {
    const auto mean = [](int a, int b, double share) { return nearest(a * share + b * (1 - share)); };
    Colours c = colours();
    const Colour fog{static_cast<std::uint8_t>(word()), static_cast<std::uint8_t>(word()),
                     static_cast<std::uint8_t>(word()), 255};
    const int visible = round % 7 == 0 ? 256 << 16 : below((256 << 16) + 1);
    const int step = (below((256 << 16) + 1) - visible) / kPerspectiveRun;
    const auto share_at = [&](int i) { return ((visible + step * i) >> 16) / 256.0; };
    mix_fog(fog, visible, step, c.now, c.count);
    expect(c, [&](int i, const Channels& b) {
      const double share = share_at(i);
      return Channels{mean(b.r, fog.r, share), mean(b.g, fog.g, share), mean(b.b, fog.b, share), b.a};
    });
    // The same in one stage.
    const RunLight by = light();
    RunColours chain;
    std::uint16_t one[kPerspectiveRun + 1] = {}, three[kPerspectiveRun + 1] = {};
    set_to_light(by, chain, c.count);
    mix_fog(fog, visible, step, chain, c.count);
    write_packed(chain, three, c.count);
    write_fogged_light(by, fog, visible, step, one, c.count);
    for (int i = 0; i <= kPerspectiveRun; ++i) ASSERT_EQ(one[i], three[i]) << round << ' ' << i;

    Colours d = colours();
    std::uint16_t behind[kPerspectiveRun];
    for (std::uint16_t& pixel : behind) pixel = static_cast<std::uint16_t>(word());
    const int material = below(257);
    // The same in one stage, over the pixels themselves.
    Colours copy = d;
    std::uint16_t two[kPerspectiveRun] = {}, over[kPerspectiveRun];
    std::copy(std::begin(behind), std::end(behind), over);
    mix_behind(behind, static_cast<std::uint32_t>(material), copy.now, d.count);
    write_packed(copy.now, two, d.count);
    write_mixed(over, static_cast<std::uint32_t>(material), d.now, over, d.count);
    for (int i = 0; i < kPerspectiveRun; ++i) ASSERT_EQ(over[i], i < d.count ? two[i] : behind[i]) << round << ' ' << i;
    mix_behind(behind, static_cast<std::uint32_t>(material), d.now, d.count);
    expect(d, [&](int i, const Channels& b) {
      const Channels other = of_word(behind[i]);
      const double share = share_of(b.a * material / 256);
      return Channels{mean(b.r, other.r, share), mean(b.g, other.g, share), mean(b.b, other.b, share), b.a};
    });
  }
}

TEST_F(FragmentRuns, PixelsArePackedAndDithered) {
  for (int round = 0; round < 1000; ++round) {
    const Colours c = colours();
    std::uint16_t packed[kPerspectiveRun + 1] = {}, dithered[kPerspectiveRun + 1] = {};
    const auto column = static_cast<std::uint32_t>(word());
    const auto& thresholds = kBayer[round & 7];
    write_packed(c.now, packed, c.count);
    write_dithered(thresholds, column, c.now, dithered, c.count);
    for (int i = 0; i <= kPerspectiveRun; ++i) {
      if (i >= c.count) {
        ASSERT_EQ(packed[i] + dithered[i], 0);
        continue;
      }
      const Channels b = c.before[static_cast<std::size_t>(i)];
      ASSERT_EQ(packed[i], b.r / 8 * 2048 + b.g / 4 * 32 + b.b / 8);
      const double threshold = thresholds[(column + static_cast<std::uint32_t>(i)) % 8];
      // A level more, where what is lost and the threshold make a whole one. Without what repeats the upper bits.
      const auto level = [threshold](int channel, int bits) {
        const int lost = 1 << (8 - bits);
        return (channel - (channel >> bits) + static_cast<int>(threshold * lost / 64)) / lost;
      };
      ASSERT_EQ(dithered[i], level(b.r, 5) * 2048 + level(b.g, 6) * 32 + level(b.b, 5));
    }
  }
}

/// A texture of random texels in any format, and its texel at any column and row.
struct AnyTexture {
  std::vector<std::uint16_t> words;
  Texture texture{};
  unsigned width, height;

  AnyTexture(std::mt19937& random, TextureFormat format) {
    texture.log2_width = static_cast<std::uint8_t>(random() % 5),
    texture.log2_height = static_cast<std::uint8_t>(random() % 5);
    texture.format = format;
    width = 1U << texture.log2_width, height = 1U << texture.log2_height;
    const std::size_t palette = has_palette(format) ? std::size_t{1} << index_bits(format) : 0;
    words.resize(palette + level_words(format, std::uint32_t{texture.log2_width} + texture.log2_height));
    for (std::uint16_t& word : words) word = static_cast<std::uint16_t>(random());
  }
  Channels at(unsigned column, unsigned row) const {
    const std::size_t index = row % height * width + column % width;
    if (texture.format == TextureFormat::palette8)
      return of_word(words[words[256 + index / 2] >> 8 * (index % 2) & 255]);
    if (texture.format == TextureFormat::palette4) return of_word(words[words[16 + index / 4] >> 4 * (index % 4) & 15]);
    if (texture.format == TextureFormat::rgb565) return of_word(words[index]);
    return of_word(words[index], words[std::size_t{width} * height + index / 2] >> 8 * (index % 2) & 255);
  }
  RunTexels texels() const {
    return texels_of({words.data(), texture.log2_width, texture.log2_height}, texture.format);
  }
};

TEST_F(FragmentRuns, TexelsAreNearestOrTheMeanOfTheFourAround) {
  for (const TextureFormat format :
       {TextureFormat::rgb565, TextureFormat::rgb565_alpha, TextureFormat::palette8, TextureFormat::palette4}) {
    const bool alpha = format == TextureFormat::rgb565_alpha;
    for (int round = 0; round < 500; ++round) {
      const AnyTexture texture(random, format);
      // A side of one texel has the coordinate 0.
      const auto along = [&](unsigned side) { return side == 1 ? 0 : word() >> below(24); };
      // Steps of any size, both ways: within a texel, of exactly one, of many.
      const auto step_along = [&](unsigned side) -> std::uint32_t {
        if (side == 1) return 0;
        const std::uint32_t size =
            below(8) == 0 ? static_cast<std::uint32_t>((std::uint64_t{1} << 32) / side) : word() >> 1 >> below(24);
        return below(2) == 0 ? size : 0 - size;
      };
      const RunPlace place{along(texture.width) << 7, along(texture.height), step_along(texture.width),
                           step_along(texture.height)};
      const auto position = [&](int i, std::uint32_t start, std::uint32_t step, unsigned side) {
        return (start + step * static_cast<std::uint32_t>(i)) / 4294967296.0 * side;
      };
      Colours near = colours(), smooth = near, words = near;
      has_palette(format) ? fetch_nearest<true>(texture.texels(), place, near.now, near.count)
                          : fetch_nearest<false>(texture.texels(), place, near.now, near.count);
      if (alpha) fetch_alpha(texture.texels(), place, near.now, near.count);
      expect(near, [&](int i, const Channels&) {
        return texture.at(static_cast<unsigned>(position(i, place.u, place.step_u, texture.width)),
                          static_cast<unsigned>(position(i, place.v, place.step_v, texture.height)));
      });
      has_palette(format) ? fetch_words<true>(texture.texels(), place, words.now, words.count)
                          : fetch_words<false>(texture.texels(), place, words.now, words.count);
      for (int i = 0; i < words.count; ++i) {
        Channels opaque = channels(near.now[i]);
        opaque.a = 255;
        ASSERT_EQ(of_word(words.now[i]), opaque);
      }
      if (alpha) {
        fetch_bilinear<false, true>(texture.texels(), place, smooth.now, smooth.count);
      } else if (has_palette(format)) {
        fetch_bilinear<true, false>(texture.texels(), place, smooth.now, smooth.count);
      } else {
        fetch_bilinear<false, false>(texture.texels(), place, smooth.now, smooth.count);
      }
      expect(smooth, [&](int i, const Channels&) {
        // From the centres; weights are rounded down to 1/256.
        const double x = position(i, place.u, place.step_u, texture.width) - 0.5 + texture.width;
        const double y = position(i, place.v, place.step_v, texture.height) - 0.5 + texture.height;
        const auto column = static_cast<unsigned>(x), row = static_cast<unsigned>(y);
        const double right = texture.width == 1 ? 0 : std::floor((x - column) * 256) / 256;
        const double down = texture.height == 1 ? 0 : std::floor((y - row) * 256) / 256;
        const unsigned next_column = texture.width == 1 ? column : column + 1;
        const unsigned next_row = texture.height == 1 ? row : row + 1;
        const Channels a = texture.at(column, row), b = texture.at(next_column, row), c = texture.at(column, next_row),
                       d = texture.at(next_column, next_row);
        const auto mean = [&](int Channels::*channel) {
          return nearest((a.*channel * (1 - right) + b.*channel * right) * (1 - down) +
                         (c.*channel * (1 - right) + d.*channel * right) * down);
        };
        return Channels{mean(&Channels::r), mean(&Channels::g), mean(&Channels::b), mean(&Channels::a)};
      });
    }
  }
}

}  // namespace
