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

# Sources that read options and write reports take longer to compile than they will ever run: of the optimiser only -O1.
# They must emit no inline function of the core, which the linker could take for everybody.
function(zstrip_compile_quickly)
  if(NOT ZSTRIP_SANITIZED)
    set_source_files_properties(${ARGN} PROPERTIES
      COMPILE_OPTIONS "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang>,$<CONFIG:Release>>:-O1>")
  endif()
endfunction()

# zstrip_compile_together(TARGET [APART source...]): under sanitizers, where nobody works at single sources, those of one
# folder are compiled as one, which parses the headers of libraries once, and without the optimiser. APART: names of
# theirs clash with others'.
function(zstrip_compile_together target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "APART")
  if(ZSTRIP_SANITIZED)
    target_compile_options(${target} PRIVATE -O0)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    list(REMOVE_ITEM sources ${arg_APART})
    foreach(source IN LISTS sources)
      get_filename_component(folder ${source} DIRECTORY)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${target}${folder}")
    endforeach()
  endif()
endfunction()
