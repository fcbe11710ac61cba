// Counts of the work of a frame. Only renderers built with effect::statistics count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace zstrip {

/// Work that not every scene makes. Triangles and fragments are those of Statistics::covering and fragments, and those
/// that shadows draw in addition; all others are plain.
enum class WorkKind : std::uint8_t {
  textured_triangles,      ///< without light, nearest texels
  textured_fragments,      ///< theirs
  lit_textured_triangles,  ///< with light, nearest texels
  lit_textured_fragments,  ///< theirs
  staged_triangles,        ///< whose fragments have effects
  staged_fragments,        ///< theirs
  staged_textures,         ///< of these triangles, those with texels
  spans,                   ///< rows of staged triangles
  runs,                    ///< neighbouring fragments of theirs that are drawn together
  runs_of_levels,          ///< runs of textures with smaller levels
  nearest_texels,          ///< fragments in a run, as all below down to `dithered`
  bilinear_texels,
  texel_alphas,
  lit_texels,
  lit_fragments,  ///< light at pixels
  masked,
  fogged,
  blended,
  dithered,
  lit_vertices,         ///< vertices whose colour is computed, counted in each strip
  lights_of_vertices,   ///< point and spot lights on these vertices
  shining_vertices,     ///< lights of all kinds on these vertices, where the material has highlights
  mirroring_vertices,   ///< with an environment map
  clips,                ///< triangles that are clipped, tried in each strip
  cells_of_shadow_map,  ///< cells of the whole map
  shadow_samples,       ///< pixels that are looked up in the map
  hull_vertices,        ///< of outlines
  meshlets_again,       ///< of the whole scene, for each strip with pixels in shadow
  vertices_again,       ///< for the map and for pixels in shadow, as the next two
  triangles_again,
  fragments_again,
  fragments_of_quadrics,
  fragments_of_lines,
  searched_edges,   ///< of visible instances; counted once, as the next one
  surveyed_edges,   ///< whose faces do not show at once that the edge is not seen
  projected_edges,  ///< that may show in a strip; counted in each
  blended_edges,    ///< of these, the ones that cross the strip
  pixels_of_edges,  ///< rows or columns of theirs in the strip
};
inline constexpr std::size_t kWorkKinds = static_cast<std::size_t>(WorkKind::pixels_of_edges) + 1;

struct WorkCounts {
  std::uint32_t of[kWorkKinds] = {};

  constexpr std::uint32_t& operator[](WorkKind kind) { return of[static_cast<std::size_t>(kind)]; }
  constexpr std::uint32_t operator[](WorkKind kind) const { return of[static_cast<std::size_t>(kind)]; }
};

/// In place of WorkCounts on boards: takes no memory and counts nothing.
struct NoWorkCounts {
  struct Ignored {
    constexpr void operator+=(std::uint32_t) const {}
    constexpr void operator++() const {}
  };
  constexpr Ignored operator[](WorkKind) const { return {}; }
  constexpr operator WorkCounts() const { return {}; }
};
/// True on computers, of 32 bits too, and on pages: the command estimates by these counts, and each renderer keeps
/// them.
#if defined(__linux__) || defined(__wasm__)
inline constexpr bool kKeepsWork = true;
#else
inline constexpr bool kKeepsWork = sizeof(void*) > 4;
#endif

struct Statistics {
  std::uint32_t triangles = 0;  ///< sum over all instances, before any culling
  std::uint32_t drawn = 0;      ///< front-facing triangles that reach into the picture; counted in the first strip that
                                ///< they touch
  std::uint32_t clipped = 0;    ///< triangles that took the clipping path; counted once for each strip
  std::uint32_t covering = 0;   ///< drawn triangles that cover a pixel centre; counted in each strip where they do
  std::uint32_t vertices = 0;   ///< transformed vertices; in Mode::streamed counted again for each strip
  std::uint32_t fragments = 0;  ///< pixels covered by triangles, before the depth test
  std::uint32_t depth_passes = 0;  ///< fragments that were written
  [[no_unique_address]] std::conditional_t<kKeepsWork, WorkCounts, NoWorkCounts> work{};  ///< all 0 on boards
};

namespace detail {

template <bool statistics>
inline void count_pass(Statistics* counters) {
  if constexpr (statistics) ++counters->depth_passes;
}

}  // namespace detail

}  // namespace zstrip
