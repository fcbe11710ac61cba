// A table of a .toml file, read with checks: the keys that are read are those that it may have.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compose/scene_file.hpp"
#include "motion/affine.hpp"
#include "result.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// The errors of a whole file: its name, and the first error in it.
class TomlErrors {
 public:
  explicit TomlErrors(std::filesystem::path path) : path_(std::move(path)) {}
  void add(int line, const std::string& message) {
    if (!first_) first_ = at_line(path_, line, message);
  }
  const std::optional<Failure>& first() const { return first_; }

 private:
  std::filesystem::path path_;
  std::optional<Failure> first_;
};

/// Range of a number, both ends allowed.
struct Limits {
  double low = 0;
  double high = 0;
};

/// After the last key has been read, finish() reports those that were not read. Values that are missing, of the
/// wrong type or out of range come out empty; the latter two are errors.
class TomlTable {
 public:
  /// `title` names the table in messages: "[camera]". Both must outlive this.
  TomlTable(const toml::table& table, std::string title, TomlErrors& errors)
      : table_(table), title_(std::move(title)), errors_(errors) {}

  int line() const;
  /// Returns the line of the key, or the line of the table if the key is missing.
  int line_of(std::string_view key) const;
  bool has(std::string_view key) const { return table_.contains(key); }

  std::optional<double> number(const char* key, const Limits& limits);
  std::optional<std::int64_t> integer(const char* key, std::int64_t low, std::int64_t high);
  std::optional<bool> flag(const char* key);
  std::optional<std::string> text(const char* key);
  /// A text that must be there; empty if it is not, with `missing` as the error.
  std::string needed_text(const char* key, const char* missing);
  /// Three numbers.
  std::optional<Vector> vector(const char* key, const Limits& limits);
  /// Three integers 0..255, or "#rrggbb".
  std::optional<Colour> colour(const char* key);
  /// Exactly `count` numbers.
  std::optional<std::vector<double>> numbers(const char* key, std::size_t count, const Limits& limits);
  /// A list, not empty if it is there, of lists of `count` numbers.
  std::vector<std::vector<double>> rows(const char* key, std::size_t count, const Limits& limits);
  /// One number for all three, or three.
  std::optional<Vector> number_or_vector(const char* key, const Limits& limits);

  /// One of these words.
  template <typename Value, std::size_t count>
  std::optional<Value> choice(const char* key, const std::pair<std::string_view, Value> (&words)[count]) {
    const std::optional<std::string> given = text(key);
    if (!given) return std::nullopt;
    std::vector<std::string> names;
    for (const auto& [word, value] : words) {
      if (*given == word) return value;
      names.emplace_back(word);
    }
    wrong_name(key, *given, "word", names);
    return std::nullopt;
  }

  /// The table under the key, titled `title`.
  std::optional<TomlTable> table(const char* key, const std::string& title);
  /// The tables of the array under the key; none if it is missing.
  std::vector<TomlTable> tables(const char* key, const std::string& title);
  /// Pairs of a key and a text, any keys.
  std::vector<std::pair<std::string, std::string>> texts(const char* key);
  /// A list of texts, not empty if it is there; `words` names them in the message.
  std::vector<std::string> list(const char* key, std::string_view words);

  /// Says what is wrong with the value of a key: "... must be ...".
  void wrong(const char* key, const std::string& message) { errors_.add(line_of(key), title_ + ": " + message); }
  /// The value of a key is a name that is not in `names`.
  void wrong_name(const char* key, const std::string& given, const char* what, const std::vector<std::string>& names);
  void finish();

 private:
  const toml::node* find(const char* key);
  std::optional<double> number(const char* key, const toml::node& node, const Limits& limits);

  const toml::table& table_;
  std::string title_;
  TomlErrors& errors_;
  std::vector<std::string> read_;
};

}  // namespace zstrip::sim
