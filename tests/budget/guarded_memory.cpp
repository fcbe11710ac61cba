// Garbage in and around the bytes; what it must be still there is known from its place.
#include "guarded_memory.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#if defined(__has_feature)
#define ZSTRIP_HAS_FEATURE(feature) __has_feature(feature)
#else
#define ZSTRIP_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || ZSTRIP_HAS_FEATURE(address_sanitizer)
#include <sanitizer/asan_interface.h>
#define ZSTRIP_ADDRESS_SANITIZER 1
#else
#define ZSTRIP_ADDRESS_SANITIZER 0
#define ASAN_POISON_MEMORY_REGION(address, size) (static_cast<void>(address), static_cast<void>(size))
#define ASAN_UNPOISON_MEMORY_REGION(address, size) (static_cast<void>(address), static_cast<void>(size))
#endif

namespace zstrip::budget {
namespace {

constexpr std::size_t kGuard = 64;

/// No two neighbours are equal, nor is any run of them zero.
constexpr std::byte garbage(std::size_t at) { return static_cast<std::byte>(0xA5 + 37 * at); }

/// The garbage of 256 bytes that begin anywhere, since it repeats after so many. Filled and compared in such pieces:
/// byte by byte that took sanitized tests minutes.
constexpr std::size_t kPeriod = 256;
constexpr auto kGarbage = [] {
  std::array<std::byte, 2 * kPeriod> bytes{};
  for (std::size_t at = 0; at < bytes.size(); ++at) bytes[at] = garbage(at);
  return bytes;
}();
const std::byte* garbage_from(std::size_t at) { return kGarbage.data() + at % kPeriod; }

std::size_t first_aligned(const std::byte* address) { return (8 - reinterpret_cast<std::uintptr_t>(address) % 8) % 8; }

}  // namespace

GuardedMemory::GuardedMemory(std::size_t size, std::size_t misalignment)
    : begin_(0), size_(size), memory_(size + 2 * kGuard + 16) {
  for (std::size_t at = 0; at < memory_.size(); at += kPeriod) {
    std::memcpy(memory_.data() + at, garbage_from(at), std::min(kPeriod, memory_.size() - at));
  }
  begin_ = kGuard + first_aligned(memory_.data()) + misalignment;
  close_guards();
}

bool GuardedMemory::traps_access_outside() { return ZSTRIP_ADDRESS_SANITIZER != 0; }

GuardedMemory::~GuardedMemory() { open_guards(); }

void GuardedMemory::close_guards() {
  ASAN_POISON_MEMORY_REGION(memory_.data(), begin_);
  ASAN_POISON_MEMORY_REGION(memory_.data() + begin_ + size_, memory_.size() - begin_ - size_);
}

void GuardedMemory::open_guards() { ASAN_UNPOISON_MEMORY_REGION(memory_.data(), memory_.size()); }

bool GuardedMemory::is_garbage(std::size_t from, std::size_t to) const {
  for (std::size_t at = from; at < to; at += kPeriod) {
    if (std::memcmp(memory_.data() + at, garbage_from(at), std::min(kPeriod, to - at)) != 0) return false;
  }
  return true;
}

bool GuardedMemory::guards_untouched() {
  open_guards();
  const bool result = is_garbage(0, begin_) && is_garbage(begin_ + size_, memory_.size());
  close_guards();
  return result;
}

bool GuardedMemory::untouched() {
  open_guards();
  const bool result = is_garbage(0, memory_.size());
  close_guards();
  return result;
}

}  // namespace zstrip::budget
