// Stages whose camera is set by the command's options.
#pragma once

#include <cstdint>

#include "render/stage.hpp"

namespace zstrip::sim {

class CameraStage : public Stage {
 public:
  /// Sets the camera of pictures with `view`, for so many frames. Failures: those of camera().
  Result<Done> set_camera(const CameraOptions& options, const View& view, std::uint32_t frames) {
    options_ = options;
    view_ = view;
    const Result<Camera> chosen = camera(frames);
    if (!chosen) return chosen.failure();
    camera_ = *chosen;
    return Done{};
  }

 protected:
  /// Copies the camera, for copies of the stage.
  void take_camera(const CameraStage& other) {
    options_ = other.options_;
    view_ = other.view_;
    camera_ = other.camera_;
  }
  const CameraOptions& options() const { return options_; }
  const View& view() const { return view_; }
  const Camera& chosen_camera() const { return camera_; }

 private:
  CameraOptions options_;
  View view_{};
  Camera camera_;
};

}  // namespace zstrip::sim
