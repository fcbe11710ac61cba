// Draws textured spans of the span rasteriser, in runs between exact texture positions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/base/statistics.hpp"
#include "zstrip/kernels/texture_coordinates.hpp"
#include "zstrip/kernels/textured_run.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/pixels/textured_run_state.hpp"
#include "zstrip/pixels/triangle_depth.hpp"

namespace zstrip::detail {

/// 2^16 / n, for the shorter last run of a span.
inline constexpr std::int32_t kInverse[kPerspectiveRun] = {0,    65536, 32768, 21845, 16384, 13107, 10922, 9362,
                                                           8192, 7281,  6553,  5957,  5461,  5041,  4681,  4369};

/// Returns a - b modulo 2^32.
constexpr std::int32_t difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

/// Returns the step a pixel between two exact texture coordinates that are `pixels` (1 .. 15) apart, modulo 2^32.
constexpr std::uint32_t step_of_run(std::int32_t from, std::int32_t to, std::uint32_t pixels) {
  return static_cast<std::uint32_t>(long_product(difference(to, from), kInverse[pixels]) >> 16);
}

/// `light` is read only if texels are lit. Exact positions are 2^log2_run pixels apart; log2_run is 0 .. 4.
template <bool affine, int log2_run, TexelLight lit, bool statistics, class DepthPlane, class Rule>
void fill_textured(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                   const TextureView& texture, const TextureCoordinates<affine>& coordinates, const ColourPlanes& light,
                   Statistics* counters) {
  constexpr std::int32_t kRun = 1 << log2_run;
  static_assert(kRun <= kPerspectiveRun);
  const TextureAxis axis_u(texture.log2_width);
  const TextureAxis axis_v(texture.log2_height);
  using Value = typename DepthPlane::Value;
  constexpr bool kWholeRuns = kHasWholeRuns<lit, statistics, Value, Rule> && !affine && kRun == kPerspectiveRun;
  using State = std::conditional_t<kWholeRuns, TexturedRunsState, TexturedRunState<Value>>;
  TexturedRun<lit, statistics, Value, Rule, State> run;
  run.rule = rule;
  run.z = depth.at(span.columns, span.rows);
  run.step_z = depth.step_x;
  run.set_texture(texture);
  if constexpr (lit == TexelLight::flat) {
    run.r = light_factor(light.r.start), run.g = light_factor(light.g.start), run.b = light_factor(light.b.start);
  } else if constexpr (lit == TexelLight::smooth) {
    run.r = light.r.at(span.columns, span.rows);
    run.g = light.g.at(span.columns, span.rows);
    run.b = light.b.at(span.columns, span.rows);
  }
  const bool known = knows_texture(run);
  // The number of pixels of the first run that lie to the left of the span.
  std::int32_t before = span.skipped & (kRun - 1);
  std::int32_t left = span.whole_length - span.skipped + before;
  auto* depth_cell = span.depth;
  std::uint16_t* pixel = span.colour;
  std::uint16_t* const end = pixel + span.length;
  auto place = coordinates.place(span.columns - before, span.rows);
  TexelPosition from = coordinates.at(place);
  for (;;) {
    if constexpr (kWholeRuns) {
      const std::int32_t whole =
          before != 0 || !known ? 0 : std::min((left - 1) / kRun, static_cast<std::int32_t>(end - pixel) / kRun);
      if (whole > 0) {
        run.to_fraction_u = axis_u.to_fraction, run.to_fraction_v = axis_v.to_fraction;
        coordinates.start_runs(run, place, from, static_cast<std::uint32_t>(kRun));
        fill_runs(run, depth_cell, pixel, static_cast<std::uint32_t>(whole));
        pixel += whole * kRun;
        if (pixel == end) break;
        depth_cell += whole * kRun;
        left -= whole * kRun;
        place = {run.u_over_w, run.v_over_w, run.one_over_w};
        from = {run.from_u, run.from_v};
      }
    }
    // A full run ends at the first pixel of the next run, the last run at its own last pixel, both inside the triangle.
    const std::int32_t length = left > kRun ? kRun : left;
    place = coordinates.right_of(place, left > kRun ? kRun : left - 1);
    const TexelPosition to = coordinates.at(place);
    std::int32_t step_u = difference(to.u, from.u), step_v = difference(to.v, from.v);  // 16.16
    if (left > kRun) {
      step_u >>= log2_run;
      step_v >>= log2_run;
    } else {
      const std::int32_t inverse = kInverse[left - 1];
      step_u = static_cast<std::int32_t>((std::int64_t{step_u} * inverse) >> 16);
      step_v = static_cast<std::int32_t>((std::int64_t{step_v} * inverse) >> 16);
    }
    run.step_u = axis_u.fraction(step_u);
    run.step_v = axis_v.fraction(step_v);
    run.u = axis_u.fraction(from.u);
    run.v = axis_v.fraction(from.v);
    if (before != 0) {
      run.u += run.step_u * static_cast<std::uint32_t>(before);
      run.v += run.step_v * static_cast<std::uint32_t>(before);
    }
    const std::int32_t drawn = std::min(length - before, static_cast<std::int32_t>(end - pixel));
    fill_run(run, known, depth_cell, pixel, drawn, light, counters);
    pixel += drawn;
    if (pixel == end) break;
    depth_cell += drawn;
    left -= kRun;
    before = 0;
    from = to;
  }
}

}  // namespace zstrip::detail
