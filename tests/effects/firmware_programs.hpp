// Programs for boards, and the effects of the scenes that they draw: none has a symbol of another effect.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "zstrip/effects.hpp"

namespace effects_test {

using namespace zstrip;

struct Program {
  std::string name;  ///< the file's, without "zstrip_" and its end
  std::filesystem::path file;
  Effects effects;

  bool begins_with_one_of(std::initializer_list<std::string_view> words) const;
  /// A static layer, kept in the compressed store, which maps of shadows are kept in, too.
  bool has_store() const { return begins_with_one_of({"lm3s6965evb_layers", "store_bench_"}); }
  /// On processors of which no assembly transforms vertices.
  bool is_portable() const { return begins_with_one_of({"pico2_riscv_", "riscv_virt_", "versatilepb_"}); }
  /// On processors whose quotients come from a table.
  bool has_no_divider() const {
    return begins_with_one_of({"microbit_", "pico_", "versatilepb_"}) || name.ends_with("_m0");
  }
};

/// All that draw a scene of which the effects are known. Throws std::runtime_error for one that nobody knows.
std::vector<Program> firmware_programs(const std::filesystem::path& folder);

/// Whether a program may have a symbol of these effects for another reason.
bool is_excused(const Program& program, const std::string& symbol, Effects effects);

/// Lines that name the program's symbols of effects that are not among these, by their names (markers.hpp).
std::string misplaced(const Program& program, Effects effects);

}  // namespace effects_test
