// Lists the devices of the machine that can show pictures.
#include "machine_list.hpp"

#include <linux/fb.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "zstrip_hal_linux/device.hpp"
#include "zstrip_hal_linux/drm_display.hpp"
#include "zstrip_hal_linux/gpio.hpp"
#include "zstrip_hal_linux/graphics_console.hpp"

namespace zstrip::panel {
namespace {

/// Returns the files of a folder whose names begin with `prefix`.
std::vector<std::string> devices(const char* folder, std::string_view prefix) {
  std::vector<std::string> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().starts_with(prefix)) paths.push_back(entry->path());
  }
  std::ranges::sort(paths);
  return paths;
}

std::string framebuffer_line(const std::string& path) {
  const hal::Outcome<hal::FileDescriptor> file = hal::open_device(hal::DeviceKind::framebuffer, path);
  if (!file) return "  " + file.fault().message + "\n";
  fb_var_screeninfo mode{};
  fb_fix_screeninfo fixed{};
  if (hal::device_control(file->get(), FBIOGET_VSCREENINFO, &mode) != 0 ||
      hal::device_control(file->get(), FBIOGET_FSCREENINFO, &fixed) != 0) {
    return "  " + path + " is not a framebuffer\n";
  }
  const std::string driver(fixed.id, std::find(std::begin(fixed.id), std::end(fixed.id), '\0'));
  return "  fbdev:" + path + "  " + std::to_string(mode.xres) + "x" + std::to_string(mode.yres) + ", " +
         std::to_string(mode.bits_per_pixel) + " bits a pixel, driver " + driver + "\n";
}

std::string card_lines(const std::string& path) {
  const hal::Outcome<std::vector<std::string>> connectors = hal::drm_connectors(path);
  if (!connectors) return "  " + connectors.fault().message + "\n";
  std::string text = "  drm:" + path + "\n";
  for (const std::string& connector : *connectors) text += "    connector=" + connector + "\n";
  return text;
}

std::string chip_lines(const std::string& path) {
  std::vector<hal::gpio::LineInfo> lines;
  if (const int error = hal::gpio::read_lines(path, lines); error != 0)
    return "  " + hal::device_fault(hal::DeviceKind::gpio, path, "be opened", error).message + "\n";
  const std::string chip = std::filesystem::path(path).filename();
  std::string text = "  " + path + "  " + std::to_string(lines.size()) + " lines\n";
  for (std::size_t offset = 0; offset < lines.size(); ++offset) {
    const hal::gpio::LineInfo& line = lines[offset];
    if (line.name.empty() && !line.used) continue;
    text += "    " + chip + ":" + std::to_string(offset) + (line.name.empty() ? "" : "  " + line.name);
    if (line.used) text += "  in use by " + (line.consumer.empty() ? "the kernel" : "'" + line.consumer + "'");
    text += "\n";
  }
  return text;
}

std::string console_line() {
  switch (hal::console_mode()) {
    case hal::ConsoleMode::text: return "Text console: shown\n";
    case hal::ConsoleMode::graphics: return "Text console: off, a program shows pictures or was killed\n";
    case hal::ConsoleMode::none: break;
  }
  return "Text console: none, or no permission for it\n";
}

template <class Describe>
std::string section(const char* title, const std::vector<std::string>& paths, Describe describe) {
  std::string text = std::string(title) + ":" + (paths.empty() ? " none\n" : "\n");
  for (const std::string& path : paths) text += describe(path);
  return text;
}

}  // namespace

std::string machine_list() {
  return console_line() + section("Framebuffers", devices("/dev", "fb"), framebuffer_line) +
         section("Graphics cards", devices("/dev/dri", "card"), card_lines) +
         section("SPI", devices("/dev", "spidev"), [](const std::string& path) { return "  spidev=" + path + "\n"; }) +
         section("I2C", devices("/dev", "i2c-"), [](const std::string& path) { return "  i2c=" + path + "\n"; }) +
         section("GPIO chips", hal::gpio_chips(), chip_lines);
}

}  // namespace zstrip::panel
