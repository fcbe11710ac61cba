// Of Zephyr: the name that the program of the package calls.
#pragma once

#include <cstdint>

std::uint32_t k_uptime_get_32();
