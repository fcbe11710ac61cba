// The minimal programs of project/, and how they are built: what rows and columns of docs/measured/flash.csv mean.
#pragma once

#include <string>

#include "measured/table.hpp"
#include "weight.hpp"

namespace zstrip::flash {

struct Program {
  const char* name;      ///< of its target
  const char* scene;     ///< for readers
  const char* renderer;  ///< likewise
};
inline constexpr Program kPrograms[] = {
    {"k5_unclipped", "K5", "`FixedRenderer`, `unclipped`"},
    {"k5", "K5", "`FixedRenderer`"},
    {"k5_run_time", "K5", "`Renderer`"},
    {"ct_unclipped", "CT", "`FixedRenderer`, `unclipped`"},
    {"ct", "CT", "`FixedRenderer`"},
    {"ct_run_time", "CT", "`Renderer`"},
    {"pyramid", "pyramid", "`FixedRenderer`, `unclipped`"},
};

struct Preset {
  const char* name;     ///< ZSTRIP_PRESET
  const char* options;  ///< for readers
};
inline constexpr Preset kPresets[] = {{"size", "-Os, LTO"}, {"speed", "-O2"}};

struct Machine {
  const char* name;       ///< of the folder of a build
  const char* processor;  ///< for readers
};
inline constexpr Machine kMachines[] = {{"m3", "Cortex-M3"}, {"m0", "Cortex-M0"}};

/// Without rows and notes.
measured::Table flash_format();

measured::Row row_of(const std::string& program, const std::string& machine, const std::string& preset,
                     const Weight& weight);

/// The table for readers: docs/measured/flash.md.
std::string flash_page(const measured::Table& table);

}  // namespace zstrip::flash
