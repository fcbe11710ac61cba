// The list of contracts. Boards are emulated: they take a part of the cases.
#include "contracts.hpp"

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/medium_triangle.hpp"

namespace zstrip::kernels_test {

std::span<const Contract> contracts() {
  using namespace detail;
  static constexpr Contract kContracts[] = {
      {"transform", kHasThumb || kHasVectors, compare_transforms, 40'000, 2'000, 10'000},
      {"small", kHasThumb || kHasVectors, compare_small_triangles, 120'000, 40'000, 10'000},
      {"medium", kHasMediumTriangles, compare_medium_triangles, 80'000, 10'000, 4'000},
      {"textured", true, compare_medium_textured, 60'000, 8'000, 1'000},
      {"runs", kHasThumb || kHasVectors, compare_small_runs, 12'000, 600, 10'000},
      {"meshlets", kHasThumb || kHasVectors, compare_meshlets, 30'000, 900, 10'000},
      {"lists", true, compare_lists, 12'000, 1'200, 10'000},
      {"strips", true, compare_strips, 30'000, 2'000, 10'000},
      {"shadows", true, compare_shadowed_strips, 24, 12, 500},
      {"spans", kHasVectors, compare_spans, 400, 40, 10'000},
      {"texels", kHasThumb || kHasVectors, compare_textured_runs, 80'000, 28'000, 10'000},
      {"bilinear", true, compare_bilinear, 40'000, 20'000, 100'000},
      {"triangles", kHasThumb || kHasVectors, compare_span_triangles, 63'000, 36'000, 4'000},
      {"planes", true, compare_triangle_planes, 80'000, 10'000, 4'000},
  };
  return kContracts;
}

}  // namespace zstrip::kernels_test
