// The lists of triangles that wait for their strips. All of it lies in the caller's memory; every write is checked.
#pragma once

#include <cstdint>

#include "zstrip/plan/record_bytes.hpp"

namespace zstrip::detail {

/// A meshlet whose vertices stay transformed for the whole frame.
struct RetainedBatch {
  std::uint16_t instance;           ///< index into Scene::instances
  std::uint16_t meshlet;            ///< index into Mesh::meshlets
  std::uint32_t first_vertex : 31;  ///< index of the transformed vertices
  std::uint32_t all_narrow : 1;     ///< none of them needs the clipping path
};
static_assert(sizeof(RetainedBatch) == kBatchBytes);

/// Plans keep each number within its bits.
constexpr RetainedBatch retained_batch(std::uint32_t instance, std::uint32_t meshlet, std::uint32_t first_vertex,
                                       bool all_narrow) {
  return {static_cast<std::uint16_t>(instance), static_cast<std::uint16_t>(meshlet), first_vertex & 0x7FFFFFFFU,
          all_narrow};
}

/// A list is a chain of chunks of 16-bit entries: kBatchEntry + n, "the triangles of batch n follow", or the index of a
/// triangle in its meshlet.
inline constexpr std::uint16_t kBatchEntry = 0x8000;

class Bins {
 public:
  Bins() = default;
  /// `memory`: `bytes` of a plan's bins without its batches, aligned to 4.
  Bins(std::byte* memory, std::uint32_t bytes, std::uint32_t strips) {
    lists_ = reinterpret_cast<List*>(memory);
    chunks_ = reinterpret_cast<Chunk*>(memory + strips * kBinBytes);
    const std::uint32_t chunks = (bytes - strips * kBinBytes) / kBinChunkBytes;
    capacity_ = chunks < kMaxBinChunks ? chunks : kMaxBinChunks;
    for (std::uint32_t strip = 0; strip < strips; ++strip) lists_[strip] = {kNone, kNone, kNone, kBinChunkEntries};
  }

  /// False if the memory is full.
  bool add(std::uint32_t strip, std::uint16_t batch, std::uint16_t triangle) {
    List& list = lists_[strip];
    if (list.batch == batch && list.used != kBinChunkEntries) {
      chunks_[list.last].entries[list.used++] = triangle;
      return true;
    }
    if (list.batch != batch) {
      if (!append(list, static_cast<std::uint16_t>(kBatchEntry | batch))) return false;
      list.batch = batch;
    }
    return append(list, triangle);
  }

  /// Calls visit(batch, first, count) for each run of triangles of one batch, in the order in which they were added.
  template <class Visit>
  void for_each_run(std::uint32_t strip, const Visit& visit) const {
    const List& list = lists_[strip];
    std::uint16_t batch = 0;
    for (std::uint16_t at = list.first; at != kNone; at = chunks_[at].next) {
      const Chunk& chunk = chunks_[at];
      const std::uint32_t count = at == list.last ? list.used : kBinChunkEntries;
      for (std::uint32_t i = 0; i < count;) {
        if ((chunk.entries[i] & kBatchEntry) != 0) {
          batch = chunk.entries[i++] & static_cast<std::uint16_t>(~kBatchEntry);
          continue;
        }
        const std::uint32_t first = i;
        while (i < count && (chunk.entries[i] & kBatchEntry) == 0) ++i;
        visit(batch, chunk.entries + first, i - first);
      }
    }
  }

 private:
  static constexpr std::uint16_t kNone = 0xFFFF;
  struct List {
    std::uint16_t first, last;  ///< chunks
    std::uint16_t batch;        ///< of the triangle added last
    std::uint16_t used;         ///< entries of the last chunk
  };
  struct Chunk {
    std::uint16_t next;
    std::uint16_t entries[kBinChunkEntries];
  };
  static_assert(sizeof(List) == kBinBytes && sizeof(Chunk) == kBinChunkBytes);

  [[gnu::noinline]] bool append(List& list, std::uint16_t entry) {
    if (list.used == kBinChunkEntries) {
      if (used_ == capacity_) return false;
      const auto fresh = static_cast<std::uint16_t>(used_++);
      if (list.last == kNone) {
        list.first = fresh;
      } else {
        chunks_[list.last].next = fresh;
      }
      chunks_[fresh].next = kNone;
      list.last = fresh;
      list.used = 0;
    }
    chunks_[list.last].entries[list.used++] = entry;
    return true;
  }

  List* lists_ = nullptr;
  Chunk* chunks_ = nullptr;
  std::uint32_t capacity_ = 0, used_ = 0;
};

}  // namespace zstrip::detail
