// Reads a model file: glTF 2.0, or any other format that Assimp reads.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Models with more triangles are refused: a picture has at most 16.8 million pixels.
inline constexpr std::uint64_t kMaxTriangles = 10'000'000;

/// Limit for the processor time of reading a file: some damaged files never end.
constexpr std::chrono::seconds reading_limit(std::uint64_t file_bytes) {
  return std::chrono::seconds{20 + 2 * static_cast<std::int64_t>(file_bytes >> 20)};
}
/// Limit for the memory of reading a file: some damaged files take more and more.
constexpr std::uint64_t reading_memory(std::uint64_t file_bytes) { return (std::uint64_t{4} << 30) + 64 * file_bytes; }

/// Reads all meshes of all nodes in the file's coordinates, rotated so that `up` becomes +y, grouped by material. Every
/// triangle is finite and has three different corners, an area, and valid indices; the warnings count the triangles
/// that were left out. The result has at least one triangle. Throws std::bad_alloc if the machine has less memory than
/// a file of this size may take.
Result<SourceModel> read_model(const std::filesystem::path& path, std::optional<UpAxis> up,
                               Texcoords texcoords = Texcoords::of_textures, Shine shine = {});

}  // namespace zstrip::sim
