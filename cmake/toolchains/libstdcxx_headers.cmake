# For compilers that come without C++ headers: those of the Arm compiler, whose freestanding part fits every target.
# Sets zstrip_libstdcxx_flags. The compiler reports where they are, by its own release.
find_program(ZSTRIP_ARM_COMPILER arm-none-eabi-g++)
if(NOT ZSTRIP_ARM_COMPILER)
  message(FATAL_ERROR "The C++ headers are those of arm-none-eabi-g++, which is not installed")
endif()
execute_process(
  COMMAND ${ZSTRIP_ARM_COMPILER} -E -v -x c++ /dev/null
  OUTPUT_QUIET ERROR_VARIABLE zstrip_search_list)
string(REGEX MATCH "#include <...> search starts here:\n(.*)\nEnd of search list" zstrip_search_list "${zstrip_search_list}")
string(REGEX MATCHALL "[^ \n][^\n]*" zstrip_search_list "${CMAKE_MATCH_1}")
set(zstrip_libstdcxx_flags "")
foreach(folder IN LISTS zstrip_search_list)
  # Not the Arm compiler's own headers, as stdint.h: they describe its target.
  if(folder MATCHES "/include(/c\\+\\+/.*)?$" AND NOT folder MATCHES "/lib/gcc/[^/]*/[^/]*/include$|/backward$")
    string(APPEND zstrip_libstdcxx_flags " -isystem ${folder}")
  endif()
endforeach()
if(NOT zstrip_libstdcxx_flags MATCHES "/c\\+\\+/")
  message(FATAL_ERROR "${ZSTRIP_ARM_COMPILER} has no C++ headers: libstdc++-arm-none-eabi-dev is missing")
endif()
