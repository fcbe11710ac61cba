// [picture] and [camera] of a scene file.
#include <fmt/format.h>

#include "compose/perspective_runs.hpp"
#include "compose/scene_tables.hpp"
#include "compose/table_values.hpp"
#include "visibility/method_options.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

constexpr std::pair<std::string_view, PixelFormat> kFormats[] = {
    {"rgb565", PixelFormat::rgb565},    {"rgb565_swapped", PixelFormat::rgb565_swapped},
    {"gray4", PixelFormat::gray4},      {"mono", PixelFormat::mono},
    {"rgb666", PixelFormat::rgb666},    {"rgb444", PixelFormat::rgb444},
    {"xrgb8888", PixelFormat::xrgb8888}};
constexpr std::pair<std::string_view, DepthFormat> kDepthFormats[] = {
    {"z16", DepthFormat::z16}, {"float", DepthFormat::float16}, {"z24", DepthFormat::z24}};
constexpr std::pair<std::string_view, bool> kProjections[] = {{"perspective", false}, {"orthographic", true}};

VisibilitySettings read_visibility(TomlTable& table) {
  VisibilitySettings settings;
  settings.method = table.text("visibility");
  const Result<VisibilityMethod> method = parse_visibility(settings.method.value_or("zbuffer"));
  if (!method) {
    std::vector<std::string> names;
    for (const VisibilityMethod& known : visibility_methods()) names.emplace_back(known.name);
    table.wrong_name("visibility", *settings.method, "method", names);
  }
  const auto unused = [&](const char* key, const std::string& methods) {
    table.wrong(key, fmt::format("'{}' means nothing to visibility = \"{}\"; leave it out, or choose one of: {}", key,
                                 method->name, methods));
  };
  if (const auto iterations = table.integer("iterations", 0, kMaxIterations)) {
    settings.iterations = static_cast<std::uint32_t>(*iterations);
    if (method && !uses_iterations(method->effects)) unused("iterations", methods_with_iterations());
  }
  settings.sort_key = table.text("sort_key");
  if (settings.sort_key && !known_sort_key(*settings.sort_key)) {
    table.wrong("sort_key", "'sort_key' is not one of: middle, nearest, farthest");
  }
  if (settings.sort_key && method && !uses_sort_key(method->effects)) unused("sort_key", methods_with_sort_key());
  settings.cull = table.list("cull", fmt::format("one or more of: {}; or [\"none\"]", kCullWords));
  const Result<CullChoice> cull = parse_cull(settings.cull);
  if (!cull) table.wrong("cull", "'cull' " + cull.failure().message);
  if (cull && cull->temporal && method && method->effects != method::hierarchical_z) {
    table.wrong("cull", fmt::format("'cull' with temporal needs the bounds of visibility = \"hierarchical-z\", and not "
                                    "\"{}\"",
                                    method->name));
  }
  settings.sets = table.text("visible_sets");
  return settings;
}

}  // namespace

PictureSettings read_picture(TomlTable& table) {
  PictureSettings picture;
  if (const auto size = table.numbers("size", 2, {1, kMaxViewSize})) {
    picture.size = {static_cast<std::uint16_t>((*size)[0]), static_cast<std::uint16_t>((*size)[1])};
    if ((*size)[0] != picture.size->first || (*size)[1] != picture.size->second) {
      table.wrong("size", "'size' must be whole numbers");
    }
  }
  picture.format = table.choice("format", kFormats);
  picture.dither = table.flag("dither");
  if (const auto samples = table.integer("samples", 1, kMaxSamples)) {
    picture.samples = static_cast<std::uint8_t>(*samples);
    if (*samples == 3) table.wrong("samples", "'samples' must be 1, 2 or 4");
  }
  picture.edges = table.flag("edges");
  picture.depth_format = table.choice("depth_format", kDepthFormats);
  picture.perspective = table.choice("perspective", kPerspectiveRuns);
  picture.visibility = read_visibility(table);
  const auto pixels = [&table](const char* key) -> std::optional<std::uint16_t> {
    const auto value = table.integer(key, 1, kMaxViewSize);
    return value ? std::optional(static_cast<std::uint16_t>(*value)) : std::nullopt;
  };
  picture.strip_rows = pixels("strip_rows");
  picture.strip_columns = pixels("strip_columns");
  if (const auto ram = table.integer("ram", 1, 0xFFFFFFFF)) picture.ram = static_cast<std::uint32_t>(*ram);
  if (const auto frames = table.integer("frames", 1, 10000)) picture.frames = static_cast<std::uint32_t>(*frames);
  table.finish();
  return picture;
}

AnimationEvent read_event(TomlTable& table) {
  AnimationEvent event;
  for (const char* key : {"time", "number"}) {
    if (!table.has(key)) table.wrong(key, fmt::format("'{}' is missing", key));
  }
  event.seconds = table.number("time", {0, 3600}).value_or(0);
  event.number = static_cast<std::uint16_t>(table.integer("number", 0, 0xFFFF).value_or(0));
  table.finish();
  return event;
}

OrbitLimits read_orbit(TomlTable& table) {
  OrbitLimits orbit;
  const auto read = [&table](const char* key, const Limits& limits, double place, OrbitLimits::Range& range) {
    const auto numbers = table.numbers(key, 2, limits);
    if (!numbers) return;
    range = {(*numbers)[0], (*numbers)[1]};
    if (range.least <= place && place <= range.most) return;
    table.wrong(key,
                fmt::format("'{}' must be the least and the most, and {} between them: the file's camera", key, place));
  };
  read("yaw", {-180, 180}, 0, orbit.yaw);
  read("pitch", {-180, 180}, 0, orbit.pitch);
  read("distance", {0.01, 100}, 1, orbit.distance);
  table.finish();
  return orbit;
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
  if (auto orbit = table.table("orbit", "[camera.orbit]")) camera.orbit = read_orbit(*orbit);
  table.finish();
  return camera;
}

}  // namespace zstrip::sim
