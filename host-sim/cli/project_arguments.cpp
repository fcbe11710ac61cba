// Folders with a program and its scene; see project_arguments.hpp.
#include "cli/project_arguments.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "cli/print.hpp"
#include "image/inputs.hpp"
#include "image/write_file.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

/// True if the file has this content and no other.
bool has_content(const fs::path& path, const std::string& text) {
  std::ifstream file(path, std::ios::binary);
  return file && std::string(std::istreambuf_iterator<char>(file), {}) == text;
}

/// Writes the file unless it is there.
Result<Done> write_new(const fs::path& path, const std::string& text) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(path, ignored))) {
    if (!has_content(path, text)) {
      print_warning(fmt::format("'{}' stays as it is; delete it to have it written anew", path.string()));
    }
    return Done{};
  }
  return write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "-o");
}

}  // namespace

void add_project_options(CLI::App& command, ProjectArguments& arguments) {
  command
      .add_option("--project", arguments.project,
                  "The kind of program in a folder: arduino, a sketch (default); platformio, a sketch with a "
                  "platformio.ini; pico or esp_idf, a program for the Raspberry Pi Pico SDK or for ESP-IDF")
      ->option_text("KIND")
      ->transform(one_of({"arduino", "platformio", "pico", "esp_idf"}));
  command
      .add_option("--display", arguments.display,
                  "The panel's driver in a folder's program: st7789 (default); tft_espi, lovyangfx, m5gfx or "
                  "arduino_gfx, which are libraries for Arduino; rgb_panel or mipi_dsi_panel, of ESP-IDF")
      ->option_text("DRIVER")
      ->transform(one_of({"st7789", "tft_espi", "lovyangfx", "m5gfx", "arduino_gfx", "rgb_panel", "mipi_dsi_panel"}));
  command
      .add_option("--cores", arguments.cores, "How many cores draw in the program of --project pico: 1 (default), 2")
      ->option_text("NUMBER")
      ->transform(one_of({"1", "2"}));
}

Result<Done> check_no_project(const ProjectArguments& arguments) {
  if (!arguments.project && !arguments.display && !arguments.cores) return Done{};
  return Failure{ExitStatus::usage,
                 fmt::format("{} is of a folder with a whole program: -o FOLDER/", arguments.project   ? "--project"
                                                                                   : arguments.display ? "--display"
                                                                                                       : "--cores")};
}

Result<Project> parse_project(const ProjectArguments& arguments, const std::string& output) {
  Project project;
  if (arguments.project == "platformio") project.kind = ProjectKind::platformio;
  if (arguments.project == "pico") project.kind = ProjectKind::pico;
  if (arguments.project == "esp_idf") project.kind = ProjectKind::esp_idf;
  if (arguments.display == "tft_espi") project.display = DisplayLibrary::tft_espi;
  if (arguments.display == "lovyangfx") project.display = DisplayLibrary::lovyangfx;
  if (arguments.display == "m5gfx") project.display = DisplayLibrary::m5gfx;
  if (arguments.display == "arduino_gfx") project.display = DisplayLibrary::arduino_gfx;
  if (arguments.display == "rgb_panel") project.esp_lcd_panel = EspLcdPanel::rgb;
  if (arguments.display == "mipi_dsi_panel") project.esp_lcd_panel = EspLcdPanel::mipi_dsi;
  const bool for_sdk = project.kind == ProjectKind::pico || project.kind == ProjectKind::esp_idf;
  if (for_sdk && project.display != DisplayLibrary::st7789) {
    return Failure{ExitStatus::usage,
                   fmt::format("--display {} is a library for Arduino; --project {} has {}", *arguments.display,
                               *arguments.project,
                               project.kind == ProjectKind::pico ? "st7789" : "st7789, rgb_panel and mipi_dsi_panel")};
  }
  if (project.kind != ProjectKind::esp_idf && project.esp_lcd_panel != EspLcdPanel::spi) {
    return Failure{ExitStatus::usage,
                   fmt::format("--display {0} is of ESP-IDF: --project esp_idf --display {0}", *arguments.display)};
  }
  if (arguments.cores == "2") {
    if (project.kind != ProjectKind::pico) {
      return Failure{ExitStatus::usage,
                     "--cores 2 is of --project pico; for Arduino the example TwoCores shows how both cores draw"};
    }
    project.cores = 2;
  }
  std::error_code error;
  const fs::path whole = fs::absolute(output, error).lexically_normal();
  project.name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
  if (const Result<Done> named = check_project_name(project.name); !named) return named.failure();
  return project;
}

PlanArguments plan_arguments_for_project(PlanArguments plan, const Project& project) {
  const EspLcdPanel panel = project.esp_lcd_panel;
  if (!plan.view.size) {
    plan.view.size = panel == EspLcdPanel::rgb ? "480x272" : panel == EspLcdPanel::mipi_dsi ? "1024x600" : "240x240";
  }
  if (!plan.view.format) plan.view.format = panel == EspLcdPanel::spi ? "rgb565_swapped" : "rgb565";
  if (panel == EspLcdPanel::rgb) {
    const auto size = parse_size(*plan.view.size);  // parse_plan() refuses a wrong one
    const std::uint16_t rows = size ? rgb_strip_rows(size->first, size->second) : 0;
    if (!plan.memory.strip_rows && rows != 0) plan.memory.strip_rows = fmt::to_string(rows);
    plan.strip_buffers = 1;  // the driver has two more
    return plan;
  }
  if (panel == EspLcdPanel::mipi_dsi && !plan.memory.ram && !plan.memory.board) plan.memory.ram = "160K";
  const bool by_dma = project.kind == ProjectKind::pico || project.kind == ProjectKind::esp_idf ||
                      project.display == DisplayLibrary::tft_espi || project.display == DisplayLibrary::lovyangfx ||
                      project.display == DisplayLibrary::m5gfx;
  plan.strip_buffers = by_dma ? 2 : plan.strip_buffers.value_or(1);
  return plan;
}

Result<Done> write_project(const std::string& output, std::span<const std::uint8_t> header,
                           std::span<const ProjectFile> files) {
  const fs::path folder = output;
  const fs::path scene = folder / "scene.hpp";
  if (const Result<Done> checked = check_no_input(scene, "-o"); !checked) return checked.failure();
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error)) {
    return Failure{ExitStatus::output, fmt::format("cannot create the folder '{}': {}; choose another place with -o",
                                                   output, error ? error.message() : "a file has this name")};
  }
  if (const Result<Done> written = write_file(scene, header, "-o"); !written) return written.failure();
  for (const ProjectFile& file : files) {
    fs::create_directories((folder / file.name).parent_path(), error);  // an error is one of the file
    if (const Result<Done> written = write_new(folder / file.name, file.text); !written) return written.failure();
  }
  return Done{};
}

}  // namespace zstrip::sim
