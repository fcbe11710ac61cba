# What programs of projects of their own link, for compilers that are not the main build's. `root` is the repository.
set(ZSTRIP_WARNINGS_AS_ERRORS ON)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
include(${root}/cmake/zstrip_target.cmake)

# zstrip_add_libraries(CORE): core, hal and scenes. CORE: zstrip::core of another build for the same processor; empty:
# compiled here. ZSTRIP_SCENES_LIBRARY likewise for the scenes.
macro(zstrip_add_libraries core)
  if("${core}" STREQUAL "")
    add_subdirectory(${root}/core core EXCLUDE_FROM_ALL)
  else()
    zstrip_import_core(${root}/core ${core})
  endif()
  foreach(folder hal firmware/scenes)
    add_subdirectory(${root}/${folder} ${folder} EXCLUDE_FROM_ALL)
  endforeach()
endmacro()

# zstrip_add_libraries_of(BUILD OWN_CORE): likewise, of BUILD where it is one; with OWN_CORE only its scenes.
macro(zstrip_add_libraries_of build own_core)
  set(core "")
  if(NOT "${build}" STREQUAL "")
    set(ZSTRIP_SCENES_LIBRARY ${build}/firmware/scenes/libzstrip_scenes.a)
    if(NOT "${own_core}")
      set(core ${build}/core/libzstrip_core.a)
    endif()
  endif()
  zstrip_add_libraries("${core}")
endmacro()

# zstrip_add_mps2(): sets `board`, for programs of emulated boards.
macro(zstrip_add_mps2)
  set(ZSTRIP_FIRMWARE_BINARIES ${CMAKE_CURRENT_BINARY_DIR})
  add_subdirectory(${root}/firmware/boards boards EXCLUDE_FROM_ALL)
  set(board zstrip_mps2 zstrip_cortex_m)
endmacro()
