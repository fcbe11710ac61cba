// Whole projects for ESP-IDF that show a baked scene with zstrip::Player on a panel of esp_lcd: on SPI, RGB or
// MIPI-DSI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bake/baked_scene.hpp"
#include "bake/project_file.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// spi: an ST7789. rgb: strips are drawn into the driver's bounce buffers. mipi_dsi: strips are copied into its
/// picture.
enum class EspLcdPanel : std::uint8_t { spi, rgb, mipi_dsi };

/// Returns the rows of the strips that two bounce buffers of at most 16 KB each take in turn: the most that divide the
/// panel into an even number of equal strips. 0 for an odd height, which has none.
std::uint16_t rgb_strip_rows(std::uint16_t width, std::uint16_t height);

/// Returns ExitStatus::usage for scenes that a player does not draw, for a namespace with a name that the program uses
/// itself, and for pictures, formats or strips that the panel does not take.
Result<Done> check_for_esp_idf_project(const BakedScene& baked, const std::string& name_space, EspLcdPanel panel);

/// `name`: of the project. Returns all files but scene.hpp, which lies in the project's folder itself.
std::vector<ProjectFile> esp_idf_files(const BakedScene& baked, const std::string& name_space, const std::string& name,
                                       EspLcdPanel panel);

}  // namespace zstrip::sim
