// Measures the error of a model's numbers in fixed point against the file's numbers. Each function keeps the maximum.
#pragma once

#include <cstdint>
#include <span>

#include "import/grid.hpp"
#include "import/model.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Compares positions and normals of `fixed`, which are steps of `grid`, with those of `source`, in the same order.
void note_vertices(Accuracy& worst, const SourceMesh& source, const MeshData& fixed, const Grid& grid);

/// Compares texture coordinates with so many fraction bits, in texels of `texture`.
void note_texcoords(Accuracy& worst, const SourceMesh& source, const MeshData& fixed, int bits,
                    const RgbImage& texture);

/// Compares the RGB565 texels of a picture.
void note_texels(Accuracy& worst, const RgbImage& image, std::span<const std::uint16_t> texels);

}  // namespace zstrip::sim
