// What is rendered: a built-in scene, a model file or a baked scene, placed for each frame of a turn.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "import/model.hpp"
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
  /// The imported file; null for other scenes.
  virtual const Model* model() const { return nullptr; }
};

enum class SceneKind : std::uint8_t { built_in, baked, model };

/// By the name alone: that of a built-in scene, a path that ends in .zsc, any other path.
SceneKind kind_of_scene(const std::string& name);

/// `name` as in kind_of_scene. `up`: the axis of a model file that points upwards. `frames`: a model's camera shows it
/// at every angle of a turn if there are more than one.
Result<std::unique_ptr<Stage>> open_stage(const std::string& name, UpAxis up, const CameraOptions& options,
                                          const View& view, std::uint32_t frames);

}  // namespace zstrip::sim
