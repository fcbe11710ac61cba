# What every target of zstrip shares: the language, and warnings that never reach those who embed it.
function(zstrip_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang>:-Wall -Wextra -Wshadow -Wconversion -Wsign-conversion>)
  if(ZSTRIP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-Werror>)
  endif()
endfunction()

# Freestanding code also keeps away from exceptions, RTTI, guarded statics and floating point in double precision.
function(zstrip_configure_freestanding_target target)
  zstrip_configure_target(${target})
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang>:-Wdouble-promotion -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics>)
endfunction()

# ZSTRIP_COMPILE_TOGETHER lists the parts, host-sim, core and tests, whose sources are compiled folder by folder. That
# parses headers once, for builds whose single sources do not change: `host-sim` in host-sim/run, that and `tests` in
# tests/run. There the core is compiled source by source: its programs are searched for code that a scene does not call,
# and its size and instructions are measured. In another project `core` is the default: on a Cortex-M3 its K5 and CT take
# as many instructions and its K5T 1 % fewer. `whole-core` makes one source of the core, which one processor compiles in
# two thirds of the time of `core`; it is for tests, of which two run at a time.

# Sources that read options and write reports take longer to compile than they will ever run: of the optimiser only -O1.
# They must emit no inline function of the core, which the linker could take for everybody.
function(zstrip_compile_quickly)
  if(NOT "host-sim" IN_LIST ZSTRIP_COMPILE_TOGETHER)
    set_source_files_properties(${ARGN} PROPERTIES
      COMPILE_OPTIONS "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang>,$<CONFIG:Release>>:-O1>")
  endif()
endfunction()

# zstrip_compile_together(TARGET PART [QUICKLY] [PRECOMPILED header...] [APART source...]): joins the target's sources if
# ZSTRIP_COMPILE_TOGETHER has the part. QUICKLY: they are then compiled with -O1, as by zstrip_compile_quickly. PRECOMPILED:
# clang parses these headers once. APART: sources that are not joined, because their names clash with others', or because
# the others would take long to compile again.
function(zstrip_compile_together target part)
  cmake_parse_arguments(PARSE_ARGV 2 arg "QUICKLY" "" "PRECOMPILED;APART")
  set(whole OFF)
  if(part STREQUAL "core" AND "whole-core" IN_LIST ZSTRIP_COMPILE_TOGETHER)
    set(whole ON)
  endif()
  if(whole OR part IN_LIST ZSTRIP_COMPILE_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    list(REMOVE_ITEM sources ${arg_APART})
    set(folders "")
    foreach(source IN LISTS sources)
      get_filename_component(folder ${source} DIRECTORY)
      list(APPEND folders "${folder}")
    endforeach()
    foreach(source IN LISTS sources)
      get_filename_component(folder ${source} DIRECTORY)
      # A folder of core that has one source joins the folder above it; otherwise each would take a step.
      set(others ${folders})
      list(FILTER others INCLUDE REGEX "^${folder}$")
      list(LENGTH others count)
      if(count EQUAL 1 AND part STREQUAL "core")
        get_filename_component(folder ${folder} DIRECTORY)
      endif()
      if(whole)
        set(folder ${part})
      endif()
      # CMake links the groups in an order that their names decide: they must not depend on where the sources are.
      if(IS_ABSOLUTE "${folder}")
        file(RELATIVE_PATH folder "${CMAKE_CURRENT_FUNCTION_LIST_DIR}" "${folder}")
      endif()
      string(MAKE_C_IDENTIFIER "${folder}" folder)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${target}_${folder}")
    endforeach()
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      target_precompile_headers(${target} PRIVATE ${arg_PRECOMPILED})
    endif()
    if(arg_QUICKLY AND CMAKE_CXX_FLAGS_RELEASE MATCHES "-O[23]")
      target_compile_options(${target} PRIVATE $<$<AND:$<CXX_COMPILER_ID:GNU,Clang>,$<CONFIG:Release>>:-O1>)
    endif()
  endif()
  # Under sanitizers the command only runs small things.
  if(ZSTRIP_SANITIZED AND part STREQUAL "host-sim")
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# zstrip_precompile(TARGET header...): with ZSTRIP_PRECOMPILED, for builds of sources whose includes another build checks.
option(ZSTRIP_PRECOMPILED "Parse headers once that most sources of core and scenes include; the code is the same" OFF)
function(zstrip_precompile target)
  # With link time optimisation GCC 12 ends with an internal error.
  if(ZSTRIP_PRECOMPILED AND NOT ZSTRIP_PRESET STREQUAL "size")
    target_precompile_headers(${target} PRIVATE ${ARGN})
    # Or ccache keeps nothing of it.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endfunction()

# zstrip_compile_tests_together(TARGET [APART source...]): if tests are to be, eight sources at a time, so that processors
# share a program. APART: names of theirs clash with others'.
function(zstrip_compile_tests_together target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "APART")
  if("tests" IN_LIST ZSTRIP_COMPILE_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    if(arg_APART)
      set_source_files_properties(${arg_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endif()
endfunction()

# zstrip_optimise_link(TARGET): as zstrip::lto says, where zstrip::core is of this build.
function(zstrip_optimise_link target)
  if(TARGET zstrip_lto)
    target_link_libraries(${target} PRIVATE zstrip_lto)
  endif()
endfunction()

# zstrip_import_core(FOLDER LIBRARY): zstrip::core of another build for the same processor; FOLDER has its headers.
function(zstrip_import_core folder library)
  add_library(zstrip_core STATIC IMPORTED GLOBAL)
  set_target_properties(zstrip_core PROPERTIES IMPORTED_LOCATION ${library})
  target_include_directories(zstrip_core INTERFACE ${folder})
  add_library(zstrip::core ALIAS zstrip_core)
endfunction()
