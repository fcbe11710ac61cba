# cmake -DFOLDER=build-folder -P is_light.cmake: the program in that folder has built of zstrip only the libraries that it
# links, in a few steps, and installing it installs nothing of zstrip.
file(GLOB_RECURSE core ${FOLDER}/zstrip/core/*zstrip_core.*)
if(NOT core)
  message(FATAL_ERROR "${FOLDER} holds no library of zstrip: was it built?")
endif()
file(GLOB_RECURSE others ${FOLDER}/zstrip/firmware/*.a ${FOLDER}/zstrip/firmware/*.o ${FOLDER}/zstrip/core/*rows_of_*.o)
if(others)
  message(FATAL_ERROR "Built without being linked: ${others}")
endif()
# Objects of core and drivers, their two libraries, and what a program with the player adds: six objects, a library and
# itself.
set(kMaxSteps 40)
file(GLOB_RECURSE objects ${FOLDER}/zstrip/core/CMakeFiles/zstrip_core.dir/*.o
  ${FOLDER}/zstrip/hal/CMakeFiles/zstrip_hal.dir/*.o)
list(LENGTH objects steps)
if(steps EQUAL 0)
  message(FATAL_ERROR "${FOLDER} holds no objects of zstrip: was it built?")
endif()
math(EXPR steps "${steps} + 2 + 8")
if(steps GREATER kMaxSteps)
  message(FATAL_ERROR "A program with zstrip's player takes ${steps} steps, more than ${kMaxSteps}: ${objects}")
endif()

set(prefix ${FOLDER}/would_install)
file(REMOVE_RECURSE ${prefix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${FOLDER} --prefix ${prefix} RESULT_VARIABLE status
  OUTPUT_QUIET ERROR_VARIABLE error)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "Installing a program that uses zstrip fails: ${error}")
endif()
file(GLOB_RECURSE installed ${prefix}/*)
if(installed)
  message(FATAL_ERROR "Installed along with a program that uses zstrip: ${installed}")
endif()
