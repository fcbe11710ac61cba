// docs/measured/memory.csv: a row for each program for a board and each scene that it draws.
#pragma once

#include <filesystem>
#include <string>

#include "measured/table.hpp"
#include "usage.hpp"

namespace zstrip::budget {

/// Without rows and notes.
measured::Table memory_format();

/// What a program takes.
measured::Row row_of(const Usage& usage);

/// What the figures hold for: the compiler of this build's programs, by name and version, and how it optimises.
std::string compiler_note(const std::string& options = "-O2");

/// Lines with the largest functions and tables of a program, to see what has grown.
std::string largest_symbols(const std::filesystem::path& program);

/// The table for readers: docs/measured/memory.md.
std::string memory_page(const measured::Table& table);

}  // namespace zstrip::budget
