// Kernel: the stages of fragments with effects. A stage is one short loop over neighbouring pixels of a row, so that
// its constants stay in registers.
//
// A run has at most kPerspectiveRun pixels. Between stages a colour is a word 0xAARRGGBB; every stage rounds to whole
// channels. Texture coordinates are 0.32 of the texture, light is 8.16; both are stepped modulo 2^32. `count` is 1 or
// more; nothing outside of the run is written.
#pragma once

#include <cstdint>

#include "zstrip/pixels/textured_run_state.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// The colours of a run between two stages.
using RunColours = std::uint32_t[kPerspectiveRun];

/// One level of a texture.
struct RunTexels {
  const std::uint16_t* texels;   ///< after the palette; the alpha channel follows
  const std::uint16_t* palette;  ///< read only if the format has one
  std::uint32_t log2_width, log2_height;
  TextureFormat format;
};

/// The texture coordinates of a run.
struct RunPlace {
  std::uint32_t u, v, step_u, step_v;
};

/// The light on a run; a channel is 0 .. 255 in its upper half.
struct RunLight {
  std::uint32_t r, g, b, step_r, step_g, step_b;
};

/// RGB565 as it is stored, in the lower half of a word. `palettes`: the format may have one.
template <bool palettes>
void fetch_words(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count);

/// Texels whose alpha is 255.
template <bool palettes>
void fetch_nearest(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count);

/// The mean of the four texels around each point, weighted by distance in 1/256. With `alpha` the texture has alpha.
template <bool palettes, bool alpha>
void fetch_bilinear(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count);

/// Sets the alpha of nearest texels.
void fetch_alpha(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count);

/// The light itself as a colour, with an alpha of 255.
void set_to_light(const RunLight& light, std::uint32_t* colours, std::int32_t count);

void multiply_by_light(const RunLight& light, std::uint32_t* colours, std::int32_t count);
void multiply_by_colours(const std::uint32_t* factors, std::uint32_t* colours, std::int32_t count);

/// Writes what multiply_by_light and write_packed would write.
void write_lit(const RunLight& light, const std::uint32_t* colours, std::uint16_t* pixels, std::int32_t count);

/// Multiplies words of RGB565 as TexturedRun does, and writes them.
void write_lit_words(const RunLight& light, const std::uint32_t* words, std::uint16_t* pixels, std::int32_t count);

/// Multiplies alpha by `material`, 0 .. 256.
void multiply_alpha(std::uint32_t material, std::uint32_t* colours, std::int32_t count);

/// `visible`: 0 .. 256 in 8.16.
void mix_fog(const Colour& fog, std::int32_t visible, std::int32_t step, std::uint32_t* colours, std::int32_t count);

/// Mixes with the pixels that are behind, by alpha times `material` (0 .. 256). Keeps alpha.
void mix_behind(const std::uint16_t* behind, std::uint32_t material, std::uint32_t* colours, std::int32_t count);

/// Writes what mix_behind and write_packed would write. `pixels` may be `behind`.
void write_mixed(const std::uint16_t* behind, std::uint32_t material, const std::uint32_t* colours,
                 std::uint16_t* pixels, std::int32_t count);

/// Writes what set_to_light, mix_fog and write_packed would write.
void write_fogged_light(const RunLight& light, const Colour& fog, std::int32_t visible, std::int32_t step,
                        std::uint16_t* pixels, std::int32_t count);

void write_packed(const std::uint32_t* colours, std::uint16_t* pixels, std::int32_t count);

/// `thresholds`: a row of kBayer; `column`: of the first pixel.
void write_dithered(const std::uint8_t (&thresholds)[8], std::uint32_t column, const std::uint32_t* colours,
                    std::uint16_t* pixels, std::int32_t count);

}  // namespace zstrip::detail
