// Writes the tables, one row for each program and scene.
#include "memory_page.hpp"

#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace zstrip::budget {
namespace {

constexpr std::string_view kBegin = "<!-- tests/budget/update writes from here -->\n";
constexpr std::string_view kEnd = "<!-- to here -->\n";

/// With a comma before each three digits.
std::string grouped(std::uint32_t value) {
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

template <class... Cells>
void write_row(std::ostringstream& text, const Cells&... cells) {
  text << '|';
  ((text << ' ' << cells << " |"), ...);
  text << '\n';
}

std::string picture(const View& view) {
  return std::to_string(view.width) + "x" + std::to_string(view.height) +
         (view.format == PixelFormat::gray4 ? ", 4 bits" : "");
}

/// Programs with several scenes have one row for all of them.
void write_flash(std::ostringstream& text, std::span<const Usage> usages) {
  write_row(text, "Board", "Scene", "Code", "Constants", "Initial data", "Flash");
  text << "|---|---|--:|--:|--:|--:|\n";
  for (std::size_t i = 0; i < usages.size();) {
    const Usage& usage = usages[i];
    std::string scenes;
    for (; i < usages.size() && usages[i].target->program == std::string_view(usage.target->program); ++i) {
      scenes += (scenes.empty() ? "" : ", ") + std::string(usages[i].target->scene);
    }
    write_row(text, usage.target->board, scenes, grouped(usage.code), grouped(usage.constants),
              grouped(usage.initial_data), grouped(usage.flash()));
  }
}

void write_ram(std::ostringstream& text, std::span<const Usage> usages) {
  write_row(text, "Board", "Scene", "Picture", "Strips", "Instances", "Extents", "Vertices", "Depth", "Colour", "Bins",
            "Pixels", "Statics", "Stack: reserved", "bound", "measured", "RAM");
  text << "|---|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Usage& usage : usages) {
    const Plan& plan = usage.plan;
    write_row(text, usage.target->board, usage.target->scene, picture(usage.target->view),
              std::to_string(plan.strips) + " of " + std::to_string(plan.strip_columns) + "x" +
                  std::to_string(plan.strip_rows),
              grouped(plan.instance_bytes), grouped(plan.extent_bytes), grouped(plan.vertex_bytes),
              grouped(plan.depth_bytes), grouped(plan.colour_bytes), grouped(plan.bin_bytes), grouped(usage.pixels),
              grouped(usage.statics), grouped(usage.stack_reserved), grouped(usage.stack_bound),
              usage.target->report == Report::none ? "not run" : grouped(usage.stack_measured), grouped(usage.ram()));
  }
}

}  // namespace

std::string memory_tables(std::span<const Usage> usages, const std::string& compiler) {
  std::ostringstream text;
  text << "Bytes, compiled by " << compiler << " with `-O2`.\n\n";
  write_flash(text, usages);
  text << '\n';
  write_ram(text, usages);
  return text.str();
}

std::string page_with_tables(const std::string& page, const std::string& tables) {
  const std::size_t begin = page.find(kBegin), end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    throw std::runtime_error("the page has no marks for the tables");
  }
  return page.substr(0, begin + kBegin.size()) + tables + page.substr(end);
}

std::string compiler_version() {
  constexpr const char* kCompiler = "arm-none-eabi-g++";
  FILE* const pipe = popen((std::string(kCompiler) + " -dumpfullversion").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(std::string("cannot run ") + kCompiler);
  std::array<char, 64> buffer{};
  const std::size_t count = std::fread(buffer.data(), 1, buffer.size() - 1, pipe);
  if (pclose(pipe) != 0) throw std::runtime_error(std::string("failed: ") + kCompiler);
  const std::string version(buffer.data(), count);
  return std::string(kCompiler) + " " + version.substr(0, version.find('\n'));
}

}  // namespace zstrip::budget
