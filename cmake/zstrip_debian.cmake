# Packages for Debian, by `cpack -G DEB` in the build folder: libzstrip-dev has libraries and headers, zstrip the command,
# if it is built. They are written to packages/. Configured with -DCMAKE_INSTALL_PREFIX=/usr the libraries lie in the folder of
# their architecture, as Debian wants.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME zstrip)
set(CPACK_PACKAGE_VENDOR "the zstrip authors")
set(ZSTRIP_CONTACT "the zstrip authors <zstrip@example.org>" CACHE STRING "Who answers for packages for Debian: a name and <an address>")
set(CPACK_PACKAGE_CONTACT "${ZSTRIP_CONTACT}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)

# zstrip_debian_compressed(SOURCE NAME DESTINATION COMPONENT): installs SOURCE as NAME.gz, with the same bytes each time.
find_program(ZSTRIP_GZIP gzip)
function(zstrip_debian_compressed source name destination component)
  if(NOT ZSTRIP_GZIP)
    return()
  endif()
  set(file ${PROJECT_BINARY_DIR}/debian/${component}/${name}.gz)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/debian/${component})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  execute_process(COMMAND ${ZSTRIP_GZIP} -9nc ${source} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${file} DESTINATION ${destination} COMPONENT ${component})
endfunction()

# What Debian's policy asks of each package: the licence, and a changelog, here with this release alone:
# on the day of its section, as RFC 5322 has it; the weekday by Sakamoto's method.
file(STRINGS CHANGELOG.md day REGEX "^## \\[${PROJECT_VERSION}\\] - ")
if(day MATCHES " - ([0-9]+)-0?([0-9]+)-0?([0-9]+)$")
  set(year ${CMAKE_MATCH_1})
  math(EXPR month "${CMAKE_MATCH_2} - 1")
  set(day ${CMAKE_MATCH_3})
  set(shifts 0 3 2 5 0 3 5 1 4 6 2 4)
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  set(weekdays Sun Mon Tue Wed Thu Fri Sat)
  list(GET shifts ${month} shift)
  list(GET months ${month} name)
  set(counted ${year})
  if(month LESS 2)
    math(EXPR counted "${year} - 1")
  endif()
  math(EXPR weekday "(${counted} + ${counted} / 4 - ${counted} / 100 + ${counted} / 400 + ${shift} + ${day}) % 7")
  list(GET weekdays ${weekday} weekday)
  set(day "${weekday}, ${day} ${name} ${year} 00:00:00 +0000")
endif()
function(zstrip_debian_documents component package)
  install(FILES LICENSE DESTINATION share/doc/${package} RENAME copyright COMPONENT ${component})
  if(day)
    file(CONFIGURE OUTPUT debian/${component}/changelog
      CONTENT "zstrip (@PROJECT_VERSION@) unstable; urgency=medium

  * Release @PROJECT_VERSION@. What changed is in CHANGELOG.md of the sources.

 -- @ZSTRIP_CONTACT@  @day@
" @ONLY)
    zstrip_debian_compressed(${PROJECT_BINARY_DIR}/debian/${component}/changelog changelog share/doc/${package} ${component})
  endif()
endfunction()

set(CPACK_COMPONENTS_ALL zstrip_development)
zstrip_debian_documents(zstrip_development libzstrip-dev)
if(TARGET zstrip)
  list(APPEND CPACK_COMPONENTS_ALL zstrip_command)
  zstrip_debian_documents(zstrip_command zstrip)
  zstrip_debian_compressed(${PROJECT_SOURCE_DIR}/host-sim/zstrip.1 zstrip.1 share/man/man1 zstrip_command)
  file(WRITE ${PROJECT_BINARY_DIR}/debian/see_zstrip.1 ".so man1/zstrip.1\n")
  foreach(program any measure view)
    if(TARGET zstrip-${program})
      zstrip_debian_compressed(${PROJECT_BINARY_DIR}/debian/see_zstrip.1 zstrip-${program}.1 share/man/man1 zstrip_command)
    endif()
  endforeach()
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ZSTRIP_DEVELOPMENT_PACKAGE_NAME libzstrip-dev)
set(CPACK_DEBIAN_ZSTRIP_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_ZSTRIP_COMMAND_PACKAGE_NAME zstrip)
set(CPACK_DEBIAN_ZSTRIP_COMMAND_PACKAGE_SECTION graphics)
# Which libraries the command needs; by dpkg-shlibdeps, of the package dpkg-dev. Those of libzstrip-dev are static, and need
# no other package.
set(CPACK_DEBIAN_ZSTRIP_COMMAND_PACKAGE_SHLIBDEPS ON)
include(CPack)
cpack_add_component(zstrip_development DESCRIPTION
  "Static libraries and headers of zstrip, which draws 3D scenes strip by strip,\nin fixed point, without a framebuffer or a full z-buffer.")
cpack_add_component(zstrip_command DESCRIPTION
  "The command zstrip converts, plans and shows scenes for zstrip, a renderer\nfor microcontrollers.")
