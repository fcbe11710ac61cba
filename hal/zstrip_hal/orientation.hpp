// The orientation of a picture on the glass of a panel, and the directions of a controller's address counters for it.
#pragma once

#include <cstdint>

namespace zstrip::hal {

/// Rotation of the picture on the glass, clockwise.
enum class Rotation : std::uint8_t {
  none,    ///< upright
  by_90,   ///< degrees; width and height are exchanged
  by_180,  ///< degrees
  by_270,  ///< degrees; width and height are exchanged
};

/// The picture is mirrored first (left and right swapped), then rotated. A picture mirrored top to bottom is mirrored
/// and rotated by 180 degrees.
struct Orientation {
  Rotation rotation = Rotation::none;  ///< after mirroring
  bool mirrored = false;               ///< left and right swapped
  friend constexpr bool operator==(const Orientation&, const Orientation&) = default;
};

/// True if a row of the picture is a column of the glass, so that width and height are exchanged.
constexpr bool is_sideways(const Orientation& orientation) {
  return orientation.rotation == Rotation::by_90 || orientation.rotation == Rotation::by_270;
}

/// The orientation as a controller's address counters see it: pixel (x, y) of the picture lies in column
/// `exchanged ? y : x`, counted from the right if `columns_reversed`, and in row `exchanged ? x : y`, counted from the
/// bottom if `rows_reversed`.
struct Scan {
  bool exchanged = false;         ///< rows of the picture are columns of the glass
  bool columns_reversed = false;  ///< columns are counted from the right of the glass
  bool rows_reversed = false;     ///< rows are counted from the bottom of the glass
};

/// Returns the directions in which a controller must count for this orientation.
constexpr Scan scan_of(const Orientation& orientation) {
  const bool exchanged = is_sideways(orientation);
  const bool half_turn = orientation.rotation == Rotation::by_180;
  // Mirroring reverses the direction of a row of the picture, which is a row or a column of the glass.
  return {
      .exchanged = exchanged,
      .columns_reversed =
          (half_turn || orientation.rotation == Rotation::by_90) != (orientation.mirrored && !exchanged),
      .rows_reversed = (half_turn || orientation.rotation == Rotation::by_270) != (orientation.mirrored && exchanged)};
}

}  // namespace zstrip::hal
