// The lists of triangles that wait for their strips. They lie in the caller's memory; every write is checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/plan/record_bytes.hpp"

namespace zstrip::detail {

/// A meshlet whose transformed vertices are kept for the whole frame.
struct RetainedBatch {
  std::uint16_t instance;           ///< index into Scene::instances
  std::uint16_t meshlet;            ///< index into Mesh::meshlets
  std::uint32_t first_vertex : 31;  ///< index of the transformed vertices
  std::uint32_t all_narrow : 1;     ///< no vertex needs the clipping path
};
static_assert(sizeof(RetainedBatch) == kBatchBytes);

/// Makes a batch; plans keep each number within its bits.
constexpr RetainedBatch retained_batch(std::uint32_t instance, std::uint32_t meshlet, std::uint32_t first_vertex,
                                       bool all_narrow) {
  return {static_cast<std::uint16_t>(instance), static_cast<std::uint16_t>(meshlet), first_vertex & 0x7FFFFFFFU,
          all_narrow};
}

/// A list is a chain of chunks of 16-bit entries. An entry kBatchEntry + n means "triangles of batch n follow"; any
/// other entry is the index of a triangle in its meshlet.
inline constexpr std::uint16_t kBatchEntry = 0x8000;
constexpr bool is_batch_entry(std::uint16_t entry) { return (entry & kBatchEntry) != 0; }

/// Slots of a chunk: the number of the next chunk, then the entries.
inline constexpr std::uint32_t kBinChunkSlots = kBinChunkEntries + 1;
static_assert(kBinChunkSlots * sizeof(std::uint16_t) == kBinChunkBytes);

struct BinList {
  std::uint32_t next;   ///< slot of the next entry. A slot directly after a chunk means that the chunk is full or that
                        ///< there is none.
  std::uint16_t batch;  ///< batch of the triangle that was added last
  std::uint16_t first;
};
static_assert(sizeof(BinList) == kBinBytes);

class Bins {
 public:
  Bins() = default;
  /// `memory`: `bytes` of a plan's bins without its batches, aligned to 4.
  Bins(std::byte* memory, std::uint32_t bytes, std::uint32_t strips) {
    lists_ = reinterpret_cast<BinList*>(memory);
    slots_ = reinterpret_cast<std::uint16_t*>(memory + strips * kBinBytes);
    const std::uint32_t chunks = (bytes - strips * kBinBytes) / kBinChunkBytes;
    capacity_ = static_cast<std::uint16_t>(chunks < kMaxBinChunks ? chunks : kMaxBinChunks);
    newest_batch_ = kNone;  // assigned here: a member initialiser would put the whole renderer with its arena into
                            // flash
    for (std::uint32_t strip = 0; strip < strips; ++strip) lists_[strip] = {0, kNone, kNone};
    if (capacity_ != 0) __builtin_memset(slots_ + (capacity_ - 1) * kBinChunkSlots, 0, kBinChunkBytes);
  }

  /// Returns false if the memory is full.
  bool add(std::uint32_t strip, std::uint16_t batch, std::uint16_t triangle) {
    BinList& list = lists_[strip];
    const std::uint32_t next = list.next;
    if (list.batch != batch || next % kBinChunkSlots == 0) return append(list, batch, triangle);
    slots_[next] = triangle;
    list.next = next + 1;
    return true;
  }

  /// Adds to a list that has no room for a triangle of this batch, or no entry for the batch.
  [[gnu::noinline]] bool append(BinList& list, std::uint16_t batch, std::uint16_t triangle) {
    if (list.batch != batch) {
      if (!put(list, static_cast<std::uint16_t>(kBatchEntry | batch))) return false;
      list.batch = newest_batch_ = batch;
    }
    return put(list, triangle);
  }

  /// True if some list has a triangle of this batch, and no list has one of a later batch.
  bool has_newest(std::uint16_t batch) const { return newest_batch_ == batch; }

  /// Returns the memory that no list uses, in whole chunks. The last chunk is all zeros when the frame begins.
  std::span<std::uint16_t> spare() const {
    return {slots_ + used_ * kBinChunkSlots, (capacity_ - std::size_t{used_}) * kBinChunkSlots};
  }

  /// Returns the lists without spare memory.
  Bins without_spare() const {
    Bins lists = *this;
    lists.capacity_ = used_;
    return lists;
  }

  BinList* lists() const { return lists_; }
  std::uint16_t* slots() const { return slots_; }

 private:
  static constexpr std::uint16_t kNone = 0xFFFF;

  bool put(BinList& list, std::uint16_t entry) {
    if (list.next % kBinChunkSlots == 0) {
      if (used_ == capacity_) return false;
      const std::uint16_t fresh = used_++;
      if (list.next == 0) {
        list.first = fresh;
      } else {
        slots_[list.next - kBinChunkSlots] = fresh;
      }
      list.next = fresh * kBinChunkSlots + 1;
    }
    slots_[list.next++] = entry;
    return true;
  }

  BinList* lists_ = nullptr;
  std::uint16_t* slots_ = nullptr;
  std::uint16_t capacity_ = 0, used_ = 0;  ///< chunks
  std::uint16_t newest_batch_ = 0;
};

/// Reads the list of a strip from its start.
class BinReader {
 public:
  BinReader(const Bins& bins, std::uint32_t strip)
      : bins_(bins),
        slots_(bins.slots()),
        at_(bins.lists()[strip].first * kBinChunkSlots + 1),
        end_(bins.lists()[strip].next) {
    if (end_ == 0) at_ = 0;
  }
  const Bins& bins() const { return bins_; }

  /// Goes to the next batch. Returns false at the end of the list.
  bool next_batch() {
    const std::span<const std::uint16_t> entries = rest();
    if (entries.empty()) return false;
    batch_ = static_cast<std::uint16_t>(entries[0] & ~kBatchEntry);
    take(1);
    return true;
  }
  std::uint16_t batch() const { return batch_; }

  /// Returns the next entries of the current chunk; empty at the end of the list. A list's chunks have ascending
  /// numbers.
  std::span<const std::uint16_t> rest() {
    if (at_ == end_) return {};
    if (at_ % kBinChunkSlots == 0) at_ = slots_[at_ - kBinChunkSlots] * kBinChunkSlots + 1;
    const std::uint32_t behind = (at_ | (kBinChunkSlots - 1)) + 1;
    return {slots_ + at_, (end_ < behind ? end_ : behind) - at_};
  }
  void take(std::size_t entries) { at_ += static_cast<std::uint32_t>(entries); }

  /// Returns the next triangles of this batch and skips them; empty at the end of the batch.
  std::span<const std::uint16_t> next_run() {
    const std::span<const std::uint16_t> entries = rest();
    std::size_t count = 0;
    while (count < entries.size() && !is_batch_entry(entries[count])) ++count;
    take(count);
    return entries.first(count);
  }

 private:
  const Bins& bins_;
  const std::uint16_t* slots_;
  std::uint32_t at_, end_;
  std::uint16_t batch_ = 0;
};

}  // namespace zstrip::detail
