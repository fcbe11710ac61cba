// Understands the few instructions of GCC's Thumb code that move the stack pointer or leave a function.
#include "thumb_function.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <optional>
#include <regex>
#include <stdexcept>

namespace zstrip::budget {
namespace {

[[noreturn]] void fail(const ThumbFunction& function, const Instruction& at, const std::string& what) {
  throw std::runtime_error(demangled(function.name) + ": " + what + ": " + at.mnemonic + " " + at.operands);
}

template <class Integer>
std::optional<Integer> number(std::string_view text, int base) {
  Integer value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end == text.data()) return std::nullopt;
  return value;
}

/// The number behind the last '#'.
std::optional<std::int32_t> immediate(const std::string& operands) {
  const std::size_t mark = operands.rfind('#');
  if (mark == std::string::npos) return std::nullopt;
  return number<std::int32_t>(std::string_view(operands).substr(mark + 1), 10);
}

/// Registers in "{r4, r5, lr}"; objdump writes no ranges in it.
std::uint32_t register_count(const std::string& operands) {
  const std::size_t open = operands.find('{');
  const auto begin = operands.begin() + static_cast<std::ptrdiff_t>(open == std::string::npos ? 0 : open);
  return 1 + static_cast<std::uint32_t>(std::count(begin, operands.end(), ','));
}

std::uint32_t word_at(const ElfFile& program, std::uint32_t address) {
  for (const Section& section : program.sections) {
    if (address < section.address || address - section.address + std::uint64_t{4} > section.bytes.size()) continue;
    std::uint32_t word = 0;
    std::memcpy(&word, section.bytes.data() + (address - section.address), sizeof word);
    return word;
  }
  throw std::runtime_error("no word at address " + std::to_string(address));
}

/// What an instruction `add sp, rN` adds: the register's latest value, if that is a literal or a small constant.
std::int32_t added_register(const ThumbFunction& function, std::size_t at, const ElfFile& program) {
  const Instruction& instruction = function.instructions[at];
  const std::string name = instruction.operands.substr(instruction.operands.rfind('r'));
  for (std::size_t i = at; i-- > 0;) {
    const Instruction& before = function.instructions[i];
    if (!before.operands.starts_with(name + ",")) continue;
    if (before.mnemonic == "ldr" && before.operands.starts_with(name + ", [pc,")) {
      // Of Thumb: pc is the instruction's address and 4, rounded down to a multiple of 4.
      const auto offset = immediate(before.operands);
      if (!offset) break;
      return static_cast<std::int32_t>(
          word_at(program, ((before.address + 4U) & ~3U) + static_cast<std::uint32_t>(*offset)));
    }
    if (before.mnemonic == "lsls") continue;                                // of the constant before it
    if (before.mnemonic == "movs" && immediate(before.operands)) return 0;  // constants of movs are positive
    break;
  }
  fail(function, instruction, "the stack pointer changes by an unknown amount");
}

/// Bytes by which an instruction lowers the stack pointer; 0 if it does not, or raises it.
std::uint32_t lowers_by(const ThumbFunction& function, std::size_t at, const ElfFile& program) {
  const auto& [address, mnemonic, operands] = function.instructions[at];
  if (mnemonic == "push") return 4 * register_count(operands);
  if (mnemonic == "stmdb" && operands.starts_with("sp!")) return 4 * register_count(operands);
  if (mnemonic == "vpush") {
    static const std::regex doubles("\\{d");
    return (std::regex_search(operands, doubles) ? 8U : 4U) * 32U;  // of any range: at most all
  }
  static const std::regex written("^sp(,|$)"), stored_before("\\[sp, #-[0-9]+\\]!");
  if (std::regex_search(operands, stored_before)) {
    const std::size_t mark = operands.find("#-");
    return number<std::uint32_t>(std::string_view(operands).substr(mark + 2), 10).value_or(0);
  }
  if (!std::regex_search(operands, written)) return 0;
  if (mnemonic == "cmp" || mnemonic.starts_with("str")) return 0;
  if (mnemonic == "sub" || mnemonic == "subw") {
    const auto bytes = immediate(operands);
    if (!bytes || *bytes < 0) fail(function, function.instructions[at], "the frame has no fixed size");
    return static_cast<std::uint32_t>(*bytes);
  }
  if (mnemonic == "add" || mnemonic == "addw") {
    if (immediate(operands)) return 0;
    const std::int32_t added = added_register(function, at, program);
    return added < 0 ? static_cast<std::uint32_t>(-added) : 0;
  }
  fail(function, function.instructions[at], "the stack pointer changes in an unknown way");
}

bool is_branch(const std::string& mnemonic) {
  static const std::regex branch("b(l|lx)?(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?|cbn?z");
  return std::regex_match(mnemonic, branch);
}

/// Not blt, ble and bls, which are conditions of b.
bool is_call(const std::string& mnemonic) {
  return mnemonic == "bl" || mnemonic == "blx" || (mnemonic.size() == 4 && mnemonic.starts_with("bl"));
}

/// Whether `bx rN` only returns to where a pop has just found in rN.
bool is_return(const ThumbFunction& function, std::size_t at) {
  const std::string& name = function.instructions[at].operands;
  if (name == "lr") return true;
  for (std::size_t i = at; i > 0 && at - i < 3; --i) {
    const Instruction& before = function.instructions[i - 1];
    if (before.mnemonic == "pop") return before.operands == "{" + name + "}";
  }
  return false;
}

}  // namespace

std::vector<ThumbFunction> parse_disassembly(std::string_view text) {
  std::vector<ThumbFunction> functions;
  static const std::regex header("^([0-9a-f]{8}) <(.*)>:$");
  static const std::regex instruction("^ *([0-9a-f]+):\t([^\t]+)\t?([^\t]*).*$");
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line(text.substr(begin, end - begin));
    begin = end + 1;
    std::smatch match;
    if (std::regex_match(line, match, header)) {
      functions.push_back({match[2], number<std::uint32_t>(match[1].str(), 16).value_or(0)});
    } else if (!functions.empty() && std::regex_match(line, match, instruction)) {
      std::string mnemonic = match[2], operands = match[3];
      mnemonic = mnemonic.substr(0, mnemonic.find_first_of(". "));
      operands = operands.substr(0, operands.find(" @"));
      while (operands.ends_with(' ')) operands.pop_back();
      functions.back().instructions.push_back(
          {number<std::uint32_t>(match[1].str(), 16).value_or(0), std::move(mnemonic), std::move(operands)});
    }
  }
  return functions;
}

std::uint32_t stack_frame(const ThumbFunction& function, const ElfFile& program) {
  std::uint32_t frame = 0;
  for (std::size_t at = 0; at < function.instructions.size(); ++at) frame += lowers_by(function, at, program);
  return frame;
}

Targets targets_of(const ThumbFunction& function) {
  Targets targets;
  const std::uint32_t last = function.instructions.empty() ? function.address : function.instructions.back().address;
  for (std::size_t at = 0; at < function.instructions.size(); ++at) {
    const auto& [address, mnemonic, operands] = function.instructions[at];
    if (!is_branch(mnemonic) && mnemonic != "bx") continue;
    const std::size_t comma = operands.rfind(", ");
    const std::string target = comma == std::string::npos ? operands : operands.substr(comma + 2);
    const auto to = number<std::uint32_t>(target, 16);
    if (mnemonic == "bx" || (mnemonic == "blx" && target.find('<') == std::string::npos)) {
      if (mnemonic == "blx" || !is_return(function, at)) targets.through_pointer = true;
    } else if (!to) {
      fail(function, function.instructions[at], "a branch to nowhere");
    } else if (*to < function.address || *to > last || (*to == function.address && is_call(mnemonic))) {
      targets.addresses.push_back(*to);
    }
  }
  return targets;
}

}  // namespace zstrip::budget
