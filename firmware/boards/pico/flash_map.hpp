// Flash addresses of a Pico or Pico 2 for a baked scene and the program that shows it, and the limits of that program.
// The program, `zstrip bake` and the tools that make .uf2 files share this header.
#pragma once

#include <cstdint>

namespace zstrip::pico {

inline constexpr std::uint32_t kFlash = 0x10000000;
inline constexpr std::uint32_t kPage = 256;     // programmed at once
inline constexpr std::uint32_t kSector = 4096;  // erased at once

/// The program has the first megabyte of the flash, the scene the rest: the program may grow in later releases without
/// moving the scene. Sectors are not shared, so that the boot loader can replace one part and leave the other.
inline constexpr std::uint32_t kScene = kFlash + (1 << 20);
static_assert((kScene - kFlash) % kSector == 0);

/// The side of the panel for which the scene is baked, in pixels.
inline constexpr std::uint16_t kPanelSide = 240;

/// The rows of a strip, if a plan with so many fits: three strips, so that the bus has little to send before the first
/// one is drawn and after the last one. More strips make scenes with many triangles slower.
inline constexpr std::uint16_t kStripRows = 80;

/// `zstrip bake` finds this text in a program that reads scenes of this version from this address. It is part of the
/// message that the program shows if there is no scene.
#define ZSTRIP_PICO_READS "scene of version 6 at 10100000"
inline constexpr char kReads[] = ZSTRIP_PICO_READS;
static_assert(kScene == 0x10100000);

/// A board with its player, the program that shows a scene.
struct Board {
  const char* name;    ///< for options
  const char* called;  ///< used in sentences
  const char* chip;
  std::uint32_t family;  ///< family of the chip, in .uf2 files
  std::uint32_t flash_bytes;
  const char* player;           ///< the program's name
  std::uint32_t player_memory;  ///< bytes of RAM that it has for data that is not in flash
  const char* no_scene;         ///< the message that it then shows

  constexpr std::uint32_t scene_bytes() const { return kFlash + flash_bytes - kScene; }
};

#define ZSTRIP_PICO_NO_SCENE(options)                                             \
  "no " ZSTRIP_PICO_READS " in the flash. zstrip bake MODEL -o scene.uf2" options \
  ", hold BOOTSEL while plugging in, copy scene.uf2 to the drive"
inline constexpr Board kPico{.name = "pico",
                             .called = "Pico",
                             .chip = "RP2040",
                             .family = 0xE48BFF56,
                             .flash_bytes = 2 << 20,
                             .player = "zstrip_pico_player",
                             .player_memory = 246 * 1024,
                             .no_scene = ZSTRIP_PICO_NO_SCENE("")};
/// Returns a board whose player has hot code in RAM. The scene has `bytes` less, for that code and some KB in which it
/// may grow.
constexpr Board with_hot_code(Board board, const char* name, const char* player, std::uint32_t bytes,
                              const char* no_scene) {
  board.name = name, board.player = player, board.no_scene = no_scene;
  board.player_memory -= bytes;
  return board;
}
inline constexpr Board kPicoHot =
    with_hot_code(kPico, "pico_hot", "zstrip_pico_player_hot", 28 * 1024, ZSTRIP_PICO_NO_SCENE(" --board pico_hot"));
/// The board with the RP2350's Arm processors, secure.
inline constexpr Board kPico2{.name = "pico2",
                              .called = "Pico 2",
                              .chip = "RP2350",
                              .family = 0xE48BFF59,
                              .flash_bytes = 4 << 20,
                              .player = "zstrip_pico2_player",
                              .player_memory = 507 * 1024,
                              .no_scene = ZSTRIP_PICO_NO_SCENE(" --board pico2")};
/// Returns the same board with programs for its RISC-V processors.
constexpr Board on_riscv(Board board) {
  board.name = "pico2_riscv", board.family = 0xE48BFF5A;
  return board;
}
inline constexpr Board kPico2Riscv = on_riscv(kPico2);
inline constexpr Board kPico2Hot = with_hot_code(kPico2, "pico2_hot", "zstrip_pico2_player_hot", 32 * 1024,
                                                 ZSTRIP_PICO_NO_SCENE(" --board pico2_hot"));
#undef ZSTRIP_PICO_NO_SCENE
#undef ZSTRIP_PICO_READS

inline constexpr const Board* kBoards[] = {&kPico, &kPicoHot, &kPico2, &kPico2Hot};

}  // namespace zstrip::pico
