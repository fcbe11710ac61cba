// Of Zephyr 4.4: the names that the adapter calls.
#pragma once

struct device;
bool device_is_ready(const struct device* dev);
