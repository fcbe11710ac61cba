// Shortens names as the demangler writes them.
#include "reader_name.hpp"

#include <cctype>
#include <string_view>

#include "elf_file.hpp"

namespace zstrip::budget {
namespace {

bool ends_a_name(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_' || character == '>' ||
         character == '}';
}

void erase_all(std::string& text, std::string_view part) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;) text.erase(at, part.size());
}

/// Behind the parenthesis that closes the one at `open`.
std::size_t closed(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (depth == 0) return at + 1;
  }
  return text.size();
}

/// At any depth; what is in parentheses at the beginning of an expression is a cast and stays.
std::string without_parameters(const std::string& name) {
  std::string result;
  for (std::size_t at = 0; at < name.size();) {
    const bool behind_a_name = !result.empty() && (ends_a_name(result.back()) || result.ends_with("operator()"));
    if (name.compare(at, 2, "()") == 0 && result.ends_with("operator")) {
      result += "()";
      at += 2;
    } else if (name[at] == '(' && behind_a_name) {
      at = closed(name, at);
      if (name.compare(at, 6, " const") == 0) at += 6;
    } else {
      result += name[at++];
    }
  }
  return result;
}

std::string without_return_type(const std::string& name) {
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const char character = name[at];
    if (character == '<' || character == '(' || character == '{') ++depth;
    if (character == '>' || character == ')' || character == '}') --depth;
    if (character == ' ' && depth == 0) begin = at + 1;
  }
  return name.substr(begin);
}

void erase_effects(std::string& name) {
  constexpr std::string_view kBegin = "Effects{";
  for (std::size_t at = 0; (at = name.find(kBegin, at)) != std::string::npos;) {
    if (at > 0 && ends_a_name(name[at - 1])) {  // another type, whose name ends like this
      at += kBegin.size();
      continue;
    }
    std::size_t end = name.find('}', at);
    end = end == std::string::npos ? name.size() : end + 1;
    if (name.compare(end, 2, ", ") == 0)
      end += 2;
    else if (at >= 2 && name.compare(at - 2, 2, ", ") == 0)
      at -= 2;
    name.erase(at, end - at);
  }
  erase_all(name, "<>");
}

/// Of a name that the demangler does not understand: the first word that is not a namespace, and in brackets what loops
/// of pixels are named there.
std::string words_of(const std::string& mangled) {
  std::string name, loops;
  for (std::size_t at = 0; at < mangled.size();) {
    std::size_t length = 0;
    while (at < mangled.size() && std::isdigit(static_cast<unsigned char>(mangled[at])) != 0) {
      length = 10 * length + static_cast<std::size_t>(mangled[at++] - '0');
    }
    if (length < 2 || length > mangled.size() - at) {
      if (length == 0) ++at;
      continue;
    }
    const std::string word = mangled.substr(at, length);
    at += length;
    if (word == "zstrip" || word == "detail" || word.starts_with("_GLOBAL_")) continue;
    if (name.empty()) {
      name = word;
    } else if (word.starts_with("draw_") || word.starts_with("fill_")) {
      loops += loops.empty() ? "<" : ", ";
      loops += word;
    }
  }
  if (!loops.empty()) loops += ">";
  return name + loops;
}

}  // namespace

std::string reader_name(const std::string& symbol) {
  std::string name = demangled(symbol);
  if (name.starts_with("_Z")) return words_of(name);
  for (const std::string_view whole : {"zstrip::detail::", "zstrip::", "(anonymous namespace)::"}) {
    erase_all(name, whole);
  }
  name = name.substr(0, name.find(" [clone"));
  name = without_return_type(without_parameters(name));
  erase_effects(name);
  return name;
}

std::string without_arguments(const std::string& reader_name) {
  std::string result;
  int depth = 0;
  for (const char character : reader_name) {
    if (character == '<') ++depth;
    if (depth == 0) result += character;
    if (character == '>') --depth;
  }
  return result;
}

}  // namespace zstrip::budget
