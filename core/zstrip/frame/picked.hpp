// The result of pick: the surface that a pixel shows.
#pragma once

#include <cstdint>

#include "zstrip/status.hpp"

namespace zstrip {

class Frame;

/// The kind of thing that a pixel shows.
enum class Shown : std::uint8_t {
  background,  ///< nothing was drawn there
  instance,    ///< a triangle of an instance
  outline,     ///< the outline of an instance: a triangle of its hull
  quadric,     ///< a sphere or ellipsoid
  line,        ///< a line or point
  sprite,      ///< a sprite of the overlay
  label,       ///< text of the overlay, or its background
};

/// A pixel's surface.
struct Picked {
  Shown shown = Shown::background;  ///< says which table `index` refers to
  bool textured = false;            ///< true for triangles with a texture of their own, not an environment map
  std::uint16_t index = 0;          ///< index into Scene::instances, Scene::quadrics, Scene::lines, Overlay::sprites or
                                    ///< Overlay::labels; of an outline the index of the instance that it surrounds
  std::uint32_t triangle = 0;  ///< index into Mesh::triangles, of an outline those of its hull; of a line the index
                               ///< into LineSet::segments; else 0
  std::uint16_t u = 0, v = 0;  ///< if `textured`: the place in the texture that the pixel shows, in 1/65536 of its
                               ///< width and height from its upper left corner; repetitions are removed
  friend constexpr bool operator==(const Picked&, const Picked&) = default;
};

/// The function `pick` for one set of effects: &pick<effects>, or picker_for(effects).
using PickFunction = Status (*)(const Frame& frame, std::uint16_t x, std::uint16_t y, Picked& picked);

}  // namespace zstrip
