// The output of pictures: one file, or numbered frames in a folder.
#include "cli/output_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "image/inputs.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::pair<std::string_view, ImageType> kEndings[] = {
    {".png", ImageType::png}, {".apng", ImageType::apng}, {".jpg", ImageType::jpeg}, {".jpeg", ImageType::jpeg},
    {".ppm", ImageType::ppm}, {".pgm", ImageType::ppm},   {".raw", ImageType::raw}};

std::optional<ImageType> type_of_ending(const std::string& ending) {
  const auto* const known = std::ranges::find(kEndings, lower(ending), &std::pair<std::string_view, ImageType>::first);
  return known == std::end(kEndings) ? std::nullopt : std::optional(known->second);
}

/// True if this is an ending of files, such as ".txt", and not the end of a folder's name such as "v1.2".
bool is_of_files(const std::string& ending) {
  return ending.size() > 1 && lower(ending)[1] >= 'a' && lower(ending)[1] <= 'z';
}

/// Returns the same path for all names of a file, also for a file that does not exist yet.
std::filesystem::path resolved(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : std::move(whole);
}

/// True for devices such as /dev/null, which can get several outputs.
bool is_device(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

}  // namespace

std::filesystem::path OutputNames::file(std::uint32_t frame) const {
  return folder ? path / fmt::format("frame_{:04}{}", frame, file_extension(type, format)) : path;
}

Result<OutputNames> name_outputs(const std::string& scene, const std::optional<std::string>& output,
                                 std::optional<std::uint32_t> frames, std::optional<ImageType> type, PixelFormat format,
                                 std::uint32_t folder_frames) {
  OutputNames names;
  names.format = format;
  std::error_code ignored;
  if (output == "-") {
    return Failure{ExitStatus::usage, "-o '-' is not a file; name /dev/stdout for standard output"};
  }
  if (output) {
    names.path = *output;
    const std::string ending = names.path.extension().string();
    const auto by_name = type_of_ending(ending);
    const std::filesystem::file_status status = std::filesystem::status(names.path, ignored);
    const bool is_there = std::filesystem::exists(status);
    names.folder = std::filesystem::is_directory(status) || (!is_there && !by_name);
    // A file of another kind is not overwritten, unless its type is given.
    if (!by_name && is_of_files(ending) && (!is_there || (std::filesystem::is_regular_file(status) && !type))) {
      return Failure{ExitStatus::usage,
                     fmt::format("-o '{0}': '{1}' is not a picture type; files end in .png, .apng (all frames in one), "
                                 ".jpg, .ppm, .pgm or .raw, and '{0}/' is a folder",
                                 *output, ending)};
    }
    if (!names.folder && by_name && type && *by_name != *type) {
      return Failure{ExitStatus::usage,
                     fmt::format("-o '{}' and --image name different picture types; give one of them", *output)};
    }
    names.type = type.value_or(names.folder ? ImageType::png : by_name.value_or(ImageType::png));
    names.frames = frames.value_or(names.folder || names.is_animated() ? folder_frames : 1);
    if (!names.folder && !names.is_animated() && names.frames > 1) {
      return Failure{ExitStatus::usage,
                     fmt::format("-o '{}' is one picture and cannot take {} frames; name a folder, or a file that "
                                 "ends in .apng",
                                 *output, names.frames)};
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

bool is_standard_output(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

Result<Done> check_distinct(const OutputNames& outputs, const std::optional<std::string>& json,
                            const std::optional<std::string>& sets) {
  const auto usage = [](std::string message) { return Failure{ExitStatus::usage, std::move(message)}; };
  const bool json_on_stdout = json && (*json == "-" || is_standard_output(*json));
  if (json_on_stdout && is_standard_output(outputs.path.string())) {
    return usage("-o and --json both name standard output; give one of them a file");
  }
  // Empty if there is no separate file.
  const auto file_of = [](bool is_file, const std::string& path) {
    return is_file && !is_device(path) ? resolved(path) : std::filesystem::path();
  };
  const std::filesystem::path report = file_of(json && !json_on_stdout, json.value_or(""));
  const std::filesystem::path set_file = file_of(sets.has_value(), sets.value_or(""));
  if (!report.empty() && report == set_file) {
    return usage(fmt::format("--json '{}' is the file of --visible-sets; give the report another name", *json));
  }

  // All files of a folder have the same path except for their names.
  const std::filesystem::path place = outputs.folder ? resolved(outputs.path) : "";
  const std::uint32_t files = outputs.folder ? outputs.frames : 1;
  for (std::uint32_t frame = 0; frame < files; ++frame) {
    const std::filesystem::path name = outputs.file(frame);
    if (!outputs.folder && is_device(name)) continue;
    const std::filesystem::path picture = outputs.folder ? place / name.filename() : resolved(name);
    if (!report.empty() && picture == report) {
      return usage(fmt::format("--json '{}' is a file of -o; give the report another name", *json));
    }
    if (!set_file.empty() && picture == set_file) {
      return usage(fmt::format("-o '{}' is the file of --visible-sets; name another one", name.string()));
    }
  }
  return Done{};
}

Result<Done> prepare(const OutputNames& outputs) {
  for (std::uint32_t frame = 0; frame < (outputs.folder ? outputs.frames : 1); ++frame) {
    if (Result<Done> checked = check_no_input(outputs.file(frame), "-o"); !checked) return checked;
  }
  if (!outputs.folder) return Done{};
  std::error_code error;
  std::filesystem::create_directories(outputs.path, error);
  if (!error && std::filesystem::is_directory(outputs.path, error)) return Done{};
  return Failure{ExitStatus::output,
                 fmt::format("cannot create the folder '{}': {}; choose another place with -o", outputs.path.string(),
                             error ? error.message() : "a file has this name")};
}

}  // namespace zstrip::sim
