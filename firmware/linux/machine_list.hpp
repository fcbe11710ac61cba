// Lists the devices of the machine that can show pictures.
#pragma once

#include <string>

namespace zstrip::panel {

/// Returns lines of text: the text console, framebuffers, graphics cards with their connectors, spidev, I2C buses, GPIO
/// chips with their lines and the users of these. If something cannot be read, a line says why.
std::string machine_list();

}  // namespace zstrip::panel
