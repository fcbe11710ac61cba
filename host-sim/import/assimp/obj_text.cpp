// Converts OBJ and its materials to a form that Assimp 5.2 reads correctly.
#include "import/assimp/obj_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include "import/screen_channel.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kSpaces = " \t\v\f", kLineEnds = "\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// Removes the next line from `text` and returns it without spaces around it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(kLineEnds), text.size());
  const std::string_view line = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Removes the next word from `line` and returns it; empty if there is none.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpaces));
  line.remove_prefix(word.size());
  return word;
}

/// Returns the words before a comment, at most so many.
template <std::size_t most>
std::span<const std::string_view> take_words(std::string_view line, std::array<std::string_view, most>& words) {
  std::size_t count = 0;
  while (count < most) {
    const std::string_view word = take_word(line);
    if (word.empty() || word[0] == '#') break;
    words[count++] = word;
  }
  return std::span(words).first(count);
}

void append(std::string& to, std::string_view key, std::span<const std::string_view> numbers) {
  to += key;
  for (const std::string_view number : numbers) {
    to += ' ';
    if (number[0] == '.') to += '0';
    to += number;
  }
}

/// Joins a line that ends in a backslash with the next one.
std::string with_joined_lines(std::string_view text) {
  std::string joined;
  joined.reserve(text.size());
  while (!text.empty()) {
    const std::size_t backslash = std::min(text.find('\\'), text.size());
    joined += text.substr(0, backslash);
    text.remove_prefix(backslash);
    const std::size_t end = text.starts_with("\\\r\n")                             ? 3
                            : text.starts_with("\\\n") || text.starts_with("\\\r") ? 2
                                                                                   : 0;
    if (end == 0 && !text.empty()) joined += '\\';
    if (end != 0) joined += ' ';
    text.remove_prefix(std::min(std::max<std::size_t>(end, 1), text.size()));
  }
  return joined;
}

/// Appends the names of files after `mtllib`, each on a line of its own. A name that is no file may be several.
void append_libraries(std::string& to, std::string_view names, const std::function<bool(std::string_view)>& is_file) {
  std::vector<std::string_view> words;
  std::string_view rest = names;
  for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
    words.push_back(word);
  }
  if (is_file(names) || std::ranges::none_of(words, is_file)) words = {names};
  for (const std::string_view word : words) to += fmt::format("mtllib {}\n", word);
}

/// True for lines of numbers alone, in which a comment may follow. Names may have a #.
bool is_of_numbers(std::string_view key) {
  constexpr std::array<std::string_view, 5> kKeys{"vn", "f", "l", "p", "s"};
  return std::ranges::find(kKeys, key) != kKeys.end();
}

/// x y z, x y z w, x y z r g b or x y z r g b a.
using VertexWords = std::array<std::string_view, 7>;

bool has_colour(std::span<const std::string_view> words) { return words.size() >= 6; }

bool has_coloured_vertices(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    VertexWords words;
    if (take_word(line) == "v" && has_colour(take_words(line, words))) return true;
  }
  return false;
}

void append_vertex(std::string& to, std::span<const std::string_view> words, bool coloured) {
  const std::size_t used = has_colour(words)                ? 6
                           : words.size() == 4 && !coloured ? 4
                                                            : std::min<std::size_t>(words.size(), 3);
  append(to, "v", words.first(used));
  if (coloured && used == 3) to += fmt::format(" {0} {0} {0}", kNoColour);
  to += '\n';
}

/// Some exporters write a decimal comma.
std::optional<double> number_of(std::string_view word) {
  std::string text(word.starts_with('+') ? word.substr(1) : word);
  std::ranges::replace(text, ',', '.');
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Reads three numbers, or one for all three channels.
std::optional<std::array<double, 3>> colour_of(std::string_view line) {
  std::array<std::string_view, 3> words;
  const std::span<const std::string_view> found = take_words(line, words);
  std::array<double, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto channel = found.empty() ? std::nullopt : number_of(found[std::min(i, found.size() - 1)]);
    if (!channel) return std::nullopt;
    colour[i] = *channel;
  }
  return colour;
}

}  // namespace

bool is_of_blender(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    if (line.empty()) continue;
    if (line[0] != '#') return false;
    if (trimmed(line.substr(1)).starts_with("Blender")) return true;
  }
  return false;
}

std::string plain_obj(std::string_view from, const std::function<bool(std::string_view)>& is_file,
                      std::set<std::string>& used) {
  const std::string joined = with_joined_lines(from);
  std::string_view text = joined;
  const bool coloured = has_coloured_vertices(text);
  std::string_view material;
  std::string plain;
  plain.reserve(text.size() + text.size() / 8);
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    std::string_view rest = line;
    const std::string_view key = take_word(rest);
    if (key == "v") {
      VertexWords words;
      append_vertex(plain, take_words(rest, words), coloured);
    } else if (key == "vt") {
      std::array<std::string_view, 3> words;
      const std::span<const std::string_view> found = take_words(rest, words);
      append(plain, key, found);
      plain += found.size() == 1 ? " 0\n" : "\n";
    } else if (key == "mtllib") {
      append_libraries(plain, trimmed(rest), is_file);
    } else {
      plain += is_of_numbers(key) ? line.substr(0, line.find('#')) : line;
      plain += '\n';
    }
    if (key == "usemtl") material = trimmed(rest);
    if ((key == "f" || key == "l" || key == "p") && !material.empty()) {
      used.emplace(material);
      material = {};
    }
  }
  return plain;
}

namespace {

/// The values of an MTL material while its lines are read.
struct MtlMaterial {
  std::string_view name, texture, illumination;  ///< as in the file, after their key
  std::optional<std::array<double, 3>> colour;
  bool bad_colour = false, emits = false;
};

/// True if options of a texture scale it (-s) or move it (-o).
bool is_placed(std::string_view texture) {
  double neutral = -1;  // the value without effect; -1: none, these numbers do not move or scale
  for (std::string_view word = take_word(texture); !word.empty(); word = take_word(texture)) {
    const std::optional<double> number = number_of(word);
    if (number && neutral >= 0 && *number != neutral) return true;
    if (!number) neutral = word == "-s" ? 1 : word == "-o" ? 0 : -1;
  }
  return false;
}

void append(std::string& to, const MtlMaterial& material, bool linear) {
  to += fmt::format("newmtl {}\n", material.name);
  std::optional<std::array<double, 3>> colour = material.colour;
  // Blender's texture replaces the colour.
  if (!material.texture.empty() && (linear || !colour)) colour = {1, 1, 1};
  if (colour) {
    to += "Kd";
    for (const double channel : *colour) to += fmt::format(" {:.6f}", to_screen_channel(channel, linear) / 255.0);
    to += '\n';
  }
  if (!material.illumination.empty()) to += fmt::format("illum {}\n", material.illumination);
  if (!material.texture.empty()) to += fmt::format("map_Kd {}\n", material.texture);
}

void warn(const MtlMaterial& material, std::vector<std::string>& warnings) {
  const std::string name = printable(std::string(material.name));
  if (material.bad_colour) {
    warnings.push_back(fmt::format("material '{}' drawn without its colour: only Kd of numbers is read", name));
  }
  if (is_placed(material.texture)) {
    warnings.push_back(fmt::format("material '{}' drawn with its texture as it is: -s and -o are not read", name));
  }
  if (material.emits) {
    warnings.push_back(fmt::format("material '{}' drawn without its emission: it is read of glTF 2.0 only", name));
  }
}

/// Keys of maps that change normals, in small letters.
constexpr std::array<std::string_view, 4> kNormalMaps{"bump", "map_bump", "map_kn", "norm"};

}  // namespace

std::string plain_mtl(std::string_view text, bool linear, std::vector<std::string>& warnings,
                      std::set<std::string>& defined) {
  linear = linear || is_of_blender(text);
  std::string plain;
  std::optional<MtlMaterial> material;
  bool has_normal_maps = false;
  const auto finish = [&] {
    if (!material) return;
    append(plain, *material, linear);
    warn(*material, warnings);
  };
  while (!text.empty()) {
    std::string_view rest = take_line(text);
    const std::string key = lower(std::string(take_word(rest)));
    rest = trimmed(rest);
    if (key == "newmtl") {
      finish();
      material = MtlMaterial{.name = rest, .texture = {}, .illumination = {}, .colour = {}};
      defined.emplace(rest);
    }
    if (!material) continue;
    if (std::ranges::find(kNormalMaps, key) != kNormalMaps.end()) has_normal_maps = true;
    if (key == "kd") {
      material->colour = colour_of(rest);
      material->bad_colour = !material->colour;
    }
    if (key == "ke") material->emits = colour_of(rest).value_or(std::array<double, 3>{}) != std::array<double, 3>{};
    if (key == "map_ke" || key == "map_emissive") material->emits = true;
    if (key == "illum" && number_of(rest)) material->illumination = rest;
    if (key == "map_kd") material->texture = rest;
  }
  finish();
  constexpr std::string_view kWarning = "drawn without: normal maps";  // once for all files of materials
  if (has_normal_maps && std::ranges::find(warnings, kWarning) == warnings.end()) warnings.emplace_back(kWarning);
  return plain;
}

}  // namespace zstrip::sim
