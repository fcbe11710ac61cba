// Programs that show a baked scene with zstrip::Player: a sketch for Arduino, a program for the Raspberry Pi Pico SDK,
// a source for CMake. All include the scene's header by the name scene.hpp.
#pragma once

#include <cstdint>
#include <string>

#include "bake/baked_scene.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The driver of a sketch's panel: zstrip's own for an ST7789, or another library.
enum class DisplayLibrary : std::uint8_t { st7789, tft_espi, lovyangfx, m5gfx, arduino_gfx };

/// Returns ExitStatus::usage for scenes that a player does not draw (with a visibility method), and for a namespace
/// with a name that the program uses itself.
Result<Done> check_for_program(const BakedScene& baked, const std::string& name_space);
/// Checks the same for a sketch, and refuses pictures that no ST7789 can show. The panels of TFT_eSPI and M5GFX may be
/// larger.
Result<Done> check_for_sketch(const BakedScene& baked, const std::string& name_space,
                              DisplayLibrary library = DisplayLibrary::st7789);
/// Checks the same for a program for the Raspberry Pi Pico SDK with an ST7789.
Result<Done> check_for_pico_program(const BakedScene& baked, const std::string& name_space);

/// `name_space`: that of the header. The same scene always gives the same text.
std::string to_sketch(const BakedScene& baked, const std::string& name_space,
                      DisplayLibrary library = DisplayLibrary::st7789);
/// `cores`: 1 or 2 of the chip's cores draw.
std::string to_pico_program(const BakedScene& baked, const std::string& name_space, std::uint8_t cores);
/// `file`: its name, which is used in its CMakeLists.txt.
std::string to_program(const BakedScene& baked, const std::string& name_space, const std::string& file);

}  // namespace zstrip::sim
