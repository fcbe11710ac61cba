# Cross compiler for the ARM926EJ-S, an ARMv5TE core without FPU: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/arm926ej-s.cmake
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_CXX_FLAGS_INIT "-mcpu=arm926ej-s -marm -ffunction-sections -fdata-sections")
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")
