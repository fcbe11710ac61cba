// The contract of the kernels (core/zstrip/kernels): what a processor's own implementation writes is what the portable
// one writes, bit by bit. The same cases on hosts and on boards: hard edges and random ones, with fixed seeds.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace zstrip::kernels_test {

/// What came of comparing a kernel's implementations.
struct Outcome {
  std::uint32_t compared = 0;   ///< what is equal: vertices, triangles, or pictures that something was drawn into
  std::string_view difference;  ///< what differs in case `number`; empty: nothing
  std::uint32_t number = 0;

  constexpr bool differs(std::string_view what, std::uint32_t which) {
    difference = what, number = which;
    return true;
  }
};

struct Contract {
  std::string_view name;
  bool has_own;                                       ///< whether this processor has an implementation of its own
  Outcome (*compare)(std::uint32_t number_of_cases);  ///< these in their order, the first ones
  std::uint32_t on_hosts, on_boards;                  ///< how many cases
  std::uint32_t least;                                ///< of Outcome::compared, on boards
};

/// One for each kernel, and four for what calls several.
std::span<const Contract> contracts();

Outcome compare_transforms(std::uint32_t cases);
Outcome compare_small_triangles(std::uint32_t cases);
Outcome compare_medium_triangles(std::uint32_t cases);
Outcome compare_medium_textured(std::uint32_t cases);
Outcome compare_small_runs(std::uint32_t cases);
Outcome compare_meshlets(std::uint32_t cases);
Outcome compare_lists(std::uint32_t cases);
Outcome compare_strips(std::uint32_t cases);
Outcome compare_shadowed_strips(std::uint32_t cases);
Outcome compare_spans(std::uint32_t cases);
Outcome compare_textured_runs(std::uint32_t cases);
Outcome compare_bilinear(std::uint32_t cases);
Outcome compare_span_triangles(std::uint32_t cases);
Outcome compare_triangle_planes(std::uint32_t cases);

}  // namespace zstrip::kernels_test
