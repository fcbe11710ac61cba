// Independent random triangles, flat, double-sided: the benchmarks' workloads R50 (few large ones) and R10k (many
// small ones).
#pragma once

#include <array>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

/// `count` triangles without shared vertices; the three vertices of each have its colour.
template <std::size_t count>
struct TriangleSoup {
  std::array<Position, 3 * count> positions;
  std::array<Colour, 3 * count> colours;
  std::array<Triangle, count> triangles;
};

// Centres lie within 0.9, corners within half the size of their centre: 1.4 for R50 (size 1.0), 0.93 for R10k (0.06).
inline constexpr Vec3 kRandom50HalfExtent{fixed(1.4375), fixed(1.4375), fixed(1.4375)};
inline constexpr Vec3 kRandom10kHalfExtent{fixed(0.9375), fixed(0.9375), fixed(0.9375)};
inline constexpr std::size_t kRandomMeshletTriangles = 21;  // 63 vertices
inline constexpr std::size_t kRandom10kMeshlets = (10000 + kRandomMeshletTriangles - 1) / kRandomMeshletTriangles;

extern const TriangleSoup<50> kRandom50;
extern const TriangleSoup<10000> kRandom10k;
extern const std::array<Meshlet, kRandom10kMeshlets> kRandom10kMeshletTable;

template <std::size_t count>
constexpr Mesh soup_mesh(const TriangleSoup<count>& soup, const Vec3& half_extent,
                         std::span<const Meshlet> meshlets = {}) {
  return {.positions = soup.positions,
          .normals = {},
          .colours = soup.colours,
          .texcoords = {},
          .triangles = soup.triangles,
          .meshlets = meshlets,
          .half_extent = half_extent};
}

inline constexpr Mesh kRandom50Mesh[] = {soup_mesh(kRandom50, kRandom50HalfExtent)};
inline constexpr Mesh kRandom10kMesh[] = {soup_mesh(kRandom10k, kRandom10kHalfExtent)};
inline constexpr Mesh kRandom10kMeshletsMesh[] = {soup_mesh(kRandom10k, kRandom10kHalfExtent, kRandom10kMeshletTable)};
inline constexpr Material kRandomMaterial[] = {{.lit = false, .smooth = false, .double_sided = true}};
inline constexpr Instance kRandomInstance[] = {{}};

inline constexpr BuiltIn random50{.name = "random50",
                                  .description = "50 large random triangles, flat (workload R50)",
                                  .scene = {.meshes = kRandom50Mesh,
                                            .materials = kRandomMaterial,
                                            .textures = {},
                                            .instances = kRandomInstance,
                                            .lights = {}},
                                  .counts = counts_of_one(kRandom50Mesh[0], kRandomMaterial[0]),
                                  .camera = turntable_camera(6.0, 20, 3.7),
                                  .focal_across = fixed(4.0)};

inline constexpr BuiltIn random10k{.name = "random10k",
                                   .description = "10000 small random triangles, flat (workload R10k)",
                                   .scene = {.meshes = kRandom10kMesh,
                                             .materials = kRandomMaterial,
                                             .textures = {},
                                             .instances = kRandomInstance,
                                             .lights = {}},
                                   .counts = counts_of_one(kRandom10kMesh[0], kRandomMaterial[0]),
                                   .camera = turntable_camera(5.0, 20, 3.1),
                                   .focal_across = fixed(3.5)};

inline constexpr BuiltIn random10k_meshlets{
    .name = "random10k_meshlets",
    .description = "workload R10k in meshlets of 21 triangles",
    .scene = {.meshes = kRandom10kMeshletsMesh,
              .materials = kRandomMaterial,
              .textures = {},
              .instances = kRandomInstance,
              .lights = {}},
    .counts = counts_of_one(kRandom10kMeshletsMesh[0], kRandomMaterial[0], 3 * kRandomMeshletTriangles,
                            kRandomMeshletTriangles),
    .camera = random10k.camera,
    .focal_across = random10k.focal_across};

}  // namespace zstrip::scenes
