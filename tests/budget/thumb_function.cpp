// Understands the few instructions of GCC's Thumb code that move the stack pointer or leave a function.
#include "thumb_function.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <initializer_list>
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

std::string last_operand(const std::string& operands) {
  const std::size_t comma = operands.rfind(", ");
  return comma == std::string::npos ? operands : operands.substr(comma + 2);
}

/// The number behind the last '#'.
std::optional<std::int32_t> immediate(const std::string& operands) {
  const std::size_t mark = operands.rfind('#');
  if (mark == std::string::npos) return std::nullopt;
  return number<std::int32_t>(std::string_view(operands).substr(mark + 1), 10);
}

/// Bytes of the registers in "{r4, r5, lr}", "{d8}" or "{s16-s19}"; only those of the FPU have ranges.
std::uint32_t register_bytes(const ThumbFunction& function, const Instruction& instruction) {
  static const std::regex list("[^{]*\\{([a-z][a-z0-9, ]*)\\}");
  static const std::regex fpu_list("\\{([ds])([0-9]+)(?:-[ds]([0-9]+))?\\}");
  std::smatch match;
  if (std::regex_match(instruction.operands, match, fpu_list)) {
    const auto first = number<std::uint32_t>(match[2].str(), 10).value_or(0);
    const auto last = match[3].matched ? number<std::uint32_t>(match[3].str(), 10).value_or(0) : first;
    return (last - first + 1) * (match[1] == "d" ? 8U : 4U);
  }
  if (!std::regex_match(instruction.operands, match, list)) fail(function, instruction, "no list of registers");
  const std::string names = match[1];
  return 4 * (1 + static_cast<std::uint32_t>(std::count(names.begin(), names.end(), ',')));
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
  const std::string name = last_operand(instruction.operands);
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
    if (before.mnemonic == "lsls" && before.operands.starts_with(name + ", " + name + ", #")) continue;
    if (before.mnemonic == "movs" && immediate(before.operands)) return 0;  // such constants are positive
    break;
  }
  fail(function, instruction, "the stack pointer changes by an unknown amount");
}

/// Bytes by which an instruction lowers the stack pointer; 0 if it does not, or raises it.
std::uint32_t lowers_by(const ThumbFunction& function, std::size_t at, const ElfFile& program) {
  const auto& [address, mnemonic, operands] = function.instructions[at];
  if (mnemonic.starts_with("push") || mnemonic.starts_with("vpush") ||
      (mnemonic.starts_with("stmdb") && operands.starts_with("sp!"))) {
    return register_bytes(function, function.instructions[at]);
  }
  if (mnemonic.starts_with("msr") && !operands.starts_with("MSPLIM,")) {
    fail(function, function.instructions[at], "the stack pointer may change in an unknown way");
  }
  if (operands.find("[sp, #-") != std::string::npos && operands.find("]!") != std::string::npos) {
    const std::size_t mark = operands.find("#-");
    return number<std::uint32_t>(std::string_view(operands).substr(mark + 2), 10).value_or(0);
  }
  if (operands != "sp" && !operands.starts_with("sp,")) return 0;
  if (mnemonic.starts_with("cmp") || mnemonic.starts_with("st") || mnemonic.starts_with("ldm")) return 0;
  if (mnemonic.starts_with("sub")) {
    const auto bytes = immediate(operands);
    if (!bytes || *bytes < 0) fail(function, function.instructions[at], "the frame has no fixed size");
    return static_cast<std::uint32_t>(*bytes);
  }
  if (mnemonic.starts_with("add")) {
    if (immediate(operands)) return 0;
    const std::int32_t added = added_register(function, at, program);
    return added < 0 ? static_cast<std::uint32_t>(-added) : 0;
  }
  fail(function, function.instructions[at], "the stack pointer changes in an unknown way");
}

bool is_branch(std::string_view mnemonic) {
  if (mnemonic == "cbz" || mnemonic == "cbnz") return true;
  constexpr std::string_view kConditions[] = {"",   "eq", "ne", "cs", "cc", "mi", "pl", "vs",
                                              "vc", "hi", "ls", "ge", "lt", "gt", "le"};
  return std::ranges::any_of(std::initializer_list<std::string_view>{"b", "bl", "blx"}, [&](std::string_view branch) {
    return mnemonic.starts_with(branch) && std::ranges::count(kConditions, mnemonic.substr(branch.size())) != 0;
  });
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
    if (before.mnemonic == "pop" && before.operands.ends_with("pc}")) break;
    if (before.mnemonic == "pop") return before.operands == "{" + name + "}";
  }
  // A routine inside of a function in assembly: it has moved lr to a register that it does not write otherwise.
  for (std::size_t i = at; i > 0; --i) {
    const Instruction& before = function.instructions[i - 1];
    if (before.operands.starts_with(name + ", ")) return before.mnemonic == "mov" && before.operands == name + ", lr";
  }
  return false;
}

/// A jump to an address that stands beside it: what linkers insert where a branch does not reach.
bool is_veneer(const std::string& mnemonic, const std::string& operands) {
  return mnemonic == "ldr" && operands.starts_with("pc, [pc");
}

/// Whether its last instruction goes on to what stands behind it, as in assembler with several entries. A call at the
/// end does not return.
bool falls_through(const ThumbFunction& function) {
  for (std::size_t at = function.instructions.size(); at-- > 0;) {
    const auto& [address, mnemonic, operands] = function.instructions[at];
    // Data, and what aligns it: also zeros, which read as an instruction.
    if (mnemonic.empty() || mnemonic == "nop" || (mnemonic == "movs" && operands == "r0, r0")) continue;
    if (mnemonic == "b" || mnemonic == "bx" || mnemonic == "udf" || is_call(mnemonic)) return false;
    const bool loads_pc = operands.starts_with("pc, ") || operands.ends_with("pc}");
    return !loads_pc;
  }
  return false;
}

/// "00000100 <name>:"
std::optional<ThumbFunction> parse_header(std::string_view line) {
  constexpr std::size_t kDigits = 8;
  if (line.size() < kDigits + 4 || line.substr(kDigits, 2) != " <" || !line.ends_with(">:")) return std::nullopt;
  const auto address = number<std::uint32_t>(line.substr(0, kDigits), 16);
  if (!address) return std::nullopt;
  return ThumbFunction{std::string(line.substr(kDigits + 2, line.size() - kDigits - 4)), *address};
}

/// "     100:<tab>push<tab>{r4, lr}"; objdump appends comments to operands, widths to mnemonics.
std::optional<Instruction> parse_instruction(std::string_view line) {
  const std::size_t first = line.find_first_not_of(' '), colon = line.find(":\t");
  if (first == std::string_view::npos || colon == std::string_view::npos) return std::nullopt;
  const auto address = number<std::uint32_t>(line.substr(first, colon - first), 16);
  if (!address || line.find_first_not_of("0123456789abcdef", first) != colon) return std::nullopt;
  const std::string_view rest = line.substr(colon + 2);
  const std::size_t tab = std::min(rest.find('\t'), rest.size());
  std::string_view mnemonic = rest.substr(0, tab), operands = rest.substr(std::min(tab + 1, rest.size()));
  if (mnemonic.empty()) return std::nullopt;
  mnemonic = mnemonic.substr(0, mnemonic.find_first_of(". "));
  operands = operands.substr(0, operands.find('\t'));
  operands = operands.substr(0, operands.find(" @"));
  operands = operands.substr(0, operands.find_last_not_of(' ') + 1);
  return Instruction{*address, std::string(mnemonic), std::string(operands)};
}

}  // namespace

std::vector<ThumbFunction> parse_disassembly(std::string_view text) {
  std::vector<ThumbFunction> functions;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (const auto header = parse_header(line)) {
      functions.push_back(*header);
    } else if (const auto instruction = parse_instruction(line); instruction && !functions.empty()) {
      functions.back().instructions.push_back(*instruction);
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
    const std::string target = last_operand(operands);
    const bool to_register = mnemonic.starts_with("blx") && target.find('<') == std::string::npos;
    if (to_register || (mnemonic.starts_with("bx") && !is_return(function, at)) || is_veneer(mnemonic, operands)) {
      targets.through_pointer = true;
      continue;
    }
    if (!is_branch(mnemonic)) continue;
    const auto to = number<std::uint32_t>(target, 16);
    if (!to) fail(function, function.instructions[at], "a branch to nowhere");
    if (*to < function.address || *to > last || (*to == function.address && is_call(mnemonic))) {
      targets.addresses.push_back(*to);
    }
  }
  targets.next = falls_through(function);
  return targets;
}

}  // namespace zstrip::budget
