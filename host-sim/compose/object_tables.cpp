// The objects of a scene file: [[model]], [[instance]] with its keyframes, [[ellipsoid]], [[lines]] and [[points]],
// [[csg]].
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "compose/scene_tables.hpp"
#include "compose/table_values.hpp"
#include "image/resample.hpp"
#include "motion/fitted_animation.hpp"

namespace zstrip::sim {
namespace {

constexpr std::pair<std::string_view, UpAxis> kAxes[] = {{"x", UpAxis::plus_x}, {"-x", UpAxis::minus_x},
                                                         {"y", UpAxis::plus_y}, {"-y", UpAxis::minus_y},
                                                         {"z", UpAxis::plus_z}, {"-z", UpAxis::minus_z}};
constexpr std::pair<std::string_view, Billboard> kBillboards[] = {{"viewer", Billboard::viewer},
                                                                  {"upright", Billboard::upright}};
constexpr std::pair<std::string_view, ShadowRole> kShadowRoles[] = {{"both", ShadowRole::casts_and_receives},
                                                                    {"casts", ShadowRole::only_casts},
                                                                    {"receives", ShadowRole::only_receives},
                                                                    {"none", ShadowRole::none}};
constexpr std::pair<std::string_view, bool> kLayers[] = {{"static", true}, {"moving", false}};
constexpr std::pair<std::string_view, Interpolation> kInterpolations[] = {{"linear", Interpolation::linear},
                                                                          {"step", Interpolation::step}};

constexpr int kMaxTriangleLimit = 1'000'000'000;
constexpr double kFade = 0.25;  // seconds, from one clip to the next

template <typename Value>
void add_key(Curve<Value>& curve, double time, const std::optional<Value>& value) {
  if (!value) return;
  curve.times.push_back(time);
  curve.values.push_back(*value);
}

/// Refuses a rotation of an instance or of its keyframe.
void refuse_rotation(TomlTable& table, Billboard billboard) {
  if (billboard != Billboard::viewer) return;
  for (const char* key : {"rotation", "quaternion"}) {
    if (table.has(key)) table.wrong(key, "a billboard that faces the viewer has no rotation of its own");
  }
}

void read_keyframes(TomlTable& table, FileInstance& instance) {
  const Interpolation interpolation = table.choice("interpolation", kInterpolations).value_or(Interpolation::linear);
  double last = -1;
  for (TomlTable& keyframe : table.tables("keyframe", "[[instance.keyframe]]")) {
    if (!keyframe.has("time")) keyframe.wrong("time", "'time' is missing");
    const double time = keyframe.number("time", {0, kMaxAnimation}).value_or(last + 1);
    if (time <= last) keyframe.wrong("time", "'time' must be greater than in the keyframe before");
    last = time;
    refuse_rotation(keyframe, instance.billboard);
    add_key(instance.translation, time, keyframe.vector("translation", kLength));
    add_key(instance.rotation, time, read_rotation(keyframe));
    add_key(instance.scale, time, keyframe.number_or_vector("scale", kPositive));
    keyframe.finish();
  }
  instance.translation.interpolation = interpolation;
  instance.rotation.interpolation = interpolation;
  instance.scale.interpolation = interpolation;
}

}  // namespace

FileModel read_model_table(TomlTable& table) {
  FileModel model;
  model.line = table.line();
  model.name = table.needed_text("name", "'name' is missing; instances refer to it");
  model.file = table.text("file").value_or("");
  model.built_in = table.text("built_in").value_or("");
  model.file_line = table.line_of(table.has("file") ? "file" : "built_in");
  if (table.has("file") == table.has("built_in")) table.wrong("file", "give either 'file' or 'built_in'");
  model.up = table.choice("up", kAxes);
  model.animation = table.text("animation");
  model.animation_line = table.line_of("animation");
  for (TomlTable& clip : table.tables("clip", "[[model.clip]]")) {
    FileClip& step = model.clips.emplace_back();
    step.line = clip.line();
    step.animation = clip.needed_text("animation", "'animation' is missing: the name of one of the file");
    step.seconds = clip.number("seconds", {0.01, kMaxAnimation}).value_or(0);
    step.fade = clip.number("fade", {0, kMaxAnimation}).value_or(kFade);
    clip.finish();
  }
  if (table.has("clip") && table.has("animation")) table.wrong("animation", "give either 'animation' or 'clip'");
  if (const auto side = table.integer("texture_size", 0, kMaxTextureSide)) {
    model.reduction.texture_side = static_cast<std::uint32_t>(*side);
    model.reduction.fold_textures = *side == 0;
    if (*side != 0 && !std::has_single_bit(model.reduction.texture_side)) {
      table.wrong("texture_size", "'texture_size' must be 0 or a power of two");
    }
  }
  if (const auto triangles = table.integer("triangles", 1, kMaxTriangleLimit)) {
    model.reduction.triangles = static_cast<std::uint64_t>(*triangles);
  }
  for (const char* key : {"up", "animation", "clip", "texture_size", "triangles"}) {
    if (table.has("built_in") && table.has(key)) table.wrong(key, fmt::format("'{}' goes with 'file'", key));
  }
  table.finish();
  return model;
}

FileInstance read_instance(TomlTable& table) {
  FileInstance instance;
  instance.line = table.line();
  instance.name = table.text("name").value_or("");
  instance.model = table.needed_text("model", "'model' is missing");
  instance.material = table.text("material").value_or("");
  instance.materials = table.texts("materials");
  instance.placement = read_placement(table, "scale");
  instance.is_static = table.choice("layer", kLayers).value_or(false);
  instance.billboard = table.choice("billboard", kBillboards).value_or(Billboard::none);
  refuse_rotation(table, instance.billboard);
  if (instance.billboard != Billboard::none && table.has("turntable")) {
    table.wrong("turntable", "a billboard rotates with the camera: it has no 'turntable'");
  }
  if (auto outline = table.table("outline", "[instance.outline]")) {
    instance.outline.emplace();
    instance.outline->line = table.line_of("outline");
    instance.outline->width = outline->number("width", {1.0 / 16, kMaxOutlineWidth / 16.0}).value_or(2);
    instance.outline->colour = outline->colour("colour").value_or(Colour{0, 0, 0, 255});
    outline->finish();
  }
  instance.shadow = table.choice("shadow", kShadowRoles).value_or(ShadowRole::casts_and_receives);
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
    table.wrong("layer", "an instance of the static layer cannot have keyframes or a turntable");
  }
  table.finish();
  return instance;
}

FileEllipsoid read_ellipsoid(TomlTable& table) {
  FileEllipsoid ellipsoid;
  ellipsoid.line = table.line();
  ellipsoid.material = table.needed_text("material", "'material' is missing");
  ellipsoid.placement = read_placement(table, "radius");
  table.finish();
  return ellipsoid;
}

FileLines read_lines(TomlTable& table, bool are_points) {
  constexpr std::size_t kMaxVertices = 65535;
  FileLines lines;
  lines.line = table.line();
  lines.are_points = are_points;
  lines.material = table.needed_text("material", "'material' is missing");
  lines.width = static_cast<std::uint8_t>(table.integer("width", 1, kMaxLineWidth).value_or(1));
  lines.model = table.text("model").value_or("");
  for (const std::vector<double>& v : table.rows("vertices", 3, kLength)) lines.vertices.push_back({v[0], v[1], v[2]});
  if (table.has("model") == table.has("vertices")) table.wrong("vertices", "give either 'model' or 'vertices'");
  if (lines.vertices.size() > kMaxVertices) {
    table.wrong("vertices", "'vertices' must be 65,535 at most");
    lines.vertices.clear();
  }
  const auto count = static_cast<double>(lines.vertices.size());
  const auto join = [&lines](double a, double b) {
    lines.segments.push_back({static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)});
  };
  if (are_points) {
    for (double i = 0; i < count; ++i) join(i, i);
  } else if (table.has("segments")) {
    if (!table.has("vertices")) table.wrong("segments", "'segments' goes with 'vertices'");
    for (const std::vector<double>& segment : table.rows("segments", 2, {0, std::max(count - 1, 0.0)})) {
      if (segment[0] != std::floor(segment[0]) || segment[1] != std::floor(segment[1]) || segment[0] == segment[1]) {
        table.wrong("segments", "'segments' must be pairs of two different vertices, counted from 0");
      }
      join(segment[0], segment[1]);
    }
  } else {
    if (table.has("vertices") && count < 2) table.wrong("vertices", "'vertices' must be two or more");
    for (double i = 0; i + 1 < count; ++i) join(i, i + 1);
  }
  lines.placement = read_placement(table, "scale");
  table.finish();
  return lines;
}

FileCsg read_csg(TomlTable& table) {
  FileCsg csg;
  csg.line = table.line_of("expression");
  const std::string expression = table.needed_text("expression", "'expression' is missing");
  if (!expression.empty()) {
    auto products = products_of(expression);
    if (const auto* const wrong = std::get_if<std::string>(&products)) {
      table.wrong("expression", fmt::format("'expression' is not one: {}", *wrong));
    } else {
      csg.products = std::get<std::vector<CsgProduct>>(products);
      for (const std::string& name : names_without_effect(expression)) {
        table.wrong("expression", fmt::format("'expression' is the same without '{}': leave it out", name));
      }
    }
  }
  table.finish();
  return csg;
}

}  // namespace zstrip::sim
