// The colour store: RGB565 of a static layer, compressed without loss, next to its depth.
#pragma once

#include "zstrip/store/colour_tile.hpp"
#include "zstrip/store/tile_store.hpp"

namespace zstrip {

namespace detail {
inline constexpr TileCodec kColourCodec{'c', Purpose::colour, encode_colour_tile, decode_colour_tile};
}

/// Never allocates. Tiles that were never written read as 0. Writing takes less than 1 KB of stack, reading less than
/// 768 bytes.
class ColourStore : public detail::TileStore {
 public:
  constexpr ColourStore() : TileStore(detail::kColourCodec) {}
};

/// Reads the blob of a ColourStore in place, as DepthReader does.
class ColourReader : public detail::TileReader {
 public:
  constexpr ColourReader() : TileReader(detail::kColourCodec) {}
  /// Error::store_damaged if these bytes do not begin with a colour store's index. The blob must stay alive.
  using TileReader::open;
};

}  // namespace zstrip
