// Programs for the boot loaders of Raspberry Pi's chips, as files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace zstrip::boards {

using Bytes = std::vector<unsigned char>;

/// The flash of a program from its beginning, as binutils see it. `tools`: their prefix.
Bytes flash_image(const std::string& program_name, const std::string& tools = "arm-none-eabi");

/// How many bytes a variable of a program takes, by its mangled name; 0 if there is none.
std::uint32_t variable_bytes(const std::string& program_name, const std::string& variable);

/// Four bytes, the lowest first.
std::uint32_t word(const Bytes& bytes, std::size_t at);

/// What is wrong with a program's .uf2 file for a chip of this family, by its format and by the flash; empty: nothing.
std::string uf2_complaint(const Bytes& uf2, Bytes flash, std::uint32_t family);

/// The bytes of whole pages by their addresses, of a file that is in order.
std::map<std::uint32_t, Bytes> uf2_pages(const Bytes& uf2);

/// A file; empty where there is none.
Bytes file_contents(const std::filesystem::path& file);

/// The program's .uf2 file; empty where the cross build had no compiler for this machine.
Bytes uf2_file(const std::string& program_name);

}  // namespace zstrip::boards
