// The data of the kernel of texels, for all implementations: the current state of runs.
#pragma once

#include <cstdint>

#include "zstrip/pixels/target.hpp"

namespace zstrip::detail {

/// The factor of texels: none, one colour, or interpolated colours.
enum class TexelLight : std::uint8_t { none, flat, smooth };

/// The largest number of pixels between two exact texture positions: a whole run.
inline constexpr std::int32_t kPerspectiveRun = 16;

/// A texture coordinate as a fraction of the texture in 0.32, which wraps by itself. If a side has one texel the
/// fraction stays 0.
struct TextureAxis {
  std::uint32_t to_fraction;  ///< factor, from 16.16 texels
  std::int32_t to_index;      ///< right shift

  explicit TextureAxis(std::uint8_t log2_size)
      : to_fraction(log2_size == 0 ? 0 : std::uint32_t{1} << (16 - log2_size)),
        to_index(log2_size == 0 ? 31 : 32 - log2_size) {}
  std::uint32_t fraction(std::int32_t texels) const { return static_cast<std::uint32_t>(texels) * to_fraction; }
};

/// The current state of a run. The assembly depends on the order of the members.
template <class Value>
struct TexturedRunState {
  std::uint32_t u, v, step_u, step_v;  ///< 0.32
  Value z, step_z;                     ///< from a depth plane
  const std::uint16_t* texels;
  std::int32_t to_column, to_row;  ///< right shifts; after to_row the row is multiplied by the texture's width
  std::uint32_t row_mask;          ///< clears the bits below a row

  void set_texture(const TextureView& texture) {
    texels = texture.texels;
    to_column = TextureAxis(texture.log2_width).to_index;
    const int row_bits = texture.log2_height + texture.log2_width;
    to_row = row_bits == 0 ? 31 : 32 - row_bits;
    row_mask = ~((std::uint32_t{1} << texture.log2_width) - 1);
  }
};

template <class State>
struct LitRunState : State {
  std::uint32_t r, g, b;  ///< light: light_factor if it is flat, 8.16 if it is smooth
};

/// With a depth of 32 bits, for assembly and vectors.
using WordRunState = TexturedRunState<std::uint32_t>;
using LitWordRunState = LitRunState<WordRunState>;

/// The state of the whole runs of a span with perspective: 16 pixels between two exact positions.
struct TexturedRunsState : WordRunState {
  std::uint32_t u_over_w, v_over_w, one_over_w;                 ///< at the first pixel of the next run
  std::uint32_t u_over_w_step, v_over_w_step, one_over_w_step;  ///< step a run
  std::int32_t base_u, base_v;                                  ///< from TextureCoordinates
  std::int32_t from_u, from_v;                                  ///< the exact position there, 16.16
  std::uint32_t to_fraction_u, to_fraction_v;                   ///< from TextureAxis
  std::int32_t right_shift;  ///< shift after the division by w, for a 1/w with normalisation 0
};

}  // namespace zstrip::detail
