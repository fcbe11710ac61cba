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

/// A backslash at a line's end would join the next line to it.
std::string_view without_end_backslashes(std::string_view line) {
  while (line.ends_with('\\')) line = trimmed(line.substr(0, line.size() - 1));
  return line;
}

/// Returns the numbers of a line, before a comment, at most so many.
template <std::size_t most>
std::span<const std::string_view> take_words(std::string_view line, std::array<std::string_view, most>& words) {
  std::size_t count = 0;
  while (count < most && !line.empty()) {
    const std::string_view word = without_end_backslashes(take_word(line));
    if (word.starts_with('#')) break;
    if (!word.empty()) words[count++] = word;
  }
  return std::span(words).first(count);
}

void append(std::string& to, std::string_view number) {
  to += ' ';
  if (number[0] == '.') to += '0';
  to += number;
}

void append(std::string& to, std::string_view key, std::span<const std::string_view> numbers) {
  to += key;
  for (const std::string_view number : numbers) append(to, number);
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

bool is_quoted(std::string_view name) { return name.size() > 2 && name.starts_with('"') && name.ends_with('"'); }

/// Appends the names of files after `mtllib`, each on a line of its own. A name that is not a file may be several
/// names.
void append_libraries(std::string& to, std::string_view names, const std::function<bool(std::string_view)>& is_file) {
  std::vector<std::string_view> words;
  std::string_view rest = names;
  for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
    words.push_back(word);
  }
  if (is_file(names) || std::ranges::none_of(words, is_file)) words = {names};
  while (words.size() == 1 && is_quoted(words[0])) {
    words[0] = without_end_backslashes(trimmed(words[0].substr(1, words[0].size() - 2)));
  }
  for (const std::string_view word : words) to += fmt::format("mtllib {}\n", word);
}

/// True for lines of numbers alone, in which a comment may follow. Names may have a #.
bool is_of_numbers(std::string_view key) {
  constexpr std::array<std::string_view, 7> kKeys{"v", "vt", "vn", "f", "l", "p", "s"};
  return std::ranges::find(kKeys, key) != kKeys.end();
}

/// Removes the next line from a text of joined lines; returns it without the comment that may follow numbers.
std::string_view take_statement(std::string_view& text) {
  const std::string_view line = without_end_backslashes(take_line(text));
  std::string_view rest = line;
  return is_of_numbers(take_word(rest)) ? without_end_backslashes(trimmed(line.substr(0, line.find('#')))) : line;
}

/// Others are of curves and of other programs; Assimp takes some for lines that begin with the same letter.
bool is_read(std::string_view key) {
  constexpr std::array<std::string_view, 4> kNames{"o", "g", "usemtl", "fo"};
  return is_of_numbers(key) || std::ranges::find(kNames, key) != kNames.end();
}

/// x y z, x y z w, x y z r g b or x y z r g b a.
using VertexWords = std::array<std::string_view, 7>;

bool has_colour(std::span<const std::string_view> words) { return words.size() >= 6; }

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

/// Facts about all vertices that a file has.
struct Vertices {
  bool coloured = false, has_texcoords = false;
  std::array<double, 3> origin{};  ///< of positions too far away for floats
};

Vertices survey(std::string_view text) {
  constexpr double kFar = 1024;  // times the file's extent; 13 of a float's 23 bits are left
  Vertices found;
  std::array<double, 3> low{}, high{};
  bool is_first = true;
  while (!text.empty()) {
    std::string_view line = take_statement(text);
    VertexWords words;
    const std::string_view key = take_word(line);
    if (key == "vt") found.has_texcoords = true;
    if (key != "v") continue;
    const std::span<const std::string_view> of_vertex = take_words(line, words);
    if (has_colour(of_vertex)) found.coloured = true;
    for (std::size_t axis = 0; of_vertex.size() >= 3 && axis < 3; ++axis) {
      const std::optional<double> number = number_of(of_vertex[axis]);
      if (!number) continue;
      low[axis] = is_first ? *number : std::min(low[axis], *number);
      high[axis] = is_first ? *number : std::max(high[axis], *number);
    }
    is_first = false;
  }
  double extent = 0, distance = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent = std::max(extent, high[axis] - low[axis]);
    distance = std::max(distance, std::abs(high[axis] + low[axis]) / 2);
  }
  for (std::size_t axis = 0; distance > kFar * extent && axis < 3; ++axis) {
    found.origin[axis] = (high[axis] + low[axis]) / 2;
  }
  return found;
}

/// Appends the number with as many digits as a float has, from the origin.
void append_from(std::string& to, std::string_view word, double origin) {
  const std::optional<double> number = number_of(word);
  append(to, number ? fmt::format("{:.9g}", *number - origin) : std::string(word));
}

void append_vertex(std::string& to, std::span<const std::string_view> words, const Vertices& all) {
  const bool coloured = all.coloured;
  const std::size_t used = has_colour(words)                ? 6
                           : words.size() == 4 && !coloured ? 4
                                                            : std::min<std::size_t>(words.size(), 3);
  const bool is_far = all.origin != std::array<double, 3>{} && used >= 3;
  if (is_far) {
    to += 'v';
    for (std::size_t axis = 0; axis < 3; ++axis) append_from(to, words[axis], all.origin[axis]);
    append(to, "", words.subspan(3, used - 3));
  } else {
    append(to, "v", words.first(used));
  }
  if (coloured && used == 3) to += fmt::format(" {0} {0} {0}", kNoColour);
  to += '\n';
}

/// Appends the corners of a face or line without texture coordinates: "1/2/3" becomes "1//3", and "1/2" becomes "1".
/// Other words stay as they are.
void append_without_texcoords(std::string& to, std::string_view corners) {
  for (std::string_view corner = take_word(corners); !corner.empty(); corner = take_word(corners)) {
    const bool is_corner = corner[0] != '/' && corner.find_first_not_of("+-/0123456789") == std::string_view::npos;
    const std::size_t texcoord = is_corner ? std::min(corner.find('/'), corner.size()) : corner.size();
    const std::size_t normal = corner.find('/', texcoord + 1);
    to += ' ';
    to += corner.substr(0, texcoord);
    if (normal == std::string_view::npos) continue;
    to += '/';
    to += corner.substr(normal);
  }
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
                      std::set<std::string>& used, std::array<double, 3>& origin) {
  const std::string joined = with_joined_lines(from);
  std::string_view text = joined;
  const Vertices all = survey(text);
  origin = all.origin;
  std::string_view material;
  std::string plain;
  plain.reserve(text.size() + text.size() / 8);
  while (!text.empty()) {
    const std::string_view line = take_statement(text);
    std::string_view rest = line;
    const std::string_view key = take_word(rest);
    if (key == "v") {
      VertexWords words;
      append_vertex(plain, take_words(rest, words), all);
    } else if (key == "vt") {
      std::array<std::string_view, 3> words;
      const std::span<const std::string_view> found = take_words(rest, words);
      append(plain, key, found);
      plain += found.size() == 1 ? " 0\n" : "\n";
    } else if (key == "mtllib") {
      append_libraries(plain, trimmed(rest), is_file);
    } else if ((key == "f" || key == "l") && !all.has_texcoords) {
      // Assimp left out faces that name texture coordinates of a file without any, or took them for normals.
      plain += key;
      append_without_texcoords(plain, rest);
      plain += '\n';
    } else if (is_read(key)) {
      plain += line;
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
  std::string_view name, texture, alpha_map, illumination;  ///< as in the file, after their key
  std::optional<std::array<double, 3>> colour;
  std::optional<double> metallic, roughness;     ///< 0..1
  std::optional<double> dissolve, transparency;  ///< 0..1: d, and Tr, which is used if there is no d
  bool bad_colour = false, emits = false;
};

/// Returns a number from 0 to 1, or nothing.
std::optional<double> share_of(std::string_view text) {
  const std::optional<double> number = number_of(text);
  if (!number || !(*number >= 0)) return std::nullopt;
  return std::min(*number, 1.0);
}

/// The name of a texture, and the options before it that are drawn.
struct MtlTexture {
  std::string_view name;
  TexturePlace place;
  bool clamps = false;
};

/// Numbers after -s and -o: one to three, of which the third is depth.
void take_numbers(std::string_view& rest, std::array<double, 2>& numbers) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::string_view after = rest;
    const std::optional<double> number = number_of(take_word(after));
    if (!number) return;
    if (i < 2) numbers[i] = *number;
    rest = after;
  }
}

MtlTexture texture_of(std::string_view line) {
  constexpr std::array<std::string_view, 9> kOfOneWord{"-blendu",  "-blendv", "-boost", "-cc",        "-bm",
                                                       "-imfchan", "-texres", "-type",  "-colorspace"};
  MtlTexture texture;
  std::array<double, 2> ignored{};
  while (true) {
    std::string_view rest = line;
    const std::string option = lower(std::string(take_word(rest)));
    if (option == "-s") {
      take_numbers(rest, texture.place.scale);
    } else if (option == "-o") {
      take_numbers(rest, texture.place.move);
    } else if (option == "-t" || option == "-mm") {
      take_numbers(rest, ignored);
    } else if (option == "-clamp") {
      texture.clamps = lower(std::string(take_word(rest))) == "on";
    } else if (std::ranges::find(kOfOneWord, option) != kOfOneWord.end()) {
      take_word(rest);
    } else {
      texture.name = trimmed(line);
      return texture;
    }
    line = rest;
  }
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
  if (material.metallic) to += fmt::format("Pm {:.6f}\n", *material.metallic);
  if (material.roughness) to += fmt::format("Pr {:.6f}\n", *material.roughness);
  to += fmt::format("d {:.6f}\n", material.dissolve.value_or(1 - material.transparency.value_or(0)));
  const auto append_map = [&to](std::string_view key, const MtlTexture& map) {
    if (!map.name.empty()) to += fmt::format("{} {}{}\n", key, map.clamps ? "-clamp on " : "", map.name);
  };
  append_map("map_Kd", texture_of(material.texture));
  append_map("map_d", texture_of(material.alpha_map));
}

void warn(const MtlMaterial& material, std::vector<std::string>& warnings) {
  const std::string name = printable(std::string(material.name));
  if (material.bad_colour) {
    warnings.push_back(fmt::format("material '{}' drawn without its colour: only Kd of numbers is read", name));
  }
  if (material.emits) {
    warnings.push_back(fmt::format("material '{}' drawn without its emission: it is read of glTF 2.0 only", name));
  }
}

/// Returns the factor after `d`. With -halo it would be smaller where the surface faces the camera.
std::optional<double> dissolve_of(std::string_view rest) {
  std::string_view after = rest;
  return share_of(lower(std::string(take_word(after))) == "-halo" ? trimmed(after) : rest);
}

/// Keys of maps that change normals, in small letters.
constexpr std::array<std::string_view, 4> kNormalMaps{"bump", "map_bump", "map_kn", "norm"};

}  // namespace

std::string plain_mtl(std::string_view text, bool linear, std::vector<std::string>& warnings, ObjMaterials& materials) {
  linear = linear || is_of_blender(text);
  std::string plain;
  std::optional<MtlMaterial> material;
  bool has_normal_maps = false;
  const auto finish = [&] {
    if (!material) return;
    append(plain, *material, linear);
    warn(*material, warnings);
    const TexturePlace place = texture_of(material->texture.empty() ? material->alpha_map : material->texture).place;
    if (place != TexturePlace{}) materials.places[std::string(material->name)] = place;
  };
  while (!text.empty()) {
    std::string_view rest = take_line(text);
    const std::string key = lower(std::string(take_word(rest)));
    rest = trimmed(rest);
    if (key == "newmtl") {
      finish();
      material = MtlMaterial{.name = rest,
                             .texture = {},
                             .alpha_map = {},
                             .illumination = {},
                             .colour = {},
                             .metallic = {},
                             .roughness = {},
                             .dissolve = {},
                             .transparency = {}};
      materials.defined.emplace(rest);
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
    if (key == "map_d") material->alpha_map = rest;
    if (key == "d") material->dissolve = dissolve_of(rest);
    if (key == "tr") material->transparency = share_of(rest);
    if (key == "pm") material->metallic = share_of(rest);
    if (key == "pr") material->roughness = share_of(rest);
  }
  finish();
  constexpr std::string_view kWarning = "drawn without: normal maps";  // once for all files of materials
  if (has_normal_maps && std::ranges::find(warnings, kWarning) == warnings.end()) warnings.emplace_back(kWarning);
  return plain;
}

}  // namespace zstrip::sim
