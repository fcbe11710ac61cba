// Reads the sections of a scene blob, whose bytes may be anything, and keeps the first error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/scene/blob_sections.hpp"

namespace zstrip::detail {

/// Reads the table of sections once, in the order of the list of known sections; keeps the first error.
class BlobReader {
 public:
  /// The envelope must have been checked: header and table lie inside the blob.
  explicit BlobReader(std::span<const std::byte> blob)
      : first_(blob.data()), size_(static_cast<std::uint32_t>(blob.size())) {
    const auto* const header = reinterpret_cast<const blob_layout::Header*>(first_);
    next_ = reinterpret_cast<const blob_layout::Section*>(header + 1);
    end_ = next_ + header->sections;
    free_ = offset_of(end_);
  }

  [[gnu::noinline]] void fail(const Status& status) {
    if (status_) status_ = status;
  }
  void require(bool holds, const void* culprit) {
    if (!holds) fail({.error = Error::blob_damaged, .needed = offset_of(culprit)});
  }
  /// Checks that a bool is 0 or 1: other values must not be read as a bool.
  void flag(const bool& value) { require(*reinterpret_cast<const std::uint8_t*>(&value) <= 1, &value); }

  /// The interface that blob_layout::for_each_section calls.
  template <class Record>
  void operator()(blob_layout::Tag tag, std::span<const Record>& where) {
    static_assert(alignof(Record) <= kSceneBlobAlignment);
    const Found found = take(tag, sizeof(Record));
    where = {reinterpret_cast<const Record*>(found.first), found.count};
  }
  template <class Record>
  void operator()(blob_layout::Tag tag, const Record*& where) {
    static_assert(alignof(Record) <= kSceneBlobAlignment);
    where = reinterpret_cast<const Record*>(take_one(tag, sizeof(Record)));
  }
  template <class Record>
  void needed(blob_layout::Tag tag, const Record*& where) {
    (*this)(tag, where);
    require(where != nullptr, next_);
  }
  /// Call it after the last known section.
  void finish() {
    (void)take(0xFFFFFFFF, 1);
    require(next_ == end_, next_);
    require(free_ == size_, first_ + free_);
  }

  /// Returns the part of `all` that a record refers to; empty if it is out of range.
  template <class Record>
  std::span<const Record> some(std::span<const Record> all, const blob_layout::Range& range) {
    if (!inside(range, all.size())) return {};
    return {all.data() + range.first, range.count};
  }

  const Status& status() const { return status_; }

 private:
  struct Found {
    const std::byte* first;
    std::uint32_t count;
  };

  std::uint32_t offset_of(const void* place) const {
    return static_cast<std::uint32_t>(static_cast<const std::byte*>(place) - first_);
  }
  [[gnu::noinline]] bool inside(const blob_layout::Range& range, std::size_t count) {
    const bool holds = range.first <= count && range.count <= count - range.first;
    require(holds, &range);
    return holds;
  }
  /// Returns the begin of the next section, or null if the section is not where it must be. Moves on to the section
  /// after it.
  [[gnu::noinline]] const std::byte* step() {
    const blob_layout::Section& section = *next_++;
    const bool ascends = section.tag() > last_, follows = section.offset == free_;
    require(ascends, &section);
    require(follows, &section.offset);
    const bool fits = follows && section.bytes != 0 && section.bytes <= size_ - free_;
    require(fits, &section.bytes);
    last_ = section.tag();
    if (!fits) return nullptr;
    free_ = (section.offset + section.bytes + kSceneBlobAlignment - 1) & ~(kSceneBlobAlignment - 1);
    return first_ + section.offset;
  }
  /// Returns the records of this section, or none if the section is missing. Sections before it are unknown.
  [[gnu::noinline]] Found take(blob_layout::Tag tag, std::uint32_t record_bytes) {
    while (next_ != end_ && next_->tag() < tag) {
      (void)step();
      // A second section with the same tag comes here, too, but step() has already reported that it does not ascend.
      if (blob_layout::must_be_known(last_)) fail({.error = Error::blob_section, .needed = last_});
    }
    if (next_ == end_ || next_->tag() != tag) return {nullptr, 0};
    const blob_layout::Section& section = *next_;
    const std::byte* const first = step();
    const std::uint32_t count = section.bytes / record_bytes;
    const bool whole = count * record_bytes == section.bytes;
    require(whole, &section.bytes);
    return first != nullptr && whole ? Found{first, count} : Found{nullptr, 0};
  }
  [[gnu::noinline]] const std::byte* take_one(blob_layout::Tag tag, std::uint32_t record_bytes) {
    const Found found = take(tag, record_bytes);
    if (found.count > 1) require(false, &next_[-1].bytes);
    return found.first;
  }

  const std::byte* first_;
  std::uint32_t size_;
  const blob_layout::Section* next_;
  const blob_layout::Section* end_;
  std::uint32_t free_;         ///< the offset at which the next section must begin
  blob_layout::Tag last_ = 0;  ///< the tag of the section before
  Status status_;
};

}  // namespace zstrip::detail
