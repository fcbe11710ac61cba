// Pictures of a scene that are not its colours: wires, depth, how often pixels are drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

enum class Look : std::uint8_t { colour, wireframe, depth, overdraw, accuracy };

/// "colours", "wireframe", "depth", "overdraw", "accuracy".
const char* name_of(Look look);

/// In RGB565 of one sample, without a panel, edges and methods of visibility, whatever the picture has: these are for
/// eyes, not for a device.
struct LookPicture {
  View view;
  std::vector<std::byte> pixels;
};
/// Of any look but colour and accuracy, of the size of `view`.
Result<LookPicture> draw_look(const Staging& staging, Look look, const View& view);

}  // namespace zstrip::sim
