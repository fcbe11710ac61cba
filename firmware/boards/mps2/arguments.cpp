// Reads the words of the benchmark's command line.
#include "mps2/arguments.hpp"

#include <cstddef>

namespace zstrip::bench {
namespace {

using namespace std::literals;  // literals that know their length: otherwise unoptimised code would call strlen

/// Removes the part of `text` before `separator`, or all of it, and returns it.
std::string_view take(std::string_view& text, char separator) {
  std::size_t end = 0;  // a loop, because find() would need a C library
  while (end < text.size() && text[end] != separator) ++end;
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == text.size() ? end : end + 1);
  return part;
}

/// Reads decimal digits. Returns false if there are none or the value does not fit.
template <class Number>
bool read_number(std::string_view digits, Number& number) {
  if (digits.empty() || digits.size() > 10) return false;
  std::uint64_t value = 0;
  for (const char digit : digits) {
    if (digit < '0' || digit > '9') return false;
    value = 10 * value + static_cast<std::uint64_t>(digit - '0');
  }
  number = static_cast<Number>(value);
  return number == value;
}

bool read_word(std::string_view word, Arguments& arguments) {
  std::string_view value = word;
  const std::string_view key = take(value, '=');
  if (key == "workload"sv) {
    arguments.workload = value;
    return true;
  }
  if (key == "depth"sv) {
    arguments.depth = value;
    return true;
  }
  if (key == "format"sv) {
    arguments.format = value;
    return value == "rgb565"sv || value == "gray4"sv || value == "mono"sv;
  }
  if (key == "size"sv) {
    const std::string_view width = take(value, 'x');
    return read_number(width, arguments.width) && read_number(value, arguments.height);
  }
  if (key == "rows"sv) return read_number(value, arguments.rows);
  if (key == "columns"sv) return read_number(value, arguments.columns);
  if (key == "frames"sv) return read_number(value, arguments.frames) && arguments.frames > 0;
  if (key == "first"sv) return read_number(value, arguments.first);
  if (key == "buffers"sv) return read_number(value, arguments.buffers) && arguments.buffers <= 2;
  if (key == "order"sv) {
    arguments.in_turns = value == "turns"sv;
    return arguments.in_turns || value == "down"sv;
  }
  if (key == "ram"sv) return read_number(value, arguments.ram);
  return false;
}

}  // namespace

Arguments parse_arguments(std::string_view text) {
  Arguments arguments;
  while (!text.empty()) {
    const std::string_view word = take(text, ' ');
    if (!word.empty() && !read_word(word, arguments)) {
      arguments.wrong_word = word;
      break;
    }
  }
  return arguments;
}

}  // namespace zstrip::bench
