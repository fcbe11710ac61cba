# The host build drives one cross build for each processor; target `firmware` builds them all.
# Their programs appear in ZSTRIP_FIRMWARE_BINARIES.
include(ExternalProject)

# These two have benchmarks alone and run nearly the code of the Cortex-M4 and M33: they are built with ZSTRIP_LONG_TESTS,
# or by target `firmware`. Their pixels are checked in any case (tests/targets). Target `tested_firmware` is what tests need.
set(long_processors "")
if(NOT ZSTRIP_LONG_TESTS)
  set(long_processors cortex-m7 cortex-m55)
endif()
set_property(GLOBAL PROPERTY ZSTRIP_UNTESTED_PROCESSORS ${long_processors})

add_custom_target(firmware)
add_custom_target(tested_firmware ALL)
set(processors cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 cortex-m55 arm926ej-s)
find_program(ZSTRIP_RISCV_COMPILER riscv64-unknown-elf-g++)
if(ZSTRIP_RISCV_COMPILER)
  list(APPEND processors rv32imac)
else()
  message(STATUS "No programs for RISC-V: they need riscv64-unknown-elf-g++")
endif()
foreach(cpu IN LISTS processors)
  set(name firmware_${cpu})
  set(toolchain ${cpu})
  if(cpu MATCHES "^cortex-m")
    set(toolchain arm-none-eabi)
  endif()
  ExternalProject_Add(${name}
    SOURCE_DIR ${PROJECT_SOURCE_DIR}
    BINARY_DIR ${PROJECT_BINARY_DIR}/firmware/${cpu}
    STAMP_DIR ${PROJECT_BINARY_DIR}/firmware/stamps
    TMP_DIR ${PROJECT_BINARY_DIR}/firmware/temporary
    DEPENDS zstrip_scenes
    CMAKE_ARGS
      -DCMAKE_TOOLCHAIN_FILE=${PROJECT_SOURCE_DIR}/cmake/toolchains/${toolchain}.cmake
      -DCMAKE_BUILD_TYPE=Release
      -DZSTRIP_CPU=${cpu}
      -DZSTRIP_HOST_SIM=OFF
      -DZSTRIP_TESTS=OFF
      -DZSTRIP_LONG_TESTS=${ZSTRIP_LONG_TESTS}
      -DZSTRIP_PRECOMPILED=ON
      -DZSTRIP_SCENES_TABLES=$<TARGET_FILE:zstrip_scenes>
      -DZSTRIP_WARNINGS_AS_ERRORS=${ZSTRIP_WARNINGS_AS_ERRORS}
      -DZSTRIP_FIRMWARE_BINARIES=${ZSTRIP_FIRMWARE_BINARIES}
      -DZSTRIP_SCENE=${ZSTRIP_SCENE}
      -DZSTRIP_BOARD_FOLDER=${ZSTRIP_BOARD_FOLDER}
      -DZSTRIP_LVGL=${ZSTRIP_LVGL}
      -DZSTRIP_LVGL_SCENE=${PROJECT_BINARY_DIR}/tests/player/scenes/clips.zsc
    BUILD_ALWAYS ON
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target boards
    INSTALL_COMMAND ""
    # One after the other: each already uses all processors.
    USES_TERMINAL_BUILD ON
    # Target firmware_CPU-configure, for programs that are built one by one.
    STEP_TARGETS configure)
  set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(firmware ${name})
  if(NOT cpu IN_LIST long_processors)
    add_dependencies(tested_firmware ${name})
  endif()
endforeach()
