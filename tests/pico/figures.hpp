// docs/measured/pico.csv: what frames take on the running Pico.
#pragma once

#include <filesystem>

#include "measured/table.hpp"

namespace zstrip::pico {

inline measured::Table figures_format() {
  return {
      .part = "pico",
      .columns = {{"program"},
                  {"scene"},
                  {"cycles", measured::kInstructions},             // a frame
                  {"waiting", measured::kInstructions},            // of them, for the panel
                  {"misses", measured::Tolerance{.share = 0.05}},  // of the flash's cache; code that moves changes them
                  {"stack", measured::kExact}}};
}

inline const std::filesystem::path kFiguresFile = ZSTRIP_MEASURED "/pico.csv";

}  // namespace zstrip::pico
