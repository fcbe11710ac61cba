# A user C module of MicroPython, for its ports that are built by CMake: USER_C_MODULES=FOLDER/micropython.cmake.
# ZSTRIP_EFFECTS: the effects that its scenes have, of zstrip/effects.hpp.
set(ZSTRIP_EFFECTS lighting gouraud vertex_colours textures bins overlay skins CACHE STRING "Effects of zstrip's pipeline")
file(GLOB_RECURSE zstrip_sources ${CMAKE_CURRENT_LIST_DIR}/cpp/*.cpp)
list(TRANSFORM ZSTRIP_EFFECTS PREPEND "|zstrip::effect::" OUTPUT_VARIABLE zstrip_effects)
list(JOIN zstrip_effects "" zstrip_effects)
add_library(usermod_zstrip INTERFACE)
target_sources(usermod_zstrip INTERFACE
  ${CMAKE_CURRENT_LIST_DIR}/zstrip_module.c ${CMAKE_CURRENT_LIST_DIR}/pipeline.cpp ${zstrip_sources})
target_include_directories(usermod_zstrip INTERFACE ${CMAKE_CURRENT_LIST_DIR}/cpp)
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/pipeline.cpp ${zstrip_sources} PROPERTIES
  COMPILE_OPTIONS "-std=c++20;-O2;-ffreestanding;-fno-exceptions;-fno-rtti;-fno-threadsafe-statics;-fno-single-precision-constant"
  COMPILE_DEFINITIONS "ZSTRIP_EFFECTS=zstrip::Effects{}${zstrip_effects}")
target_link_libraries(usermod INTERFACE usermod_zstrip)
