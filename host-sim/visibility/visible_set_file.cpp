// Reads the file once, and checks it against the scene of each frame.
#include "visibility/visible_set_file.hpp"

#include <fmt/format.h>

#include <cstring>

#include "import/read_file.hpp"
#include "visibility/visible_set_bake.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/visibility/visible_sets.hpp"

namespace zstrip::sim {

Result<VisibleSetFile> VisibleSetFile::read(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) {
    return Failure{bytes.failure().status,
                   fmt::format("--visible-sets '{}' {}; 'zstrip bake' of this scene with --visible-sets writes it",
                               path, bytes.failure().message)};
  }
  VisibleSetFile file;
  file.path_ = path;
  file.bytes_ = bytes->size();
  file.words_.resize((bytes->size() + 3) / 4);
  if (!bytes->empty()) std::memcpy(file.words_.data(), bytes->data(), bytes->size());
  return file;
}

Result<std::span<const std::uint32_t>> VisibleSetFile::at(const Scene& scene, const Camera& camera,
                                                          const Animation& animation) const {
  VisibleSets sets;
  const Status opened = open_visible_sets(std::as_bytes(std::span(words_)).first(bytes_), count(scene).meshlets, sets);
  // The number of meshlets differs; the file does not end before that number.
  const bool of_another = opened.needed == detail::visible_sets_at::kMeshlets && bytes_ > opened.needed;
  if (!opened && opened.error == Error::blob_damaged && !of_another) {
    return Failure{ExitStatus::input,
                   fmt::format("'{}' holds no visible sets, or damaged ones: byte {}", path_, opened.needed)};
  }
  if (!opened && opened.error == Error::blob_version) {
    return Failure{ExitStatus::input, fmt::format("'{}' has version {} of visible sets, and {} is read; bake it again",
                                                  path_, opened.needed, opened.available)};
  }
  if (!opened || sets.scene_checksum != visibility_checksum(scene, animation)) {
    return Failure{ExitStatus::input,
                   fmt::format("'{}' was baked for another scene, or instances that stood still have moved", path_)};
  }
  // open_visible_sets accepts a larger region, because it may be flash; a file must end with its sets.
  if (const std::uint32_t size = words_[detail::visible_sets_at::kSize / 4]; size != bytes_) {
    return Failure{ExitStatus::input,
                   fmt::format("'{}' does not end with its visible sets, at byte {}; bake it again", path_, size)};
  }
  if (camera.projection == Projection::orthographic) {
    return Failure{ExitStatus::usage, "--visible-sets needs a perspective camera: an orthographic one has no eye"};
  }
  if (camera.near_plane < sets.near_plane) {
    return Failure{ExitStatus::usage,
                   fmt::format("--visible-sets: '{}' is for cameras with a near plane of {:.4g} or more, and this one "
                               "has {:.4g}; bake it with this camera, or say 'near' in the scene file's [camera]",
                               path_, sets.near_plane / 65536.0, camera.near_plane / 65536.0)};
  }
  return sets.at(camera.eye);
}

}  // namespace zstrip::sim
