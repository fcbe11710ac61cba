// Records the triangle, the depth code and the texel of each pixel that the renderer drew, in addition to its colour.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "accuracy/knobs.hpp"
#include "import/model.hpp"
#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::sim {

/// The middle of the texel that a pixel shows, and the size of its texture; zeros if it shows no texel.
struct TexelSeen {
  float u = 0, v = 0;
  float width = 0, height = 0;
};

/// A depth code as the number that is linear in 1/w or w, and the difference to the next code.
struct DepthSeen {
  double value = 0, step = 1;
};
DepthSeen depth_of(DepthFormat format, std::uint32_t code);

struct Observation {
  std::vector<std::array<float, 3>> rgb;  ///< 0..255, for each pixel, row by row
  std::vector<std::uint32_t> label;       ///< label_of() the triangle; 0: background
  std::vector<DepthSeen> depth;           ///< 0 for the background
  std::vector<TexelSeen> texel;           ///< empty without textures, or if they are bilinear or mipmapped
};

/// The colours can distinguish 65,535 triangles.
constexpr std::uint32_t label_of(std::uint32_t triangle) { return triangle % 65535 + 1; }

/// Pixels as `zstrip render` draws them, in other memory where needed.
struct Drawn {
  std::vector<std::byte> pixels;
  std::vector<std::uint32_t> code;  ///< only on request
};
/// `effects`: in addition to those that the scene needs.
Result<Drawn> draw(const Staging& staged, const View& view, Effects effects, const Budget& budget, bool with_depth);

/// Returns the texture of each triangle and quadric, null if it has none.
std::vector<const Texture*> textures_of(const Scene& scene);

/// Draws the scene, then with a colour for each triangle, then with a colour for each texel. The latter two have one
/// sample a pixel, because labels and positions have no mean. `staged` is as SceneVariant::apply left it.
Result<Observation> observe(const Staging& staged, const View& view, const Settings& settings);

/// Converts the view's pixels to 0..255 a channel.
std::vector<std::array<std::uint8_t, 3>> to_rgb(const View& view, std::span<const std::byte> pixels);

}  // namespace zstrip::sim
