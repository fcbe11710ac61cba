// The table of workloads.
#include "bench/workloads.hpp"

#include <array>
#include <map>
#include <utility>

#include "import/model.hpp"
#include "result.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array kWorkloads{
    Workload{"K5", "knot", "a knot of 5120 small Gouraud triangles: transform and set-up", 320, 240},
    Workload{"K5M", "knot_meshlets", "the same knot in 64 meshlets", 320, 240},
    Workload{"K5T", "knot_textured", "that knot, textured and lit", 320, 240},
    Workload{"CT", "cube", "a textured cube that fills the picture: fill rate", 320, 240},
    Workload{"R50", "random50", "50 large flat triangles, no culling", 640, 480},
    Workload{"R10k", "random10k", "10000 small flat triangles, no culling", 640, 480},
    Workload{"teapot", "teapot", "the Utah teapot, lit: medium Gouraud triangles", 320, 240},
    Workload{"character", "character", "a figure with a skeleton, textured and lit, moved in each frame", 240, 320},
    Workload{"room", "room", "a lit, textured room that the camera stands in", 320, 240},
};

constexpr std::array kModels{
    Workload{"bunny", "/usr/share/glmark2/models/bunny.obj",
             "the Stanford bunny of Debian's package glmark2-data, lit: triangles smaller than pixels", 320, 240},
};

/// Reads a model as a built-in scene. Returns null if it cannot be read.
const scenes::BuiltIn* model_in(std::string_view file) {
  static std::map<std::string_view, std::pair<Result<Model>, scenes::BuiltIn>> models;
  const auto [entry, is_new] = models.try_emplace(file, import_model(file), scenes::BuiltIn{});
  auto& [model, built_in] = entry->second;
  if (!model) return nullptr;
  if (is_new) {
    built_in.name = "model";
    built_in.scene.meshes = model->meshes;
    built_in.scene.materials = model->materials;
    built_in.scene.instances = model->instances;
    built_in.counts = count(built_in.scene);
  }
  return &built_in;
}

}  // namespace

const scenes::BuiltIn* Workload::built_in() const { return is_model() ? model_in(scene) : scenes::find(scene); }
bool Workload::is_model() const { return scene.starts_with('/'); }

std::span<const Workload> workloads() { return kWorkloads; }
std::span<const Workload> model_workloads() { return kModels; }

const Workload* find_workload(std::string_view name) {
  for (const std::span<const Workload> all : {workloads(), model_workloads()}) {
    for (const Workload& each : all) {
      if (each.name == name) return &each;
    }
  }
  return nullptr;
}

}  // namespace zstrip::sim
