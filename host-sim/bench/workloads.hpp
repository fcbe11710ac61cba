// The workloads: built-in scenes, which the renderers of peers.hpp were measured on, and models of packages.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {

struct Workload {
  std::string_view name;         ///< as "K5"
  std::string_view scene;        ///< name of the built-in scene, or the model's file
  std::string_view description;  ///< one phrase
  std::uint16_t width, height;   ///< in pixels, unless --size is given

  /// Null if the scene is a model that is not installed; never one of workloads().
  const scenes::BuiltIn* built_in() const;
  /// Whether boards get the scene as a file.
  bool is_model() const;
};

/// Those that are built in.
std::span<const Workload> workloads();
/// Those whose scene is a model of a package.
std::span<const Workload> model_workloads();

/// Null if there is no workload of this name.
const Workload* find_workload(std::string_view name);

}  // namespace zstrip::sim
