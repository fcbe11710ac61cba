// What each effect costs: its scene with and without it. `tests/measure effects` and a test run it; part.hpp has
// the words; beside them `k5` and `set EFFECT`, which say what tests/effects/compiled_out builds.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "list.hpp"
#include "machines.hpp"
#include "memory_table.hpp"
#include "part.hpp"
#include "table_page.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/stage.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;
using measured::kExact;

constexpr const char* kHost = "host";
/// What layout and alignment move in common code, in bytes and in instructions of a frame.
constexpr measured::Tolerance kFlashMore{.share = 0.01, .at_least = 16};
constexpr measured::Tolerance kInstructionsMore{.share = 0.01, .at_least = 100};

measured::Table format() {
  return {.part = "effects",
          .columns = {{"effect"},
                      {"machine"},
                      {"flash", kFlashMore},
                      {"ram", kExact},
                      {"instructions", kInstructionsMore},
                      {"count", kExact},
                      {"unit", kExact}}};
}

std::size_t place_of(const std::string& effect) {
  std::size_t place = 0;
  while (kCosts[place].effect != effect) {
    if (++place == std::size(kCosts)) throw std::runtime_error("there is no effect " + effect);
  }
  return place;
}

/// Of a frame, those that the effect touches. Only what calls for the effect is drawn, so that nothing hides it.
std::uint64_t touched(const CostOfEffect& cost) {
  const scenes::BuiltIn& built_in = *cost.with.scene;
  const View& view = cost.with.view;
  const Effects effects = effects_of(built_in.scene, built_in.camera) | effects_of(view) | effect::statistics;
  const Plan plan = zstrip::plan(built_in.counts, view, effects, {.strip_rows = view.height}).plan;
  std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1), pixels(plan.strip_pixel_bytes(view) / 8 + 1);
  AnyRenderer renderer(effects);
  std::size_t edges = 0;
  for (const EdgeSet& set : built_in.scene.edges) edges += set.edges.size();
  if (cost.unit == "edge") return edges;
  if (cost.unit == "pixel") return std::uint64_t{kWidth} * kHeight;
  std::uint64_t count = 0;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    scenes::Staged staged;
    stage(built_in, staged, frame, kFramesPerTurn, view);
    std::vector<Instance> instances;
    for (const Instance& instance : staged.scene.instances) {
      Scene alone = staged.scene;
      alone.instances = {&instance, 1};
      alone.quadrics = {};
      alone.lines = {};
      if ((effects_of(alone, staged.camera) | cost.called_for).any(cost.own)) instances.push_back(instance);
    }
    staged.scene.instances = instances;
    if (cost.unit == "instance") count += instances.size();
    for (const Instance& instance : instances) {
      if (cost.unit == "vertex") count += staged.scene.meshes[instance.mesh].positions.size();
    }
    if (cost.unit != "fragment") continue;
    if (!renderer.begin_frame(staged.scene, staged.camera, view, plan, std::as_writable_bytes(std::span(arena))) ||
        !renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels)))) {
      throw std::runtime_error(std::string(cost.effect) + ": its scene is not drawn");
    }
    // Every pixel of a picture that is dithered as a whole.
    count += renderer.frame().statistics().fragments;
  }
  return count / kFrames;
}

std::int64_t more(std::uint64_t with, std::uint64_t without) {
  return static_cast<std::int64_t>(with) - static_cast<std::int64_t>(without);
}

/// "arena instructions", which the program prints.
std::pair<std::uint64_t, std::uint64_t> drawn(const std::string& machine, const std::filesystem::path& build,
                                              std::size_t number) {
  const std::filesystem::path program = build / machine / ("draw_" + name_of(drawing_at(number).effects));
  std::pair<std::uint64_t, std::uint64_t> result{};
  std::istringstream text(printed_on(machine, program, std::to_string(number)));
  if (!(text >> result.first >> result.second)) throw std::runtime_error(program.string() + " prints " + text.str());
  return result;
}

std::vector<measured::Row> measure(const std::string& effect, const std::filesystem::path& build,
                                   const Names& machines) {
  const std::size_t place = place_of(effect);
  const CostOfEffect& cost = kCosts[place];
  const std::string count = std::to_string(touched(cost));
  std::vector<measured::Row> rows;
  for (const std::string& machine : machines) {
    std::string flash, ram;
    std::int64_t instructions = 0;
    if (machine == kHost) {
      const auto here = [&](std::size_t number) {
        return instructions_here(build / kHost / ("draw_" + name_of(drawing_at(number).effects)),
                                 std::to_string(number)) /
               kFrames;
      };
      instructions = more(here(2 * place), here(2 * place + 1));
    } else {
      const auto weigh = [&](Effects effects) { return flash_of(build / machine / ("weigh_" + name_of(effects))); };
      const auto with = drawn(machine, build, 2 * place), without = drawn(machine, build, 2 * place + 1);
      flash = std::to_string(more(weigh(cost.with.effects), weigh(cost.without.effects)));
      ram = std::to_string(more(with.first, without.first));
      instructions = more(with.second, without.second);
    }
    rows.push_back({effect, machine, flash, ram, std::to_string(instructions), count, std::string(cost.unit)});
  }
  return rows;
}

/// With two digits that count.
std::string quotient(const std::string& sum, const std::string& count) {
  const double each = std::strtod(sum.c_str(), nullptr) / std::strtod(count.c_str(), nullptr);
  char text[32];
  std::snprintf(text, sizeof text, each > -10 && each < 10 ? "%.1f" : "%.0f", each);
  return text;
}

std::string page(const measured::Table& table) {
  std::ostringstream text;
  text << "# What each effect costs\n\nMeasured by `tests/measure effects`; [effects](../effects.md#what-each-costs) "
          "says\n"
          "how, and [effects.csv](effects.csv) has the same figures. What the effect adds, on a Cortex-M0 / M3 / "
          "M4F;\n"
          "instructions also on this host, x86-64.\n\n"
       << notes_of(table)
       << "\n| Effect | Flash, bytes | RAM, bytes | Instructions a frame | of | each |\n|---|---|---|---|---|---|\n";
  for (const std::string& effect : effects_in(table)) {
    const std::vector<measured::Row> rows = rows_of(table, effect);
    const std::string &count = rows.front()[5], &unit = rows.front()[6];
    const auto column = [&](std::size_t at, const auto& shown) {
      Names cells;
      for (const measured::Row& row : rows) {
        if (!row[at].empty()) cells.push_back(shown(row[at]));
      }
      return joined(cells);
    };
    const auto itself = [](const std::string& cell) { return cell; };
    text << "| `" << effect << "` | " << column(2, itself) << " | " << column(3, itself) << " | " << column(4, itself)
         << " | " << count << ' '
         << (count == "1"       ? unit
             : unit == "vertex" ? "vertices"
                                : unit + "s")
         << " | " << column(4, [&](const std::string& cell) { return quotient(cell, count); }) << " |\n";
  }
  return text.str();
}

}  // namespace

int main(int count, char** words) {
  Part part{.format = format(),
            .notes = {budget::compiler_note(), "host: compiled by g++ " __VERSION__ " with -O3"},
            .names = {},
            // Of vertices, of fragments, and with a pass of its own.
            .usual = {"specular", "blending", "shadows"},
            .programs =
                [](const std::string& effect) {
                  const CostOfEffect& cost = kCosts[place_of(effect)];
                  return std::set<std::string>{name_of(cost.with.effects), name_of(cost.without.effects)};
                },
            .measure = measure,
            .page = page,
            .check = {}};
  for (const CostOfEffect& cost : kCosts) part.names.emplace_back(cost.effect);
  const std::string_view command = count > 1 ? words[1] : "";
  if (command == "k5") {  // its set of effects, and the number of a drawing of it
    const std::size_t number = 2 * place_of("dithered_colours") + 1;
    std::cout << name_of(drawing_at(number).effects) << ' ' << number << '\n';
    return 0;
  }
  if (command == "set" && count == 3) {  // of the scene with this effect
    std::cout << name_of(kCosts[place_of(words[2])].with.effects) << '\n';
    return 0;
  }
  return run_part(count, words, part);
}
