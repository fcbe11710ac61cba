// Numbers for people: digits in groups of three.
#include "text/number.hpp"

namespace zstrip::sim {

std::string grouped(std::uint64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string counted(std::uint64_t value, std::string_view thing) {
  std::string text = grouped(value) + ' ';
  text += thing;
  if (value != 1) text += thing.ends_with("sh") ? "es" : "s";
  return text;
}

}  // namespace zstrip::sim
