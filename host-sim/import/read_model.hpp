// Reads a model file: glTF 2.0, or any other format that Assimp reads.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// More is refused: a picture has at most 16.8 million pixels.
inline constexpr std::uint64_t kMaxTriangles = 10'000'000;

/// Processor time that reading a file may take: some damaged files never end.
constexpr std::chrono::seconds reading_limit(std::uint64_t file_bytes) {
  return std::chrono::seconds{20 + 2 * static_cast<std::int64_t>(file_bytes >> 20)};
}
/// And memory: others take more and more of it.
constexpr std::uint64_t reading_memory(std::uint64_t file_bytes) { return (std::uint64_t{4} << 30) + 64 * file_bytes; }

/// All meshes of all nodes in the file's coordinates, turned so that `up` becomes +y, grouped by material. Every
/// triangle is finite, has three different corners, an area, and indices that exist; what is left out is counted in the
/// warnings. At least one triangle.
Result<SourceModel> read_model(const std::filesystem::path& path, std::optional<UpAxis> up,
                               Texcoords texcoords = Texcoords::of_textures, Highlights highlights = Highlights::none);

}  // namespace zstrip::sim
