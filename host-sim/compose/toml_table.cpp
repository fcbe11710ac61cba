// A table of a .toml file, read with checks.
#include "compose/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compose/retired.hpp"
#include "text/colour.hpp"
#include "text/edit_distance.hpp"

namespace zstrip::sim {
namespace {

int line_of_node(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Names of a hostile file may be as long as the file.
std::string shortened(const std::string& name) {
  constexpr std::size_t kMax = 80;
  if (name.size() <= kMax) return name;
  std::size_t end = kMax;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // not within a character of UTF-8
  return name.substr(0, end) + "...";
}

std::string shown(double value) { return fmt::format("{:g}", value); }

}  // namespace

Failure at_line(const std::filesystem::path& path, int line, const std::string& message) {
  return {ExitStatus::input, fmt::format("'{}' line {}: {}", path.string(), line, message)};
}

std::string origin_of(const std::filesystem::path& path, int line) {
  return fmt::format("{} line {}", path.filename().string(), line);
}

std::string nearest(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::size_t kMax = 64;  // keys of a hostile file may be as long as the file
  if (name.size() > kMax) return {};
  std::string best;
  std::size_t least = std::max<std::size_t>(2, name.size() / 2) + 1;
  for (const std::string& candidate : names) {
    if (candidate.size() > kMax) continue;
    const std::size_t changes = edit_distance(name, candidate);
    if (changes < least) least = changes, best = candidate;
  }
  return best;
}

int TomlTable::line() const { return std::max(1, line_of_node(table_)); }

int TomlTable::line_of(std::string_view key) const {
  for (const auto& [name, value] : table_) {
    if (name == key) return static_cast<int>(name.source().begin.line);
  }
  return line();
}

const toml::node* TomlTable::find(const char* key) {
  if (std::ranges::find(read_, key) == read_.end()) read_.emplace_back(key);
  return table_.get(key);
}

std::optional<double> TomlTable::number(const char* key, const toml::node& node, const Limits& limits) {
  std::optional<double> value;
  if (const auto* const floating = node.as_floating_point()) value = floating->get();
  if (const auto* const whole = node.as_integer()) value = static_cast<double>(whole->get());
  if (value && *value >= limits.low && *value <= limits.high) return value;
  wrong(key, fmt::format("'{}' must be a number from {} to {}", key, shown(limits.low), shown(limits.high)));
  return std::nullopt;
}

std::optional<double> TomlTable::number(const char* key, const Limits& limits) {
  const toml::node* const node = find(key);
  return node == nullptr ? std::nullopt : number(key, *node, limits);
}

std::optional<std::int64_t> TomlTable::integer(const char* key, std::int64_t low, std::int64_t high) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto* const whole = node->as_integer();
  if (whole != nullptr && whole->get() >= low && whole->get() <= high) return whole->get();
  wrong(key, fmt::format("'{}' must be a whole number from {} to {}", key, low, high));
  return std::nullopt;
}

std::optional<bool> TomlTable::flag(const char* key) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* const given = node->as_boolean()) return given->get();
  wrong(key, fmt::format("'{}' must be true or false", key));
  return std::nullopt;
}

std::optional<std::string> TomlTable::text(const char* key) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto* const given = node->as_string();
  // The system and the core would take a zero for the end of the text.
  const bool has_zero = given != nullptr && given->get().find('\0') != std::string::npos;
  if (given != nullptr && !given->get().empty() && !has_zero) return given->get();
  wrong(key, fmt::format("'{}' must {}", key,
                         has_zero           ? "not have U+0000"
                         : given != nullptr ? "not be empty"
                                            : "be a text in quotes"));
  return std::nullopt;
}

std::string TomlTable::needed_text(const char* key, const char* missing) {
  if (!has(key)) {
    std::string message = missing;
    for (const auto& [name, value] : table_) {
      const std::string other(name.str());
      if (!nearest(other, {key}).empty()) message = fmt::format("'{}' is missing, but there is '{}'", key, other);
    }
    wrong(key, message);
  }
  return text(key).value_or("");
}

std::optional<std::vector<double>> TomlTable::numbers(const char* key, std::size_t count, const Limits& limits) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* const array = node->as_array();
  if (array == nullptr || array->size() != count) {
    wrong(key, fmt::format("'{}' must be {} numbers in brackets", key, count));
    return std::nullopt;
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    const std::optional<double> value = number(key, element, limits);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::vector<std::vector<double>> TomlTable::rows(const char* key, std::size_t count, const Limits& limits) {
  const toml::node* const node = find(key);
  std::vector<std::vector<double>> rows;
  if (node == nullptr) return rows;
  const auto add = [&](const toml::node& element) {
    const toml::array* const array = element.as_array();
    if (array == nullptr || array->size() != count) return false;
    std::vector<double>& row = rows.emplace_back();
    for (const toml::node& each : *array) {
      const std::optional<double> value = number(key, each, limits);
      if (!value) return true;  // has been said
      row.push_back(*value);
    }
    return true;
  };
  const toml::array* const array = node->as_array();
  bool holds = array != nullptr && !array->empty();
  for (std::size_t i = 0; holds && i < array->size(); ++i) holds = add(*array->get(i));
  if (!holds) wrong(key, fmt::format("'{}' must be a list of lists of {} numbers", key, count));
  for (const std::vector<double>& row : rows) holds = holds && row.size() == count;
  if (!holds) rows.clear();
  return rows;
}

std::optional<Vector> TomlTable::vector(const char* key, const Limits& limits) {
  const auto values = numbers(key, 3, limits);
  if (!values) return std::nullopt;
  return Vector{(*values)[0], (*values)[1], (*values)[2]};
}

std::optional<Vector> TomlTable::number_or_vector(const char* key, const Limits& limits) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_array()) return vector(key, limits);
  const std::optional<double> one = number(key, *node, limits);
  if (!one) return std::nullopt;
  return Vector{*one, *one, *one};
}

std::optional<Colour> TomlTable::colour(const char* key) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* const given = node->as_string()) {
    const std::string& text = given->get();
    const auto parsed = text.starts_with('#') ? parse_colour(std::string_view(text).substr(1)) : std::nullopt;
    if (parsed) return parsed;
  } else if (const toml::array* const array = node->as_array(); array != nullptr && array->size() == 3) {
    std::vector<std::uint8_t> channels;
    for (const toml::node& element : *array) {
      const auto* const channel = element.as_integer();
      if (channel != nullptr && channel->get() >= 0 && channel->get() <= 255) {
        channels.push_back(static_cast<std::uint8_t>(channel->get()));
      }
    }
    if (channels.size() == 3) return Colour{channels[0], channels[1], channels[2], 255};
  }
  wrong(key, fmt::format("'{}' must be a colour: [red, green, blue], each 0 to 255, or \"#rrggbb\"", key));
  return std::nullopt;
}

std::optional<TomlTable> TomlTable::table(const char* key, const std::string& title) {
  const toml::node* const node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const toml::table* const found = node->as_table()) return TomlTable(*found, title, errors_);
  wrong(key, fmt::format("'{}' must be a table, {}", key, title));
  return std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(const char* key, const std::string& title) {
  std::vector<TomlTable> found;
  const toml::node* const node = find(key);
  if (node == nullptr) return found;
  if (const toml::array* const array = node->as_array()) {
    for (const toml::node& element : *array) {
      if (const toml::table* const each = element.as_table()) found.emplace_back(*each, title, errors_);
    }
    if (found.size() == array->size()) return found;
  }
  wrong(key, fmt::format("'{}' must be tables, each with a heading {}", key, title));
  return {};
}

std::vector<std::pair<std::string, std::string>> TomlTable::texts(const char* key) {
  std::vector<std::pair<std::string, std::string>> found;
  const toml::node* const node = find(key);
  if (node == nullptr) return found;
  if (const toml::table* const pairs = node->as_table()) {
    for (const auto& [name, value] : *pairs) {
      if (const auto* const given = value.as_string()) found.emplace_back(std::string(name.str()), given->get());
    }
    if (found.size() == pairs->size()) return found;
  }
  wrong(key, fmt::format("'{}' must be a table of texts, {{ \"name\" = \"name\" }}", key));
  return {};
}

std::vector<std::string> TomlTable::list(const char* key, std::string_view words) {
  std::vector<std::string> found;
  const toml::node* const node = find(key);
  if (node == nullptr) return found;
  if (const toml::array* const array = node->as_array(); array != nullptr && !array->empty()) {
    for (const toml::node& element : *array) {
      if (const auto* const given = element.as_string()) found.push_back(given->get());
    }
    if (found.size() == array->size()) return found;
  }
  wrong(key, fmt::format("'{}' must be a list, [\"word\", \"word\"], of {}", key, words));
  return {};
}

void TomlTable::wrong_name(const char* key, const std::string& given, const char* what,
                           const std::vector<std::string>& names) {
  const std::string near = nearest(given, names);
  const std::string_view instead = instead_of(given);
  wrong(key, fmt::format("'{}' names no {} '{}'; {}", key, what, shortened(given),
                         !instead.empty() ? fmt::format("it is gone, {}", instead)
                         : !near.empty()  ? fmt::format("did you mean '{}'?", near)
                         : names.empty()  ? std::string("there is none")
                                          : "there are " + listed(names)));
}

void TomlTable::finish() {
  for (const auto& [name, value] : table_) {
    const std::string key(name.str());
    if (std::ranges::find(read_, key) != read_.end()) continue;
    const std::string near = nearest(key, read_);
    errors_.add(static_cast<int>(name.source().begin.line),
                fmt::format("{} has no key '{}'; {}", title_, shortened(key),
                            near.empty() ? "it may have " + listed(read_) : fmt::format("did you mean '{}'?", near)));
  }
}

}  // namespace zstrip::sim
