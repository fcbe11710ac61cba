// The workloads: built-in scenes, on which the renderers of peers.hpp were measured, and models of packages.
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

  /// Returns null if the scene is a model that is not installed; never for one of workloads().
  const scenes::BuiltIn* built_in() const;
  /// True if boards get the scene as a file.
  bool is_model() const;
};

/// Returns the workloads with built-in scenes.
std::span<const Workload> workloads();
/// Returns the workloads whose scene is a model of a package.
std::span<const Workload> model_workloads();

/// Returns null if there is no workload of this name.
const Workload* find_workload(std::string_view name);

}  // namespace zstrip::sim
