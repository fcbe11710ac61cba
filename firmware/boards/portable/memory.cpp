// memcpy, memmove, memset and memcmp, which compilers call even in freestanding code, for targets without a C library.
// They use whole words if both sides are aligned; on Arm sixteen bytes at a time with load and store multiple. Compile
// with GCC's -fno-tree-loop-distribute-patterns or clang's -fno-builtin: otherwise compilers replace these loops by
// calls of the same functions.
#include <cstddef>
#include <cstdint>

namespace {

using Byte = unsigned char;
using Word [[gnu::may_alias]] = std::uint32_t;

constexpr std::size_t kBlock = 16;

bool aligned(const void* address) { return reinterpret_cast<std::uintptr_t>(address) % sizeof(Word) == 0; }

bool equally_aligned(const void* a, const void* b) {
  return (reinterpret_cast<std::uintptr_t>(a) - reinterpret_cast<std::uintptr_t>(b)) % sizeof(Word) == 0;
}

// Both addresses are aligned, blocks > 0; moves them to the end of the blocks.
#if defined(__arm__)
void copy_blocks(Byte*& to, const Byte*& from, std::size_t blocks) {
  asm volatile(
      ".syntax unified\n"
      "1: ldmia %1!, {r3, r4, r5, r6}\n\t"
      "stmia %0!, {r3, r4, r5, r6}\n\t"
      "subs %2, %2, #1\n\t"
      "bne 1b"
      : "+l"(to), "+l"(from), "+l"(blocks)
      :
      : "r3", "r4", "r5", "r6", "cc", "memory");
}

void fill_blocks(Byte*& to, Word value, std::size_t blocks) {
  asm volatile(
      ".syntax unified\n\t"
      "mov r3, %2\n\t"
      "mov r4, %2\n\t"
      "mov r5, %2\n\t"
      "mov r6, %2\n"
      "1: stmia %0!, {r3, r4, r5, r6}\n\t"
      "subs %1, %1, #1\n\t"
      "bne 1b"
      : "+l"(to), "+l"(blocks)
      : "l"(value)
      : "r3", "r4", "r5", "r6", "cc", "memory");
}
#else
void copy_blocks(Byte*& to, const Byte*& from, std::size_t blocks) {
  for (std::size_t words = blocks * (kBlock / sizeof(Word)); words > 0; --words) {
    *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
    to += sizeof(Word);
    from += sizeof(Word);
  }
}

void fill_blocks(Byte*& to, Word value, std::size_t blocks) {
  for (std::size_t words = blocks * (kBlock / sizeof(Word)); words > 0; --words, to += sizeof(Word)) {
    *reinterpret_cast<Word*>(to) = value;
  }
}
#endif

void copy_upwards(Byte* to, const Byte* from, std::size_t count) {
  if (count >= 2 * sizeof(Word) && equally_aligned(to, from)) {
    for (; !aligned(to); --count) *to++ = *from++;
    if (count >= kBlock) copy_blocks(to, from, count / kBlock);
    count %= kBlock;
    for (; count >= sizeof(Word); count -= sizeof(Word), to += sizeof(Word), from += sizeof(Word)) {
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
    }
  }
  while (count-- > 0) *to++ = *from++;
}

void copy_downwards(Byte* to, const Byte* from, std::size_t count) {
  to += count;
  from += count;
  if (count >= 2 * sizeof(Word) && equally_aligned(to, from)) {
    for (; !aligned(to); --count) *--to = *--from;
    for (; count >= sizeof(Word); count -= sizeof(Word)) {
      to -= sizeof(Word);
      from -= sizeof(Word);
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
    }
  }
  while (count-- > 0) *--to = *--from;
}

}  // namespace

extern "C" {

void* memcpy(void* __restrict to, const void* __restrict from, std::size_t count) {
  copy_upwards(static_cast<Byte*>(to), static_cast<const Byte*>(from), count);
  return to;
}

void* memmove(void* to, const void* from, std::size_t count) {
  // Copying upwards is right unless `to` lies inside [from, from + count); the difference wraps if it lies below.
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
  if (count >= 2 * sizeof(Word)) {
    for (; !aligned(next); --count) *next++ = byte;
    const Word word = byte * 0x01010101U;
    if (count >= kBlock) fill_blocks(next, word, count / kBlock);
    count %= kBlock;
    for (; count >= sizeof(Word); count -= sizeof(Word), next += sizeof(Word)) *reinterpret_cast<Word*>(next) = word;
  }
  while (count-- > 0) *next++ = byte;
  return to;
}

int memcmp(const void* a, const void* b, std::size_t count) {
  const Byte* left = static_cast<const Byte*>(a);
  const Byte* right = static_cast<const Byte*>(b);
  if (aligned(left) && aligned(right)) {
    while (count >= sizeof(Word) && *reinterpret_cast<const Word*>(left) == *reinterpret_cast<const Word*>(right)) {
      left += sizeof(Word);
      right += sizeof(Word);
      count -= sizeof(Word);
    }
  }
  for (; count > 0; --count, ++left, ++right) {
    if (*left != *right) return *left - *right;
  }
  return 0;
}
}
