// Corrects input that Assimp 5.2 reads wrong, before Assimp reads it.
#include "import/model_files.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/IOStream.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "image/inputs.hpp"
#include "import/ending.hpp"
#include "import/find_file.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kLittleEndian = "\xFF\xFE", kBigEndian = "\xFE\xFF", kMarkOfUtf8 = "\xEF\xBB\xBF";
constexpr char32_t kNoCharacter = 0xFFFD;

bool is_utf16(std::string_view text) { return text.starts_with(kLittleEndian) || text.starts_with(kBigEndian); }

void append(std::string& to, char32_t c) {
  const auto byte = [&to](char32_t value) { to += static_cast<char>(value); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | c >> 6);
    byte(0x80 | (c & 63));
  } else if (c < 0x10000) {
    byte(0xE0 | c >> 12);
    byte(0x80 | (c >> 6 & 63));
    byte(0x80 | (c & 63));
  } else {
    byte(0xF0 | c >> 18);
    byte(0x80 | (c >> 12 & 63));
    byte(0x80 | (c >> 6 & 63));
    byte(0x80 | (c & 63));
  }
}

/// Removes names of groups, which are the lines that do not begin with a number.
std::string without_groups(std::string_view raw) {
  std::string text;
  while (!raw.empty()) {
    const std::size_t end = std::min(raw.find('\n'), raw.size() - 1) + 1;
    const std::string_view line = raw.substr(0, end);
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && std::string_view("0123456789+-").find(line[first]) != std::string_view::npos)
      text += line;
    raw.remove_prefix(end);
  }
  return text;
}

/// Puts each vertex and face of an OFF file on a line of its own. The format separates numbers by any spaces, but
/// Assimp reads lines and crashes if a face takes several. Returns other texts, for example with colours, unchanged.
std::string with_lines_of_elements(std::string_view off) {
  static constexpr std::string_view kSpaces = " \t\r\n";
  std::string_view rest = off;
  const auto take_word = [&rest] {
    rest.remove_prefix(std::min(rest.find_first_not_of(kSpaces), rest.size()));
    while (rest.starts_with('#')) {
      rest.remove_prefix(std::min(rest.find_first_of("\r\n"), rest.size()));
      rest.remove_prefix(std::min(rest.find_first_not_of(kSpaces), rest.size()));
    }
    const std::string_view word = rest.substr(0, rest.find_first_of(kSpaces));
    rest.remove_prefix(word.size());
    return word;
  };
  std::string lines = "OFF\n";
  const auto append_words = [&](std::uint64_t count) {
    for (; count > 0; --count) {
      const std::string_view word = take_word();
      if (word.empty()) return false;
      lines += word;
      lines += count == 1 ? '\n' : ' ';
    }
    return true;
  };
  const auto take_count = [&]() -> std::optional<std::uint64_t> {
    const std::string_view word = take_word();
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    return error == std::errc() && end == word.data() + word.size() ? std::optional(count) : std::nullopt;
  };
  if (take_word() != "OFF") return std::string(off);
  const std::optional<std::uint64_t> vertices = take_count(), faces = take_count(), edges = take_count();
  if (!vertices || !faces || !edges) return std::string(off);
  lines += std::to_string(*vertices) + ' ' + std::to_string(*faces) + ' ' + std::to_string(*edges) + '\n';
  for (std::uint64_t i = 0; i < *vertices; ++i) {
    if (!append_words(3)) return std::string(off);
  }
  for (std::uint64_t i = 0; i < *faces; ++i) {
    const std::optional<std::uint64_t> corners = take_count();
    if (!corners) return std::string(off);
    lines += std::to_string(*corners) + ' ';
    if (*corners == 0 || !append_words(*corners)) return std::string(off);
  }
  return take_word().empty() ? lines : std::string(off);
}

/// Counts the entities of a DXF text that have a shape and that Assimp leaves out. A file is pairs of lines: a code,
/// and a value. Code 0 begins an entity or a section, code 2 names the section.
std::size_t curves_and_solids_of(std::string_view dxf) {
  static constexpr std::array<std::string_view, 9> kLeftOut{"3DSOLID", "ARC",   "BODY",   "CIRCLE", "ELLIPSE",
                                                            "MESH",    "SOLID", "SPLINE", "TRACE"};
  const auto take_line = [&dxf] {
    std::string_view line = dxf.substr(0, dxf.find('\n'));
    dxf.remove_prefix(std::min(line.size() + 1, dxf.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
  };
  std::size_t count = 0;
  bool in_entities = false;
  while (!dxf.empty()) {
    const std::string_view code = take_line(), value = take_line();
    if (code == "2" && value == "ENTITIES") in_entities = true;
    if (code == "0" && value == "ENDSEC") in_entities = false;
    if (code == "0" && in_entities && std::ranges::find(kLeftOut, value) != kLeftOut.end()) ++count;
  }
  return count;
}

/// True if the text begins with the UTF-8 mark; binary formats may begin with the same bytes by chance.
bool has_mark_of_utf8(std::string_view bytes) {
  return bytes.starts_with(kMarkOfUtf8) && bytes.find('\0') == std::string_view::npos;
}

std::string rest_of(Assimp::IOStream& stream) {
  std::string bytes(stream.FileSize() - stream.Tell(), '\0');
  bytes.resize(bytes.empty() ? 0 : stream.Read(bytes.data(), 1, bytes.size()));
  return bytes;
}

}  // namespace

std::string as_utf8(std::string_view text) {
  if (has_mark_of_utf8(text)) text.remove_prefix(kMarkOfUtf8.size());
  if (!is_utf16(text)) return std::string(text);
  const bool swapped = text.starts_with(kBigEndian);
  const auto unit_at = [&](std::size_t at) -> char32_t {
    const char32_t first = static_cast<std::uint8_t>(text[at]);
    const char32_t second = static_cast<std::uint8_t>(text[at + 1]);
    return swapped ? first << 8 | second : second << 8 | first;
  };
  std::string utf8;
  for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
    char32_t c = unit_at(at);
    const char32_t low = at + 3 < text.size() ? unit_at(at + 2) : 0;
    if (c >= 0xD800 && c < 0xDC00 && low >= 0xDC00 && low < 0xE000) {
      c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
      at += 2;
    }
    append(utf8, c >= 0xD800 && c < 0xE000 ? kNoCharacter : c);
  }
  return utf8;
}

std::string ModelFiles::place_of(const char* file) const {
  const std::string folder = model_.has_parent_path() ? model_.parent_path().string() + "/" : "";
  const std::string name(file);
  return name.starts_with(folder) ? find_file(model_.parent_path(), name.substr(folder.size())).string() : name;
}

std::string ModelFiles::plain(const std::string& file, std::string text) {
  const std::string ending = ending_of(model_);
  if (ending == ".raw") return without_groups(text);
  if (ending == ".dxf") read_.curves_and_solids = curves_and_solids_of(text);
  if (ending == ".off") return with_lines_of_elements(text);
  if (ending != ".obj") return text;
  if (file != model_) return plain_mtl(text, of_blender_, read_.warnings, read_.materials);
  of_blender_ = is_of_blender(text);
  const auto is_file = [this](std::string_view name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(find_file(model_.parent_path(), std::string(name)), ignored);
  };
  return plain_obj(text, is_file, read_.materials.used, read_.origin);
}

Assimp::IOStream* ModelFiles::Open(const char* file, const char* mode) {
  std::string place = file;
  std::unique_ptr<Assimp::IOStream> stream(DefaultIOSystem::Open(file, mode));
  if (!stream) {
    place = place_of(file);
    stream.reset(DefaultIOSystem::Open(place.c_str(), mode));
  }
  if (!stream) {
    read_.not_opened.emplace_back(file);
    return nullptr;
  }
  remember_input(place);
  std::string begin(kMarkOfUtf8.size(), '\0');
  begin.resize(stream->Read(begin.data(), 1, begin.size()));
  stream->Seek(0, aiOrigin_SET);
  const std::string ending = ending_of(model_);
  constexpr std::array<std::string_view, 4> kEndings{".raw", ".off", ".obj", ".dxf"};
  const bool has_plain_form = std::ranges::find(kEndings, ending) != kEndings.end();
  if (!has_plain_form && !is_utf16(begin) && !has_mark_of_utf8(begin)) return stream.release();
  const std::string text = plain(file, as_utf8(rest_of(*stream)));
  auto bytes = std::make_unique<std::uint8_t[]>(text.size());
  std::ranges::copy(text, bytes.get());
  return new Assimp::MemoryIOStream(bytes.release(), text.size(), true);
}

}  // namespace zstrip::sim
