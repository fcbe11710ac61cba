// The lines of an emulated PL061, from the emulator's trace.
#include "spi_trace.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <utility>

namespace zstrip::linux_guest {
namespace {

struct Change {
  sim::Nanoseconds time{};
  int line = 0;
  bool high = false;
};

/// PROCESS@SECONDS.MICROSECONDS:pl061_set_output NAME setting output LINE to LEVEL
void for_each_change(const std::filesystem::path& trace, const std::function<void(const Change&)>& use) {
  std::ifstream stream(trace);
  if (!stream) throw std::runtime_error("there is no trace " + trace.string());
  for (std::string text; std::getline(stream, text);) {
    long long seconds = 0;
    long long microseconds = 0;
    int line = 0;
    int level = 0;
    const std::size_t words = text.find(" setting output ");
    if (words == std::string::npos || std::sscanf(text.c_str(), "%*d@%lld.%lld:", &seconds, &microseconds) != 2 ||
        std::sscanf(text.c_str() + words, " setting output %d to %d", &line, &level) != 2 || line < 0 || line > 7) {
      throw std::runtime_error("a line of the trace that is none: " + text);
    }
    use({std::chrono::seconds(seconds) + std::chrono::microseconds(microseconds), line, level != 0});
  }
}

}  // namespace

std::string replay(const std::filesystem::path& trace, const PanelLines& lines, sim::PanelModel& panel,
                   std::size_t skipped) {
  std::array<bool, 8> levels{};
  const auto level = [&levels](int line) { return line >= 0 && levels[static_cast<std::size_t>(line)]; };
  std::string fault;
  unsigned bits = 0;
  unsigned byte = 0;
  sim::Nanoseconds time{};
  for_each_change(trace, [&](const Change& change) {
    if (skipped > 0) {
      --skipped;
      levels[static_cast<std::size_t>(change.line)] = change.high;
      return;
    }
    if (time != sim::Nanoseconds{}) panel.elapse(change.time - time);
    time = change.time;
    const bool was = std::exchange(levels[static_cast<std::size_t>(change.line)], change.high);
    if (was == change.high) return;
    if (change.line == lines.reset) panel.set_reset(change.high);
    if (change.line == lines.select && bits % 8 != 0) fault = "chip select changes amid a byte";
    const bool selected = !level(lines.select);
    if (!selected) bits = 0;
    if (change.line == lines.data && selected && level(lines.clock) && fault.empty())
      fault = "data changes while the clock is high";
    if (change.line == lines.data_command && bits % 8 != 0) fault = "D/C changes amid a byte";
    if (change.line != lines.clock || !change.high || !selected) return;
    byte = byte << 1 | (level(lines.data) ? 1U : 0U);
    if (++bits % 8 != 0) return;
    const auto arrived = static_cast<std::byte>(byte & 0xFF);
    panel.receive(level(lines.data_command) ? sim::Wire::data : sim::Wire::command, std::span(&arrived, 1));
  });
  return fault;
}

std::size_t changes_of(const std::filesystem::path& trace) {
  std::size_t changes = 0;
  for_each_change(trace, [&](const Change&) { ++changes; });
  return changes;
}

int last_level(const std::filesystem::path& trace, int line) {
  int level = -1;
  for_each_change(trace, [&](const Change& change) {
    if (change.line == line) level = change.high ? 1 : 0;
  });
  return level;
}

}  // namespace zstrip::linux_guest
