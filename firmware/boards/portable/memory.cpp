// memcpy, memmove, memset and memcmp for targets that have no C library, in plain C++: whole words where both sides
// allow it. To be compiled so that these loops do not become calls of themselves.
#include <cstddef>
#include <cstdint>

namespace {

using Byte = unsigned char;
using Word [[gnu::may_alias]] = std::uint32_t;

bool aligned(const void* a, const void* b) {
  return ((reinterpret_cast<std::uintptr_t>(a) | reinterpret_cast<std::uintptr_t>(b)) % sizeof(Word)) == 0;
}

void copy_upwards(Byte* to, const Byte* from, std::size_t count) {
  if (aligned(to, from)) {
    for (; count >= sizeof(Word); count -= sizeof(Word), to += sizeof(Word), from += sizeof(Word)) {
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
    }
  }
  while (count-- > 0) *to++ = *from++;
}

void copy_downwards(Byte* to, const Byte* from, std::size_t count) {
  while (count-- > 0) to[count] = from[count];
}

}  // namespace

extern "C" {

void* memcpy(void* __restrict to, const void* __restrict from, std::size_t count) {
  copy_upwards(static_cast<Byte*>(to), static_cast<const Byte*>(from), count);
  return to;
}

void* memmove(void* to, const void* from, std::size_t count) {
  // Upwards is right unless `to` lies inside [from, from + count); the difference wraps if it lies below.
  const std::uintptr_t distance = reinterpret_cast<std::uintptr_t>(to) - reinterpret_cast<std::uintptr_t>(from);
  if (distance >= count) {
    copy_upwards(static_cast<Byte*>(to), static_cast<const Byte*>(from), count);
  } else {
    copy_downwards(static_cast<Byte*>(to), static_cast<const Byte*>(from), count);
  }
  return to;
}

void* memset(void* to, int value, std::size_t count) {
  Byte* next = static_cast<Byte*>(to);
  const Byte byte = static_cast<Byte>(value);
  if (aligned(next, next)) {
    const Word word = byte * 0x01010101U;
    for (; count >= sizeof(Word); count -= sizeof(Word), next += sizeof(Word)) *reinterpret_cast<Word*>(next) = word;
  }
  while (count-- > 0) *next++ = byte;
  return to;
}

int memcmp(const void* a, const void* b, std::size_t count) {
  const Byte* left = static_cast<const Byte*>(a);
  const Byte* right = static_cast<const Byte*>(b);
  for (; count > 0; --count, ++left, ++right) {
    if (*left != *right) return *left - *right;
  }
  return 0;
}
}
