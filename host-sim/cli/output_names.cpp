// Where the pictures go: one file, or numbered frames in a folder.
#include "cli/output_names.hpp"

#include <fmt/format.h>

#include <system_error>

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kFolderFrames = 8;

std::optional<ImageType> type_of_extension(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".png") return ImageType::png;
  if (extension == ".ppm" || extension == ".pgm") return ImageType::ppm;
  if (extension == ".raw") return ImageType::raw;
  return std::nullopt;
}

}  // namespace

std::filesystem::path OutputNames::file(std::uint32_t frame) const {
  return folder ? path / fmt::format("frame_{:04}{}", frame, file_extension(type, format)) : path;
}

Result<OutputNames> name_outputs(const std::string& scene, const std::optional<std::string>& output,
                                 std::optional<std::uint32_t> frames, std::optional<ImageType> type,
                                 PixelFormat format) {
  OutputNames names;
  names.format = format;
  std::error_code ignored;
  if (output) {
    names.path = *output;
    const auto by_name = type_of_extension(names.path);
    const std::filesystem::file_status status = std::filesystem::status(names.path, ignored);
    names.folder = std::filesystem::is_directory(status) || (!std::filesystem::exists(status) && !by_name);
    if (!names.folder && by_name && type && *by_name != *type) {
      return Failure{ExitStatus::usage,
                     fmt::format("-o '{}' and --image name different picture types; give one of them", *output)};
    }
    names.type = type.value_or(names.folder ? ImageType::png : by_name.value_or(ImageType::png));
    names.frames = frames.value_or(names.folder ? kFolderFrames : 1);
    if (!names.folder && names.frames > 1) {
      return Failure{
          ExitStatus::usage,
          fmt::format("-o '{}' is one file and cannot take {} frames; name a folder instead", *output, names.frames)};
    }
    return names;
  }
  const std::string stem = std::filesystem::path(scene).stem().string();
  names.type = type.value_or(ImageType::png);
  names.frames = frames.value_or(1);
  names.folder = names.frames > 1;
  names.path = names.folder ? stem : stem + file_extension(names.type, format);
  return names;
}

Result<Done> prepare(const OutputNames& outputs) {
  if (!outputs.folder) return Done{};
  std::error_code error;
  std::filesystem::create_directories(outputs.path, error);
  if (!error && std::filesystem::is_directory(outputs.path, error)) return Done{};
  return Failure{ExitStatus::output,
                 fmt::format("cannot create the folder '{}': {}; choose another place with -o", outputs.path.string(),
                             error ? error.message() : "a file has this name")};
}

}  // namespace zstrip::sim
