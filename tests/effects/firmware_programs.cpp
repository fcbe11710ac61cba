// Which scene each program draws, and the symbols that it has.
#include "firmware_programs.hpp"

#include <algorithm>
#include <stdexcept>

#include "elf_file.hpp"
#include "markers.hpp"
#include "reader_name.hpp"
#include "targets.hpp"
#include "zstrip/plan.hpp"
#include "zstrip_scenes/in_front.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace effects_test {
namespace {

namespace fs = std::filesystem;

/// Programs of one beginning that tests/budget/targets.cpp does not know, or of which it knows one scene of several
/// or not all effects: the scenes that they draw, and what else they choose.
struct Other {
  std::string_view begin;
  std::vector<std::string_view> scenes;
  Effects chosen{};
};
const std::vector<Other> kOthers = {
    {"my_board_", {"teapot_meshlets"}, effect::unclipped},
    {"pico_show", {"teapot"}, effect::bins},
    {"pico2_show", {"teapot"}, effect::bins},
    {"pico2_riscv_show", {"teapot"}, effect::bins | effect::unclipped},
    {"lm3s6965evb_stuck_bus", {"teapot"}, effect::unclipped},
    {"lm3s6965evb_display_test", {}},
    {"riscv_virt_teapot", {"teapot"}, effect::unclipped},
    {"riscv_virt_room", {"room"}, quality::exact.effects},
    {"riscv_virt_fault", {}},
    {"versatilepb_teapot_qvga", {"teapot"}, effect::unclipped},
    {"versatilepb_room_vga", {"room"}, quality::exact.effects},
    {"versatilepb_fault_qvga", {}},
    {"pipeline_k5_", {"knot"}},
    {"bench_m", {"teapot", "room", "knot_textured", "character"}},
    {"bench_rv32", {"knot", "cube", "knot_textured", "character"}},
    {"bench_bins_", {"knot", "cube", "random50", "random10k", "teapot", "room", "knot_textured"}, effect::bins},
    {"bench_depth_", {"random50"}, effect::depth_state | effect::depth_ranges | effect::depth_formats},
    {"bench_visibility_",
     {"knot", "cube", "room", "knot_textured"},
     method::painter | method::front_to_back | method::hierarchical_z | method::midpoint_safe},
    {"store_bench_", {"room", "knot", "random10k"}},
};

/// The first calls functions of stages by themselves, without a scene; the others draw a scene that somebody has baked.
constexpr std::string_view kSkipped[] = {"self_test_",        "scene_",      "bench_scene_", "played_",
                                         "lm3s6965evb_scene", "pico_player", "pico2_player"};

Effects effects_of_program(const std::string& name) {
  Effects effects{};
  bool known = false;
  for (const budget::Target& target : budget::targets()) {
    if (name != target.program) continue;
    effects = effects | budget::effects_of(target);
    // What turns in front of the camera is drawn without clipping.
    const scenes::BuiltIn* const turned = target.report == budget::Report::bench ? nullptr : scenes::find(target.scene);
    if (turned != nullptr && scenes::stays_in_front(*turned, target.view)) effects = effects | effect::unclipped;
    known = true;
  }
  for (const Other& other : kOthers) {
    if (!name.starts_with(other.begin)) continue;
    effects = effects | other.chosen;
    known = true;
    for (const std::string_view scene : other.scenes) {
      const scenes::BuiltIn* const found = scenes::find(scene);
      if (found == nullptr) throw std::runtime_error(std::string("no scene ").append(scene));
      effects = effects | effects_of(found->scene, found->camera);
    }
  }
  if (!known)
    throw std::runtime_error(name + ": tests/effects/firmware_programs.cpp does not know which scene it draws");
  return effects;
}

}  // namespace

bool Program::begins_with_one_of(std::initializer_list<std::string_view> words) const {
  return std::ranges::any_of(words, [&](std::string_view word) { return name.starts_with(word); });
}

std::vector<Program> firmware_programs(const fs::path& folder) {
  std::vector<Program> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    constexpr std::string_view kBegin = "zstrip_";
    std::string name = entry.path().stem();
    if (entry.path().extension() != ".elf" || !name.starts_with(kBegin)) continue;
    name.erase(0, kBegin.size());
    if (std::ranges::any_of(kSkipped, [&](std::string_view begin) { return name.starts_with(begin); })) continue;
    found.push_back({name, entry.path(), effects_of_program(name)});
  }
  return found;
}

bool is_excused(const Program& program, const std::string& symbol, Effects effects) {
  if (program.is_portable() && symbol == "transform_vertices_portable") return true;
  if (program.has_no_divider() && symbol == "kReciprocalTable") return true;
  return program.has_store() && effects == effect::shadows && symbol.find("hadow") == std::string::npos;
}

std::string misplaced(const Program& program, Effects effects) {
  std::string lines;
  for (const budget::Symbol& symbol : budget::read_elf(program.file).symbols) {
    const std::string whole = budget::demangled(symbol.name);
    for (const Marker& marker : kMarkers) {
      if (!effects.any(marker.effects) && whole.find(marker.symbol) != std::string::npos &&
          !is_excused(program, marker.symbol, marker.effects)) {
        lines += whole + '\n';
      }
    }
  }
  return lines;
}

}  // namespace effects_test
