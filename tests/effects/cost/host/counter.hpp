// On a host valgrind counts the whole program; it runs once and three times, and half of the difference is a run.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace zstrip::effects_cost {

struct Counter {
  void resume() {}
  void pause() {}
  std::uint64_t instructions() const { return 0; }
};
inline bool start_counter() { return true; }
/// The environment's COST_THRICE decides.
inline std::uint32_t repeats() { return std::getenv("COST_THRICE") != nullptr ? 3 : 1; }
/// The environment's COST_DRAWING.
inline std::uint32_t chosen_drawing() {
  const char* const text = std::getenv("COST_DRAWING");
  return text == nullptr ? ~0U : static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
}

}  // namespace zstrip::effects_cost
