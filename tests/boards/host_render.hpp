// The same frames as on the boards, drawn by the host's build of the library.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grey_picture.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::boards {

/// A frame of a built-in scene on the turntable, in 16 greys.
GreyPicture render_turntable_gray4(const std::string& scene, std::uint32_t frame, std::uint32_t frames,
                                   std::uint16_t width, std::uint16_t height);

/// A frame of a built-in scene on the turntable, in RGB565, drawn in one strip with the effects of a preset, too.
std::vector<std::uint16_t> render_turntable_rgb565(const std::string& scene, std::uint32_t frame, std::uint32_t frames,
                                                   std::uint16_t width, std::uint16_t height,
                                                   const Quality& preset = quality::balanced);

/// The whole showroom with the teapot where it is in that frame, in 16 greys, drawn as one scene without layers.
GreyPicture render_showroom_gray4(std::uint32_t frame, std::uint32_t frames, std::uint16_t width, std::uint16_t height);

/// zlib's CRC-32 of a frame of a built-in scene as a workload, in RGB565, drawn in strips of `rows` rows.
std::uint32_t workload_crc32(const std::string& scene, std::uint32_t frame, std::uint16_t width, std::uint16_t height,
                             std::uint16_t rows);

/// zlib's CRC-32 of a frame of a built-in scene on the turntable, 16 bits a pixel with the high byte first, drawn in
/// one strip.
std::uint32_t turntable_crc32(const std::string& scene, std::uint32_t frame, std::uint32_t frames, std::uint16_t width,
                              std::uint16_t height);

}  // namespace zstrip::boards
