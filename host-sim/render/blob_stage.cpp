// A baked scene (.zsc) as something to render.
#include "render/blob_stage.hpp"

#include <fmt/format.h>

#include <utility>

#include "import/read_file.hpp"
#include "zstrip/scene/scene_blob.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::sim {
namespace {

std::string reason(const Status& status, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kKind = 3;
  switch (status.error) {
    case Error::blob_damaged:
      if (status.needed == kKind && bytes.size() > kKind && bytes[kKind] == 'v') {
        return "holds visible sets and no scene; name the scene, and this file with --visible-sets";
      }
      return fmt::format("is no whole baked scene (byte {}); bake it again", status.needed);
    case Error::blob_version:
      return fmt::format("is a baked scene of version {}, and this zstrip reads versions {} to {}; bake it again",
                         status.needed, kOldestSceneBlobVersion, status.available);
    default:
      return fmt::format("is a baked scene that cannot be drawn: {} (number {}); bake it again", message(status.error),
                         status.needed);
  }
}

class BlobStage : public Stage {
 public:
  explicit BlobStage(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  BlobStage(const BlobStage&) = delete;
  BlobStage& operator=(const BlobStage&) = delete;

  std::span<const std::uint8_t> bytes() const { return bytes_; }
  const View& view() const { return blob_.view; }

  Status open() {
    Status status = open_with(0);
    if (status.error == Error::blob_memory) status = open_with(status.needed);
    return status;
  }

  Result<Done> set_camera(const CameraOptions& options, const View& view) {
    const Result<Camera> camera = options.placed()
                                      ? place_camera(options, Units{}, radius_about_origin(blob_.scene))
                                      : change_projection(scenes::fit_width(blob_.camera, blob_.view, view), options);
    if (!camera) return camera.failure();
    camera_ = *camera;
    return Done{};
  }

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    instances_.assign(blob_.scene.instances.begin(), blob_.scene.instances.end());
    lines_.assign(blob_.scene.lines.begin(), blob_.scene.lines.end());
    if (!animation().tracks.empty()) {
      pose(animation(), time_of_frame(animation(), frame, frames), instances_);
    } else if (frame % frames != 0) {
      for (Instance& instance : instances_) {
        if (!scenes::can_turn(instance.transform)) {
          return Failure{ExitStatus::input, "an instance of the baked scene is too far away to turn; render one frame"};
        }
        instance.transform = scenes::turned(instance.transform, frame, frames);
      }
      for (LineSet& lines : lines_) {
        if (!scenes::can_turn(lines.transform)) {
          return Failure{ExitStatus::input, "lines of the baked scene are too far away to turn; render one frame"};
        }
        lines.transform = scenes::turned(lines.transform, frame, frames);
      }
    }
    Scene scene = blob_.scene;
    scene.instances = instances_;
    scene.lines = lines_;
    return Staging{scene, camera_, blob_.tree};
  }

  std::unique_ptr<Stage> copy() const override {
    auto stage = std::make_unique<BlobStage>(bytes_);
    static_cast<void>(stage->open());  // these bytes have been opened before
    stage->camera_ = camera_;
    return stage;
  }

  const std::vector<std::string>& warnings() const override { return warnings_; }
  Animation animation() const override { return blob_.animation; }

 private:
  Status open_with(std::size_t memory) {
    memory_.resize((memory + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    return open_scene_blob(std::as_bytes(std::span(bytes_)), std::as_writable_bytes(std::span(memory_)), blob_);
  }

  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint64_t> memory_;
  SceneBlob blob_;
  Camera camera_;
  std::vector<Instance> instances_;
  std::vector<LineSet> lines_;
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

Result<std::unique_ptr<Stage>> open_blob_stage(const std::string& path, const CameraOptions& options,
                                               const View& view) {
  Result<std::unique_ptr<BlobStage>> stage = open(path);
  if (!stage) return stage.failure();
  if (const Result<Done> camera = (*stage)->set_camera(options, view); !camera) return camera.failure();
  return std::unique_ptr<Stage>(std::move(*stage));
}

Result<View> view_of_blob(const std::string& path) {
  const Result<std::unique_ptr<BlobStage>> stage = open(path);
  if (!stage) return stage.failure();
  return (*stage)->view();
}

}  // namespace zstrip::sim
