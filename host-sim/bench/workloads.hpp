// The workloads that the renderers of peers.hpp were measured on, as built-in scenes.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {

struct Workload {
  std::string_view name;         ///< as "K5"
  std::string_view scene;        ///< name of the built-in scene
  std::string_view description;  ///< one phrase
  std::uint16_t width, height;   ///< in pixels, unless --size is given

  /// Never null: a test looks every one up.
  const scenes::BuiltIn* built_in() const { return scenes::find(scene); }
};

std::span<const Workload> workloads();

/// Null if there is no workload of this name.
const Workload* find_workload(std::string_view name);

}  // namespace zstrip::sim
