// Classes by mnemonic. Conditions are checked explicitly where they look like another mnemonic: BLS is not BL.
#include "bench/instruction_class.hpp"

#include <algorithm>
#include <charconv>

namespace zstrip::sim {
namespace {

using enum InstructionClass;

constexpr std::array<std::string_view, 17> kConditions = {"",   "eq", "ne", "cs", "hs", "cc", "lo", "mi", "pl",
                                                          "vs", "vc", "hi", "ls", "ge", "lt", "gt", "le"};

bool is(std::string_view mnemonic, std::string_view name) {
  return mnemonic.starts_with(name) &&
         std::ranges::find(kConditions, mnemonic.substr(name.size())) != kConditions.end();
}

template <std::size_t count>
bool is_any(std::string_view mnemonic, const std::array<std::string_view, count>& names) {
  return std::ranges::any_of(names, [mnemonic](std::string_view name) { return is(mnemonic, name); });
}

constexpr std::array<std::string_view, 17> kMultiplies = {"mul",    "muls",   "smulbb", "smulbt", "smultb", "smultt",
                                                          "smulwb", "smulwt", "smuad",  "smuadx", "smusd",  "smusdx",
                                                          "smmul",  "smmulr", "smlad",  "smladx", "smlsd"};
constexpr std::array<std::string_view, 12> kAccumulates = {"mla",    "mls",    "smlabb", "smlabt", "smlatb", "smlatt",
                                                           "smlawb", "smlawt", "smmla",  "smmlar", "smmls",  "smmlsr"};
constexpr std::array<std::string_view, 2> kLongMultiplies = {"smull", "umull"};
constexpr std::array<std::string_view, 5> kLongAccumulates = {"smlal", "umlal", "umaal", "smlald", "smlsld"};
constexpr std::array<std::string_view, 2> kDivides = {"sdiv", "udiv"};

/// Counts registers in "{r4, r5, r6-r8}"; QEMU lists each register, but ranges are accepted, too.
std::uint32_t registers_in(std::string_view operands) {
  const std::size_t open = operands.find('{');
  if (open == std::string_view::npos) return 0;
  return static_cast<std::uint32_t>(1 + std::ranges::count(operands.substr(open), ','));
}

ClassifiedInstruction transfer(std::string_view mnemonic, std::string_view operands) {
  const bool list = mnemonic.starts_with("ldm") || mnemonic.starts_with("pop") || mnemonic.starts_with("stm") ||
                    mnemonic.starts_with("push");
  const bool loads = mnemonic.starts_with("ld") || mnemonic.starts_with("pop");
  if (list) {
    const bool pc = loads && operands.find("pc}") != std::string_view::npos;
    return {loads ? load_multiple : store_multiple, registers_in(operands), pc};
  }
  if (mnemonic.starts_with("ldrd") || mnemonic.starts_with("strd")) return {loads ? load_multiple : store_multiple, 2};
  return {loads ? load : store, 1, loads && operands.starts_with("pc,")};
}

/// Returns the number after `begin` in the operands, decimal or hexadecimal; 0 if there is none.
std::uint32_t number_behind(std::string_view operands, std::string_view begin) {
  const std::size_t at = operands.find(begin);
  if (at == std::string_view::npos) return 0;
  std::string_view digits = operands.substr(at + begin.size());
  const bool hexadecimal = digits.starts_with("0x");
  if (hexadecimal) digits.remove_prefix(2);
  std::uint32_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, hexadecimal ? 16 : 10);
  return value;
}

bool is_complex(std::string_view mnemonic, std::string_view operands) {
  for (const std::string_view shift : {", lsr #", ", asr #", ", ror #", ", rrx"}) {
    if (operands.find(shift) != std::string_view::npos) return true;
  }
  if (number_behind(operands, ", lsl #") > 3) return true;
  constexpr std::uint32_t kPlain = 255;
  const bool moves = mnemonic.starts_with("mov") || mnemonic == "addw" || mnemonic == "subw";
  return !moves && number_behind(operands, ", #") > kPlain;
}

}  // namespace

ClassifiedInstruction classify(std::string_view text) {
  const std::size_t space = text.find_first_of(" \t");
  std::string_view mnemonic = text.substr(0, space);
  std::string_view operands = space == std::string_view::npos ? "" : text.substr(space + 1);
  operands.remove_prefix(std::min(operands.find_first_not_of(" \t"), operands.size()));
  mnemonic = mnemonic.substr(0, mnemonic.find('.'));
  if (mnemonic == "cbz" || mnemonic == "cbnz" || is(mnemonic, "b")) return {branch};
  if (mnemonic == "tbb" || mnemonic == "tbh") return {load, 1, true};
  if (is(mnemonic, "bl")) return {call};
  if (is(mnemonic, "bx") || is(mnemonic, "blx")) return {branch_register};
  if (is_any(mnemonic, kDivides)) return {divide};
  if (is_any(mnemonic, kMultiplies)) return {multiply};
  if (is_any(mnemonic, kAccumulates)) return {accumulate};
  if (is_any(mnemonic, kLongMultiplies)) return {long_multiply};
  if (is_any(mnemonic, kLongAccumulates)) return {long_accumulate};
  for (const std::string_view name : {"ldr", "ldm", "pop", "str", "stm", "push"}) {
    if (mnemonic.starts_with(name)) return transfer(mnemonic, operands);
  }
  return {.complex = is_complex(mnemonic, operands)};
}

}  // namespace zstrip::sim
