// Reads a complete scene file: syntax, tables, and the references between them.
#include <toml++/toml.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "compose/csg_expression.hpp"
#include "compose/scene_file.hpp"
#include "compose/scene_tables.hpp"
#include "compose/toml_key_depth.hpp"
#include "compose/toml_table.hpp"
#include "import/read_file.hpp"
#include "motion/fitted_animation.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxBytes = 16U << 20;

/// Checks names of models or materials; each must be unique.
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

/// Refuses properties of materials that the renderer does not draw on ellipsoids.
void check_ellipsoid(const FileEllipsoid& ellipsoid, const SceneFile& scene, TomlErrors& errors) {
  const auto material = std::ranges::find(scene.materials, ellipsoid.material, &FileMaterial::name);
  if (material == scene.materials.end()) return;
  if (material->has_finish()) {
    errors.add(
        ellipsoid.line,
        fmt::format("[[ellipsoid]]: the material '{}' must do without emissive, specular, "
                    "shininess, alpha_mode, alpha_cutoff, filter, palette, mipmaps and environment: ellipsoids have "
                    "none",
                    material->name));
  }
  const bool punctual =
      std::ranges::any_of(scene.lights, [](const FileLight& light) { return light.punctual.has_value(); });
  if (punctual && material->lit.value_or(Material{}.lit)) {
    errors.add(ellipsoid.line, fmt::format("[[ellipsoid]]: point and spot lights do not reach ellipsoids; the material "
                                           "'{}' needs lit = false, or the scene only directional lights",
                                           material->name));
  }
}

/// Refuses properties of materials that the renderer does not draw on lines and points.
void check_lines(const FileLines& lines, const SceneFile& scene, TomlErrors& errors) {
  const auto material = std::ranges::find(scene.materials, lines.material, &FileMaterial::name);
  if (material == scene.materials.end() || (!material->has_finish() && !material->texture)) return;
  errors.add(lines.line,
             fmt::format("{}: the material '{}' must do without texture, environment, emissive, specular, shininess, "
                         "alpha_mode, alpha_cutoff, filter and mipmaps: lines and points have none",
                         lines.title(), material->name));
}

/// Names of instances need not be unique, except names of solids.
void check_csg(const FileCsg& csg, const SceneFile& scene, TomlTable& table) {
  std::vector<std::string> names;
  for (const FileInstance& instance : scene.instances) {
    if (!instance.name.empty()) names.push_back(instance.name);
  }
  for (const CsgProduct& product : csg.products) {
    for (const CsgTerm& term : product) {
      const auto in_quotes = std::ranges::find_if(
          names, [&](const std::string& name) { return needs_quotes(name) && name.starts_with(term.name); });
      if (in_quotes != names.end() && std::ranges::find(names, term.name) == names.end()) {
        table.wrong("expression", fmt::format("'expression' names no instance '{}'; '{}' would stand in ' ' there",
                                              term.name, *in_quotes));
      }
      check_name(term.name, names, table, "expression", "instance");
      if (std::ranges::count(names, term.name) > 1) {
        table.wrong("expression", fmt::format("there are several instances '{}'", term.name));
      }
    }
  }
}

SceneFile read_root(TomlTable& root, TomlErrors& errors) {
  SceneFile scene;
  scene.ambient = root.colour("ambient");
  scene.background = root.colour("background");
  scene.duration = root.number("duration", {0.001, kMaxAnimation});
  if (auto picture = root.table("picture", "[picture]")) scene.picture = read_picture(*picture);
  if (auto camera = root.table("camera", "[camera]")) scene.camera = read_camera(*camera);
  if (scene.camera && scene.camera->orthographic &&
      !effects_agree(depth_effect(scene.picture.depth_format.value_or(DepthFormat::z16)) | effect::orthographic)) {
    errors.add(scene.camera->projection_line,
               "[camera]: 'depth_format' of [picture] needs a perspective camera; z16 and z24 do not");
  }
  for (TomlTable& model : root.tables("model", "[[model]]")) scene.models.push_back(read_model_table(model));
  for (TomlTable& table : root.tables("material", "[[material]]")) scene.materials.push_back(read_material(table));
  std::vector<TomlTable> instances = root.tables("instance", "[[instance]]");
  for (TomlTable& table : instances) scene.instances.push_back(read_instance(table));
  std::vector<TomlTable> ellipsoids = root.tables("ellipsoid", "[[ellipsoid]]");
  for (TomlTable& table : ellipsoids) scene.ellipsoids.push_back(read_ellipsoid(table));
  std::vector<TomlTable> line_tables;
  for (const bool are_points : {false, true}) {
    for (TomlTable& table : root.tables(are_points ? "points" : "lines", are_points ? "[[points]]" : "[[lines]]")) {
      scene.lines.push_back(read_lines(table, are_points));
      line_tables.push_back(table);
    }
  }
  std::vector<TomlTable> csg_tables = root.tables("csg", "[[csg]]");
  if (csg_tables.size() > kMaxCsgOperands) {
    errors.add(csg_tables[kMaxCsgOperands].line(),
               fmt::format("more than {} [[csg]]; all of them together have {} solids at most", kMaxCsgOperands,
                           kMaxCsgOperands));
    csg_tables.clear();
  }
  for (TomlTable& table : csg_tables) scene.csg.push_back(read_csg(table));
  if (auto fog = root.table("fog", "[fog]")) scene.fog = read_fog(*fog);
  std::vector<TomlTable> lights = root.tables("light", "[[light]]");
  for (TomlTable& table : lights) scene.lights.push_back(read_light(table));
  for (TomlTable& table : root.tables("sprite", "[[sprite]]")) scene.sprites.push_back(read_sprite(table));
  for (TomlTable& table : root.tables("label", "[[label]]")) scene.labels.push_back(read_label(table));
  for (TomlTable& table : root.tables("event", "[[event]]")) scene.events.push_back(read_event(table));
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
  for (std::size_t i = 0; i < ellipsoids.size(); ++i) {
    check_name(scene.ellipsoids[i].material, materials, ellipsoids[i], "material", "material");
    check_ellipsoid(scene.ellipsoids[i], scene, errors);
  }
  for (std::size_t i = 0; i < line_tables.size(); ++i) {
    check_name(scene.lines[i].model, models, line_tables[i], "model", "model");
    check_name(scene.lines[i].material, materials, line_tables[i], "material", "material");
    check_lines(scene.lines[i], scene, errors);
  }
  for (std::size_t i = 0; i < csg_tables.size(); ++i) check_csg(scene.csg[i], scene, csg_tables[i]);
  if (instances.empty() && ellipsoids.empty() && line_tables.empty()) {
    errors.add(1,
               "the scene has neither [[instance]] nor [[ellipsoid]], [[lines]] or [[points]]: there is nothing to "
               "draw");
  }
  std::size_t directional = 0, punctual = 0;
  for (const FileLight& light : scene.lights) {
    if (++(light.punctual ? punctual : directional) > (light.punctual ? kMaxPunctualLights : kMaxLights)) {
      errors.add(light.line, "more than four directional lights, or more than four point and spot lights");
    }
  }
  return scene;
}

}  // namespace

Result<SceneFile> parse_scene_file(const std::string& text, const std::filesystem::path& path) {
  if (const std::optional<int> deep = line_of_deep_key(text)) {
    return at_line(path, *deep, fmt::format("a key has more than {} names with dots between them", kMaxKeyNames));
  }
  toml::table document;
  try {
    document = toml::parse(text);
  } catch (const toml::parse_error& error) {
    return at_line(path, static_cast<int>(error.source().begin.line), fmt::format("not TOML: {}", error.description()));
  }
  TomlErrors errors(path);
  TomlTable root(document, "a scene", errors);
  SceneFile scene = read_root(root, errors);
  if (errors.first()) return *errors.first();
  scene.path = path;
  return scene;
}

Result<SceneFile> read_scene_file(const std::filesystem::path& path) {
  const Result<std::vector<std::uint8_t>> bytes = read_file(path, kMaxBytes);
  if (!bytes) return Failure{ExitStatus::input, fmt::format("'{}' {}", path.string(), bytes.failure().message)};
  return parse_scene_file(std::string(bytes->begin(), bytes->end()), path);
}

}  // namespace zstrip::sim
