// Whole folders that show a baked scene: for Arduino, for PlatformIO, for the Raspberry Pi Pico SDK, for ESP-IDF.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bake/baked_scene.hpp"
#include "bake/esp_idf_project.hpp"
#include "bake/program_text.hpp"
#include "bake/project_file.hpp"
#include "result.hpp"

namespace zstrip::sim {

enum class ProjectKind : std::uint8_t { arduino, platformio, pico, esp_idf };

struct Project {
  ProjectKind kind = ProjectKind::arduino;
  DisplayLibrary display = DisplayLibrary::st7789;  ///< of sketches
  EspLcdPanel esp_lcd_panel = EspLcdPanel::spi;     ///< of a project for ESP-IDF
  std::uint8_t cores = 1;                           ///< of a program for the Pico: 1 or 2
  std::string name;                                 ///< the folder's, which is that of its sketch or program
};

/// Returns ExitStatus::usage for names that Arduino or CMake do not take: other characters than letters, digits, '_',
/// '-' and '.', none at all, more than 63, or a '.' or '-' first.
Result<Done> check_project_name(const std::string& name);

/// Returns ExitStatus::usage for scenes and pictures that the program does not show.
Result<Done> check_for_project(const BakedScene& baked, const std::string& name_space, const Project& project);

/// Returns all files but scene.hpp, the scene's header. The same scene always gives the same text.
std::vector<ProjectFile> project_files(const BakedScene& baked, const std::string& name_space, const Project& project);

}  // namespace zstrip::sim
