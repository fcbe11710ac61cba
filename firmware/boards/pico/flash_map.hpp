// What lies where in a Pico's flash when a baked scene is beside the program that shows it, and what that program has
// for it. Of the program, of `zstrip bake` and of what makes .uf2 files.
#pragma once

#include <cstdint>

namespace zstrip::pico {

inline constexpr std::uint32_t kFlash = 0x10000000, kFlashBytes = 2 << 20;
inline constexpr std::uint32_t kPage = 256;     // which is programmed at once
inline constexpr std::uint32_t kSector = 4096;  // which is erased at once

/// The scene has the upper half of the flash: the program may grow in any release without moving it, and sectors are
/// whole, so that the boot loader replaces one and leaves the other.
inline constexpr std::uint32_t kScene = kFlash + kFlashBytes / 2, kSceneBytes = kFlash + kFlashBytes - kScene;
static_assert((kScene - kFlash) % kSector == 0);

/// What the player has of the RAM for all that is not in flash.
inline constexpr std::uint32_t kPlayerMemory = 248 * 1024;

/// Of the panel, which the scene is baked for.
inline constexpr std::uint16_t kPanelSide = 240;

/// Of a strip, where a plan with them fits: three strips, so that the bus has little to do before the first one is
/// drawn and after the last one. More of them make scenes of many triangles slower.
inline constexpr std::uint16_t kStripRows = 80;

/// What the program shows where there is no scene. `zstrip bake` knows by kReads, which is part of it, that a program
/// reads scenes of this version from this place.
#define ZSTRIP_PICO_READS "scene of version 5 at 10100000"
inline constexpr char kReads[] = ZSTRIP_PICO_READS;
inline constexpr char kNoScene[] =
    "no " ZSTRIP_PICO_READS
    " in the flash. zstrip bake MODEL -o scene.uf2, hold BOOTSEL while plugging in, copy "
    "scene.uf2 to the drive";
#undef ZSTRIP_PICO_READS
static_assert(kScene == 0x10100000);

}  // namespace zstrip::pico
