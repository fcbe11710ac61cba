// What is rendered: a built-in scene, a scene file, a model file or a baked scene, placed for each frame of a turn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bake/effects_found.hpp"
#include "import/model.hpp"
#include "render/camera.hpp"
#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// One frame: views of what the stage owns, valid until the stage is placed again.
struct Staging {
  Scene scene;
  Camera camera;
  BspTree tree{};          ///< of method::bsp, where one was baked for the scene
  std::size_t splits = 0;  ///< triangles that were split for it
};

class Stage {
 public:
  virtual ~Stage() = default;
  /// Frame `frame` of `frames` that show the scene's animation once, or without one a full turn, with the camera for as
  /// many frames as the stage was opened for.
  virtual Result<Staging> place(std::uint32_t frame, std::uint32_t frames) = 0;
  /// The camera of frame 0 if the stage were opened for so many frames.
  virtual Result<Camera> camera(std::uint32_t frames) const = 0;
  /// Another stage of the same scene, to be placed on another thread; it shares what does not move.
  virtual std::unique_ptr<Stage> copy() const = 0;
  /// What the picture lacks, one line each.
  virtual const std::vector<std::string>& warnings() const = 0;
  /// What moves the instances; without tracks where nothing does. Valid as long as the stage.
  virtual Animation animation() const { return {}; }
  /// Whether meshes differ from frame to frame.
  virtual bool bends() const { return false; }
  /// What moves the joints of model()'s skins, if so. Likewise.
  virtual Animation joint_animation() const { return {}; }
  /// What moves without them.
  virtual Turn turn() const = 0;
  /// Where what calls for effects stands, and the names of materials.
  virtual Origins origins() const { return {}; }
  /// The imported file; null for other scenes.
  virtual const Model* model() const { return nullptr; }
};

/// Of all frames: the scene's animation, or else a turn, which has no time of its own.
std::uint32_t milliseconds_of(const Stage& stage);

enum class SceneKind : std::uint8_t { built_in, baked, composed, model };

/// By the name alone: that of a built-in scene, a path that ends in .zsc, one that ends in .toml, any other path.
SceneKind kind_of_scene(const std::string& name);

/// How a model file is read.
struct ModelOptions {
  std::optional<UpAxis> up{};              ///< the axis that points upwards; empty: as the format says
  std::optional<std::string> animation{};  ///< its name; empty: the first, if there is one
  Highlights highlights = Highlights::none;
};

/// `name` as in kind_of_scene. `frames`: a model's camera shows it at every angle of a turn if there are more than one.
Result<std::unique_ptr<Stage>> open_stage(const std::string& name, const ModelOptions& model,
                                          const CameraOptions& options, const View& view, std::uint32_t frames);

}  // namespace zstrip::sim
