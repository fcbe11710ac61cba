// The depth store: keeps depth after its strip is drawn, compressed without loss. Cells have 16 bits, in any format in
// which 0 is a cleared cell; the codec is made for depth that is linear over the picture, or nearly so.
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

/// Reads the blob of a DepthStore in place, also in flash. Never reads outside the blob, for any contents.
class DepthReader : public detail::TileReader {
 public:
  constexpr DepthReader() : TileReader(detail::kDepthCodec) {}
  /// Error::store_damaged if the bytes do not begin with a depth store's index. The blob must stay alive; bytes after
  /// the last record are ignored. Records are not checked here, but when they are read.
  using TileReader::open;
};

}  // namespace zstrip
