// A stage for a baked scene (.zsc).
#include "render/blob_stage.hpp"

#include <fmt/format.h>

#include <utility>

#include "import/read_file.hpp"
#include "render/camera_stage.hpp"
#include "render/model_animation.hpp"
#include "render/turned_parts.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/scene/blob_sections.hpp"

namespace zstrip::sim {
namespace {

std::string reason(const Status& status, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kKind = 3;
  switch (status.error) {
    case Error::blob_damaged:
      if (status.needed == kKind && bytes.size() > kKind && bytes[kKind] == 'v') {
        return "holds visible sets and no scene; name the scene, and this file with --visible-sets";
      }
      return fmt::format("is not a complete baked scene (byte {}); bake it again", status.needed);
    case Error::blob_version:
      return fmt::format(
          "is a baked scene of version {}, and this zstrip reads version {}; bake it again from its model or scene "
          "file: zstrip bake MODEL -o FILE.zsc",
          status.needed, status.available);
    case Error::blob_section:
      return fmt::format("is a baked scene with a section '{}' that this zstrip does not know; take a newer zstrip",
                         blob_layout::name_of(status.needed).data());
    default:
      return fmt::format("is a baked scene that cannot be drawn: {} (number {}); bake it again", message(status.error),
                         status.needed);
  }
}

constexpr Position kCorners[] = {{-32767, -32767, -32767}, {32767, -32767, -32767}, {-32767, 32767, -32767},
                                 {32767, 32767, -32767},   {-32767, -32767, 32767}, {32767, -32767, 32767},
                                 {-32767, 32767, 32767},   {32767, 32767, 32767}};

class BlobStage : public CameraStage {
 public:
  explicit BlobStage(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  BlobStage(const BlobStage&) = delete;
  BlobStage& operator=(const BlobStage&) = delete;

  std::span<const std::uint8_t> bytes() const { return bytes_; }

  Status open() {
    Status status = open_with(0);
    if (status.error == Error::blob_memory) status = open_with(status.needed);
    return status;
  }

  Result<Camera> camera(std::uint32_t frames) const override {
    if (!options().placed()) {
      return change_projection(scenes::fit_width(blob_.camera_for(frames), blob_.view, view()), options());
    }
    const std::vector<Instance> poses = all_poses(animation(), blob_.scene.instances);
    Scene whole = blob_.scene;
    whole.instances = poses;
    // Vertices that move may be anywhere in their mesh's box.
    std::vector<Mesh> boxes(whole.meshes.begin(), whole.meshes.end());
    for (const Skin& skin : blob_.skins)
      boxes[static_cast<std::size_t>(skin.mesh - whole.meshes.data())].positions = kCorners;
    for (const MovedMorph& morph : blob_.morphs.meshes) boxes[morph.mesh].positions = kCorners;
    whole.meshes = boxes;
    return place_camera(options(), Units{}, radius_about_origin(whole));
  }

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    PlayedClip played{.clip = clip_};
    if (!blob_.clips.empty()) played.time = time_of_frame(blob_.clips[clip_].instances, frame, frames);
    const auto refused = [&played](const std::string& what) {
      return Failure{ExitStatus::input, fmt::format("{} ms after its start the animation {}", played.time, what)};
    };
    if (const Status posed = pose_clips(blob_.clips, {&played, 1}, blob_.moved); !posed) {
      return refused(fmt::format("moves joint {} too far", posed.needed));
    }
    if (!pose_clips(blob_.clips, {&played, 1}, blob_.morphs)) return refused("has too large weights of morph targets");
    Result<Staging> placed =
        parts_.place({blob_.scene, chosen_camera(), animation(), turn()}, blob_.tree, frame, frames);
    if (placed && !blob_.morphs.meshes.empty()) placed->version = frame + 1;
    if (placed) placed->levels = blob_.levels;
    return placed;
  }

  std::unique_ptr<Stage> copy() const override {
    auto stage = std::make_unique<BlobStage>(bytes_);
    static_cast<void>(stage->open());  // these bytes have been opened before without an error
    stage->take_camera(*this);
    stage->clip_ = clip_;
    return stage;
  }

  /// Shows the clip of this name.
  Result<Done> choose(const std::string& name) {
    std::string names;
    for (std::size_t i = 0; i < blob_.clips.size(); ++i) {
      if (blob_.clips[i].name == name) {
        clip_ = static_cast<std::uint16_t>(i);
        return Done{};
      }
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", blob_.clips[i].name);
    }
    return Failure{ExitStatus::input, fmt::format("there is no animation '{}' in the baked scene; {}", name,
                                                  names.empty() ? "it has no names of animations" : "it has " + names)};
  }

  const std::vector<std::string>& warnings() const override { return warnings_; }
  const SceneBlob* blob() const override { return &blob_; }
  std::size_t file_bytes() const override { return bytes_.size(); }
  Animation animation() const override { return blob_.clips.empty() ? blob_.animation : blob_.clips[clip_].instances; }
  bool bends() const override {
    return (!blob_.skins.empty() && !joint_animation().tracks.empty()) || !weight_animation().tracks.empty();
  }
  Animation joint_animation() const override { return blob_.clips.empty() ? Animation{} : blob_.clips[clip_].joints; }
  std::vector<ClipEvent> events() const override {
    if (!blob_.clips.empty()) return {};
    return {blob_.events.begin(), blob_.events.end()};
  }
  WeightAnimation weight_animation() const override {
    return blob_.clips.empty() ? WeightAnimation{} : blob_.clips[clip_].weights;
  }
  /// With a camera from the options, the scene does not move if the motion is one around the blob's own camera.
  Turn turn() const override {
    if (blob_.turn.what == Turning::camera && options().placed()) return {.what = Turning::nothing};
    return blob_.turn;
  }

 private:
  Status open_with(std::size_t memory) {
    memory_.resize((memory + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    return open_scene_blob(std::as_bytes(std::span(bytes_)), std::as_writable_bytes(std::span(memory_)), blob_);
  }

  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint64_t> memory_;
  SceneBlob blob_;
  std::uint16_t clip_ = 0;
  TurnedParts parts_;
  std::vector<std::string> warnings_;
};

Result<std::unique_ptr<BlobStage>> open(const std::string& path) {
  Result<std::vector<std::uint8_t>> bytes = read_file(path);
  if (!bytes) return Failure{ExitStatus::input, fmt::format("'{}' {}", path, bytes.failure().message)};
  auto stage = std::make_unique<BlobStage>(std::move(*bytes));
  if (const Status status = stage->open(); !status) {
    return Failure{ExitStatus::input, fmt::format("'{}' {}", path, reason(status, stage->bytes()))};
  }
  return stage;
}

}  // namespace

Result<std::unique_ptr<Stage>> open_blob_stage(const std::string& path, const CameraOptions& options, const View& view,
                                               std::uint32_t frames, const std::optional<std::string>& clip) {
  Result<std::unique_ptr<BlobStage>> stage = open(path);
  if (!stage) return stage.failure();
  if (clip) {
    if (const Result<Done> chosen = (*stage)->choose(*clip); !chosen) return chosen.failure();
  }
  if (const Result<Done> camera = (*stage)->set_camera(options, view, frames); !camera) return camera.failure();
  return std::unique_ptr<Stage>(std::move(*stage));
}

Result<BakedPicture> picture_of_blob(const std::string& path) {
  const Result<std::unique_ptr<BlobStage>> stage = open(path);
  if (!stage) return stage.failure();
  return BakedPicture{(*stage)->blob()->view, (*stage)->blob()->effects};
}

}  // namespace zstrip::sim
