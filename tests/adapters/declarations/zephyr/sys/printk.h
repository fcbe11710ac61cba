// Of Zephyr: the name that the program of the package calls.
#pragma once

[[gnu::format(printf, 1, 2)]] void printk(const char* format, ...);
