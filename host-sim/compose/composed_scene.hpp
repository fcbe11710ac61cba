// A scene file and all files that it names, as one scene in the renderer's formats.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compose/scene_file.hpp"
#include "import/model.hpp"
#include "motion/fitted_animation.hpp"
#include "motion/fitted_weights.hpp"
#include "result.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Distance from the origin to the farthest point in the scene's units: large enough that rotations and scales keep
/// their precision, small enough that cameras have room outside.
inline constexpr double kComposedRadius = 8;

/// Owns the data that its views refer to; must not be moved.
struct ComposedScene {
  ComposedScene() = default;
  ComposedScene(const ComposedScene&) = delete;
  ComposedScene& operator=(const ComposedScene&) = delete;

  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Instance> instances;  ///< those of the static layer first
  std::vector<Quadric> quadrics;
  std::vector<LineSet> lines;
  std::vector<Outline> outlines;
  std::vector<CsgOperand> csg;
  std::vector<DirectionalLight> lights;
  std::vector<PunctualLight> punctual_lights;
  std::vector<Finish> finishes;
  std::optional<Fog> fog;
  std::optional<Shadow> shadow;
  std::vector<OverlayImage> overlay_images;
  std::vector<Font> fonts;
  std::vector<Sprite> sprites;
  std::vector<Label> labels;
  std::optional<Overlay> overlay;
  Colour ambient, background;
  std::size_t static_instances = 0;
  FittedAnimation animation;
  Model bent;                       ///< joints, skins and morph targets of the one model that bends, whose meshes are
                                    ///< `meshes`; empty: nothing bends
  FittedAnimation joint_animation;  ///< of bent.joints; as long as `animation`
  FittedWeights weight_animation;   ///< of bent.weights; as long as `animation`
  Units units;                      ///< of the file's lengths
  std::vector<std::string> material_names;
  std::vector<std::string> material_origins;  ///< "room.toml line 12", or the model of the material
  std::string fog_origin, shadow_origin, csg_origin;
  std::vector<std::string> instance_names;  ///< of each instance: that of the file, or its model; and its node
  std::vector<std::string> warnings;

  std::deque<Model> models;
  std::deque<MeshData> scaled;         ///< normals and meshlets of meshes that are scaled unevenly
  std::deque<MeshData> hulls;          ///< of meshes with outlines
  std::deque<MeshData> line_vertices;  ///< of lines with separate vertices
  std::deque<std::vector<Segment>> segments;
  std::deque<std::vector<std::uint16_t>> texels;   ///< of textures and images that the scene file itself names
  std::deque<std::vector<std::uint8_t>> coverage;  ///< of images
  std::deque<std::string> texts;                   ///< of labels

  Scene scene() const {
    return {.meshes = meshes,
            .materials = materials,
            .textures = textures,
            .instances = instances,
            .lights = lights,
            .ambient = ambient,
            .background = background,
            .fog = fog ? &*fog : nullptr,
            .finishes = finishes,
            .punctual_lights = punctual_lights,
            .quadrics = quadrics,
            .lines = lines,
            .outlines = outlines,
            .shadow = shadow ? &*shadow : nullptr,
            .csg = csg,
            .edges = {},
            .overlay = overlay ? &*overlay : nullptr};
  }
};

/// Reads the models and textures that `file` names. Failures say the line with the error, or the file.
Result<std::unique_ptr<const ComposedScene>> compose(const SceneFile& file);

}  // namespace zstrip::sim
