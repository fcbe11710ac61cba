// The columns of the table, and the pages that are made of it.
#include "gallery_table.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace zstrip::gallery {
namespace {

const measured::Row& row_in(const measured::Table& table, const std::string& scene, const std::string& machine,
                            const std::string& preset, const std::string& kilobytes) {
  const measured::Row* const row = table.find({scene, machine, preset, kilobytes});
  if (row == nullptr) throw std::runtime_error("there is no row of " + scene + ", " + machine + ", " + preset);
  return *row;
}

/// "28.4".
std::string millions(const measured::Table& table, const std::string& scene, const std::string& machine,
                     const std::string& preset, const std::string& kilobytes) {
  const measured::Row& row = row_in(table, scene, machine, preset, kilobytes);
  const std::uint64_t tenths = (std::stoull(row.at(5)) + 50'000) / 100'000;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

/// "60,648", with 22 KB of RAM.
std::string flash_bytes(const measured::Table& table, const std::string& scene, const std::string& machine,
                        const std::string& preset) {
  std::string digits = row_in(table, scene, machine, preset, "22").at(7);
  if (digits.size() > 3) digits.insert(digits.size() - 3, ",");
  return digits;
}

}  // namespace

measured::Table gallery_format() {
  return {.part = "gallery",
          .columns = {{"scene"},
                      {"machine"},
                      {"preset"},
                      {"ram_kilobytes"},
                      {"strip_rows", measured::kExact},
                      {"instructions", measured::kInstructions},
                      {"instructions_at_most", measured::kInstructions},
                      {"flash_bytes", measured::kFlash}}};
}

Counted parse_counted(const std::string& printed) {
  Counted counted;
  std::istringstream text(printed);
  text >> counted.strip_rows >> counted.crc32;
  for (std::uint64_t instructions = 0; text >> instructions;) counted.instructions.push_back(instructions);
  if (counted.instructions.empty()) throw std::runtime_error("no frames are counted: " + printed);
  return counted;
}

measured::Row row_of(const std::string& scene, const std::string& machine, const std::string& preset,
                     const std::string& kilobytes, const Counted& counted, std::uint32_t flash) {
  const auto& frames = counted.instructions;
  const std::uint64_t sum = std::accumulate(frames.begin(), frames.end(), std::uint64_t{0});
  return {scene,
          machine,
          preset,
          kilobytes,
          counted.strip_rows,
          std::to_string(sum / frames.size()),
          std::to_string(*std::ranges::max_element(frames)),
          std::to_string(flash)};
}

std::string gallery_page(const measured::Table& table) {
  std::ostringstream page;
  page << "# Instructions and flash of the gallery\n\n"
          "Counted by `tests/measure gallery`; [gallery.csv](gallery.csv) has the figures themselves. Million "
          "instructions a\nframe of the [whole scenes](../gallery.md#whole-scenes) at 240x240 pixels: the mean of four "
          "frames, at 0, 1/4, 1/2 and\n3/4 of the motion, in QEMU with `-icount`. Bending the skin of `fox` is in "
          "them, posing instances is not. Flash, in\nbytes, is that of the program that counts, with its start-up "
          "code, for 22 KB.\n\n";
  for (const std::string& note : table.notes) page << "- " << note << '\n';
  std::string heading = "| Scene | Processor ", rule = "|---|---|";
  for (const char* const preset : kPresets) {
    for (const char* const kilobytes : kKilobytes) {
      heading += std::string("| ") + preset + ", " + kilobytes + " KB ";
      rule += "--:|";
    }
  }
  for (const char* const preset : kPresets) heading += std::string("| flash, ") + preset + " ", rule += "--:|";
  page << '\n' << heading << "|\n" << rule << '\n';
  for (const char* const scene : kScenes) {
    for (const char* const machine : kMachines) {
      page << "| `" << scene << "` | Cortex-" << (machine == std::string("m3") ? "M3 " : "M0 ");
      for (const char* const preset : kPresets) {
        for (const char* const kilobytes : kKilobytes) {
          page << "| " << millions(table, scene, machine, preset, kilobytes) << ' ';
        }
      }
      for (const char* const preset : kPresets) page << "| " << flash_bytes(table, scene, machine, preset) << ' ';
      page << "|\n";
    }
  }
  return page.str();
}

PageRow row_of_page(const measured::Table& table, const std::string& scene) {
  return {
      "| `" + scene + "` | " + flash_bytes(table, scene, "m3", "size") + " | ",
      "| " + millions(table, scene, "m3", "size", "22") + " | " + millions(table, scene, "m3", "size", "48") + " |"};
}

}  // namespace zstrip::gallery
