# Cross compiler for Cortex-M: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/arm-none-eabi.cmake -DZSTRIP_CPU=cortex-m3
# ZSTRIP_CPU is what GCC's -mcpu takes: cortex-m0, cortex-m0plus, cortex-m23, cortex-m33 ...
# ZSTRIP_FPU is what its -mfpu takes, for floats in FPU registers; auto: that of the processor; none: no FPU. The
# renderer has no floats, but linkers refuse to mix the two: say what the rest of the program is compiled with. By
# default M4, M7 and M55 have their FPU.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
# Test programs of CMake are not linked, because there is no C library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ZSTRIP_CPU ZSTRIP_FPU)

set(zstrip_fpu_of_cortex-m4 fpv4-sp-d16)
set(zstrip_fpu_of_cortex-m7 fpv5-sp-d16)
set(zstrip_fpu_of_cortex-m55 auto)
set(ZSTRIP_CPU cortex-m3 CACHE STRING "The processor to compile for")
set(zstrip_fpu none)
if(DEFINED zstrip_fpu_of_${ZSTRIP_CPU})
  set(zstrip_fpu ${zstrip_fpu_of_${ZSTRIP_CPU}})
endif()
set(ZSTRIP_FPU ${zstrip_fpu} CACHE STRING "Its FPU, or none")
set(zstrip_cpu_flags "-mcpu=${ZSTRIP_CPU} -mthumb")
if(NOT ZSTRIP_FPU STREQUAL "none")
  string(APPEND zstrip_cpu_flags " -mfloat-abi=hard -mfpu=${ZSTRIP_FPU}")
endif()
# The compiler's own words, instead of a compiler that seems broken.
separate_arguments(zstrip_cpu_flag_list UNIX_COMMAND "${zstrip_cpu_flags}")
execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${zstrip_cpu_flag_list} -fsyntax-only -x c++ /dev/null
  RESULT_VARIABLE zstrip_cpu_status OUTPUT_QUIET ERROR_VARIABLE zstrip_cpu_error)
if(NOT zstrip_cpu_status EQUAL 0)
  message(FATAL_ERROR "${CMAKE_CXX_COMPILER} does not take ZSTRIP_CPU=${ZSTRIP_CPU}, ZSTRIP_FPU=${ZSTRIP_FPU}: "
    "${zstrip_cpu_status}\n${zstrip_cpu_error}")
endif()

set(CMAKE_CXX_FLAGS_INIT "${zstrip_cpu_flags} -ffunction-sections -fdata-sections")
# No C library: of the compiler's libraries only libgcc, after everything else.
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")
# In the cache before CMake's own default, which is -O3.
set(CMAKE_CXX_FLAGS_RELEASE "-O2" CACHE STRING "Flags of the Release build type")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
