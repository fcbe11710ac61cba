// Lists the devices of the machine that can show pictures.
#pragma once

#include <string>

namespace zstrip::panel {

/// Lines of text: the text console, framebuffers, graphics cards with their connectors, spidev, I2C buses, GPIO chips
/// with their lines and the users of those; for what cannot be read: why.
std::string machine_list();

}  // namespace zstrip::panel
