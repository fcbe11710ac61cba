// Reads a model file: glTF 2.0, PLY, STL and 3MF with readers of their own, all other formats with Assimp.
#include "import/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "image/decode.hpp"
#include "import/3mf/read_3mf.hpp"
#include "import/assimp/read_assimp.hpp"
#include "import/blend_file.hpp"
#include "import/crash_guard.hpp"
#include "import/ending.hpp"
#include "import/find_file.hpp"
#include "import/foreign_file.hpp"
#include "import/gltf/data_uri.hpp"
#include "import/gltf/read_gltf.hpp"
#include "import/model_files.hpp"
#include "import/ply/read_ply.hpp"
#include "import/read_file.hpp"
#include "import/stl/read_stl.hpp"
#include "import/turn_up.hpp"
#include "import/unreadable.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// True for names of glTF files, and for avatars (.vrm) by their first bytes.
bool is_gltf(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  std::array<char, 4> begin{};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return ending == ".gltf" || ending == ".glb" || begin == std::array{'g', 'l', 'T', 'F'};
}

bool is_archive(const std::filesystem::path& path) {
  constexpr std::string_view kEndings[] = {".zip", ".rar", ".7z",  ".gz",  ".tgz", ".tar",
                                           ".xz",  ".bz2", ".zst", ".lz4", ".lzma"};
  return std::ranges::find(kEndings, ending_of(path)) != std::end(kEndings);
}

/// True for the files that zstrip bake writes, except blobs.
bool is_for_firmware(const std::filesystem::path& path) {
  constexpr std::string_view kEndings[] = {".uf2", ".hpp", ".h", ".ino", ".cpp"};
  return std::ranges::find(kEndings, ending_of(path)) != std::end(kEndings);
}

/// Returns a function that finds buffers and pictures next to the file.
ReadUri reader_beside(const std::filesystem::path& folder) {
  return [folder](const std::string& uri) -> Result<std::vector<std::uint8_t>> {
    return read_file(find_file(folder, without_escapes(uri)));
  };
}

/// Returns a function that finds pictures next to the file.
ReadPicture picture_reader_beside(const std::filesystem::path& folder) {
  return [folder](const std::string& name) -> Result<RgbImage> {
    const Result<std::vector<std::uint8_t>> bytes = read_file(find_file(folder, name));
    if (!bytes) return bytes.failure();
    return decode_image(*bytes);
  };
}

/// Reads any format. Files of glTF 1.0, which is another format, are read by Assimp.
Result<SourceModel> read_any(const std::filesystem::path& path, const ExportedBlend& blend, std::optional<UpAxis> up,
                             Texcoords texcoords, Shine shine, CrashGuard& guard) {
  const auto parsed = [&guard] { guard.lift_limits(); };
  if (!blend.glb.empty()) {
    const Result<GltfDocument> document = parse_gltf(blend.glb);
    if (!document) return unreadable_model(document.failure().message);
    // The export has turned z upwards already.
    const Affine turn = turn_up(up.value_or(UpAxis::plus_z)) * inverse(turn_up(UpAxis::plus_z));
    return read_gltf(*document, reader_beside(path.parent_path()), turn, texcoords, shine);
  }
  const std::string ending = ending_of(path);
  if (ending == ".ply" || ending == ".3mf" || ending == ".stl") {
    const Result<std::vector<std::uint8_t>> bytes = read_file(path);
    if (!bytes) return bytes.failure();
    const std::string_view file(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const Affine turn = turn_up(up.value_or(ending == ".ply" ? UpAxis::plus_y : UpAxis::plus_z));
    if (ending == ".3mf") return read_3mf(file, turn, texcoords);
    if (ending == ".stl") return read_stl(as_utf8(file), turn);
    return read_ply(as_utf8(file), picture_reader_beside(path.parent_path()), turn, texcoords);
  }
  if (!is_gltf(path)) return read_assimp(path, up, texcoords, parsed);
  const Result<std::vector<std::uint8_t>> bytes = read_file(path);
  if (!bytes) return bytes.failure();
  const Result<GltfDocument> document = parse_gltf(*bytes);
  if (!document) return unreadable_model(document.failure().message);
  if (document->version == 1) return read_assimp(path, up, texcoords, parsed);
  if (document->version != 2) return unreadable_model("it is of a version of glTF that is not known");
  return read_gltf(*document, reader_beside(path.parent_path()), turn_up(up.value_or(UpAxis::plus_y)), texcoords,
                   shine);
}

}  // namespace

Result<SourceModel> read_model(const std::filesystem::path& path, std::optional<UpAxis> up, Texcoords texcoords,
                               Shine shine) {
  const auto named = [&](const std::string& message) {
    return Failure{ExitStatus::input, fmt::format("'{}' {}", path.string(), message)};
  };
  if (const Result<Done> readable = check_readable(path); !readable) return named(readable.failure().message);
  if (is_archive(path)) return named("is an archive; unpack it first, and name the model in it");
  if (is_for_firmware(path)) {
    return named(
        "was written by zstrip bake for firmware and cannot be read; name the scene that it was made from, or "
        "bake a .zsc");
  }
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(path, error);
  if (error) return named("cannot be read: " + error.message());
  const std::chrono::seconds limit = reading_limit(bytes);
  const std::string ending = ending_of(path);
  std::string begin(kBytesOfKind, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  constexpr std::string_view kGzip = "\x1F\x8B", kZstd = "\x28\xB5\x2F\xFD";
  ExportedBlend blend;
  if (ending == ".blend" && (begin.starts_with("BLENDER") || begin.starts_with(kGzip) || begin.starts_with(kZstd))) {
    constexpr std::chrono::minutes kStart{1};  // of blender, on a busy machine
    blend = export_blend(path, limit + kStart);
  }
  const std::string why = blend.reason.empty() ? "" : fmt::format("blender did not export it: {}", blend.reason);
  if (const std::optional<std::string> other = foreign_kind(begin, ending); other && blend.glb.empty()) {
    return named(*other + (why.empty() ? "" : "; " + why));
  }
  if (ending == ".blend" && blend.glb.empty()) {
    blend.warnings.push_back(
        "drawn without: modifiers, flat faces, nodes of materials, skins and animations, which " +
        (why.empty() ? std::string("only the program blender reads; it is not installed") : "blender reads; " + why));
  }
  const std::string shown = printable(path.string());
  CrashGuard guard(
      fmt::format(
          "zstrip: '{}' crashed the model reader: it is damaged, or not as the reader expects it; export it again",
          shown),
      fmt::format("zstrip: '{}' is not read after {} s: the file is damaged, or too intricate; export it again", shown,
                  limit.count()),
      limit, reading_memory(bytes));
  Result<SourceModel> model = [&]() -> Result<SourceModel> {
    try {
      return read_any(path, blend, up, texcoords, shine, guard);
    } catch (const std::bad_alloc&) {
      guard.lift_limits();
      if (!machine_gives(reading_memory(bytes))) throw;
      return unreadable_model("it asks for more memory than a file of its size may");
    }
  }();
  if (!model) return named(model.failure().message + (why.empty() ? "" : "; " + why));
  model->warnings.insert(model->warnings.end(), blend.warnings.begin(), blend.warnings.end());
  return model;
}

}  // namespace zstrip::sim
