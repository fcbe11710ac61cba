// The contents of a scene file (.toml), before the files that it names are read. docs/scenes.md has every key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compose/csg_expression.hpp"
#include "import/reduction.hpp"
#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "motion/node_tree.hpp"
#include "render/orbit_limits.hpp"
#include "result.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/depth_format.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The keys of [picture] for the visibility method: names as on the command line.
struct VisibilitySettings {
  std::optional<std::string> method{};
  std::optional<std::uint32_t> iterations{};
  std::optional<std::string> sort_key{};
  std::vector<std::string> cull{};    ///< empty: not given
  std::optional<std::string> sets{};  ///< a path relative to the scene file's folder, or an absolute one
};

/// [picture]: values for options that are not on the command line.
struct PictureSettings {
  std::optional<std::pair<std::uint16_t, std::uint16_t>> size;
  std::optional<PixelFormat> format;
  std::optional<bool> dither;
  std::optional<std::uint8_t> samples;  ///< 1, 2 or 4
  std::optional<bool> edges;            ///< edges of all meshes are anti-aliased
  std::optional<DepthFormat> depth_format;
  std::optional<Effects> perspective;  ///< one of effect::perspective_runs
  VisibilitySettings visibility;
  std::optional<std::uint16_t> strip_rows;
  std::optional<std::uint16_t> strip_columns;
  std::optional<std::uint32_t> ram;
  std::optional<std::uint32_t> frames;
};

/// [camera]: exactly one of `eye` and `radius` is set.
struct FileCamera {
  int line = 0;
  std::optional<Vector> eye;
  std::optional<double> radius;  ///< > 0; for spherical coordinates
  double phi = 0, theta = 90;    ///< degrees
  Vector look_at{0, 0, 0};
  Vector up{0, 1, 0};
  int projection_line = 0;  ///< line of the key that set `orthographic`
  bool orthographic = false;
  std::optional<double> field_of_view;  ///< degrees
  std::optional<double> half_height;    ///< half the height that an orthographic camera shows
  std::optional<double> near_plane, far_plane;
  OrbitLimits orbit{};  ///< without a target
};

/// A part of a [[model]]: one step of a sequence of its animations.
struct FileClip {
  int line = 0;
  std::string animation;  ///< its name in the file
  double seconds = 0;     ///< > 0; 0: as long as the animation
  double fade = 0;        ///< seconds, at most `seconds`
};

/// [[model]]: exactly one of `file` and `built_in` is set.
struct FileModel {
  int line = 0;
  std::string name;
  std::filesystem::path file;  ///< relative to the scene file's folder
  std::string built_in;
  int file_line = 0;           ///< line of `file` or `built_in`
  std::optional<UpAxis> up{};  ///< empty: the axis of the format
  std::optional<std::string> animation;
  int animation_line = 0;
  std::vector<FileClip> clips{};  ///< instead of `animation`; empty: none
  Reduction reduction{};          ///< keys `texture_size` and `triangles`
};

/// [[material]]: values that are set replace those of the model's material.
struct FileMaterial {
  int line = 0;
  std::string name;
  std::optional<Colour> colour;
  std::optional<std::filesystem::path> texture;
  bool mirrors = false;  ///< `texture` is the value of the key `environment`
  int texture_line = 0;
  std::optional<bool> lit, double_sided, depth_write;
  std::optional<Shading> smooth;  ///< value of the key `shading` or `smooth`
  std::optional<Colour> emissive, specular;
  std::optional<std::uint8_t> shininess, alpha, alpha_cutoff;  ///< alpha: of the colour
  std::optional<AlphaMode> alpha_mode;
  std::optional<TextureFilter> filter;
  std::optional<TextureFormat> palette;  ///< for `texture`: palette8 or palette4
  std::optional<bool> mipmaps;           ///< for `texture`, or else for the model's own texture
  int mipmaps_line = 0;
  std::optional<DepthTest> depth_test;
  std::optional<std::int32_t> depth_bias;
  int depth_line = 0;  ///< line of the first key about depth

  /// True if it sets values that need a Finish.
  bool has_finish() const {
    return emissive || specular || shininess || alpha_mode || alpha_cutoff || filter || palette ||
           mipmaps.value_or(false) || mirrors;
  }
};

/// A part of an [[instance]].
struct FileTurntable {
  int line = 0;
  Vector axis{0, 1, 0};
  double turns = 1;  ///< in one duration of the animation
};

/// A part of an [[instance]].
struct FileOutline {
  int line = 0;
  double width = 2;  ///< pixels
  Colour colour{0, 0, 0, 255};
};

/// [[instance]]
struct FileInstance {
  int line = 0;
  std::string name, model;
  std::string material;                                        ///< for the whole model; may be empty
  std::vector<std::pair<std::string, std::string>> materials;  ///< the model's name of a material, and its replacement
  Placement placement;
  bool is_static = false;
  Billboard billboard = Billboard::none;
  std::optional<FileOutline> outline;
  ShadowRole shadow = ShadowRole::casts_and_receives;
  std::optional<FileTurntable> turntable;
  Curve<Vector> translation, scale;  ///< keyframes; without times they keep the values of `placement`
  Curve<Quaternion> rotation;

  bool moves() const {
    return turntable.has_value() || !translation.times.empty() || !rotation.times.empty() || !scale.times.empty();
  }
};

/// A part of a directional [[light]].
struct FileShadow {
  std::uint8_t log2_size = 8;
  std::uint16_t bias = Shadow{}.bias;
  double slope_bias = 1.25;
  std::uint32_t pool = 0;  ///< bytes; 0: the worst case
};

/// [[light]]
struct FileLight {
  int line = 0;
  std::optional<PunctualLightType> punctual;  ///< empty: directional
  Vector direction{0, -1, 0};                 ///< direction in which it shines, for directional and spot lights; any
                                              ///< length except zero
  Vector position{0, 0, 0};                   ///< for point and spot lights
  Colour colour{255, 255, 255, 255};
  double intensity = 1;              ///< for point and spot lights, at distance 1; a directional light has it in its
                                     ///< colour
  double range = 0;                  ///< 0: unlimited
  double inner = 0, outer = 45;      ///< degrees from a spot's direction: fully lit within `inner`, dark outside
                                     ///< `outer`
  std::optional<FileShadow> shadow;  ///< for at most one light
};

/// [fog]; lengths and densities in the file's units.
struct FileFog {
  int line = 0;
  Colour colour{128, 128, 128, 255};
  FogMode mode = FogMode::linear;
  double start = 0, end = 0, density = 0;
};

/// [[ellipsoid]]
struct FileEllipsoid {
  int line = 0;
  std::string material;
  Placement placement;  ///< of the unit sphere
};

/// [[lines]] or [[points]]: exactly one of `model` and `vertices` is set.
struct FileLines {
  int line = 0;
  bool are_points = false;
  std::string material, model;
  std::uint8_t width = 1;
  std::vector<Vector> vertices;
  std::vector<Segment> segments;  ///< between `vertices`; a point is a segment from a vertex to itself
  Placement placement;

  const char* title() const { return are_points ? "[[points]]" : "[[lines]]"; }
};

/// [[csg]]: the names are names of instances.
struct FileCsg {
  int line = 0;
  std::vector<CsgProduct> products;
};

/// [[sprite]]
struct FileSprite {
  int line = 0;
  std::filesystem::path image;  ///< relative to the scene file's folder
  std::int16_t x = 0, y = 0;
  Colour colour{255, 255, 255, 255};
  std::uint8_t coverage_bits = 0;  ///< 0: the image's own colours and alpha
};

enum class FileFont : std::uint8_t { small, large };

/// [[label]]
struct FileLabel {
  int line = 0;
  std::string text;
  std::int16_t x = 0, y = 0;
  FileFont font = FileFont::small;
  Alignment alignment = Alignment::left;
  Colour colour{255, 255, 255, 255}, background{0, 0, 0, 0};
};

struct SceneFile {
  std::filesystem::path path;
  PictureSettings picture;
  std::optional<Colour> ambient, background;
  std::optional<double> duration;  ///< seconds, of the animation
  std::optional<FileCamera> camera;
  std::vector<FileModel> models;
  std::vector<FileMaterial> materials;
  std::vector<FileInstance> instances;
  std::vector<FileEllipsoid> ellipsoids;
  std::vector<FileLines> lines;  ///< lines, ellipsoids and instances together have at least one entry
  std::vector<FileCsg> csg;
  std::optional<FileFog> fog;
  std::vector<FileLight> lights;
  std::vector<FileSprite> sprites;
  std::vector<FileLabel> labels;
  std::vector<AnimationEvent> events;  ///< [[event]]

  /// Returns the path of a file that this file names.
  std::filesystem::path beside(const std::filesystem::path& name) const { return path.parent_path() / name; }
};

/// Returns a failure at a line of a file: "'room.toml' line 12: ...".
Failure at_line(const std::filesystem::path& path, int line, const std::string& message);
/// Returns the origin of an object of the scene: "room.toml line 12".
std::string origin_of(const std::filesystem::path& path, int line);

/// Returns the element of `names` that is most similar to `name`; empty if none is similar.
std::string nearest(const std::string& name, const std::vector<std::string>& names);

/// Checks everything that needs no other file: syntax, keys, types, ranges, references between tables.
Result<SceneFile> read_scene_file(const std::filesystem::path& path);
/// Reads a scene file from text; `path` is for messages.
Result<SceneFile> parse_scene_file(const std::string& text, const std::filesystem::path& path);

}  // namespace zstrip::sim
