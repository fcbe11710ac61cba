# ESP-IDF's part: it reads a component's CMakeLists.txt twice, first as a script that ends at idf_component_register, to
# know its requirements; then as a subdirectory.
execute_process(COMMAND ${CMAKE_COMMAND} -DPACKAGE=${PACKAGE} -P ${CMAKE_CURRENT_LIST_DIR}/esp_idf_requirements.cmake
  RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The component cannot be read as a script: ${error}")
endif()

function(idf_component_register)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "SRCS;INCLUDE_DIRS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "The stand-in for idf_component_register does not know ${arg_UNPARSED_ARGUMENTS}")
  endif()
  list(TRANSFORM arg_INCLUDE_DIRS PREPEND ${PACKAGE}/)
  # As release 5.1 compiles by default.
  zstrip_in_sdk(OPTIONS -std=gnu++2b -Og SOURCES ${arg_SRCS} INCLUDES ${arg_INCLUDE_DIRS})
endfunction()
add_subdirectory(${PACKAGE} component)
