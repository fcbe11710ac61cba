// Records in docs/measured/changes.csv how many bytes a panel is sent of the frames of scenes, and writes the page of
// it; or compares. The part `changes` of tests/measure.
//   zstrip_changed_bytes measure [--exact] [SCENE...]
//   zstrip_changed_bytes check [SCENE...]
// Exit status: 0 yes, 1 no, 2 wrong words.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "bench/board_model.hpp"
#include "measured/update.hpp"
#include "panel/simulated_panel.hpp"
#include "render/render_frame.hpp"

namespace {

using namespace zstrip;

constexpr std::uint16_t kSide = 240, kRows = 16;
constexpr std::uint32_t kFrames = 64;
constexpr double kMilliseconds = 8 / 12.5e3;  // of a byte on SPI with 12.5 MHz
// What may be sent of what is asked for: the rectangle that changes, in tiles and in strips.
constexpr double kOverShare = 1.2;

/// A scene, and the share of the picture's bytes that the smallest rectangle with all changes has in the mean; 0: it is
/// not known.
struct Case {
  const char* name;
  const char* scene;
  double rectangle;
};
constexpr Case kCases[] = {
    {"train", ZSTRIP_SCENE_FILES "/gallery/train.toml", 0.11},
    {"figure", ZSTRIP_SCENE_FILES "/figure/figure.gltf", 0.20},
    {"teapot", "teapot", 0.31},
    {"astronaut", ZSTRIP_SCENE_FILES "/gallery/astronaut.toml", 0.60},
    {"watch", ZSTRIP_SCENE_FILES "/gallery/watch.toml", 0.64},
    {"robot", ZSTRIP_SCENE_FILES "/gallery/robot.toml", 1.0},
    {"lighthouse", ZSTRIP_SCENE_FILES "/gallery/lighthouse.toml", 0},
    {"chess", ZSTRIP_SCENE_FILES "/gallery/chess.toml", 0},
    {"home", ZSTRIP_SCENE_FILES "/gallery/home.toml", 0},
    {"knot", "knot", 0},
    {"room", "room", 0},
};

const std::filesystem::path kFile = ZSTRIP_MEASURED "/changes.csv";

measured::Table format() {
  return {.part = "changes",
          .columns = {{"scene"},
                      {"bytes_whole", measured::kExact},
                      {"bytes_changed", measured::Tolerance{.share = 0.01}},
                      {"strips", measured::kExact},
                      {"strips_drawn", measured::Tolerance{.at_least = 0.1}}}};
}

template <class T>
T value_of(sim::Result<T> result) {
  if (!result) throw std::runtime_error(result.failure().message);
  return std::move(*result);
}

/// The mean of all frames of a motion but the first.
measured::Row row_of(const Case& of) {
  const View view{kSide, kSide, PixelFormat::rgb565_swapped};
  const sim::PanelKind& kind = sim::panel_kinds().front();
  const auto panel = sim::open_panel({.kind = &kind,
                                      .module = kind.modules.front(),
                                      .orientation = {},
                                      .format = hal::DisplayFormat::rgb565_swapped,
                                      .bus = sim::BusKind::spi,
                                      .cycle = sim::Nanoseconds(80),
                                      .changes = true});
  if (panel->start() != hal::Error::none) throw std::runtime_error("the panel does not start");
  const auto stage = value_of(sim::open_stage(of.scene, {}, {}, view, kFrames));
  sim::FrameRenderer renderer(view, {.strip_rows = kRows});
  renderer.show_on(*panel);
  std::uint64_t whole = 0, before = panel->bytes();
  std::uint32_t strips = 0, drawn = 0;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    const sim::FrameReport report = value_of(renderer.render(value_of(stage->place(frame, kFrames))));
    if (frame == 0) {
      whole = panel->bytes() - before;
      before = panel->bytes();
      strips = report.plan.strips;
    } else {
      drawn += report.drawn_strips;
    }
  }
  const std::uint64_t changed = (panel->bytes() - before) / (kFrames - 1);
  char mean[16];
  std::snprintf(mean, sizeof mean, "%.1f", drawn / double{kFrames - 1});
  return {of.name, std::to_string(whole), std::to_string(changed), std::to_string(strips), mean};
}

/// What is wrong with the share of a row.
std::string over_bound(const Case& of, const measured::Row& row) {
  const double share = std::stod(row[2]) / std::stod(row[1]);
  if (of.rectangle == 0 || share <= kOverShare * of.rectangle) return {};
  return std::string(of.name) + ": " + std::to_string(share) + " of the bytes are sent, more than 1.2 times " +
         std::to_string(of.rectangle) + "\n";
}

/// Milliseconds of whole frames and of what changed, by the board's fastest clock.
void write_boards(std::ostream& page, const measured::Table& table) {
  constexpr const char* kBoards[] = {"microbit", "bluepill", "stm32f4", "pico", "esp32s3"};
  page << R"(
## By board
Milliseconds on the bus, whole and only what changed, with the fastest clock that the board's chip drives a display
with. The ST7789's data sheet allows 15 MHz; many programs run it faster.

| Scene |)";
  std::string rule = "|---|";
  std::vector<double> clocks;
  for (const char* const name : kBoards) {
    clocks.push_back(sim::find_board(name)->spi_mhz);
    char head[60];
    std::snprintf(head, sizeof head, " `%s`, %g MHz |", name, clocks.back());
    page << head;
    rule += "--:|";
  }
  page << '\n' << rule << '\n';
  for (const measured::Row& row : table.rows) {
    page << "| `" << row[0] << "` |";
    for (const double mhz : clocks) {
      char cell[40];
      std::snprintf(cell, sizeof cell, " %.1f, %.1f |", std::stod(row[1]) * 8 / (mhz * 1e3),
                    std::stod(row[2]) * 8 / (mhz * 1e3));
      page << cell;
    }
    page << '\n';
  }
}

void write_page(const measured::Table& table) {
  std::ofstream page(std::filesystem::path(kFile).replace_extension(".md"));
  page << R"(# What is sent of frames

Written by `tests/measure changes`; [changes.csv](changes.csv) has the same figures. Bytes on the bus of an ST7789 with
240x240 pixels, commands included, in strips of 16 rows: the mean of the frames 1 to 63 of 64 that show the scene's
motion. `ChangedTiles` [sends only what changed](../displays.md#send-only-what-changed). The rectangle is the smallest
one that has all changed pixels of a frame, in the mean; a test allows 1.2 times its share. Milliseconds are those of
SPI at 12.5 MHz. A strip in which nothing can have changed
[is not drawn](../displays.md#strips-that-are-not-drawn).

| Scene | Whole frame | ms | Only what changed | ms | Share | Rectangle | Strips drawn |
|---|--:|--:|--:|--:|--:|--:|--:|
)";
  for (const measured::Row& row : table.rows) {
    const double whole = std::stod(row[1]), changed = std::stod(row[2]);
    char text[200], rectangle[16] = "";
    for (const Case& of : kCases) {
      if (row[0] == of.name && of.rectangle != 0) std::snprintf(rectangle, sizeof rectangle, "%.2f", of.rectangle);
    }
    std::snprintf(text, sizeof text, "| `%s` | %s | %.1f | %s | %.1f | %.2f | %s | %s of %s |\n", row[0].c_str(),
                  row[1].c_str(), whole * kMilliseconds, row[2].c_str(), changed * kMilliseconds, changed / whole,
                  rectangle, row[4].c_str(), row[3].c_str());
    page << text;
  }
  write_boards(page, table);
  page << "\n[The Pico's figures](pico.md) have the time of whole frames, drawing included.\n";
  if (!page.flush()) throw std::runtime_error("cannot write the page");
}

std::vector<std::string> known() {
  std::vector<std::string> names;
  for (const Case& of : kCases) names.emplace_back(of.name);
  return names;
}

int check(const std::vector<std::string>& scenes) {
  const measured::Table recorded = measured::read_table(kFile, format());
  std::string lines;
  for (const Case& of : kCases) {
    if (!scenes.empty() && std::ranges::find(scenes, of.name) == scenes.end()) continue;
    const measured::Row row = row_of(of);
    lines += measured::complaint(recorded, row) + over_bound(of, row);
  }
  std::cout << lines;
  return lines.empty() ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> given(words + 1, words + count);
  if (!given.empty() && given[0] == "check") {
    try {
      return check({given.begin() + 1, given.end()});
    } catch (const std::exception& error) {
      std::cerr << error.what() << '\n';
      return 1;
    }
  }
  return measured::run_update(count, words, "zstrip_changed_bytes measure", 1,
                              [](const std::vector<std::string>&, const measured::Choice& choice) {
                                measured::check(choice, known());
                                measured::Table fresh = format();
                                for (const Case& of : kCases) {
                                  if (choice.has(of.name)) fresh.rows.push_back(row_of(of));
                                }
                                const measured::Table table = measured::merged(
                                    measured::recorded_or_empty(kFile, format()), fresh, choice.exact, choice.whole());
                                measured::write_table(kFile, table);
                                write_page(table);
                              });
}
