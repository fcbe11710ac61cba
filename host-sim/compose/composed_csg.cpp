// CSG of a composed scene; see composed_csg.hpp.
#include "compose/composed_csg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "zstrip/scene/validate.hpp"

namespace zstrip::sim {
namespace {

/// Returns the property that prevents an instance from being a solid.
const char* what_no_solid_has(const ComposedScene& scene, const Instance& instance) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  if (mesh.billboard != Billboard::none) return "is a billboard";
  if (mesh.outline != 0) return "has an outline";
  if (has_depth_state(scene.materials[instance.material])) {
    return "has a material with depth_test, depth_write or depth_bias";
  }
  return "has a material that is not opaque";
}

/// Returns the instance with the name `name`, which must be unique.
Result<std::uint16_t> solid(const SceneFile& file, const FileCsg& csg, const std::string& name,
                            std::span<const PlacedPart> placed, const ComposedScene& scene) {
  const auto wrong = [&](const std::string& what) {
    return at_line(file.path, csg.line, fmt::format("[[csg]]: '{}' {}", name, what));
  };
  const auto is_called = [&name](const PlacedPart& part) { return part.file->name == name; };
  const auto at = std::ranges::find_if(placed, is_called);
  const auto parts = std::ranges::count_if(placed, is_called);
  if (parts != 1) {
    return wrong(fmt::format("is made of {} meshes, by its materials; a solid is one closed mesh", parts));
  }
  const auto index = static_cast<std::uint16_t>(at - placed.begin());
  const Instance& instance = scene.instances[index];
  if (at->file->is_static) return wrong("lies in the static layer, where solids of [[csg]] must not lie");
  if (!detail::can_be_operand(scene.scene(), instance)) {
    return wrong(fmt::format("{}: solids do without", what_no_solid_has(scene, instance)));
  }
  if (const std::size_t open = open_edges(scene.meshes[instance.mesh]); open != 0) {
    return wrong(fmt::format("has {} open edges; a solid is closed: each edge is one of two triangles", open));
  }
  return index;
}

}  // namespace

std::size_t open_edges(const Mesh& mesh) {
  using Place = std::tuple<std::int16_t, std::int16_t, std::int16_t>;
  std::map<std::pair<Place, Place>, int> edges;  // number in this direction minus number in the other one
  const auto place = [&mesh](std::uint16_t vertex) {
    const Position& p = mesh.positions[vertex];
    return Place{p.x, p.y, p.z};
  };
  for (const Triangle& t : mesh.triangles) {
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
      const Place a = place(from), b = place(to);
      if (a < b) ++edges[{a, b}];
      if (b < a) --edges[{b, a}];
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
}

Result<Done> add_products(const SceneFile& file, std::span<const PlacedPart> placed, ComposedScene& scene) {
  std::uint8_t number = 0;
  for (const FileCsg& csg : file.csg) {
    if (scene.shadow) {
      return at_line(file.path, csg.line, "[[csg]]: CSG does not go with the shadow of a light");
    }
    for (const CsgProduct& product : csg.products) {
      for (const CsgTerm& term : product) {
        if (scene.csg.size() == kMaxCsgOperands) {
          return at_line(file.path, csg.line,
                         fmt::format("[[csg]]: all products of the scene, multiplied out, have more than {} solids",
                                     kMaxCsgOperands));
        }
        const Result<std::uint16_t> instance = solid(file, csg, term.name, placed, scene);
        if (!instance) return instance.failure();
        scene.csg.push_back({*instance, number, term.use});
      }
      ++number;
    }
    scene.csg_origin = origin_of(file.path, csg.line);
  }
  return Done{};
}

}  // namespace zstrip::sim
