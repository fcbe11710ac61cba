// Finds lines by name or by chip and offset, requests them, and names the program that uses a busy line.
#include "zstrip_hal_linux/gpio.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>

#include "zstrip_hal_linux/device.hpp"

namespace zstrip::hal {
namespace {

constexpr std::string_view kDevices = "/dev/";
constexpr std::string_view kChipName = "gpiochip";

std::optional<unsigned> number(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string chip_path(const std::string& chip) {
  if (chip.find('/') != std::string::npos) return chip;
  return std::string(kDevices) + (number(chip) ? std::string(kChipName) : std::string()) + chip;
}

Outcome<std::vector<gpio::LineInfo>> lines_of(const std::string& chip) {
  std::vector<gpio::LineInfo> lines;
  const int error = gpio::read_lines(chip, lines);
  // libgpiod reports these errors for a file that does not belong to a GPIO chip.
  if (error == ENOTTY || error == EINVAL || error == ENODEV)
    return Fault{chip + " is not a GPIO chip; --list shows those that there are"};
  if (error != 0) return device_fault(DeviceKind::gpio, chip, "be opened", error);
  return lines;
}

Fault no_such_line(const GpioLine& line, std::size_t lines) {
  return {line.chip + " has no line " + std::to_string(line.offset) + ", only " + std::to_string(lines) +
          " lines from 0 on"};
}

Fault busy(const GpioLine& line, const gpio::LineInfo& info) {
  return {line.chip + " line " + std::to_string(line.offset) + (info.name.empty() ? "" : " (" + info.name + ")") +
          " is busy: " + (info.consumer.empty() ? "a driver of the kernel" : "'" + info.consumer + "'") +
          " has it; choose another line, or end that program or take that driver out of the device tree"};
}

/// Explains why a line could not become an output or an input.
Fault refused(const GpioLine& line, const char* what, int error) {
  const Outcome<std::vector<gpio::LineInfo>> lines = lines_of(line.chip);
  if (!lines) return lines.fault();
  if (line.offset >= lines->size()) return no_such_line(line, lines->size());
  if (error == EBUSY) return busy(line, (*lines)[line.offset]);
  return device_fault(DeviceKind::gpio, line.chip, ("make line " + std::to_string(line.offset) + " " + what).c_str(),
                      error);
}

}  // namespace

std::vector<std::string> gpio_chips() {
  std::vector<unsigned> numbers;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(kDevices, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (!name.starts_with(kChipName)) continue;
    if (const auto chip = number(std::string_view(name).substr(kChipName.size()))) numbers.push_back(*chip);
  }
  std::sort(numbers.begin(), numbers.end());
  std::vector<std::string> paths;
  for (const unsigned chip : numbers) paths.push_back(chip_path(std::to_string(chip)));
  return paths;
}

Outcome<GpioLine> find_gpio_line(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const auto offset = colon == std::string::npos ? std::nullopt : number(std::string_view(text).substr(colon + 1));
  if (offset && colon > 0) {
    const GpioLine line{chip_path(text.substr(0, colon)), *offset};
    const Outcome<std::vector<gpio::LineInfo>> lines = lines_of(line.chip);
    if (!lines) return lines.fault();
    if (line.offset >= lines->size()) return no_such_line(line, lines->size());
    return line;
  }

  const std::vector<std::string> chips = gpio_chips();
  if (chips.empty()) return Fault{"the GPIO line '" + text + "' was not found: this machine has no GPIO chip"};
  std::optional<Fault> unreadable;
  for (const std::string& chip : chips) {
    const Outcome<std::vector<gpio::LineInfo>> lines = lines_of(chip);
    if (!lines) {
      if (!unreadable) unreadable = lines.fault();
      continue;
    }
    const auto found = std::ranges::find(*lines, text, &gpio::LineInfo::name);
    if (found != lines->end()) return GpioLine{chip, static_cast<unsigned>(found - lines->begin())};
  }
  if (unreadable) return *unreadable;
  return Fault{"no GPIO chip has a line with the name '" + text +
               "'; take one that --list shows, or give chip and offset as in gpiochip0:17"};
}

Outcome<GpioPin> GpioPin::request(const GpioLine& line, bool level) {
  gpio::RequestPointer request;
  const int error = gpio::request_output(line.chip, line.offset, level, request);
  if (error == 0) return GpioPin(std::move(request), level);
  return refused(line, "an output", error);
}

Outcome<GpioInput> GpioInput::request(const GpioLine& line) {
  gpio::RequestPointer request;
  const int error = gpio::request_input(line.chip, line.offset, request);
  if (error == 0) return GpioInput(std::move(request));
  return refused(line, "an input", error);
}

}  // namespace zstrip::hal
