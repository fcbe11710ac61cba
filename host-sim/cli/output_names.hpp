// The output of pictures: one file, or numbered frames in a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "image/encode.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct OutputNames {
  std::filesystem::path path;
  bool folder = false;
  ImageType type = ImageType::png;
  std::uint32_t frames = 1;
  PixelFormat format = PixelFormat::rgb565;

  /// True if `path` is one file with all frames.
  bool is_animated() const { return !folder && type == ImageType::apng; }
  /// Returns the file of a frame: `path` itself, or frame_0000.png and so on in it.
  std::filesystem::path file(std::uint32_t frame) const;
};

inline constexpr std::uint32_t kFolderFrames = 8;

/// `output` is the argument of -o. It is a file if it ends in .png, .apng, .jpg, .jpeg, .ppm, .pgm or .raw, or if it
/// exists as a file or device; else it is a folder, which must have no other ending unless it exists or ends with '/'.
/// Without `output`: SCENE.png for one frame, a folder SCENE for several, both in the current folder. If the number of
/// frames is not given: 1 for a picture, `folder_frames` for a folder or an animation.
Result<OutputNames> name_outputs(const std::string& scene, const std::optional<std::string>& output,
                                 std::optional<std::uint32_t> frames, std::optional<ImageType> type, PixelFormat format,
                                 std::uint32_t folder_frames = kFolderFrames);

/// True if `path` is a name of standard output: /dev/stdout and similar names.
bool is_standard_output(const std::string& path);

/// Refuses to write two outputs to one place: pictures, the report, the file of --visible-sets. write_file protects
/// the inputs.
Result<Done> check_distinct(const OutputNames& outputs, const std::optional<std::string>& json,
                            const std::optional<std::string>& sets = std::nullopt);

/// Creates the folder, if there is one. Refuses names of files that were read, before anything is written.
Result<Done> prepare(const OutputNames& outputs);

}  // namespace zstrip::sim
