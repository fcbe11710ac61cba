// Reads a baked scene (.zsc) from a file, with its animation or rotation.
#include "scene_file.hpp"

#include <filesystem>
#include <fstream>

#include "zstrip/scene/blob_sections.hpp"
#include "zstrip/status.hpp"

namespace zstrip::panel {
namespace {

static_assert(kSceneBlobAlignment <= alignof(std::uint64_t) && kSceneBlobMemoryAlignment <= alignof(std::uint64_t));

constexpr std::uintmax_t kMaxFile = std::uintmax_t{256} << 20;

std::vector<std::uint64_t> words_for(std::size_t bytes) {
  return std::vector<std::uint64_t>((bytes + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
}

std::string reason(const Status& status) {
  switch (status.error) {
    case Error::blob_damaged:
      return "is not a complete baked scene (byte " + std::to_string(status.needed) + "); bake it again: zstrip bake";
    case Error::blob_version:
      return "is a baked scene of version " + std::to_string(status.needed) + ", and this program reads version " +
             std::to_string(status.available) + "; bake it again: zstrip bake MODEL -o FILE.zsc";
    case Error::blob_section:
      return std::string("is a baked scene with a section '") + blob_layout::name_of(status.needed).data() +
             "' that this program does not know; it needs a newer one";
    default: return std::string("is a baked scene that cannot be drawn: ") + message(status.error) + "; bake it again";
  }
}

}  // namespace

hal::Outcome<SceneFile> SceneFile::open(const std::string& path) {
  const auto fault = [&path](const std::string& text) { return hal::Fault{"'" + path + "' " + text}; };
  std::error_code error;
  const std::uintmax_t file_size = std::filesystem::file_size(path, error);
  if (error) return fault("cannot be read: " + error.message());
  if (file_size > kMaxFile) return fault("is larger than 256 MB: no baked scene");
  const auto size = static_cast<std::size_t>(file_size);
  SceneFile file;
  file.bytes_ = words_for(size);
  const std::span<std::byte> bytes = std::as_writable_bytes(std::span(file.bytes_)).first(size);
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    return fault("cannot be read");

  Status status = open_scene_blob(bytes, {}, file.blob_);
  if (status.error == zstrip::Error::blob_memory) {
    file.tables_ = words_for(status.needed);
    status = open_scene_blob(bytes, std::as_writable_bytes(std::span(file.tables_)), file.blob_);
  }
  if (!status) return fault(reason(status));
  return file;
}

Camera SceneFile::camera(const View& view, std::uint32_t frames) const {
  return scenes::fit_width(blob_.camera_for(frames), blob_.view, view);
}

bool SceneFile::can_turn(const Camera& camera) const {
  return scenes::can_turn({blob_.scene, camera, blob_.animation, blob_.turn});
}

scenes::BakedFrame SceneFile::staged(const Camera& camera, std::uint32_t frame, std::uint32_t frames) {
  PlayedClip played{};
  if (!blob_.clips.empty()) played.time = time_of_frame(blob_.clips[0].instances, frame, frames);
  // A skin that cannot be posed is drawn as it was modelled; zstrip bake has tried many poses.
  static_cast<void>(pose_clips(blob_, {&played, 1}));
  const bool is_at_rest = frame % frames == 0 && blob_.animation.tracks.empty();
  if (is_at_rest && blob_.levels.empty()) return {blob_.scene, camera};
  instances_.resize(blob_.scene.instances.size());
  lines_.resize(blob_.scene.lines.size());
  scenes::BakedFrame staged{blob_.scene, camera};
  if (!is_at_rest) {
    staged = scenes::move({blob_.scene, camera, blob_.animation, blob_.turn}, frame, frames,
                          {.instances = instances_, .lines = lines_});
  }
  scenes::choose_levels(blob_.levels, blob_.scene, instances_, staged);
  return staged;
}

}  // namespace zstrip::panel
