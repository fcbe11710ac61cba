// Of the Raspberry Pi Pico SDK 1.5 and 2: the name that a program with two cores calls.
#pragma once

void multicore_launch_core1(void (*entry)());
