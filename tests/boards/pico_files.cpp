// Reads what the cross build has made, with a decoder of .uf2 files of its own.
#include "pico_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "programs.hpp"

namespace zstrip::boards {

Bytes file_contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

Bytes flash_image(const std::string& program_name, const std::string& tools) {
  const std::filesystem::path image =
      std::filesystem::path(testing::TempDir()) / (program_name + "-" + std::to_string(::getpid()));
  const std::string command =
      tools + "-objcopy -O binary '" + program(program_name).string() + "' '" + image.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  Bytes bytes = file_contents(image);
  std::filesystem::remove(image);
  return bytes;
}

std::uint32_t variable_bytes(const std::string& program_name, const std::string& variable) {
  const std::filesystem::path list =
      std::filesystem::path(testing::TempDir()) / (program_name + "-" + std::to_string(::getpid()) + ".symbols");
  const std::string command = "arm-none-eabi-nm -S '" + program(program_name).string() + "' > '" + list.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::uint32_t found = 0;
  std::ifstream stream(list);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name, kind;
    std::uint32_t address = 0, bytes = 0;
    if (words >> std::hex >> address >> bytes >> kind >> name && name == variable) found = bytes;
  }
  std::filesystem::remove(list);
  return found;
}

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes.at(at) | bytes.at(at + 1) << 8 | bytes.at(at + 2) << 16) |
         static_cast<std::uint32_t>(bytes.at(at + 3)) << 24;
}

std::string uf2_complaint(const Bytes& uf2, Bytes flash, std::uint32_t family) {
  constexpr std::size_t kBlock = 512, kPage = 256, kHeader = 32;
  flash.resize((flash.size() + kPage - 1) / kPage * kPage);
  const std::size_t blocks = flash.size() / kPage;
  if (uf2.size() != blocks * kBlock) return "size " + std::to_string(uf2.size());
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t at = kBlock * block;
    const std::uint32_t expected[] = {0x0A324655,
                                      0x9E5D5157,
                                      0x2000,
                                      static_cast<std::uint32_t>(0x10000000 + kPage * block),
                                      kPage,
                                      static_cast<std::uint32_t>(block),
                                      static_cast<std::uint32_t>(blocks),
                                      family};
    for (std::size_t i = 0; i < std::size(expected); ++i) {
      if (word(uf2, at + 4 * i) != expected[i]) {
        return "block " + std::to_string(block) + ", word " + std::to_string(i) + " of the header";
      }
    }
    if (word(uf2, at + kBlock - 4) != 0x0AB16F30) return "block " + std::to_string(block) + ", its end";
    const auto begin = uf2.begin() + static_cast<std::ptrdiff_t>(at + kHeader);
    if (!std::equal(begin, begin + kPage, flash.begin() + static_cast<std::ptrdiff_t>(kPage * block))) {
      return "block " + std::to_string(block) + ", its bytes";
    }
  }
  return "";
}

std::map<std::uint32_t, Bytes> uf2_pages(const Bytes& uf2) {
  std::map<std::uint32_t, Bytes> pages;
  for (std::size_t at = 0; at + 512 <= uf2.size(); at += 512) {
    const auto begin = uf2.begin() + static_cast<std::ptrdiff_t>(at + 32);
    pages[word(uf2, at + 12)] = Bytes(begin, begin + 256);
  }
  return pages;
}

Bytes uf2_file(const std::string& program_name) {
  return file_contents(program(program_name).replace_extension(".uf2"));
}

}  // namespace zstrip::boards
