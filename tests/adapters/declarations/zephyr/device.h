// Of Zephyr 4.4: the names that the adapter calls.
#pragma once

struct device;
bool device_is_ready(const struct device* dev);
// The program of the package chooses its display by the devicetree.
extern const struct device* const chosen_zephyr_display;
#define DT_CHOSEN(name) chosen_##name
#define DEVICE_DT_GET(node) node
