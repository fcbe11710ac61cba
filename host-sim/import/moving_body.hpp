// Meshes that move together, simplified as one surface, so that no crack opens where they meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// The vertices that stay.
enum class Held : std::uint8_t {
  shared_borders,  ///< those of keep_shared_borders
  all,             ///< and those where colours, joints or the texture change so much that it would be seen
};

/// Meshes of a model that the same node moves, or skins of one size. Refers to the model.
class MovingBody {
 public:
  /// `meshes`: indices of welded meshes with normals and triangles. `unit`: length in the file of a unit of their
  /// vertices.
  MovingBody(const SourceModel& model, std::vector<std::size_t> meshes, double unit);

  /// Open edges of bodies that do not move together meet where they have the same position: there, the vertices of all
  /// of these bodies stay.
  static void keep_shared_borders(std::span<MovingBody> bodies);
  /// Must be called before simplify, after keep_shared_borders.
  void hold(Held held);

  /// The longest side of its box, in the file's units.
  double size() const { return size_; }
  std::size_t triangles() const { return result_.size() / 3; }
  /// The longest movement of the surface, by the simplifier's measure, in the file's units.
  double error() const { return error_; }

  /// Removes from the whole body as much as `error` allows, a length in the file's units, until `triangles` are left. A
  /// body that would vanish is as it was before.
  void simplify(double error, std::size_t triangles = 0);

  /// Writes the triangles that are left. A mesh may have none.
  void write_to(SourceModel& model) const;

 private:
  std::vector<std::uint32_t> open_vertices() const;

  std::vector<std::size_t> meshes_;
  std::vector<SourceVertex> vertices_;  ///< of all meshes; a normal of zero: that of the face
  std::vector<std::uint32_t> indices_;
  std::vector<bool> stays_, is_shared_;  ///< for each vertex: Held::all, Held::shared_borders
  std::vector<std::uint32_t> result_;
  std::vector<std::size_t> first_vertices_;  ///< for each mesh, and one behind
  double unit_, size_ = 0, error_ = 0;
};

}  // namespace zstrip::sim
