// Makes a .uf2 file for the boot loader of an RP2040 or RP2350 from pages of flash. Used by programs of the build
// machine and by `zstrip bake`. Format: "USB Flashing Format (UF2)", Microsoft; the loader's rules: RP2040 data sheet,
// 2.8.4.2.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "pico/flash_map.hpp"

namespace zstrip::pico {

using Page = std::array<std::uint8_t, kPage>;
using Pages = std::map<std::uint32_t, Page>;  // by address, a multiple of kPage in the flash

inline constexpr std::size_t kBlock = 512, kBlockHeader = 32, kBlockEnd = kBlock - 4;
inline constexpr std::uint32_t kBegin0 = 0x0A324655, kBegin1 = 0x9E5D5157, kEnd = 0x0AB16F30;
inline constexpr std::uint32_t kFamilyPresent = 0x2000;

/// Returns the pages in whole sectors: each sector except the last is complete and begins at its first page, because a
/// loader may conclude from a block's number whether its sector was erased (erratum RP2040-E14). Added pages are those
/// of erased flash.
inline Pages in_whole_sectors(const Pages& pages) {
  Page erased;
  erased.fill(0xFF);
  Pages whole = pages;
  if (pages.empty()) return whole;
  const std::uint32_t last = pages.rbegin()->first;
  for (const auto& [address, page] : pages) {
    const std::uint32_t sector = address / kSector * kSector;
    for (std::uint32_t at = sector; at < sector + kSector && at <= last; at += kPage) whole.try_emplace(at, erased);
  }
  return whole;
}

inline std::vector<std::uint8_t> to_uf2(const Pages& pages, const Board& board) {
  const Pages whole = in_whole_sectors(pages);
  std::vector<std::uint8_t> file;
  file.reserve(whole.size() * kBlock);
  const auto put = [&file](std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) file.push_back(static_cast<std::uint8_t>(value >> shift));
  };
  std::uint32_t block = 0;
  for (const auto& [address, page] : whole) {
    for (const std::uint32_t word : {kBegin0, kBegin1, kFamilyPresent, address, kPage, block++,
                                     static_cast<std::uint32_t>(whole.size()), board.family}) {
      put(word);
    }
    file.insert(file.end(), page.begin(), page.end());
    file.resize(file.size() + kBlockEnd - kBlockHeader - kPage);
    put(kEnd);
  }
  return file;
}

}  // namespace zstrip::pico
