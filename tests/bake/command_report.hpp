// What the command reports of a scene that was baked with some options: checksums of frames, the plan.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace zstrip::sim::test {

/// Whether the options of `zstrip bake`, words separated by spaces, ask for a turntable.
bool is_turntable(const std::string& options);

/// Checksums of `zstrip render`'s frames with those of the options that say what the picture is, and not how it is
/// planned: one frame, or of what moves four of a turn. Fails the test, and is empty, where the command fails. Writes
/// into `folder`.
std::vector<std::string> rendered_frames(const std::string& scene, const std::string& options, bool moves,
                                         const std::string& folder);

struct PlanReport {
  std::size_t arena, strip_pixels;  ///< bytes
  std::uint16_t strips;
  std::string mode;
};
/// Returns the plan in a file that `zstrip bake --json` wrote.
PlanReport baked_plan(const std::string& report);

/// As the command prints it.
std::string crc32_of(std::span<const std::byte> bytes);

}  // namespace zstrip::sim::test
