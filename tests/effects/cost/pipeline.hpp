// The two functions of a pipeline that is compiled alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/visibility.hpp"
#include "zstrip/zstrip.hpp"

extern "C" zstrip::Status cost_begin_frame(const zstrip::Scene& scene, const zstrip::Camera& camera,
                                           const zstrip::View& view, const zstrip::Plan& plan,
                                           std::span<std::byte> arena);
extern "C" zstrip::Status cost_draw_strip(std::uint16_t strip, std::span<std::byte> pixels);
