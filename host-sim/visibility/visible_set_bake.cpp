// Computes the sets of a grid of cells, and their bytes.
#include "visibility/visible_set_bake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include "visibility/occluders.hpp"
#include "zstrip/base/crc32.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/visibility/visible_sets.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxOccluders = 256;
constexpr double kWidening = 1.0 / 256;  // a share of the distance: more than 1/16 pixel, with room for rounding

using Corners = std::array<SoupPoint, 8>;

Corners corners_of(const SoupPoint& low, const SoupPoint& high) {
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
  }
  return corners;
}

double distance(const SoupPoint& a, const SoupPoint& b) {
  const SoupPoint d = difference(a, b);
  return std::sqrt(dot(d, d));
}

/// A meshlet, or a mesh without meshlets, in the order of VisibilityOptions::potentially_visible.
struct Part {
  Corners corners;           ///< of its bounding box in mesh space, transformed to world space
  bool always_seen = false;  ///< it moves, or is drawn over nearer surfaces
};

Corners box_of(const Mesh& mesh, const Transform& transform, std::span<const Triangle> triangles) {
  std::array<std::int16_t, 3> low{32767, 32767, 32767}, high{-32768, -32768, -32768};
  for (const Triangle& t : triangles) {
    for (const std::uint16_t index : {t.a, t.b, t.c}) {
      const Position& p = mesh.positions[index];
      low = {std::min(low[0], p.x), std::min(low[1], p.y), std::min(low[2], p.z)};
      high = {std::max(high[0], p.x), std::max(high[1], p.y), std::max(high[2], p.z)};
    }
  }
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = world_position(
        mesh, transform,
        {(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]});
  }
  return corners;
}

/// Returns true for each instance that moves. Billboards move with the camera.
std::vector<bool> moving(const Scene& scene, const Animation& animation) {
  std::vector<bool> moves;
  for (const Instance& instance : scene.instances) {
    moves.push_back(scene.meshes[instance.mesh].billboard != Billboard::none);
  }
  for (const Track& track : animation.tracks) {
    if (track.instance < moves.size()) moves[track.instance] = true;
  }
  // The visible part of a product is not where its operands are.
  for (const CsgOperand& operand : scene.csg) moves[operand.instance] = true;
  return moves;
}

std::vector<Part> parts_of(const Scene& scene, const std::vector<bool>& moves) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const bool always = moves[i] || has_depth_state(scene.materials[instance.material]);
    const auto add = [&](std::span<const Triangle> triangles) {
      parts.push_back({box_of(mesh, instance.transform, triangles), always || triangles.empty()});
    };
    if (mesh.meshlets.empty()) add(mesh.triangles);
    for (const Meshlet& meshlet : mesh.meshlets) {
      add(mesh.triangles.subspan(meshlet.first_triangle, meshlet.triangle_count));
    }
  }
  // The meshlets of the outlines' hulls follow; hulls reach beyond the boxes.
  parts.resize(count(scene).meshlets, {.corners = {}, .always_seen = true});
  return parts;
}

class Judge {
 public:
  Judge(const Scene& scene, const std::vector<bool>& moves, const Camera& camera)
      : occluders_(occluders_of(scene, moves, kMaxOccluders)), near_(camera.near_plane / 65536.0) {}

  /// Selects the occluders that are completely in front of the cell, far enough that the near plane cuts none of them.
  void enter(const Corners& cell) {
    cell_ = cell;
    facing_.clear();
    for (const Occluder& occluder : occluders_) {
      if (std::ranges::all_of(cell, [&](const SoupPoint& p) { return occluder.plane().at(p) >= 2 * near_; })) {
        facing_.push_back(&occluder);
      }
    }
  }

  bool is_hidden(const Part& part) const {
    return !part.always_seen &&
           std::ranges::any_of(facing_, [&](const Occluder* occluder) { return hides(*occluder, part.corners); });
  }

 private:
  bool hides(const Occluder& occluder, const Corners& corners) const {
    std::vector<PlanePoint> crossings;
    double farthest = 0, nearest_behind = 1e300;
    if (!std::ranges::all_of(corners, [&](const SoupPoint& q) { return occluder.plane().at(q) < 0; })) return false;
    for (const SoupPoint& q : corners) {
      const double behind = -occluder.plane().at(q);
      nearest_behind = std::min(nearest_behind, behind);
      for (const SoupPoint& p : cell_) {
        const double before = occluder.plane().at(p), all = before + behind;
        const SoupPoint x{(p.x * behind + q.x * before) / all, (p.y * behind + q.y * before) / all,
                          (p.z * behind + q.z * before) / all};
        farthest = std::max(farthest, distance(p, x));
        crossings.push_back(occluder.projected(x));
        if (!occluder.may_cover(crossings.back())) return false;
      }
    }
    // At least two codes of depth at that distance, doubled because only half of `nearest_behind` may be along the
    // axis.
    if (nearest_behind < 4 * farthest * farthest / (near_ * 65533)) return false;
    const double wider = farthest * kWidening;
    std::vector<PlanePoint> region;
    for (const PlanePoint& c : crossings) {
      for (const double x : {-wider, wider}) {
        for (const double y : {-wider, wider}) region.push_back({c.x + x, c.y + y});
      }
    }
    return occluder.cover(std::move(region));
  }

  std::vector<Occluder> occluders_;
  std::vector<const Occluder*> facing_;
  double near_;
  Corners cell_{};
};

template <class Value>
void put(std::vector<std::uint32_t>& words, std::uint32_t at, Value value) {
  std::memcpy(reinterpret_cast<std::byte*>(words.data()) + at, &value, sizeof value);
}

struct Grid {
  Vec3 origin, cell;
  CellCounts counts;

  Corners corners(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    const auto at = [](Fixed from, Fixed size, std::uint32_t i) { return (from + double{1} * size * i) / 65536; };
    return corners_of({at(origin.x, cell.x, x), at(origin.y, cell.y, y), at(origin.z, cell.z, z)},
                      {at(origin.x, cell.x, x + 1), at(origin.y, cell.y, y + 1), at(origin.z, cell.z, z + 1)});
  }
};

Grid grid_around(const std::vector<Part>& parts, const CellCounts& counts) {
  SoupPoint low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Part& part : parts) {
    if (part.always_seen) continue;
    for (const SoupPoint& p : part.corners) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  const auto fixed = [](double value) {
    return static_cast<Fixed>(std::clamp(value * 65536, -2147483647.0, 2147483647.0));
  };
  const auto size = [&](double from, double to, std::uint16_t n) {
    return std::max<Fixed>(1, fixed(std::ceil((to - from) * 65536 / n) / 65536));
  };
  return {{fixed(low.x), fixed(low.y), fixed(low.z)},
          {size(low.x, high.x, counts.across), size(low.y, high.y, counts.up), size(low.z, high.z, counts.deep)},
          counts};
}

std::vector<std::uint32_t> bytes_of(const Grid& grid, Fixed near, std::uint32_t meshlets, std::uint32_t checksum,
                                    const std::vector<std::uint16_t>& set_of_cell,
                                    const std::vector<std::uint32_t>& sets, std::uint16_t count) {
  using namespace zstrip::detail;
  using namespace zstrip::detail::visible_sets_at;
  const auto sets_at = static_cast<std::uint32_t>(kCells + (set_of_cell.size() * 2 + 3) / 4 * 4);
  const auto size = static_cast<std::uint32_t>(sets_at + sets.size() * 4);
  std::vector<std::uint32_t> words(size / 4);
  std::memcpy(words.data(), kVisibleSetsMark, sizeof kVisibleSetsMark);
  put(words, kSize, size);
  put(words, kScene, checksum);
  put(words, kMeshlets, meshlets);
  put(words, kOrigin, grid.origin);
  put(words, kCell, grid.cell);
  put(words, kCounts, std::array<std::uint16_t, 3>{grid.counts.across, grid.counts.up, grid.counts.deep});
  put(words, kSets, count);
  put(words, kNear, near);
  std::memcpy(reinterpret_cast<std::byte*>(words.data()) + kCells, set_of_cell.data(), set_of_cell.size() * 2);
  if (!sets.empty()) {
    std::memcpy(reinterpret_cast<std::byte*>(words.data()) + sets_at, sets.data(), sets.size() * 4);
  }
  put(words, kChecksum, crc32(std::as_bytes(std::span(words)).subspan(kChecked)));
  return words;
}

}  // namespace

Result<CellCounts> parse_cells(const std::string& text, const char* option) {
  std::array<std::uint16_t, 3> counts{};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  for (std::size_t i = 0; i < 3 && good; ++i) {
    if (i != 0) good = at != end && *at++ == 'x';
    const auto [next, error] = std::from_chars(at, end, counts[i]);
    good = good && error == std::errc{} && counts[i] > 0;
    at = next;
  }
  if (good && at == end && std::uint64_t{counts[0]} * counts[1] * counts[2] <= kMaxCells) {
    return CellCounts{counts[0], counts[1], counts[2]};
  }
  return Failure{ExitStatus::usage,
                 fmt::format("{} '{}' must be cells along x, y and z, as 8x2x8, {} at most", option, text, kMaxCells)};
}

std::uint32_t visibility_checksum(const Scene& scene, const Animation& animation) {
  std::vector<std::byte> all;
  const auto add = [&](const auto& values) {
    const auto bytes = std::as_bytes(std::span(values));
    all.insert(all.end(), bytes.begin(), bytes.end());
  };
  for (const Mesh& mesh : scene.meshes) {
    add(mesh.positions);
    add(mesh.triangles);
    for (const Meshlet& m : mesh.meshlets) add(std::array<std::uint32_t, 2>{m.first_triangle, m.triangle_count});
    add(std::array<Vec3, 2>{mesh.centre, mesh.half_extent});
  }
  const std::vector<bool> moves = moving(scene, animation);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Material& material = scene.materials[instance.material];
    const AlphaMode alpha = finish_of(scene, material).alpha_mode;
    add(std::array<std::uint32_t, 5>{instance.mesh, moves[i] ? 1U : 0U, material.double_sided ? 1U : 0U,
                                     has_depth_state(material) ? 1U : 0U, static_cast<std::uint32_t>(alpha)});
    if (!moves[i]) add(std::span(&instance.transform, 1));
  }
  return crc32(all);
}

Result<BakedVisibleSets> bake_visible_sets(const Scene& scene, const Camera& camera, const Animation& animation,
                                           const CellCounts& counts) {
  if (camera.projection == Projection::orthographic) {
    return Failure{ExitStatus::usage, "visible sets need a perspective camera: an orthographic one has no eye"};
  }
  const std::vector<bool> moves = moving(scene, animation);
  const std::vector<Part> parts = parts_of(scene, moves);
  if (std::ranges::all_of(parts, &Part::always_seen)) {
    return Failure{ExitStatus::usage, "visible sets need something that stands still"};
  }
  const Grid grid = grid_around(parts, counts);
  Judge judge(scene, moves, camera);
  BakedVisibleSets baked{.words = {}, .meshlets = static_cast<std::uint32_t>(parts.size())};
  std::map<std::vector<std::uint32_t>, std::uint16_t> numbers;
  std::vector<std::uint16_t> set_of_cell;
  std::vector<std::uint32_t> sets;
  std::uint64_t hidden = 0;
  for (std::uint32_t z = 0; z < counts.deep; ++z) {
    for (std::uint32_t y = 0; y < counts.up; ++y) {
      for (std::uint32_t x = 0; x < counts.across; ++x) {
        judge.enter(grid.corners(x, y, z));
        std::vector<std::uint32_t> set((parts.size() + 31) / 32, 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
          if (judge.is_hidden(parts[i])) {
            ++hidden;
          } else {
            set[i / 32] |= std::uint32_t{1} << (i % 32);
          }
        }
        const auto [found, is_new] = numbers.try_emplace(set, static_cast<std::uint16_t>(numbers.size()));
        if (is_new) sets.insert(sets.end(), set.begin(), set.end());
        set_of_cell.push_back(found->second);
      }
    }
  }
  baked.cells = static_cast<std::uint32_t>(set_of_cell.size());
  baked.sets = static_cast<std::uint32_t>(numbers.size());
  baked.hidden = static_cast<double>(hidden) / (static_cast<double>(parts.size()) * baked.cells);
  baked.words = bytes_of(grid, camera.near_plane, baked.meshlets, visibility_checksum(scene, animation), set_of_cell,
                         sets, static_cast<std::uint16_t>(baked.sets));
  return baked;
}

}  // namespace zstrip::sim
