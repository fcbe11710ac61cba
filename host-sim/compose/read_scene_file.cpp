// The keys of a scene file, table by table; docs/scenes.md describes them.
#include <toml++/toml.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compose/scene_file.hpp"
#include "compose/toml_table.hpp"
#include "import/read_file.hpp"
#include "motion/fitted_animation.hpp"

namespace zstrip::sim {
namespace {

constexpr Limits kLength{-1e9, 1e9};
constexpr Limits kPositive{1e-9, 1e9};
constexpr Limits kDegrees{-36000, 36000};
constexpr std::size_t kMostBytes = 16U << 20;

constexpr std::pair<std::string_view, PixelFormat> kFormats[] = {{"rgb565", PixelFormat::rgb565},
                                                                 {"rgb565_swapped", PixelFormat::rgb565_swapped},
                                                                 {"gray4", PixelFormat::gray4},
                                                                 {"mono", PixelFormat::mono}};
constexpr std::pair<std::string_view, DepthFormat> kDepthFormats[] = {{"z16", DepthFormat::z16},
                                                                      {"float", DepthFormat::float16},
                                                                      {"w16", DepthFormat::w16},
                                                                      {"z24", DepthFormat::z24},
                                                                      {"z32", DepthFormat::z32}};
constexpr std::pair<std::string_view, UpAxis> kAxes[] = {{"x", UpAxis::plus_x}, {"-x", UpAxis::minus_x},
                                                         {"y", UpAxis::plus_y}, {"-y", UpAxis::minus_y},
                                                         {"z", UpAxis::plus_z}, {"-z", UpAxis::minus_z}};
constexpr std::pair<std::string_view, bool> kProjections[] = {{"perspective", false}, {"orthographic", true}};
constexpr std::pair<std::string_view, bool> kLayers[] = {{"static", true}, {"moving", false}};
constexpr std::pair<std::string_view, Interpolation> kInterpolations[] = {{"linear", Interpolation::linear},
                                                                          {"step", Interpolation::step}};
constexpr std::pair<std::string_view, DepthTest> kDepthTests[] = {{"never", DepthTest::never},
                                                                  {"nearer", DepthTest::nearer},
                                                                  {"equal", DepthTest::equal},
                                                                  {"farther", DepthTest::farther},
                                                                  {"not_equal", DepthTest::not_equal},
                                                                  {"always", DepthTest::always},
                                                                  {"nearer_or_equal", DepthTest::nearer_or_equal},
                                                                  {"farther_or_equal", DepthTest::farther_or_equal}};

void read_picture(TomlTable& table, PictureSettings& picture) {
  if (const auto size = table.numbers("size", 2, {1, kMaxViewSize})) {
    picture.size = {static_cast<std::uint16_t>((*size)[0]), static_cast<std::uint16_t>((*size)[1])};
  }
  picture.format = table.choice("format", kFormats);
  picture.depth_format = table.choice("depth_format", kDepthFormats);
  const auto pixels = [&table](const char* key) -> std::optional<std::uint16_t> {
    const auto value = table.integer(key, 1, kMaxViewSize);
    return value ? std::optional(static_cast<std::uint16_t>(*value)) : std::nullopt;
  };
  picture.strip_rows = pixels("strip_rows");
  picture.strip_columns = pixels("strip_columns");
  if (const auto ram = table.integer("ram", 1, 0xFFFFFFFF)) picture.ram = static_cast<std::uint32_t>(*ram);
  if (const auto frames = table.integer("frames", 1, 10000)) picture.frames = static_cast<std::uint32_t>(*frames);
  table.finish();
}

/// A direction in which one can look, shine or turn.
void check_direction(TomlTable& table, const char* key, const Vector& direction) {
  if (std::ranges::all_of(direction, [](double c) { return std::abs(c) < 1e-9; })) {
    table.wrong(key, fmt::format("'{}' must have a length", key));
  }
}

FileCamera read_camera(TomlTable& table) {
  FileCamera camera;
  camera.line = table.line();
  camera.eye = table.vector("eye", kLength);
  camera.radius = table.number("r", kPositive);
  if (camera.eye.has_value() == camera.radius.has_value()) {
    table.wrong("eye", "give either 'eye' (a point) or 'r', 'phi' and 'theta' (a sphere around 'look_at')");
  }
  camera.phi = table.number("phi", kDegrees).value_or(camera.phi);
  camera.theta = table.number("theta", kDegrees).value_or(camera.theta);
  camera.look_at = table.vector("look_at", kLength).value_or(camera.look_at);
  camera.up = table.vector("up", kLength).value_or(camera.up);
  if (camera.eye) {
    for (const char* key : {"phi", "theta"}) {
      if (table.has(key)) table.wrong(key, fmt::format("'{}' goes with 'r', not with 'eye'", key));
    }
    Vector towards{};
    for (std::size_t i = 0; i < 3; ++i) towards[i] = camera.look_at[i] - (*camera.eye)[i];
    if (towards == Vector{}) table.wrong("eye", "'eye' and 'look_at' must be different points");
  } else if (table.has("up")) {
    table.wrong("up", "'up' goes with 'eye': a spherical camera's comes from 'phi'");
  }
  check_direction(table, "up", camera.up);
  camera.orthographic = table.choice("projection", kProjections).value_or(false);
  camera.projection_line = table.line_of("projection");
  camera.field_of_view = table.number("field_of_view", {1, 170});
  camera.half_height = table.number("half_height", kPositive);
  if (camera.half_height && !camera.orthographic) {
    table.wrong("half_height", "'half_height' goes with projection = \"orthographic\"");
  }
  camera.near_plane = table.number("near", kPositive);
  camera.far_plane = table.number("far", kPositive);
  if (camera.near_plane && camera.far_plane && *camera.near_plane >= *camera.far_plane) {
    table.wrong("near", "'near' must be less than 'far'");
  }
  table.finish();
  return camera;
}

FileModel read_model_table(TomlTable& table) {
  FileModel model;
  model.line = table.line();
  model.name = table.text("name").value_or("");
  model.file = table.text("file").value_or("");
  model.built_in = table.text("built_in").value_or("");
  if (!table.has("name")) table.wrong("name", "'name' is missing; instances refer to it");
  if (table.has("file") == table.has("built_in")) table.wrong("file", "give either 'file' or 'built_in'");
  model.up = table.choice("up", kAxes).value_or(UpAxis::plus_y);
  model.animation = table.text("animation");
  for (const char* key : {"up", "animation"}) {
    if (table.has("built_in") && table.has(key)) table.wrong(key, fmt::format("'{}' goes with 'file'", key));
  }
  table.finish();
  return model;
}

FileMaterial read_material(TomlTable& table) {
  FileMaterial material;
  material.line = table.line();
  material.name = table.text("name").value_or("");
  if (!table.has("name")) table.wrong("name", "'name' is missing; instances refer to it");
  material.colour = table.colour("colour");
  if (const auto texture = table.text("texture")) material.texture = *texture;
  material.texture_line = table.line_of("texture");
  material.lit = table.flag("lit");
  material.smooth = table.flag("smooth");
  material.double_sided = table.flag("double_sided");
  material.depth_test = table.choice("depth_test", kDepthTests);
  material.depth_write = table.flag("depth_write");
  if (const auto bias = table.integer("depth_bias", -65535, 65535)) {
    material.depth_bias = static_cast<std::int32_t>(*bias);
  }
  for (const char* key : {"depth_bias", "depth_write", "depth_test"}) {
    if (table.has(key)) material.depth_line = table.line_of(key);
  }
  table.finish();
  return material;
}

/// Degrees about x, y and z, or a quaternion.
std::optional<Quaternion> read_rotation(TomlTable& table) {
  const auto degrees = table.vector("rotation", kDegrees);
  const auto numbers = table.numbers("quaternion", 4, {-1, 1});
  if (degrees && numbers) table.wrong("quaternion", "give either 'rotation' or 'quaternion'");
  if (!numbers) return degrees ? std::optional(from_degrees(*degrees)) : std::nullopt;
  const Quaternion quaternion{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
  if (std::ranges::all_of(quaternion, [](double c) { return std::abs(c) < 1e-6; })) {
    table.wrong("quaternion", "'quaternion' must have a length");
    return std::nullopt;
  }
  return unit(quaternion);
}

template <typename Value>
void add_key(Curve<Value>& curve, double time, const std::optional<Value>& value) {
  if (!value) return;
  curve.times.push_back(time);
  curve.values.push_back(*value);
}

void read_keyframes(TomlTable& table, FileInstance& instance) {
  const Interpolation interpolation = table.choice("interpolation", kInterpolations).value_or(Interpolation::linear);
  double last = -1;
  for (TomlTable& keyframe : table.tables("keyframe", "[[instance.keyframe]]")) {
    if (!keyframe.has("time")) keyframe.wrong("time", "'time' is missing");
    const double time = keyframe.number("time", {0, kLongestAnimation}).value_or(last + 1);
    if (time <= last) keyframe.wrong("time", "'time' must be greater than in the keyframe before");
    last = time;
    add_key(instance.translation, time, keyframe.vector("translation", kLength));
    add_key(instance.rotation, time, read_rotation(keyframe));
    add_key(instance.scale, time, keyframe.number_or_vector("scale", kPositive));
    keyframe.finish();
  }
  instance.translation.interpolation = interpolation;
  instance.rotation.interpolation = interpolation;
  instance.scale.interpolation = interpolation;
}

FileInstance read_instance(TomlTable& table) {
  FileInstance instance;
  instance.line = table.line();
  instance.name = table.text("name").value_or("");
  instance.model = table.text("model").value_or("");
  if (!table.has("model")) table.wrong("model", "'model' is missing");
  instance.material = table.text("material").value_or("");
  instance.materials = table.texts("materials");
  instance.placement.translation = table.vector("translation", kLength).value_or(Vector{0, 0, 0});
  instance.placement.rotation = read_rotation(table).value_or(Quaternion{0, 0, 0, 1});
  instance.placement.scale = table.number_or_vector("scale", kPositive).value_or(Vector{1, 1, 1});
  instance.is_static = table.choice("layer", kLayers).value_or(false);
  if (auto turntable = table.table("turntable", "[instance.turntable]")) {
    instance.turntable.emplace();
    instance.turntable->line = table.line_of("turntable");
    instance.turntable->axis = turntable->vector("axis", kLength).value_or(Vector{0, 1, 0});
    check_direction(*turntable, "axis", instance.turntable->axis);
    instance.turntable->turns = turntable->number("turns", {-1000, 1000}).value_or(1);
    turntable->finish();
  }
  read_keyframes(table, instance);
  if (instance.is_static && instance.moves()) {
    table.wrong("layer", "what lies in the static layer cannot have keyframes or a turntable");
  }
  table.finish();
  return instance;
}

FileLight read_light(TomlTable& table) {
  FileLight light;
  light.line = table.line();
  if (!table.has("direction")) table.wrong("direction", "'direction' is missing: in which the light shines");
  light.direction = table.vector("direction", kLength).value_or(light.direction);
  check_direction(table, "direction", light.direction);
  light.colour = table.colour("colour").value_or(light.colour);
  const double intensity = table.number("intensity", {0, 1}).value_or(1);
  for (std::uint8_t* channel : {&light.colour.r, &light.colour.g, &light.colour.b}) {
    *channel = static_cast<std::uint8_t>(std::lround(*channel * intensity));
  }
  table.finish();
  return light;
}

/// Names of models or materials; each may be there once.
template <typename Entry>
std::vector<std::string> names_of(const std::vector<Entry>& entries, const char* what, TomlErrors& errors) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const Entry& entry : entries) {
    if (!known.insert(entry.name).second) errors.add(entry.line, fmt::format("a second {} '{}'", what, entry.name));
    names.push_back(entry.name);
  }
  return names;
}

void check_name(const std::string& name, const std::vector<std::string>& names, TomlTable& table, const char* key,
                const char* what) {
  if (!name.empty() && std::ranges::find(names, name) == names.end()) table.wrong_name(key, name, what, names);
}

SceneFile read_root(TomlTable& root, TomlErrors& errors) {
  SceneFile scene;
  scene.ambient = root.colour("ambient");
  scene.background = root.colour("background");
  scene.duration = root.number("duration", {0.001, kLongestAnimation});
  if (auto picture = root.table("picture", "[picture]")) read_picture(*picture, scene.picture);
  if (auto camera = root.table("camera", "[camera]")) scene.camera = read_camera(*camera);
  for (TomlTable& model : root.tables("model", "[[model]]")) scene.models.push_back(read_model_table(model));
  for (TomlTable& table : root.tables("material", "[[material]]")) scene.materials.push_back(read_material(table));
  std::vector<TomlTable> instances = root.tables("instance", "[[instance]]");
  for (TomlTable& table : instances) scene.instances.push_back(read_instance(table));
  std::vector<TomlTable> lights = root.tables("light", "[[light]]");
  for (TomlTable& table : lights) scene.lights.push_back(read_light(table));
  root.finish();

  const std::vector<std::string> models = names_of(scene.models, "model", errors);
  const std::vector<std::string> materials = names_of(scene.materials, "material", errors);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    check_name(scene.instances[i].model, models, instances[i], "model", "model");
    check_name(scene.instances[i].material, materials, instances[i], "material", "material");
    for (const auto& [own, other] : scene.instances[i].materials) {
      check_name(other, materials, instances[i], "materials", "material");
    }
  }
  if (instances.empty()) errors.add(1, "the scene has no [[instance]]: there is nothing to draw");
  if (lights.size() > kMaxLights) {
    errors.add(lights[kMaxLights].line(), fmt::format("more than {} lights", kMaxLights));
  }
  return scene;
}

}  // namespace

Result<SceneFile> parse_scene_file(const std::string& text, const std::filesystem::path& path) {
  toml::table document;
  try {
    document = toml::parse(text);
  } catch (const toml::parse_error& error) {
    return at_line(path, static_cast<int>(error.source().begin.line), std::string(error.description()));
  }
  TomlErrors errors(path);
  TomlTable root(document, "a scene", errors);
  SceneFile scene = read_root(root, errors);
  if (errors.first()) return *errors.first();
  scene.path = path;
  return scene;
}

Result<SceneFile> read_scene_file(const std::filesystem::path& path) {
  const Result<std::vector<std::uint8_t>> bytes = read_file(path);
  if (!bytes) return Failure{ExitStatus::input, fmt::format("'{}' {}", path.string(), bytes.failure().message)};
  if (bytes->size() > kMostBytes) {
    return Failure{ExitStatus::input, fmt::format("'{}' is no scene file: it has more than 16 MB", path.string())};
  }
  return parse_scene_file(std::string(bytes->begin(), bytes->end()), path);
}

}  // namespace zstrip::sim
