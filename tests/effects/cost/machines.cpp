// Runs programs in the emulator and under valgrind.
#include "machines.hpp"

#include <array>
#include <cctype>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "elf_file.hpp"
#include "qemu.hpp"

namespace zstrip::effects_cost {
namespace {

std::uint64_t counted(const std::string& environment, const std::filesystem::path& program) {
  const std::string command = environment +
                              " valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null '" +
                              program.string() + "' 2>&1 >/dev/null";
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
  const int status = pclose(pipe);
  constexpr std::string_view kHeading = "refs:";
  std::size_t at = text.find(kHeading);
  if (status != 0 || at == std::string::npos) throw std::runtime_error("failed: " + command + "\n" + text);
  std::uint64_t result = 0;
  for (at += kHeading.size(); at < text.size() && text[at] != '\n'; ++at) {
    if (std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
      result = 10 * result + static_cast<std::uint64_t>(text[at] - '0');
    }
  }
  return result;
}

}  // namespace

std::string name_of(Effects effects) {
  std::ostringstream name;
  name << std::hex << effects.bits << '_' << effects.methods;
  return name.str();
}

std::string printed_on(const std::string& machine, const std::filesystem::path& program, const std::string& word) {
  boards::Qemu emulator({.machine = machine == "m4f" ? "mps2-an386" : "mps2-an385",
                         .program = program,
                         .words = {word},
                         .count_instructions = true});
  const auto [output, status] = emulator.finish(boards::Qemu::Duration(120'000));
  if (status != 0) throw std::runtime_error(program.string() + " draws nothing: " + output);
  return output;
}

std::uint64_t instructions_here(const std::filesystem::path& program, const std::string& drawing) {
  const std::string chosen = "COST_DRAWING=" + drawing;
  return (counted(chosen + " COST_THRICE=1", program) - counted(chosen, program)) / 2;
}

std::uint32_t flash_of(const std::filesystem::path& program) {
  std::uint32_t bytes = 0;
  for (const budget::Section& section : budget::read_elf(program).sections) {
    bytes += static_cast<std::uint32_t>(section.bytes.size());
  }
  return bytes;
}

}  // namespace zstrip::effects_cost
