// Recognises files that are not models: a web page, an archive, a picture, a model of a program too old or too new.
#include "import/foreign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

using namespace std::string_view_literals;

constexpr std::array<std::string_view, 4> kZipped{".3mf", ".zae", ".ifczip", ".kmz"};

constexpr std::string_view kUnpack = "unpack it first, and name the model in it";

/// Returns a message with the program that packed the file, and what to do.
std::optional<std::string> packed_kind(std::string_view begin, std::string_view ending) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kPackers{
      {{"PK\3\4"sv, "a zip archive"},
       {"\x1F\x8B"sv, "packed by gzip"},
       {"\x28\xB5\x2F\xFD"sv, "packed by zstd"},
       {"Rar!\x1A\x07"sv, "a RAR archive"},
       {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive"},
       {"\xFD\x37zXZ\0"sv, "packed by xz"},
       {"BZh"sv, "packed by bzip2"}}};
  for (const auto& [magic, name] : kPackers) {
    if (!begin.starts_with(magic)) continue;
    if (magic.starts_with("PK") && std::ranges::find(kZipped, ending) != kZipped.end()) return std::nullopt;
    if (ending == ".blend") {
      // Assimp unpacks files that gzip packed.
      if (magic.starts_with("\x1F\x8B")) return std::nullopt;
      return fmt::format("is {}, which only the program blender reads: install it, or export the file as .glb", name);
    }
    return fmt::format("is {}; {}", name, kUnpack);
  }
  return std::nullopt;
}

/// Returns a message for FBX before 7.1, of 2011, which is another format.
std::optional<std::string> old_fbx(std::string_view begin) {
  constexpr std::string_view kBinary = "Kaydara FBX Binary", kVersion = "FBXVersion:";
  unsigned version = 0;
  if (begin.starts_with(kBinary) && begin.size() >= 27) {
    for (std::size_t i = 0; i < 4; ++i) version |= unsigned{static_cast<std::uint8_t>(begin[23 + i])} << 8 * i;
  } else if (const std::size_t at = begin.find(kVersion); at != begin.npos) {
    const std::size_t digit = begin.find_first_not_of(" \t", at + kVersion.size());
    if (digit != begin.npos) std::from_chars(begin.data() + digit, begin.data() + begin.size(), version);
  }
  if (version == 0 || version >= 7100) return std::nullopt;
  return fmt::format("is FBX {}.{}, of which only 7.1 and later is read; export it again as FBX 2013 or later, or .glb",
                     version / 1000, version / 100 % 10);
}

/// Returns a message for releases of Blender whose files Assimp does not read.
std::optional<std::string> new_blend(std::string_view begin) {
  constexpr unsigned kLastOfAssimp = 301;
  // "BLENDER-v304", or since release 5 "BLENDER17-01v0500".
  const std::size_t at = begin.substr(0, 20).find('v');
  unsigned version = 0;
  if (!begin.starts_with("BLENDER") || at == begin.npos || begin.size() < at + 5) return std::nullopt;
  std::from_chars(begin.data() + at + 1, begin.data() + at + (begin[at + 1] == '0' ? 5 : 4), version);
  if (version <= kLastOfAssimp) return std::nullopt;
  return fmt::format(
      "is of Blender {}.{}, and only the program blender of that release or a later one reads it: install it, or "
      "export the file as .glb",
      version / 100, version % 100);
}

std::optional<std::string> page_kind(std::string_view begin) {
  const std::string lowered = lower(std::string(begin));
  std::string_view text = lowered;
  const auto skip_spaces = [&text] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), text.size()));
  };
  skip_spaces();
  if (text.starts_with("<?")) {
    text.remove_prefix(std::min(text.find('>'), text.size() - 1) + 1);
    skip_spaces();
  }
  for (const char* tag : {"<!doctype html", "<html", "<head>", "<body"}) {
    if (text.starts_with(tag)) {
      return "is a web page, not the file; download the file itself, by the page's link for raw data";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> foreign_kind(std::string_view begin, std::string_view ending) {
  if (begin.empty()) return "is empty; export it again";
  if (std::ranges::all_of(begin, [](char c) { return c == '\0'; })) return "holds only zeros; copy it again";
  if (auto packed = packed_kind(begin, ending)) return packed;
  if (auto page = page_kind(begin)) return page;
  if (ending == ".fbx") {
    if (auto old = old_fbx(begin)) return old;
  }
  if (ending == ".blend") {
    if (auto too_new = new_blend(begin)) return too_new;
  }
  if (ending == ".wrl" || begin.starts_with("#VRML V")) {
    return "is VRML, which is not read; export it as .x3d or .glb, for example with Blender";
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kPictures{{{"\x89PNG\r\n"sv, "PNG"},
                                                                                    {"\xFF\xD8\xFF"sv, "JPEG"},
                                                                                    {"GIF8"sv, "GIF"},
                                                                                    {"\xABKTX"sv, "KTX"},
                                                                                    {"DDS "sv, "DDS"},
                                                                                    {"RIFF"sv, "WebP"}}};
  for (const auto& [magic, name] : kPictures) {
    if (begin.starts_with(magic))
      return fmt::format("is a picture ({}), not a model; name the model that uses it", name);
  }
  if (begin.starts_with("%PDF")) return "is a PDF, not a model";
  return std::nullopt;
}

}  // namespace zstrip::sim
