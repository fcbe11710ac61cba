// Presets of quality by name: what to add to a scene's effects, to its budget and to its camera. docs/accuracy.md says
// what each costs and buys.
#pragma once

#include <string_view>

#include "zstrip/plan/plan_types.hpp"
#include "zstrip/scene/effects.hpp"

namespace zstrip {

/// Renderer<effects_of(scene, camera) | quality.effects>, plan(..., quality.budget).
struct Quality {
  std::string_view name;
  Effects effects{};         ///< beside those that the scene calls for
  Budget budget{};           ///< rows of a strip; set `bytes` and the rest as the board has it
  bool smooth = true;        ///< for Material::smooth of all materials: false is flat shading
  int detail_percent = 100;  ///< of the triangles of a mesh, how many to keep where it is baked (meshoptimizer)
};

namespace quality {
/// Least memory: strips of 4 rows, half of the triangles, flat. For boards that cannot hold more.
inline constexpr Quality tiny{
    .name = "tiny", .budget = {.strip_rows = 4, .modes = Modes::streamed}, .smooth = false, .detail_percent = 50};
/// What the renderer does where nothing is asked for, in strips of 16 rows.
inline constexpr Quality balanced{.name = "balanced", .budget = {.strip_rows = 16, .modes = Modes::streamed}};
/// Closest to the truth: each pixel of a texture in its exact place. Meant for scenes seen with perspective.
inline constexpr Quality exact{
    .name = "exact", .effects = effect::perspective_1, .budget = {.strip_rows = 16, .modes = Modes::streamed}};
inline constexpr const Quality* all[]{&tiny, &balanced, &exact};
}  // namespace quality

/// The preset of this name; null if there is none.
constexpr const Quality* find_quality(std::string_view name) {
  for (const Quality* preset : quality::all) {
    if (preset->name == name) return preset;
  }
  return nullptr;
}

}  // namespace zstrip
