// What the programs that draw workloads with other renderers share: they implement Renderer, peer_program.cpp is main.
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
  /// Clears and draws one frame, to the last pixel: what is measured.
  virtual void draw(const View& view) = 0;
  /// RGB565 of the frame drawn last, in any order of rows.
  virtual std::span<const std::uint16_t> pixels() const = 0;
};

/// Each program's own. Throws std::runtime_error where it cannot draw; `scene` outlives it.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, int width, int height);

}  // namespace zstrip::peer
