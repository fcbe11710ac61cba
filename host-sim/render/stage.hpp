// The scene that is rendered: a built-in scene, a scene file, a model file or a baked scene, placed for each frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bake/effects_found.hpp"
#include "import/model.hpp"
#include "render/camera.hpp"
#include "render/default_look.hpp"
#include "render/model_clip.hpp"
#include "render/orbit_limits.hpp"
#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// One frame: views of memory that the stage owns, valid until the stage is placed again.
struct Staging {
  Scene scene;
  Camera camera;
  BspTree tree{};                 ///< for method::bsp, if one was baked for the scene
  std::size_t splits = 0;         ///< triangles that were split for the tree
  std::uint32_t version = 0;      ///< differs if the contents of a mesh's tables may differ (zstrip/fingerprints.hpp)
  std::size_t bent_vertices = 0;  ///< vertices of skins that were moved for this frame
  std::span<const DetailLevel> levels{};  ///< levels of detail, which FrameRenderer chooses: the instances have their
                                          ///< own meshes
};

class Stage {
 public:
  virtual ~Stage() = default;
  /// Places frame `frame` of `frames` frames that show the scene's animation once, or without one a rotation by 360
  /// degrees. The camera is the one for as many frames as the stage was opened for.
  virtual Result<Staging> place(std::uint32_t frame, std::uint32_t frames) = 0;
  /// Returns the camera of frame 0 if the stage were opened for so many frames.
  virtual Result<Camera> camera(std::uint32_t frames) const = 0;
  /// Returns another stage of the same scene, for another thread; both share the parts that do not move.
  virtual std::unique_ptr<Stage> copy() const = 0;
  /// Returns the features that are missing in the picture, one line each.
  virtual const std::vector<std::string>& warnings() const = 0;
  /// Returns the motion of the instances; it has no tracks if none moves. Valid as long as the stage.
  virtual Animation animation() const { return {}; }
  /// True if meshes differ from frame to frame.
  virtual bool bends() const { return false; }
  /// Returns the model of the meshes that bend: its skins, morph targets and joints; null if nothing can bend.
  virtual const Model* bent() const { return model(); }
  /// Returns the motion of the joints of bent()'s skins, if they move. Valid as long as the stage.
  virtual Animation joint_animation() const { return {}; }
  /// Returns the animations that a blob keeps, those of a model file that move something: the chosen one, or all.
  virtual Result<std::vector<ModelClip>> clips() const { return std::vector<ModelClip>(); }
  /// Returns the motion of the weights of bent()'s morph targets, if they move. Valid as long as the stage.
  virtual WeightAnimation weight_animation() const { return {}; }
  /// Returns the events of animation(), as those of clip 0.
  virtual std::vector<ClipEvent> events() const { return {}; }
  /// Returns how far the user may move the camera.
  virtual OrbitLimits orbit_limits() const { return {}; }
  /// Returns the motion for scenes without an animation.
  virtual Turn turn() const = 0;
  /// Returns the places in the file that need effects, and the names of materials.
  virtual Origins origins() const { return {}; }
  /// Returns the imported file; null for other scenes.
  virtual const Model* model() const { return nullptr; }
  /// Returns the baked scene; null for other scenes.
  virtual const SceneBlob* blob() const { return nullptr; }
  /// Returns the size of the baked scene's file; 0 for other scenes, and for those that have more than the file.
  virtual std::size_t file_bytes() const { return 0; }
};

/// Returns the duration of all frames: of the scene's animation, or else of a rotation, which has a default duration.
std::uint32_t milliseconds_of(const Stage& stage);

enum class SceneKind : std::uint8_t { built_in, baked, composed, model };

/// Returns the kind of a scene from its name alone: a built-in scene's name, a path that ends in .zsc or in .toml, or
/// any other path.
SceneKind kind_of_scene(const std::string& name);

/// Options for reading a model file.
struct ModelOptions {
  std::optional<UpAxis> up{};              ///< the axis that points upwards; empty: the format's axis
  std::optional<std::string> animation{};  ///< its name; empty: the first one, if there is one
  Highlights highlights = Highlights::none;
  MaterialStyle style = MaterialStyle::plain;
  Reduction reduction{};
  DefaultLook look{};  ///< of a model; lights of its file take the place of the look's
};

/// `name` as in kind_of_scene. `frames`: if there is more than one, a model's camera shows the model at every angle of
/// a rotation.
Result<std::unique_ptr<Stage>> open_stage(const std::string& name, const ModelOptions& model,
                                          const CameraOptions& options, const View& view, std::uint32_t frames);

}  // namespace zstrip::sim
