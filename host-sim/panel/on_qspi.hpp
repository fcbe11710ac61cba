// A driver of a panel with MIPI's commands, on the QSPI of a model.
#pragma once

#include "panel/model_bus.hpp"
#include "zstrip_hal/mipi_dcs.hpp"
#include "zstrip_hal/qspi.hpp"

namespace zstrip::sim {

/// Is destroyed after the driver that refers to it.
struct ModelQspi {
  hal::QspiBus<ModelBus> qspi;
};

/// Cannot be copied, because the driver refers to its bus.
template <template <class, class> class Display>
class OnQspi : private ModelQspi, public Display<hal::QspiBus<ModelBus>, ModelBus> {
 public:
  OnQspi(ModelBus& wires, const hal::DcsConfig& config)
      : ModelQspi{hal::QspiBus<ModelBus>(wires)}, Display<hal::QspiBus<ModelBus>, ModelBus>(qspi, wires, config) {}
  OnQspi(const OnQspi&) = delete;
  OnQspi& operator=(const OnQspi&) = delete;
};

}  // namespace zstrip::sim
