// Hashes of tiles and digests of scenes tell apart what differs in a few bits of neighbouring words.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "zstrip/state/digest.hpp"
#include "zstrip_hal/changed_tiles.hpp"

namespace zstrip::panels {
namespace {

/// Changes of two pixels of RGB565: one bit, two bits, or channels of one pixel or of both, in either order of bytes.
std::vector<std::uint32_t> changes_of_a_word() {
  std::vector<std::uint32_t> changes;
  for (unsigned i = 0; i < 32; ++i) {
    for (unsigned j = 0; j <= i; ++j) changes.push_back(1U << i | 1U << j);
  }
  for (const std::uint32_t channel : {0xF800U, 0x07E0U, 0x001FU, 0xFFFFU, 0x00F8U, 0xE007U, 0x1F00U}) {
    for (const std::uint32_t change : {channel, channel << 16, channel << 16 | channel}) changes.push_back(change);
  }
  return changes;
}

/// Counts the pairs of changes of two neighbouring words, of random ones, that `hash_of` does not see.
template <std::size_t size, class Hash>
int missed(std::size_t first, const Hash& hash_of) {
  const std::vector<std::uint32_t> changes = changes_of_a_word();
  std::mt19937 random(1);
  int count = 0;
  for (int contents = 0; contents < 3; ++contents) {
    std::array<std::uint32_t, size> words;
    for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(random());
    const std::uint32_t unchanged = hash_of(words);
    for (const std::uint32_t one : changes) {
      words[first] ^= one;
      for (const std::uint32_t other : changes) {
        words[first + 1] ^= other;
        count += hash_of(words) == unchanged ? 1 : 0;
        words[first + 1] ^= other;
      }
      words[first] ^= one;
    }
  }
  return count;
}

// One product a word missed 39 pairs often, among them always the highest bit of one word and bit 4 of the next.
TEST(ChangedHash, OfATileSeesChangesOfTwoNeighbouringWords) {
  const auto hash_of = [](std::span<const std::uint32_t> words) {
    return hal::detail::hash_rows(3, std::as_bytes(words).data(), 16, 16, 2);
  };
  for (const std::size_t first : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
    EXPECT_EQ(missed<8>(first, hash_of), 0) << first;
  }
}

TEST(ChangedHash, OfASceneSeesChangesOfTwoNeighbouringWords) {
  const auto digest_of = [](std::span<const std::uint32_t> words) {
    detail::Digest digest(1);
    for (const std::uint32_t word : words) digest.add(word);
    return digest.value();
  };
  EXPECT_EQ(missed<3>(0, digest_of), 0);
}

/// Of rows that are not aligned, too.
TEST(ChangedHash, SeesEveryChangeOfOneWord) {
  std::array<std::uint32_t, 8> words{};
  const std::span<std::byte> bytes = std::as_writable_bytes(std::span(words));
  for (const std::size_t misplaced : {0U, 1U}) {
    const auto hash = [&] { return hal::detail::hash_rows(3, bytes.data() + misplaced, 14, 16, 2); };
    const std::uint32_t unchanged = hash();
    for (const std::size_t at : {std::size_t{1}, std::size_t{13}, std::size_t{17}, std::size_t{29}}) {
      for (unsigned value = 1; value < 256; ++value) {
        bytes[at] = static_cast<std::byte>(value);
        ASSERT_NE(hash(), unchanged) << misplaced << ' ' << at;
      }
      bytes[at] = {};
    }
  }
}

}  // namespace
}  // namespace zstrip::panels
