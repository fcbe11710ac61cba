// The data that effects keep from begin_frame to the strips. It is the last part of the arena, and exists only in plans
// with such effects.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/effects/memory.hpp"

namespace zstrip::detail {

/// The layout depends on the effects that the scene needs, not on those of the pipeline: a pipeline with more effects
/// draws with the plan of the exact set. Only parts whose effects has() confirms may be used.
class EffectBlock {
 public:
  /// `memory`: `bytes` of the plan, aligned to kArenaAlignment.
  EffectBlock(std::byte* memory, std::uint32_t bytes) : memory_(memory), bytes_(bytes) {}

  /// Call it first. `instances` includes hulls of outlines. `bytes` must be at least those of MemoryOfEffects.
  void lay_out(Effects called_for, std::uint32_t instances) const {
    if (bytes_ >= sizeof(Header)) *reinterpret_cast<Header*>(memory_) = {called_for.bits, instances, 0};
  }
  bool has(Effects effects) const { return bytes_ >= sizeof(Header) && (header().bits & effects.bits) != 0; }
  std::uint32_t instances() const { return header().instances; }

  /// Returns an effect's part as an object, or as the first object of an array, that lies `offset` bytes after the
  /// part's beginning.
  template <class Effect, class Object>
  Object* at(std::size_t offset = 0) const {
    static_assert(alignof(Object) <= Effect::kAlignment);
    const std::size_t first = MemoryOfEffects::offset_of<Effect>({header().bits, 0}, header().instances);
    return reinterpret_cast<Object*>(memory_ + first + offset);
  }
  /// Returns the address after the last byte.
  std::byte* end() const { return memory_ + bytes_; }

 private:
  struct Header {
    std::uint64_t bits;  ///< effects that the scene needs
    std::uint32_t instances, unused;
  };
  static_assert(sizeof(Header) == kEffectHeaderBytes);
  const Header& header() const { return *reinterpret_cast<const Header*>(memory_); }

  std::byte* memory_;
  std::uint32_t bytes_;
};

}  // namespace zstrip::detail
