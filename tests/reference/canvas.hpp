// OpenGL in software (OSMesa): draws geometry in float and says of every pixel which triangle and texel it shows.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry.hpp"
#include "result.hpp"

namespace zstrip::reference {

/// What one point of the picture shows.
struct Sample {
  float r = 0, g = 0, b = 0;   ///< 0..255, neither rounded nor clamped
  std::uint32_t triangle = 0;  ///< Corner::triangle; 0 is the background
  std::uint32_t texel = 0;     ///< row * width + column; 0 without a texture
  float depth = 0;             ///< codes, with a fraction; greater is nearer, 0 is the background

  bool drawn() const { return triangle != 0; }
  bool same_surface(const Sample& other) const { return triangle == other.triangle && texel == other.texel; }
};

/// Row-major, the first row on top.
using Samples = std::vector<Sample>;

/// From the pixel's centre, in pixels.
struct Offset {
  float x = 0, y = 0;
};

/// The two surfaces that a pixel may show.
struct Layers {
  Samples nearest;
  /// Of another triangle, within a tolerance behind the nearest one; mostly background.
  Samples contender;
};

/// The depth of a corner, in codes.
double depth_code(const Corner& corner);

/// One at a time in a thread: OpenGL has a current context.
class Canvas {
 public:
  /// Fails where OSMesa has no OpenGL 3.3.
  static sim::Result<std::unique_ptr<Canvas>> open(const View& view);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Loads what all draws show. `scene`'s textures are copied.
  void load(const Geometry& geometry, const Scene& scene);
  /// Samples every pixel at its centre plus `offset`.
  Samples draw(const Offset& offset);
  /// Also what lies at most `tolerance` depth codes behind.
  Layers draw_layers(const Offset& offset, double tolerance);

 private:
  Canvas() = default;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace zstrip::reference
