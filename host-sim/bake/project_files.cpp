// Folders for Arduino, PlatformIO, the Raspberry Pi Pico SDK and ESP-IDF; see project_files.hpp.
#include "bake/project_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "bake/adapter_texts.hpp"

namespace zstrip::sim {
namespace {

/// The files and the library that a sketch needs for its panel.
struct LibraryFiles {
  const char* adapter;             ///< a file's name; null for zstrip's own driver
  std::string_view adapter_text;   ///< its content
  const char* platformio_library;  ///< by the name of PlatformIO's registry
};

LibraryFiles files_of(DisplayLibrary library) {
  switch (library) {
    case DisplayLibrary::tft_espi: return {"tft_espi.hpp", adapter_text::kTftEspi, "bodmer/TFT_eSPI@^2.5.43"};
    case DisplayLibrary::lovyangfx: return {"lovyangfx.hpp", adapter_text::kLovyanGfx, "lovyan03/LovyanGFX@^1.2.0"};
    case DisplayLibrary::m5gfx: return {"lovyangfx.hpp", adapter_text::kLovyanGfx, "m5stack/M5GFX@^0.2.0"};
    case DisplayLibrary::arduino_gfx:
      return {"arduino_gfx.hpp", adapter_text::kArduinoGfx, "moononournation/GFX Library for Arduino@^1.6.0"};
    case DisplayLibrary::st7789: break;
  }
  return {nullptr, {}, nullptr};
}

/// The pins of a board in the order SPI clock and data, data back, D/C, reset, select.
struct BoardPins {
  int clock, data, data_back, data_command, reset, select;
};

/// TFT_eSPI's setup as flags of the compiler, one a line. Its panel is upright.
std::string tft_espi_flags(const View& view, const BoardPins& pins) {
  return fmt::format(R"(build_flags =
  ${{env.build_flags}}
  -D USER_SETUP_LOADED
  -D ST7789_DRIVER
  -D TFT_WIDTH={}
  -D TFT_HEIGHT={}
  -D TFT_INVERSION_ON
  -D TFT_SCLK={}
  -D TFT_MOSI={}
  -D TFT_MISO={}
  -D TFT_DC={}
  -D TFT_RST={}
  -D TFT_CS={}
  -D SPI_FREQUENCY=40000000
)",
                     std::min(view.width, view.height), std::max(view.width, view.height), pins.clock, pins.data,
                     pins.data_back, pins.data_command, pins.reset, pins.select);
}

std::string platformio_ini(const BakedScene& baked, DisplayLibrary library) {
  // All boards of M5Stack that M5GFX knows have an ESP32.
  const bool for_m5 = library == DisplayLibrary::m5gfx;
  std::string text =
      R"(; Written by `zstrip bake`. zstrip's package, the folder zstrip of its archive, goes into lib/ next to this file.
; The sketch is also one of the Arduino IDE, so it lies in the project's folder itself.
[platformio]
src_dir = .
)" + fmt::format("default_envs = {}\n", for_m5 ? "esp32" : "pico") +
      R"(
[env]
framework = arduino
build_src_filter = +<*.cpp>
build_unflags = -std=gnu++11 -std=gnu++14 -std=gnu++17
build_flags =
  -std=gnu++20
)";
  const auto flags = [&](const BoardPins& pins) {
    return library == DisplayLibrary::tft_espi ? tft_espi_flags(baked.view, pins) : std::string();
  };
  if (const LibraryFiles files = files_of(library); files.platformio_library != nullptr) {
    text += fmt::format("lib_deps = {}\n", files.platformio_library);
  }
  text += "\n; For other boards name their platform and board here. The compiler must be GCC 11 or later.\n";
  if (!for_m5) {
    text += R"([env:pico]
platform = https://github.com/maxgerhardt/platform-raspberrypi.git
board = pico
board_build.core = earlephilhower
)";
    text += flags({18, 19, 16, 8, 9, 10}) + '\n';
  }
  text += R"([env:esp32]
platform = https://github.com/pioarduino/platform-espressif32/releases/download/stable/platform-espressif32.zip
)";
  text += fmt::format("board = {}\n", for_m5 ? "m5stack-core-esp32" : "esp32dev");
  return text + flags({18, 23, 19, 2, 4, 5});
}

std::string pico_cmake(const Project& project) {
  const std::string& name = project.name;
  std::string text =
      R"(# Written by `zstrip bake`. With the folders of the Raspberry Pi Pico SDK and of zstrip's repository:
#     cmake -S . -B build -DPICO_SDK_PATH=... -DZSTRIP_PATH=...
#     cmake --build build --target @
# makes build/@.uf2. For a Pico 2 add -DPICO_BOARD=pico2.
cmake_minimum_required(VERSION 3.22)
foreach(folder PICO_SDK_PATH ZSTRIP_PATH)
  set(${folder} "$ENV{${folder}}" CACHE PATH "")
  get_filename_component(path "${${folder}}" ABSOLUTE BASE_DIR ${CMAKE_BINARY_DIR}/..)
  if(NOT EXISTS ${path}/CMakeLists.txt)
    message(FATAL_ERROR "'${${folder}}' is not the folder of ${folder}; name it by -D${folder}=")
  endif()
endforeach()
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

include(${PICO_SDK_PATH}/pico_sdk_init.cmake)
project(@ LANGUAGES C CXX ASM)
pico_sdk_init()

add_subdirectory(${ZSTRIP_PATH} zstrip EXCLUDE_FROM_ALL)
add_executable(@ main.cpp)
# 4 KB for the stack of a core, as much as there is of its own.
target_compile_definitions(@ PRIVATE PICO_STACK_SIZE=0x1000 PICO_CORE1_STACK_SIZE=0x1000)
)";
  text += project.cores == 2
              ? "target_link_libraries(@ PRIVATE zstrip::player pico_multicore pico_stdlib hardware_spi hardware_dma)\n"
              : "target_link_libraries(@ PRIVATE zstrip::player pico_stdlib hardware_spi hardware_dma)\n";
  text += "pico_add_extra_outputs(@)\n";
  for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos; at += name.size()) text.replace(at, 1, name);
  return text;
}

}  // namespace

Result<Done> check_project_name(const std::string& name) {
  const auto is_letter_or_digit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  const bool known = !name.empty() && name.size() <= 63 && is_letter_or_digit(name.front()) &&
                     std::ranges::all_of(name, [&](char c) { return is_letter_or_digit(c) || c == '-' || c == '.'; });
  if (known) return Done{};
  return Failure{ExitStatus::usage,
                 "-o: the folder's name is that of the program; choose one of at most 63 letters, digits, '_', '-' and "
                 "'.', a letter, a digit or '_' first"};
}

Result<Done> check_for_project(const BakedScene& baked, const std::string& name_space, const Project& project) {
  if (project.kind == ProjectKind::esp_idf) {
    return check_for_esp_idf_project(baked, name_space, project.esp_lcd_panel);
  }
  return project.kind == ProjectKind::pico ? check_for_pico_program(baked, name_space)
                                           : check_for_sketch(baked, name_space, project.display);
}

std::vector<ProjectFile> project_files(const BakedScene& baked, const std::string& name_space, const Project& project) {
  if (project.kind == ProjectKind::esp_idf) {
    return esp_idf_files(baked, name_space, project.name, project.esp_lcd_panel);
  }
  std::vector<ProjectFile> files;
  if (project.kind == ProjectKind::pico) {
    files.push_back({"main.cpp", to_pico_program(baked, name_space, project.cores)});
    files.push_back({"CMakeLists.txt", pico_cmake(project)});
    files.push_back({"pico_spi_dma.hpp", std::string(adapter_text::kPicoSpiDma)});
    return files;
  }
  files.push_back({project.name + ".ino", to_sketch(baked, name_space, project.display)});
  const LibraryFiles library = files_of(project.display);
  if (library.adapter != nullptr) files.push_back({library.adapter, std::string(library.adapter_text)});
  if (project.kind == ProjectKind::platformio) {
    files.push_back({"platformio.ini", platformio_ini(baked, project.display)});
  }
  return files;
}

}  // namespace zstrip::sim
