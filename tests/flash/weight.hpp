// What a linked program without a board takes of flash, by groups.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "elf_file.hpp"
#include "groups.hpp"
#include "inlined.hpp"

namespace zstrip::flash {

/// In bytes.
struct Weight {
  std::array<std::uint32_t, std::size(kGroups)> groups{};
  std::uint32_t tables = 0;                     ///< of the scene, in no group
  std::map<std::string, std::uint32_t> rest{};  ///< what is in Group::rest, by names for readers

  std::uint32_t of(Group group) const { return groups[static_cast<std::size_t>(group)]; }
  std::uint32_t bytes() const;  ///< of all groups
};

/// Each byte of what is in flash counts once: for the first symbol of its address, or what is inlined there. Texts have
/// a section of their own.
Weight weigh(const budget::ElfFile& program, const Inlined& inlined);

/// Lines with what is in Group::rest if that is more than a tenth: the table of patterns lacks names then. Else empty.
std::string complaint_of_rest(const std::string& program, const Weight& weight);

}  // namespace zstrip::flash
