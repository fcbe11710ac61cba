# A stand-in for the Raspberry Pi Pico SDK, for this machine: of its CMake functions and libraries those that a folder of
# `zstrip bake --project pico` uses. What a program calls of the SDK is declared only: it compiles and does not link.
set(pico_declarations ${CMAKE_CURRENT_LIST_DIR}/../../adapters/declarations)

macro(pico_sdk_init)
  foreach(library pico_multicore pico_stdlib hardware_spi hardware_dma)
    add_library(${library} INTERFACE)
    target_include_directories(${library} SYSTEM INTERFACE ${pico_declarations})
  endforeach()
endmacro()

function(pico_add_extra_outputs target)
  if(NOT TARGET ${target})
    message(FATAL_ERROR "${target} is no program")
  endif()
endfunction()
