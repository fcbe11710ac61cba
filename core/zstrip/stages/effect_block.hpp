// The data that effects keep from begin_frame to the strips: the last part of the arena, which only plans with such
// have.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/effects/memory.hpp"

namespace zstrip::detail {

/// It is laid out by the effects that the scene calls for, not by those of the pipeline: a superset draws with the plan
/// of the exact set. Only parts whose effects has() confirms may be used.
class EffectBlock {
 public:
  /// `memory`: `bytes` of the plan, aligned to kArenaAlignment.
  EffectBlock(std::byte* memory, std::uint32_t bytes) : memory_(memory), bytes_(bytes) {}

  /// Comes before anything else. `instances`: hulls of outlines among them. `bytes` are those of MemoryOfEffects or
  /// more.
  void lay_out(Effects called_for, std::uint32_t instances) const {
    if (bytes_ >= sizeof(Header)) *reinterpret_cast<Header*>(memory_) = {called_for.bits, instances, 0};
  }
  bool has(Effects effects) const { return bytes_ >= sizeof(Header) && (header().bits & effects.bits) != 0; }
  std::uint32_t instances() const { return header().instances; }

  /// The part of an effect, as an object, or the first of an array, that lies `offset` bytes behind its beginning.
  template <class Effect, class Object>
  Object* at(std::size_t offset = 0) const {
    static_assert(alignof(Object) <= Effect::kAlignment);
    const std::size_t first = MemoryOfEffects::offset_of<Effect>({header().bits, 0}, header().instances);
    return reinterpret_cast<Object*>(memory_ + first + offset);
  }
  /// One behind the last byte.
  std::byte* end() const { return memory_ + bytes_; }

 private:
  struct Header {
    std::uint64_t bits;  ///< of the effects that the scene calls for
    std::uint32_t instances, unused;
  };
  static_assert(sizeof(Header) == kEffectHeaderBytes);
  const Header& header() const { return *reinterpret_cast<const Header*>(memory_); }

  std::byte* memory_;
  std::uint32_t bytes_;
};

}  // namespace zstrip::detail
