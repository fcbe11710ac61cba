// No symbol of an effect is linked into a program for a board whose scene lacks the effect: neither one whose name says
// so, nor one that K5's firmware has with the effect and not without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "elf_file.hpp"
#include "firmware_symbols.hpp"
#include "flash_rows.hpp"
#include "k5.hpp"
#include "markers.hpp"
#include "targets.hpp"
#include "zstrip/plan/quality.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace effects_test {
namespace {

namespace fs = std::filesystem;
using effects_cost::FlashRow;

/// Programs of one beginning that tests/budget/targets.cpp does not know, the scenes that they draw, and what else they
/// choose.
struct Other {
  std::string_view begin;
  std::vector<std::string_view> scenes;
  Effects chosen{};
};
const std::vector<Other> kOthers = {
    {"my_board_", {"teapot_meshlets"}},
    {"lm3s6965evb_stuck_bus", {"teapot"}},
    {"lm3s6965evb_display_test", {}},
    {"riscv_virt_teapot", {"teapot"}},
    {"riscv_virt_room", {"room"}, quality::exact.effects},
    {"riscv_virt_fault", {}},
    {"versatilepb_teapot_qvga", {"teapot"}},
    {"versatilepb_room_vga", {"room"}, quality::exact.effects},
    {"versatilepb_fault_qvga", {}},
    {"pipeline_k5_", {"knot"}},
    {"bench_bins_", {"knot", "cube", "random50", "random10k"}, effect::bins},
    {"bench_depth_", {"random50"}, effect::depth_state | effect::depth_ranges | effect::depth_formats},
    {"bench_visibility_",
     {"knot", "cube", "room", "knot_textured"},
     method::painter | method::front_to_back | method::hierarchical_z | method::midpoint_safe},
    {"store_bench_", {"room", "knot", "random10k"}},
};

/// The first calls functions of stages by themselves, without a scene; the others draw a scene that somebody has baked.
constexpr std::string_view kSkipped[] = {"self_test_", "scene_", "lm3s6965evb_scene"};

struct Program {
  std::string name;
  fs::path file;
  Effects effects;

  bool begins_with_one_of(std::initializer_list<std::string_view> words) const {
    return std::ranges::any_of(words, [&](std::string_view word) { return name.starts_with(word); });
  }
  /// A static layer, kept in the compressed store, which maps of shadows are kept in, too.
  bool has_store() const { return begins_with_one_of({"lm3s6965evb_layers", "store_bench_"}); }
  /// On processors of which no assembly transforms vertices.
  bool is_portable() const { return begins_with_one_of({"riscv_virt_", "versatilepb_"}); }
  /// On processors whose quotients come from a table.
  bool has_no_divider() const {
    return begins_with_one_of({"microbit_", "pico_", "versatilepb_"}) || name.ends_with("_m0");
  }
};

Effects effects_of_program(const std::string& name) {
  Effects effects{};
  bool known = false;
  for (const budget::Target& target : budget::targets()) {
    if (name != target.program) continue;
    effects = effects | budget::effects_of(target);
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
  if (!known) throw std::runtime_error(name + ": tests/effects/firmware_test.cpp does not know which scene it draws");
  return effects;
}

std::vector<Program> programs() {
  std::vector<Program> found;
  for (const auto& entry : fs::directory_iterator(ZSTRIP_FIRMWARE_BINARIES)) {
    constexpr std::string_view kBegin = "zstrip_";
    std::string name = entry.path().stem();
    if (entry.path().extension() != ".elf" || !name.starts_with(kBegin)) continue;
    name.erase(0, kBegin.size());
    if (std::ranges::any_of(kSkipped, [&](std::string_view begin) { return name.starts_with(begin); })) continue;
    found.push_back({name, entry.path(), effects_of_program(name)});
  }
  return found;
}

/// Effects by the symbols that K5 has with one of them and not without. What K5 loses with an effect it had before, so
/// that it is no other effect's own.
std::map<std::string, Effects> own_symbols() {
  const std::vector<FlashRow> rows = effects_cost::read_rows(ZSTRIP_ROOT "/docs/effects-symbols.csv");
  std::map<std::string, Effects> own;
  std::set<std::string> of_k5;
  for (const FlashRow& row : rows) {
    if (row.symbol.empty() || row.symbol.starts_with("__")) continue;  // the compiler's
    const auto* const comparison =
        std::ranges::find(effects_cost::kComparisons, row.effect, &effects_cost::Comparison::effect);
    if (comparison == std::end(effects_cost::kComparisons)) throw std::runtime_error("no effect " + row.effect);
    if (row.is_new()) own[row.symbol] = own[row.symbol] | comparison->added;
    if (row.with == 0 && comparison->without_it() == effects_cost::kK5) of_k5.insert(row.symbol);
  }
  std::erase_if(own,
                [&](const auto& each) { return of_k5.contains(each.first) && !each.second.any(effects_cost::kK5); });
  // K5 is not compared without vertex colours and with light, which needs it as well.
  if (const auto shared = own.find("shade_vertices"); shared != own.end()) {
    shared->second = shared->second | effect::lighting;
  }
  return own;
}

/// Whether a program may have it for another reason than the effect.
bool excused(const Program& program, const std::string& symbol, Effects effects) {
  if (program.is_portable() && symbol == "transform_vertices_portable") return true;
  if (program.has_no_divider() && symbol == "kReciprocalTable") return true;
  return program.has_store() && effects == effect::shadows && symbol.find("hadow") == std::string::npos;
}

/// Lines that name symbols of effects that are not among these.
std::string misplaced(const Program& program, Effects effects, const std::map<std::string, Effects>& own) {
  std::string lines;
  for (const budget::Symbol& symbol : budget::read_elf(program.file).symbols) {
    const std::string whole = budget::demangled(symbol.name);
    for (const Marker& marker : kMarkers) {
      if (!effects.any(marker.effects) && whole.find(marker.symbol) != std::string::npos &&
          !excused(program, marker.symbol, marker.effects)) {
        lines += whole + '\n';
      }
    }
    const std::string name = effects_cost::reader_name(symbol.name);
    const auto found = own.find(name);
    if (found != own.end() && !effects.any(found->second) && !excused(program, name, found->second))
      lines += name + '\n';
  }
  return lines;
}

TEST(FirmwareAbsence, ProgramsForBoardsHoldNoSymbolOfAnEffectThatTheirScenesLack) {
  const std::map<std::string, Effects> own = own_symbols();
  EXPECT_GT(own.size(), 300U);
  const std::vector<Program> all = programs();
  EXPECT_GT(all.size(), 30U);
  for (const Program& program : all) EXPECT_EQ(misplaced(program, program.effects, own), "") << program.name;
}

TEST(FirmwareAbsence, ASymbolOfAnEffectThatTheSceneLacksIsSeen) {
  const std::map<std::string, Effects> own = own_symbols();
  for (const Program& program : programs()) {
    for (const Effects effect : {effect::textures, effect::gouraud, effect::bins, effect::depth_state,
                                 effect::depth_ranges, effect::depth_w16, effect::perspective_1, method::painter}) {
      if (program.effects.has(effect)) {
        EXPECT_NE(misplaced(program, without(program.effects, effect), own), "") << program.name << ' ' << effect.bits;
      }
    }
  }
}

TEST(FirmwareAbsence, EveryEffectButAlphaOfTexelsHasSymbols) {
  const std::map<std::string, Effects> own = own_symbols();
  for (const effects_cost::Comparison& comparison : effects_cost::kComparisons) {
    const bool has_one = std::ranges::any_of(own, [&](const auto& each) { return each.second.any(comparison.added); });
    EXPECT_EQ(has_one, comparison.added != effect::texture_alpha) << comparison.effect;
  }
}

}  // namespace
}  // namespace effects_test
