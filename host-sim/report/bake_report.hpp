// The record of a baked scene, in words and as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bake/clipping.hpp"
#include "bake/effects_found.hpp"
#include "bake/flash_bytes.hpp"
#include "bake/mipmaps.hpp"
#include "bake/palettes.hpp"
#include "import/model.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The visibility method, if it is not the z-buffer.
struct BakedMethodRecord {
  Effects method;
  std::size_t splits = 0;  ///< triangles that were cut
  std::size_t nodes = 0;   ///< of the tree
};

/// Potentially visible sets that were written in addition to the scene.
struct VisibleSetRecord {
  std::string output;
  std::uint32_t cells = 0, sets = 0, meshlets = 0;
  std::size_t bytes = 0;
  double hidden = 0;  ///< share of all pairs of cell and meshlet that are left out
};

/// Triangles that were removed from a model.
struct ReducedTriangles {
  Reduced in_file;
  double pixels = 0;  ///< the error at the centre of the model, in the baked picture
};

/// The levels of detail of a scene.
struct LevelsRecord {
  std::size_t levels = 0;       ///< coarser meshes
  std::size_t meshes = 0;       ///< meshes that have some
  std::uint64_t triangles = 0;  ///< of all coarser meshes
  std::uint64_t ram = 0;        ///< bytes of the instances, which must be in RAM
};

struct BakeRecord {
  std::string scene;
  std::string output;
  View view;
  std::size_t materials = 0;
  SceneCounts counts;
  FlashBytes flash;
  std::optional<Accuracy> accuracy;  ///< of an imported file
  std::vector<FoundEffect> effects;
  Plan plan;
  std::uint8_t strip_buffers = 1;
  std::optional<std::uint64_t> lent_bytes;  ///< of a blob: memory that a program with 32-bit addresses lends for it
  std::vector<std::string> warnings;
  SkinRam skin_ram{};
  std::optional<BakedMethodRecord> method{};
  std::optional<VisibleSetRecord> visible_sets{};
  std::vector<PaletteRecord> palettes{};  ///< of the textures that have got one
  std::vector<MipmapRecord> mipmaps{};
  std::uint64_t palettes_would_save = 0;     ///< bytes of texels, without loss
  std::optional<ClippingRecord> clipping{};  ///< of a header
  std::optional<ReducedTriangles> reduced{};
  std::optional<Shrunk> shrunk{};
  std::size_t edges_left_out = 0;            ///< that its motion never shows
  std::optional<std::size_t> light_baked{};  ///< instances whose light is in colours of vertices
  std::optional<LevelsRecord> levels{};
};

/// `scene` has the meshes of the levels.
LevelsRecord levels_record(const Scene& scene, std::span<const DetailLevel> levels);

/// Returns the report as text.
std::string bake_summary(const BakeRecord& record);

/// One JSON object with a line end; keys are documented in README.md.
std::string bake_json(const BakeRecord& record);

}  // namespace zstrip::sim
