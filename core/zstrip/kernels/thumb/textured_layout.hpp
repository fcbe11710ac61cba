// The layout of TexturedScan for the assembly of medium textured triangles.
#pragma once

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/layout.hpp"
#include "zstrip/kernels/thumb/medium_layout.hpp"
#include "zstrip/kernels/thumb/run_layout.hpp"
#include "zstrip/pixels/textured_scan.hpp"

// clang-format off
#define ZSTRIP_TEXTURED_SCAN(field, number)                                                         \
  field(textured, TexturedScan, scan, 0)                                                            \
  number(textured.start_one_over_w, offsetof(TexturedScan, start[TexturedScan::one_over_w]), 160)   \
  number(textured.start_u_over_w, offsetof(TexturedScan, start[TexturedScan::u_over_w]), 164)       \
  number(textured.start_v_over_w, offsetof(TexturedScan, start[TexturedScan::v_over_w]), 168)       \
  number(textured.step_y_one_over_w, offsetof(TexturedScan, step_y[TexturedScan::one_over_w]), 172) \
  number(textured.step_y_u_over_w, offsetof(TexturedScan, step_y[TexturedScan::u_over_w]), 176)     \
  number(textured.step_y_v_over_w, offsetof(TexturedScan, step_y[TexturedScan::v_over_w]), 180)     \
  number(textured.step_x_one_over_w, offsetof(TexturedScan, step_x[TexturedScan::one_over_w]), 184) \
  number(textured.step_x_u_over_w, offsetof(TexturedScan, step_x[TexturedScan::u_over_w]), 188)     \
  number(textured.step_x_v_over_w, offsetof(TexturedScan, step_x[TexturedScan::v_over_w]), 192)     \
  field(textured, TexturedScan, base_u, 196)                                                        \
  field(textured, TexturedScan, base_v, 200)                                                        \
  field(textured, TexturedScan, to_fraction_u, 204)                                                 \
  field(textured, TexturedScan, to_fraction_v, 208)                                                 \
  field(textured, TexturedScan, right_shift, 212)                                                   \
  field(textured, TexturedScan, row, 216)                                                           \
  field(corner, TexturedVertex, depth, 0)                                                           \
  field(corner, TexturedVertex, u, 4)                                                               \
  field(corner, TexturedVertex, v, 8)
// clang-format on

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

ZSTRIP_CHECK_LAYOUT(ZSTRIP_TEXTURED_SCAN)

#endif

}  // namespace zstrip::detail
