// Stages of drawing with the renderer's precision, each separate: snapped corners, the transform in fixed point,
// interpolated values, depth in codes, colours of the display. After docs/conventions.md and docs/numerics.md, in
// double precision; shares no code with the renderer.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "accuracy/truth_light.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/depth_format.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Selects the coarse stages; without any of them the picture is exact.
struct Stages {
  bool snapping = false;   ///< corners rounded to 1/16 pixel
  bool transform = false;  ///< linear forms of 32 bits, each product rounded down, and 1/w with an error of 2^-28
  /// Light at the material's places (first vertex, vertices, pixels), colours linear on the screen, depth stepped with
  /// 16 fraction bits. Texture coordinates are exact at every so many pixels of a row (0: at the corners), and linear
  /// between.
  std::optional<std::uint32_t> interpolation{};
  /// Pixels keep codes of this format. `ranges`: with sub-ranges.
  struct Depth {
    DepthFormat format = DepthFormat::z16;
    bool ranges = false;
  };
  std::optional<Depth> depth{};
  std::optional<View> colour{};  ///< pixels have this format, with its dithering
};

namespace truth {

/// Depth codes of a frame. The range is fitted to the scene unless the camera's is fixed.
class DepthCodes {
 public:
  DepthCodes(const Scene& scene, const Camera& camera, const Stages::Depth& depth);

  /// Returns the value that codes represent, not rounded; greater is nearer. For float16 the number that is encoded.
  double linear(double w) const;
  double distance(double linear) const;
  std::uint32_t code(double w) const;

 private:
  DepthFormat format_;
  bool orthographic_;
  double near_, far_, first_, span_;
};

/// A vertex after the transform in 32 bits.
struct FixedVertex {
  double x, y, w;  ///< view space, w along the viewing direction
};

/// An instance's transform in fixed point.
class FixedTransform {
 public:
  FixedTransform(const Mesh& mesh, const Transform& transform, const Camera& camera, const View& view);
  FixedVertex at(const Position& p) const;

 private:
  /// offset + sum of floor(coefficient p / 2^16), below 2^30; times 2^exponent it is a length.
  struct Form {
    std::array<double, 3> coefficient{};
    double offset = 0;
    int exponent = 0;
    double at(const Position& p) const;
  };
  static Form form_of(const Vector& axis, const Mesh& mesh, const Transform& transform, const Camera& camera);

  Form x_, y_, w_;
  double mantissa_ = 1;  ///< pixels of a unit at distance 1, 0.5..1
  bool orthographic_;
};

/// Evaluates the plane through three values on the screen, stepped from the first with gradients of 16 fraction bits.
double stepped(const std::array<std::array<double, 2>, 3>& at, const std::array<double, 3>& value, double x, double y);

/// The source of a surface's colour, which decides its rounding, and if it is dithered.
enum class ColourKind : std::uint8_t { even, gradient, texel, lit_texel };
/// Returns a colour as a pixel of the picture shows it, 0..255 a channel.
std::array<float, 3> shown(const View& picture, const Vector& rgb, ColourKind kind, std::uint32_t x, std::uint32_t y);

}  // namespace truth
}  // namespace zstrip::sim
