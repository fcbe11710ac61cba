// Common to the programs that draw workloads with other renderers: they implement Renderer, peer_program.cpp has main.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>

#include "bench/peer_programs/peer_scene.hpp"

namespace zstrip::peer {

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Clears and draws one complete frame: the measured work.
  virtual void draw(const View& view) = 0;
  /// Returns the RGB565 pixels of the frame drawn last, in any order of rows.
  virtual std::span<const std::uint16_t> pixels() const = 0;
};

/// Each program defines this function. It throws std::runtime_error if it cannot draw; `scene` outlives the renderer.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, int width, int height);

}  // namespace zstrip::peer
