// The picture that a player draws by its functions in C.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "zstrip_player.h"

namespace zstrip::test {

/// The pixels of all strips, one after the other.
inline std::vector<std::byte> picture_in_c(zstrip_player* player) {
  std::vector<std::byte> pixels;
  const auto take = [](void* context, const zstrip_strip* strip) {
    const auto* const bytes = static_cast<const std::byte*>(strip->pixels);
    auto& all = *static_cast<std::vector<std::byte>*>(context);
    all.insert(all.end(), bytes, bytes + strip->bytes);
    return 1;
  };
  EXPECT_TRUE(zstrip_player_draw(player, take, &pixels)) << zstrip_player_error(player);
  return pixels;
}

}  // namespace zstrip::test
