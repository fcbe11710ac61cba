// Shows the baked scene that lies in the flash after the program (flash_map.hpp), on the panel of show_teapot.cpp. Any
// bytes are safe: the scene is checked first. Only tiles that changed are sent.
#include <array>
#include <cstddef>
#include <cstring>

#include "cortex_m/systick.hpp"
#include "pico/baked_pipelines.hpp"
#include "pico/flash_map.hpp"
#include "pico/panel_bus.hpp"
#include "pico/pins.hpp"
#include "pico/timer.hpp"
#include "portable/panel_program.hpp"
#include "zstrip/scene/blob_sections.hpp"
#include "zstrip_hal/changed_tiles.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_player/player.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::board;

static_assert(pico::kReads[17] - '0' == kSceneBlobVersion);

#ifdef ZSTRIP_HOT_IN_RAM
constexpr const pico::Board& kBoard = chip::hot_board();
#else
constexpr const pico::Board& kBoard = chip::board();
#endif

// Strips of another height may have more tiles, which are always sent.
constexpr std::uint32_t kTiles =
    hal::changed_tiles({pico::kPanelSide / pico::kStripRows, pico::kStripRows}, pico::kPanelSide);

alignas(kArenaAlignment) constinit std::array<std::byte, kBoard.player_memory> memory{};
constinit Player player(memory, &drawn_with_baked);

/// Returns the bytes that the scene claims to have, at most those of the flash; too many are an error later.
std::size_t scene_bytes(const void* scene) {
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, static_cast<const std::byte*>(scene) + offsetof(blob_layout::Header, bytes), sizeof bytes);
  return bytes < kBoard.scene_bytes() ? bytes : kBoard.scene_bytes();
}

/// Feeds the watchdog with each strip, because frames of any scene may take longer than the watchdog's time.
class FedPanel : public hal::St7789<PanelBus, SysTickClock> {
 public:
  using St7789::St7789;
  hal::Error wait() {
    const hal::Error error = St7789::wait();
    if (error == hal::Error::none) feed_watchdog();
    return error;
  }
};

/// The motion in real time. A host that steps through it gets as many frames as on a turntable.
class BakedShow {
 public:
  static constexpr std::size_t kMaxWords = 240;

  template <hal::Display Panel>
  static Failure show_for_ever(Panel& panel) {
    if (mark_fault_return()) return {"fault", FaultWords::all()};
    const auto* const scene = reinterpret_cast<const void*>(pico::kScene);
    if (std::memcmp(scene, "zs", 2) != 0) return {"scene", kBoard.no_scene};
    if (!player.open(scene, scene_bytes(scene)) ||
        !player.fit(panel, {.strip_buffers = 2, .strip_rows = pico::kStripRows}))
      return said();
    start_timer();
    player.play(milliseconds());
    HostControl control;
    for (std::uint32_t frame = 0;; frame = control.paused() ? (frame + 1) % kFrames : frame_now()) {
      if (control.paused()) player.seek(time_of(frame));
      if (!player.draw(panel)) return said();
      wait_for_tick();
      player.play(milliseconds());
      control.frame_shown(frame);
      // The time while a host paused the frames does not count.
      player.hold(true);
      player.play(milliseconds());
      player.hold(false);
    }
  }

 private:
  static constexpr std::uint32_t kFrames = 64;

  static Failure said() { return {"scene", player.error()}; }
  static std::uint32_t time_of(std::uint32_t frame) {
    return static_cast<std::uint32_t>(std::uint64_t{player.period()} * frame / kFrames);
  }
  static std::uint32_t frame_now() {
    return static_cast<std::uint32_t>(std::uint64_t{player.time()} * kFrames / player.period());
  }
};

}  // namespace

int main() {
  static constinit PanelBus bus;
  bus.start();
  static constinit SysTickClock clock(kHertz);
  static constinit FedPanel panel(bus, clock);
  static constinit hal::ChangedTiles<FedPanel, kTiles> changes(panel);
  return run_on_panel<BakedShow>(changes, PanelReset{}, clock, PanelLight{});
}
