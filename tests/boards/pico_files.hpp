// Programs for the boot loaders of Raspberry Pi's chips, as files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace zstrip::boards {

using Bytes = std::vector<unsigned char>;

/// The flash of a program from its beginning, as binutils see it.
Bytes flash_image(const std::string& program_name);

/// Four bytes, the lowest first.
std::uint32_t word(const Bytes& bytes, std::size_t at);

/// What is wrong with a program's .uf2 file for a chip of this family, by its format and by the flash; empty: nothing.
std::string uf2_complaint(const Bytes& uf2, Bytes flash, std::uint32_t family);

/// The program's .uf2 file; empty where the cross build had no compiler for this machine.
Bytes uf2_file(const std::string& program_name);

}  // namespace zstrip::boards
