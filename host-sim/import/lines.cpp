// Converts lines and points of a model to fixed point.
#include "import/lines.hpp"

#include <fmt/format.h>

#include <map>
#include <tuple>

#include "import/quantise.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

/// A growing set of lines, in which equal vertices become one.
struct Part {
  MeshData vertices;
  std::vector<Segment> segments;
  std::map<std::tuple<std::int16_t, std::int16_t, std::int16_t, std::uint32_t>, std::uint16_t> known;

  bool has_room_for_a_line() const { return vertices.positions.size() + 2 <= 65535; }

  std::uint16_t index_of(const SourceVertex& vertex, bool has_colours, const Grid& grid) {
    const Position p = grid.position(vertex.position);
    const auto& [r, g, b, a] = vertex.colour;
    const std::uint32_t colour = has_colours ? std::uint32_t{r} << 16 | std::uint32_t{g} << 8 | b : 0;
    const auto next = static_cast<std::uint16_t>(vertices.positions.size());
    const auto [at, is_new] = known.try_emplace({p.x, p.y, p.z, colour}, next);
    if (is_new) {
      vertices.positions.push_back(p);
      if (has_colours) vertices.colours.push_back({r, g, b, 255});
    }
    return at->second;
  }
};

/// True if triangles of the material differ from its plain colour.
bool is_more_than_plain(const SourceMaterial& material) {
  const bool transparent = material.alpha_mode != AlphaMode::opaque && material.alpha != 255;
  return transparent || material.texture != kNoSourceTexture || material.emissive != std::array<std::uint8_t, 3>{};
}

void add_part(Part& part, std::size_t material, const Grid& grid, Model& model) {
  const MeshData& data = model.mesh_data.emplace_back(std::move(part.vertices));
  const std::vector<Segment>& segments = model.segments.emplace_back(std::move(part.segments));
  model.lines.push_back({.segments = segments,
                         .mesh = static_cast<std::uint16_t>(model.meshes.size()),
                         .material = static_cast<std::uint16_t>(material)});
  model.meshes.push_back({.positions = data.positions,
                          .normals = {},
                          .colours = data.colours,
                          .texcoords = {},
                          .triangles = {},
                          .meshlets = {},
                          .centre = grid.centre,
                          .half_extent = grid.half_extent});
  part = Part();
}

}  // namespace

Result<Done> add_lines(const SourceModel& source, const Grid& grid, Model& model) {
  std::uint64_t moving = 0, plain = 0;
  for (const SourceLines& lines : source.lines) {
    const SourceMaterial& from = source.materials[lines.material];
    const std::size_t material = model.materials.size();
    model.materials.push_back({.colour = {from.colour[0], from.colour[1], from.colour[2], 255}, .lit = false});
    model.material_names.push_back(from.name);
    if (lines.node != kNoNode) moving += lines.indices.size() / 2;
    if (is_more_than_plain(from)) plain += lines.indices.size() / 2;
    Part part;
    for (std::size_t i = 0; i < lines.indices.size(); i += 2) {
      if (!part.has_room_for_a_line()) add_part(part, material, grid, model);
      const auto vertex = [&](std::size_t k) {
        return part.index_of(lines.vertices[lines.indices[k]], lines.has_colours, grid);
      };
      const std::uint16_t a = vertex(i), b = vertex(i + 1);
      part.segments.push_back({a, b});
    }
    add_part(part, material, grid, model);
    if (model.meshes.size() > kMaxMeshes || model.materials.size() > kMaxMeshes) {
      return Failure{ExitStatus::input, kTooManyMeshes};
    }
  }
  if (moving > 0) {
    model.warnings.push_back(fmt::format("{} drawn at rest: animations move triangles only", counted(moving, "line")));
  }
  if (plain > 0) {
    model.warnings.push_back(fmt::format(
        "{} drawn in plain colours: textures, emission and alpha are of triangles only", counted(plain, "line")));
  }
  return Done{};
}

}  // namespace zstrip::sim
