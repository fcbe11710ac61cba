// What the renderer drew, made visible: besides colours, which triangle each pixel shows, its depth code, and which
// texel of its texture.
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

/// The middle of the texel that a pixel shows, and the size of its texture; zeros where it shows none.
struct TexelSeen {
  float u = 0, v = 0;
  float width = 0, height = 0;
};

/// A depth code as the number that is linear in 1/w or w, and how much the next code is more.
struct DepthSeen {
  double value = 0, step = 1;
};
DepthSeen depth_of(DepthFormat format, std::uint32_t code);

struct Observation {
  std::vector<std::array<float, 3>> rgb;  ///< 0..255, of each pixel, row by row
  std::vector<std::uint32_t> label;       ///< label_of() the triangle; 0: background
  std::vector<DepthSeen> depth;           ///< of what is not background
  std::vector<TexelSeen> texel;           ///< empty without textures, or where they are bilinear or mipmapped
};

/// Colours tell 65,535 triangles apart.
constexpr std::uint32_t label_of(std::uint32_t triangle) { return triangle % 65535 + 1; }

/// Pixels as `zstrip render` would draw them, and where that needs it with other memory.
struct Drawn {
  std::vector<std::byte> pixels;
  std::vector<std::uint32_t> code;  ///< only on request
};
/// `effects`: beside those that the scene calls for.
Result<Drawn> draw(const Staging& staged, const View& view, Effects effects, const Budget& budget, bool with_depth);

/// Of each triangle and quadric the texture that it shows; null where none.
std::vector<const Texture*> textures_of(const Scene& scene);

/// Draws the scene, once with each triangle in a colour of its own, and once more with each texel in one; these two
/// with one sample a pixel, because neither labels nor places have a mean. `staged` is as SceneVariant::apply left it.
Result<Observation> observe(const Staging& staged, const View& view, const Settings& settings);

/// 0..255 a channel, of the view's pixels.
std::vector<std::array<std::uint8_t, 3>> to_rgb(const View& view, std::span<const std::byte> pixels);

}  // namespace zstrip::sim
