// Pictures of a scene other than its colours: wireframe, depth, overdraw.
#pragma once

#include <cstdint>
#include <vector>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

enum class Look : std::uint8_t { colour, wireframe, depth, overdraw, accuracy };

/// Returns "colours", "wireframe", "depth", "overdraw" or "accuracy".
const char* name_of(Look look);

/// In RGB565 with one sample, without a panel, edges and visibility methods, for any settings of the picture: these
/// pictures are for the user, not for a device.
struct LookPicture {
  View view;
  std::vector<std::byte> pixels;
};
/// Draws any look except colour and accuracy, in the size of `view`.
Result<LookPicture> draw_look(const Staging& staging, Look look, const View& view);

}  // namespace zstrip::sim
