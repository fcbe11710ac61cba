# Installs the libraries and headers so that find_package(zstrip) gives zstrip::core, zstrip::core_any, zstrip::methods,
# zstrip::hal and zstrip::player, and pkg-config zstrip, zstrip-any and zstrip-player; makes packages of them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/zstrip)

install(TARGETS zstrip_core zstrip_core_any zstrip_methods zstrip_hal zstrip_lto zstrip_player EXPORT zstrip_targets
  ARCHIVE COMPONENT zstrip_development)
install(DIRECTORY core/zstrip hal/zstrip_hal firmware/player/zstrip_player DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT zstrip_development FILES_MATCHING PATTERN *.hpp)
install(FILES firmware/player/zstrip_player.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT zstrip_development)
# The headers that set scenes in motion, for the player.
set(scenes firmware/scenes/include/zstrip_scenes)
install(FILES ${scenes}/baked_stage.hpp ${scenes}/built_in.hpp ${scenes}/stage.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/zstrip_scenes COMPONENT zstrip_development)
install(EXPORT zstrip_targets NAMESPACE zstrip:: DESTINATION ${package_folder} COMPONENT zstrip_development)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/zstrip_config.cmake.in ${PROJECT_BINARY_DIR}/zstripConfig.cmake
  INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/zstripConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/zstripConfig.cmake ${PROJECT_BINARY_DIR}/zstripConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT zstrip_development)

file(RELATIVE_PATH zstrip_prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(name zstrip zstrip-any zstrip-player)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT zstrip_development)
endforeach()

# zstrip as a library for Arduino, PlatformIO, ESP-IDF and Zephyr: packages/zstrip and archives of it.
find_program(ZSTRIP_BASH bash)
mark_as_advanced(ZSTRIP_BASH)
if(ZSTRIP_BASH)
  add_custom_target(package_sources VERBATIM
    COMMAND ${ZSTRIP_BASH} ${CMAKE_CURRENT_LIST_DIR}/zstrip_package_sources.sh ${PROJECT_BINARY_DIR}/packages)
endif()

if(TARGET zstrip)
  install(TARGETS zstrip zstrip-any zstrip-measure RUNTIME COMPONENT zstrip_command)
  if(TARGET zstrip-view)
    install(TARGETS zstrip-view RUNTIME COMPONENT zstrip_command)
  endif()
endif()
if(PROJECT_IS_TOP_LEVEL)
  include(${CMAKE_CURRENT_LIST_DIR}/zstrip_debian.cmake)
endif()
