// The depth store: depth that outlives its strip, compressed without loss. 16-bit cells of any format in which 0 is
// a cleared cell; the codec is made for depth that is linear over the picture, or nearly so.
#pragma once

#include "zstrip/store/depth_tile.hpp"
#include "zstrip/store/tile_store.hpp"

namespace zstrip {

namespace detail {
inline constexpr TileCodec kDepthCodec{'d', Purpose::depth, encode_depth_tile, decode_depth_tile};
}

/// Never allocates. Writing takes less than 1.5 KB of stack, reading less than 768 bytes.
class DepthStore : public detail::TileStore {
 public:
  constexpr DepthStore() : TileStore(detail::kDepthCodec) {}
};

/// Reads the blob of a DepthStore where it lies, in flash too. Nothing that the blob holds can make it read elsewhere.
class DepthReader : public detail::TileReader {
 public:
  constexpr DepthReader() : TileReader(detail::kDepthCodec) {}
  /// Error::store_damaged if these bytes do not begin with a depth store's index. The blob must stay alive; bytes
  /// behind the last record do not matter. It does not look at the records: reading does.
  using TileReader::open;
};

}  // namespace zstrip
