// How a picture lies on the glass of a panel, and what that means to a controller's address counters.
#pragma once

#include <cstdint>

namespace zstrip::hal {

/// Of the picture on the glass, clockwise.
enum class Rotation : std::uint8_t {
  none,    ///< upright
  by_90,   ///< degrees; width and height change places
  by_180,  ///< degrees
  by_270,  ///< degrees; width and height change places
};

/// The picture is mirrored first (left and right swapped), then turned. Mirrored top to bottom is mirrored and turned
/// by 180 degrees.
struct Orientation {
  Rotation rotation = Rotation::none;  ///< after mirroring
  bool mirrored = false;               ///< left and right swapped
  friend constexpr bool operator==(const Orientation&, const Orientation&) = default;
};

/// Whether a row of the picture is a column of the glass, so that width and height change places.
constexpr bool is_sideways(const Orientation& orientation) {
  return orientation.rotation == Rotation::by_90 || orientation.rotation == Rotation::by_270;
}

/// The same to a counter that walks over the glass: pixel (x, y) of the picture lies in column `exchanged ? y : x`,
/// counted from the right if `columns_reversed`, and in row `exchanged ? x : y`, from the bottom if `rows_reversed`.
struct Scan {
  bool exchanged = false;         ///< rows of the picture are columns of the glass
  bool columns_reversed = false;  ///< of the glass
  bool rows_reversed = false;     ///< of the glass
};

/// The directions in which a controller is to count for this orientation.
constexpr Scan scan_of(const Orientation& orientation) {
  const bool exchanged = is_sideways(orientation);
  const bool half_turn = orientation.rotation == Rotation::by_180;
  // Mirroring turns the direction of a row of the picture, which is a row or a column of the glass.
  return {
      .exchanged = exchanged,
      .columns_reversed =
          (half_turn || orientation.rotation == Rotation::by_90) != (orientation.mirrored && !exchanged),
      .rows_reversed = (half_turn || orientation.rotation == Rotation::by_270) != (orientation.mirrored && exchanged)};
}

}  // namespace zstrip::hal
