// What is rendered: a built-in scene or a model file, placed for each frame of a turn.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/camera.hpp"
#include "result.hpp"
#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/scene/view.hpp"

namespace zstrip::sim {

/// One frame: views of what the stage owns, valid until the stage is placed again.
struct Staging {
  Scene scene;
  Camera camera;
};

class Stage {
 public:
  virtual ~Stage() = default;
  /// Frame `frame` of a full turn in `frames` frames.
  virtual Result<Staging> place(std::uint32_t frame, std::uint32_t frames) = 0;
  /// Another stage of the same scene, to be placed on another thread; it shares what does not move.
  virtual std::unique_ptr<Stage> copy() const = 0;
  /// What the picture lacks, one line each.
  virtual const std::vector<std::string>& warnings() const = 0;
};

/// `name` is that of a built-in scene, or else the path of a model file, whose axis `up` points upwards.
Result<std::unique_ptr<Stage>> open_stage(const std::string& name, UpAxis up, const CameraOptions& options,
                                          const View& view, std::uint32_t frames);

}  // namespace zstrip::sim
