# zstrip_add_uf2(TARGET BOARD PROGRAM...): TARGET makes .uf2 files of the programs, in the same folder, for the boot
# loader of BOARD, pico, pico2 or pico2_riscv. A program of the build machine makes them.
set(ZSTRIP_UF2_SOURCES ${CMAKE_CURRENT_LIST_DIR})
function(zstrip_add_uf2 target board)
  find_program(ZSTRIP_BUILD_COMPILER NAMES c++ g++ clang++)
  if(NOT ZSTRIP_BUILD_COMPILER)
    message(STATUS "No .uf2 files: they need a C++ compiler for this machine")
    return()
  endif()
  set(uf2 ${CMAKE_CURRENT_BINARY_DIR}/uf2)
  add_custom_command(OUTPUT ${uf2}
    COMMAND ${ZSTRIP_BUILD_COMPILER} -std=c++20 -O1 -Wall -Wextra -I ${ZSTRIP_UF2_SOURCES}/..
      ${ZSTRIP_UF2_SOURCES}/uf2.cpp -o ${uf2}
    DEPENDS ${ZSTRIP_UF2_SOURCES}/uf2.cpp ${ZSTRIP_UF2_SOURCES}/uf2_blocks.hpp ${ZSTRIP_UF2_SOURCES}/flash_map.hpp VERBATIM)
  set(files "")
  foreach(program IN LISTS ARGN)
    set(file ${ZSTRIP_FIRMWARE_BINARIES}/${program}.uf2)
    add_custom_command(OUTPUT ${file}
      COMMAND ${uf2} ${board} $<TARGET_FILE:${program}> ${file} DEPENDS ${uf2} ${program} VERBATIM)
    list(APPEND files ${file})
  endforeach()
  add_custom_target(${target} DEPENDS ${files})
  add_dependencies(boards ${target})
endfunction()
