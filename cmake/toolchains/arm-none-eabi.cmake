# Cross compiler for Cortex-M: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/arm-none-eabi.cmake -DZSTRIP_CPU=cortex-m3
# ZSTRIP_CPU is one of cortex-m0, cortex-m3, cortex-m4 (with FPU), cortex-m7 (with FPU).
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
# There is no C library to link test programs with.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ZSTRIP_CPU)

set(zstrip_fpu_cortex-m4 "-mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(zstrip_fpu_cortex-m7 "-mfloat-abi=hard -mfpu=fpv5-sp-d16")
set(ZSTRIP_CPU cortex-m3 CACHE STRING "The processor to compile for")
set_property(CACHE ZSTRIP_CPU PROPERTY STRINGS cortex-m0 cortex-m3 cortex-m4 cortex-m7)
get_property(zstrip_cpus CACHE ZSTRIP_CPU PROPERTY STRINGS)
if(NOT ZSTRIP_CPU IN_LIST zstrip_cpus)
  message(FATAL_ERROR "ZSTRIP_CPU is '${ZSTRIP_CPU}'; it must be one of: ${zstrip_cpus}")
endif()

set(CMAKE_CXX_FLAGS_INIT
  "-mcpu=${ZSTRIP_CPU} -mthumb ${zstrip_fpu_${ZSTRIP_CPU}} -ffunction-sections -fdata-sections")
# No C library: of the compiler's libraries only libgcc, after everything else.
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")
# In the cache before CMake's own default, which is -O3.
set(CMAKE_CXX_FLAGS_RELEASE "-O2" CACHE STRING "Flags of the Release build type")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
