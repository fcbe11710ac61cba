// The baked scene (.zsc) that the emulator puts into the board's flash, at the address from
// host-sim/bench/board_bench.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/blob.hpp"

namespace zstrip::bench {

#if ZSTRIP_MPS2_IMAGE == 505
inline constexpr std::uintptr_t kSceneAddress = 0x10100000;
#else
inline constexpr std::uintptr_t kSceneAddress = 0x00100000;
#endif
inline constexpr std::size_t kSceneBytes = 0x00300000;  // to the end of the flash

/// Tables of up to a hundred meshes, textures, sets of lines and of edges.
alignas(kSceneBlobMemoryAlignment) inline std::byte scene_tables[scene_blob_memory(100, 100, 100, 100)];

/// Bytes 4 to 7 of a blob hold its length.
inline std::span<const std::byte> blob_in_flash() {
  const auto* const bytes = reinterpret_cast<const std::byte*>(kSceneAddress);  // NOLINT(performance-no-int-to-ptr)
  std::uint32_t size = 0;
  for (int i = 3; i >= 0; --i) size = size << 8 | std::to_integer<std::uint32_t>(bytes[4 + i]);
  return {bytes, size < kSceneBytes ? size : kSceneBytes};
}

inline Status open_scene_in_flash(SceneBlob& opened) { return open_scene_blob(blob_in_flash(), scene_tables, opened); }

}  // namespace zstrip::bench
