// Scene files: any text is a scene all of whose values are in the documented ranges, or a failure that names its line.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "compose/scene_file.hpp"
#include "require.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::sim;

template <typename Value>
void judge_curve(const Curve<Value>& curve) {
  fuzz::require(curve.times.size() == curve.values.size(), "a value at each time");
  fuzz::require(std::ranges::adjacent_find(curve.times, std::greater_equal{}) == curve.times.end(), "times grow");
}

void judge_placement(const Placement& placement) {
  double square = 0;
  for (const double component : placement.rotation) square += component * component;
  fuzz::require(std::abs(square - 1) < 1e-9, "rotations are unit quaternions");
  fuzz::require(std::ranges::all_of(placement.scale, [](double s) { return s > 0; }), "scales are positive");
  fuzz::require(std::ranges::all_of(placement.translation, [](double t) { return std::isfinite(t); }), "finite places");
}

template <typename Entry>
bool names(const std::vector<Entry>& entries, const std::string& name) {
  return std::ranges::find(entries, name, &Entry::name) != entries.end();
}

void judge(const SceneFile& file) {
  fuzz::require(!file.instances.empty() || !file.ellipsoids.empty() || !file.lines.empty(), "something to draw");
  const auto punctual =
      std::ranges::count_if(file.lights, [](const FileLight& light) { return light.punctual.has_value(); });
  fuzz::require(static_cast<std::size_t>(punctual) <= kMaxPunctualLights &&
                    file.lights.size() - static_cast<std::size_t>(punctual) <= kMaxLights,
                "no more lights than the renderer takes");
  for (const FileModel& model : file.models) {
    fuzz::require(model.file.empty() != model.built_in.empty(), "a model comes from one place");
  }
  for (const FileInstance& instance : file.instances) {
    fuzz::require(names(file.models, instance.model), "an instance names a model");
    fuzz::require(instance.material.empty() || names(file.materials, instance.material), "and a material");
    fuzz::require(!(instance.is_static && instance.moves()), "what is static does not move");
    judge_placement(instance.placement);
    judge_curve(instance.translation);
    judge_curve(instance.rotation);
    judge_curve(instance.scale);
  }
  for (const FileEllipsoid& ellipsoid : file.ellipsoids) {
    fuzz::require(names(file.materials, ellipsoid.material), "an ellipsoid names a material");
    judge_placement(ellipsoid.placement);
  }
  for (const FileLines& lines : file.lines) {
    fuzz::require(names(file.materials, lines.material), "lines name a material");
    fuzz::require(lines.model.empty() != lines.vertices.empty(), "lines have their vertices from one place");
    fuzz::require(lines.model.empty() || names(file.models, lines.model), "which is a model");
    fuzz::require(lines.width >= 1 && lines.width <= kMaxLineWidth && lines.vertices.size() <= 65535, "in range");
    for (const Segment& segment : lines.segments) {
      fuzz::require(std::max(segment.a, segment.b) < lines.vertices.size(), "segments join vertices");
      fuzz::require((segment.a == segment.b) == lines.are_points, "and points are no lines");
    }
    judge_placement(lines.placement);
  }
  if (file.camera) {
    fuzz::require(file.camera->eye.has_value() != file.camera->radius.has_value(), "a camera stands in one place");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Result<SceneFile> file = parse_scene_file(text, "scene.toml");
  if (file) {
    judge(*file);
    return 0;
  }
  fuzz::require(file.failure().status == ExitStatus::input, "a wrong scene file is the input's fault");
  fuzz::require(file.failure().message.starts_with("'scene.toml' line "), "a failure names file and line: %s",
                file.failure().message.c_str());
  return 0;
}
