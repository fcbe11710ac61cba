// Draws eight texels at a time: their indices are computed in two vectors, and the texels are fetched one by one.
#include "zstrip/kernels/vector/textured_run.hpp"

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/vector/interpolated.hpp"
#include "zstrip/pixels/colour.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {
using namespace vectors;

namespace {

/// Computes indices of texels, below 2^16, from coordinates.
class Texels {
 public:
  explicit Texels(const WordRunState& run)
      : texels_(run.texels), to_column_(run.to_column), to_row_(run.to_row), row_mask_(in_all_words(run.row_mask)) {}

  Halves four(Words u, Words v) const { return fetched<0>(Halves{}, indices(u, v)); }
  Halves eight(const Interpolated& u, const Interpolated& v) const {
    return fetched<4>(four(u.first, v.first), indices(u.last, v.last));
  }

 private:
  Halves indices(Words u, Words v) const { return as_halves(((v >> to_row_) & row_mask_) + (u >> to_column_)); }
  template <int first>
  Halves fetched(Halves texels, Halves indices) const {
    texels[first] = texels_[indices[0]];
    texels[first + 1] = texels_[indices[2]];
    texels[first + 2] = texels_[indices[4]];
    texels[first + 3] = texels_[indices[6]];
    return texels;
  }

  const std::uint16_t* texels_;
  int to_column_, to_row_;
  Words row_mask_;
};

/// Does the same as TextureCoordinates::divided: multiplies u/w and v/w in words 0 and 2 by w and shifts them right by
/// `right`, or left if `right` is negative.
Words times_w(Words over_w, const Reciprocal& w, int right) {
  const Words high = upper_products_of_even(over_w, in_all_words(static_cast<std::uint32_t>(w.value)));
  return right >= 0 ? arithmetically_right(high, right < 31 ? right : 31) : high << (right > -31 ? -right : 31);
}

/// Leaves texels unchanged.
struct Unlit {
  template <class Texels>
  Texels operator()(Texels texels) const {
    return texels;
  }
};

/// Multiplies texels by a light.
struct Lit {
  OneLight by;

  std::uint16_t operator()(std::uint16_t texel) const { return multiplied(texel, by.r, by.g, by.b); }
  Halves operator()(Halves texels) const {
    const auto lit = [](Halves channel, std::uint32_t factor) {
      return (channel * in_all_halves(static_cast<std::int32_t>(factor)) + in_all_halves(128)) >> 8;
    };
    const Halves green = (texels >> 5) & in_all_halves(0x3F), blue = texels & in_all_halves(0x1F);
    return (lit(texels >> 11, by.r) << 11) | (lit(green, by.g) << 5) | lit(blue, by.b);
  }
};

template <class Light>
[[gnu::always_inline]] inline void fill_runs(TexturedRunsState& state, const Light& light, std::uint16_t* depth,
                                             std::uint16_t* pixel, std::uint32_t count) {
  constexpr int kLog2Run = 4;
  const Texels texels(state);
  Interpolated z(state.z, state.step_z);
  std::uint32_t one_over_w = state.one_over_w;
  // u is in word 0, v in word 2.
  const auto both = [](auto u, auto v) {
    return Words{static_cast<std::uint32_t>(u), 0, static_cast<std::uint32_t>(v)};
  };
  Words over_w = both(state.u_over_w, state.v_over_w), from = both(state.from_u, state.from_v);
  const Words over_w_step = both(state.u_over_w_step, state.v_over_w_step), base = both(state.base_u, state.base_v);
  const Words to_fraction = both(state.to_fraction_u, state.to_fraction_v);
  for (std::uint32_t left = count; left != 0; --left) {
    over_w += over_w_step;
    one_over_w += state.one_over_w_step;
    const Reciprocal w = reciprocal_of(one_over_w == 0 ? 1 : one_over_w);
    const Words to = base + times_w(over_w, w, state.right_shift - w.normalisation);
    const Words start = products_of_even(from, to_fraction);
    const Words step = products_of_even(arithmetically_right(to - from, kLog2Run), to_fraction);
    Interpolated u(word_in_all<0>(start), word_in_all<0>(step)), v(word_in_all<2>(start), word_in_all<2>(step));
    draw_fragments(InOneRow{}, depth, pixel, z.upper(), [&] { return light(texels.eight(u, v)); });
    u.next(), v.next(), z.next();
    draw_fragments(InOneRow{}, depth + 8, pixel + 8, z.upper(), [&] { return light(texels.eight(u, v)); });
    z.next();
    from = to;
    depth += 16;
    pixel += 16;
  }
  state.z += state.step_z * (count << kLog2Run);
  state.u_over_w = over_w[0], state.v_over_w = over_w[2], state.one_over_w = one_over_w;
  state.from_u = static_cast<std::int32_t>(from[0]), state.from_v = static_cast<std::int32_t>(from[2]);
}

template <class Light>
[[gnu::always_inline]] inline void fill_run(WordRunState& run, const Light& light, std::uint16_t* depth,
                                            std::uint16_t* pixel, std::int32_t length) {
  const Texels texels(run);
  if (length >= 8) {
    Interpolated z(run.z, run.step_z), u(run.u, run.step_u), v(run.v, run.step_v);
    for_each_eight(
        length,
        [&](std::int32_t at) {
          draw_fragments(InOneRow{}, depth + at, pixel + at, z.upper(), [&] { return light(texels.eight(u, v)); });
        },
        [&] { z.next(), u.next(), v.next(); },
        [&](std::int32_t pixels) { z.move(pixels), u.move(pixels), v.move(pixels); });
  } else if (length >= 4) {
    // With more than four pixels this runs twice, the second time for the last four.
    for (std::int32_t at = 0;;) {
      const auto steps = static_cast<std::uint32_t>(at);
      const Words z = stepped_words(run.z + run.step_z * steps, run.step_z);
      const Words u = stepped_words(run.u + run.step_u * steps, run.step_u);
      const Words v = stepped_words(run.v + run.step_v * steps, run.step_v);
      draw_fragments(HalfRow{}, depth + at, pixel + at, upper_halves(z, z), [&] { return light(texels.four(u, v)); });
      if (at == length - 4) break;
      at = length - 4;
    }
  } else {
    std::uint32_t z = run.z, u = run.u, v = run.v;
    for (std::int32_t i = 0; i < length; ++i) {
      const auto code = static_cast<std::uint16_t>(z >> 16);
      if (code > depth[i]) {
        depth[i] = code;
        pixel[i] = light(run.texels[((v >> run.to_row) & run.row_mask) + (u >> run.to_column)]);
      }
      z += run.step_z;
      u += run.step_u;
      v += run.step_v;
    }
  }
  run.z += run.step_z * static_cast<std::uint32_t>(length);
}

}  // namespace

void fill_runs_vector(TexturedRunsState& state, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count) {
  fill_runs(state, Unlit{}, depth, pixel, count);
}
void fill_lit_runs_vector(TexturedRunsState& state, const OneLight& light, std::uint16_t* depth, std::uint16_t* pixel,
                          std::uint32_t count) {
  fill_runs(state, Lit{light}, depth, pixel, count);
}

void fill_run_vector(WordRunState& run, std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length) {
  fill_run(run, Unlit{}, depth, pixel, length);
}
void fill_lit_run_vector(WordRunState& run, const OneLight& light, std::uint16_t* depth, std::uint16_t* pixel,
                         std::int32_t length) {
  fill_run(run, Lit{light}, depth, pixel, length);
}

}  // namespace zstrip::detail

#endif
