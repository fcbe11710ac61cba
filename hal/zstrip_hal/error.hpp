// Errors between the processor and a panel, as values.
#pragma once

#include <cstdint>

namespace zstrip::hal {

/// The reason why a call of a pin, a bus or a display failed.
enum class [[nodiscard]] Error : std::uint8_t{
    none,              ///< success
    timeout,           ///< the bus or the panel did not get ready in the time that its driver states
    area,              ///< an empty area, or one that reaches beyond the display
    alignment,         ///< the area does not begin and end at whole bytes, which the panel needs
    pixels_too_small,  ///< fewer bytes than the area needs
    strip_layout,      ///< the strips do not cover the display exactly
    bus,               ///< the bus reports a fault: no device acknowledges, a transfer was refused or broke off
    pin,               ///< a line cannot be set
    configuration,     ///< the controller does not support the display's configuration
    framebuffer,       ///< the picture does not fit its memory, or its rows overlap
    flip,              ///< the screen has not shown the previous picture in the time that its driver states
    wrong_id,          ///< the controller answers with another id, or does not answer
    second_core,       ///< the second core kept the first one waiting
    underrun,          ///< the panel has read a strip before it was complete
};

/// A short English phrase without a full stop, in static storage.
const char* message(Error error);

}  // namespace zstrip::hal
