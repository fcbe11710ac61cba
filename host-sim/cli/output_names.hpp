// Where the pictures go: one file, or numbered frames in a folder.
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

  /// Whether `path` is one file with all frames.
  bool is_animated() const { return !folder && type == ImageType::apng; }
  /// The file of a frame: `path` itself, or frame_0000.png and so on in it.
  std::filesystem::path file(std::uint32_t frame) const;
};

inline constexpr std::uint32_t kFolderFrames = 8;

/// `output` is what -o gave. It names a file if it ends in .png, .apng, .jpg, .jpeg, .ppm, .pgm or .raw, or is a file
/// or device already; else a folder, which has no other ending unless it is there or a '/' follows. Without it:
/// SCENE.png for one frame, a folder SCENE for more, both in the current folder. Frames, where not given: 1 into a
/// picture, `folder_frames` into a folder or an animation.
Result<OutputNames> name_outputs(const std::string& scene, const std::optional<std::string>& output,
                                 std::optional<std::uint32_t> frames, std::optional<ImageType> type, PixelFormat format,
                                 std::uint32_t folder_frames = kFolderFrames);

/// Whether `path` is a name of standard output: /dev/stdout and the like.
bool is_standard_output(const std::string& path);

/// Refuses to write two things to one place: the report over a picture, or either over the file of the scene or of
/// --visible-sets, which is not the scene's either.
Result<Done> check_distinct(const OutputNames& outputs, const std::optional<std::string>& json,
                            const std::string& scene, const std::optional<std::string>& sets = std::nullopt);

/// Creates the folder where there is to be one.
Result<Done> prepare(const OutputNames& outputs);

}  // namespace zstrip::sim
