// Draws runs of texels in C++, on every processor.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/textured_run_state.hpp"

namespace zstrip::detail {

/// Draws the pixels between two exact texture positions: implements fill_run in C++. Not inlined: the loop needs every
/// register of a Cortex-M.
template <TexelLight lit, bool statistics, class Value, class Rule, class State = TexturedRunState<Value>>
struct TexturedRun : LitRunState<State> {
  [[no_unique_address]] Rule rule;

  [[gnu::noinline]] void fill(typename Rule::Cell* depth, std::uint16_t* pixel, std::int32_t length,
                              const ColourPlanes& light, Statistics* counters) {
    const std::uint16_t* const t = this->texels;
    const std::uint32_t du = this->step_u, dv = this->step_v, mask = this->row_mask;
    const Value dz = this->step_z;
    const std::int32_t shift_u = this->to_column, shift_v = this->to_row;
    std::uint32_t red = this->r, green = this->g, blue = this->b;
    std::uint32_t at_u = this->u, at_v = this->v;
    Value at_z = this->z;
    std::uint16_t* const end = pixel + length;
    do {
      if (rule.draws(at_z, *depth)) {
        const std::uint16_t texel = t[((at_v >> shift_v) & mask) + (at_u >> shift_u)];
        if constexpr (lit == TexelLight::smooth) {
          *pixel = modulated(texel, red, green, blue);
        } else if constexpr (lit == TexelLight::flat) {
          *pixel = multiplied(texel, red, green, blue);
        } else {
          *pixel = texel;
        }
        count_pass<statistics>(counters);
      }
      ++depth;
      at_z += dz;
      at_u += du;
      at_v += dv;
      if constexpr (lit == TexelLight::smooth) {
        red += light.r.step_x;
        green += light.g.step_x;
        blue += light.b.step_x;
      }
    } while (++pixel != end);
    this->z = at_z;
    if constexpr (lit == TexelLight::smooth) this->r = red, this->g = green, this->b = blue;
  }
};

/// Implements fill_runs in C++, for tests: it divides as the loop over a span does (kernels/textured_span.hpp).
template <class Run>
void fill_runs_portable(Run& run, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count) {
  for (; count != 0; --count) {
    run.u_over_w += run.u_over_w_step;
    run.v_over_w += run.v_over_w_step;
    run.one_over_w += run.one_over_w_step;
    const Reciprocal w = reciprocal_of(run.one_over_w == 0 ? 1 : run.one_over_w);
    const int right = run.right_shift - w.normalisation;
    // Returns u or v in texels, 16.16, modulo 2^16 texels.
    const auto texels = [&](std::uint32_t over_w, std::int32_t base) {
      const std::int32_t high = multiply_high(static_cast<std::int32_t>(over_w), w.value);
      const std::uint32_t from_base = right >= 0 ? static_cast<std::uint32_t>(high >> (right < 31 ? right : 31))
                                                 : static_cast<std::uint32_t>(high) << (right > -31 ? -right : 31);
      return static_cast<std::uint32_t>(base) + from_base;
    };
    const auto step = [](std::uint32_t from, std::uint32_t to) {  // per pixel
      static_assert(kPerspectiveRun == 1 << 4);
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(to - from) >> 4);
    };
    const auto from_u = static_cast<std::uint32_t>(run.from_u), from_v = static_cast<std::uint32_t>(run.from_v);
    const std::uint32_t to_u = texels(run.u_over_w, run.base_u), to_v = texels(run.v_over_w, run.base_v);
    run.u = from_u * run.to_fraction_u, run.v = from_v * run.to_fraction_v;
    run.step_u = step(from_u, to_u) * run.to_fraction_u, run.step_v = step(from_v, to_v) * run.to_fraction_v;
    run.fill(depth, pixel, kPerspectiveRun, ColourPlanes{}, nullptr);
    run.from_u = static_cast<std::int32_t>(to_u), run.from_v = static_cast<std::int32_t>(to_v);
    depth += kPerspectiveRun;
    pixel += kPerspectiveRun;
  }
}

}  // namespace zstrip::detail
