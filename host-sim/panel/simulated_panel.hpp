// A complete panel: the driver of hal, a bus with a speed, and the model with the visible picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "panel/model_bus.hpp"
#include "panel/panel_model.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/orientation.hpp"

namespace zstrip::sim {

enum class BusKind : std::uint8_t { spi, i2c, qspi, rgb };

/// A module on the market: a controller and its glass, upright.
struct PanelModule {
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint16_t column_offset = 0;
  std::uint16_t row_offset = 0;
  bool is_round = false;  ///< only the largest circle of the glass is there
};

/// A controller, by its name on the command line.
struct PanelKind {
  const char* name;
  std::span<const PanelModule> modules;         ///< the first one is the usual one
  std::span<const hal::DisplayFormat> formats;  ///< the first one is the usual one
  Nanoseconds fastest_spi;                      ///< time of a cycle, from its data sheet; 0: it has no SPI
  Nanoseconds fastest_i2c;                      ///< 0: it has no I2C
  Nanoseconds fastest_qspi{};                   ///< 0: it has no QSPI
  Nanoseconds fastest_rgb{};                    ///< of its pixel clock; 0: it is not refreshed by an RGB bus

  /// Returns the time of a cycle on this bus, 0 if it has none.
  constexpr Nanoseconds fastest(BusKind bus) const {
    switch (bus) {
      case BusKind::spi: return fastest_spi;
      case BusKind::i2c: return fastest_i2c;
      case BusKind::qspi: return fastest_qspi;
      case BusKind::rgb: return fastest_rgb;
    }
    return {};
  }
  /// Returns the bus that is used if none is named.
  constexpr BusKind usual_bus() const {
    if (fastest_rgb != Nanoseconds{}) return BusKind::rgb;
    return fastest_spi != Nanoseconds{} ? BusKind::spi : BusKind::qspi;
  }
};

std::span<const PanelKind> panel_kinds();

struct PanelRequest {
  const PanelKind* kind = nullptr;
  PanelModule module;  ///< one of the kind's
  hal::Orientation orientation;
  hal::DisplayFormat format{};  ///< one of the kind's
  BusKind bus = BusKind::spi;
  Nanoseconds cycle{};   ///< one cycle of the bus's clock
  bool changes = false;  ///< only what changed since the frame before is sent (zstrip_hal/changed_tiles.hpp)
};

/// A hal::Display. Cannot be moved, because the driver refers to bus and model.
class SimulatedPanel {
 public:
  SimulatedPanel() = default;
  SimulatedPanel(const SimulatedPanel&) = delete;
  SimulatedPanel& operator=(const SimulatedPanel&) = delete;
  virtual ~SimulatedPanel() = default;

  virtual hal::Error start() = 0;
  virtual std::uint16_t width() const = 0;
  virtual std::uint16_t height() const = 0;
  virtual hal::DisplayFormat format() const = 0;
  virtual hal::Error begin_frame() = 0;
  virtual hal::Error write(const hal::Area& area, std::span<std::byte> pixels) = 0;
  virtual hal::Error wait() = 0;
  virtual hal::Error end_frame() = 0;
  /// Remembers strips only with PanelRequest::changes (zstrip_hal/present.hpp).
  virtual bool shows(const hal::Area& /*area*/, std::uint32_t /*fingerprint*/) { return false; }
  static constexpr std::size_t kStrips = 256;

  virtual const PanelModel& model() const = 0;
  /// Returns the bytes of all transfers.
  virtual std::uint64_t bytes() const = 0;
  /// Returns the time of all transfers and refreshes.
  virtual Nanoseconds busy() const = 0;
};

static_assert(hal::Display<SimulatedPanel>);

/// Returns a panel 120 ms after power-on, not started.
std::unique_ptr<SimulatedPanel> open_panel(const PanelRequest& request);

/// Returns false if the controller cannot rotate or mirror a picture so.
bool has_orientation(const PanelKind& kind, const hal::Orientation& orientation);

/// Returns the longest cycle of a bus with which no driver gives up waiting; 0: any.
Nanoseconds longest_cycle(BusKind bus);

/// Returns the number of rows whose multiples are the borders of strips; the picture's last row may end a strip, too.
std::uint16_t row_step(const PanelRequest& request);

/// Returns the time of a byte and of a transfer on a bus with this clock cycle.
BusTiming timing_of(BusKind bus, Nanoseconds cycle);

}  // namespace zstrip::sim
