// Refuses language versions before C++20, and says what to do. Headers of an application include this file first. The
// compiler stops at the #error, instead of reporting hundreds of errors with the same cause.
#pragma once

#if __cplusplus < 202002L
// clang-format off
#error zstrip needs C++20 (GCC 11, Clang 14 or later). On a command line: -std=c++20. Arduino: a line compiler.cpp.extra_flags=-std=gnu++20 in platform.local.txt, beside platform.txt of the board package. PlatformIO: build_unflags = -std=gnu++11 -std=gnu++14 -std=gnu++17 and build_flags = -std=gnu++20 in platformio.ini. ESP-IDF: release 5.0 or later. Zephyr: CONFIG_STD_CPP20=y. STM32CubeIDE: Properties, C/C++ Build, Settings, MCU G++ Compiler, General, Language standard GNU++20. CMake: target_compile_features(your_program PRIVATE cxx_std_20).
#include "C++20"
// clang-format on
#endif
