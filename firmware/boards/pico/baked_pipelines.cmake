# zstrip_add_baked_pipelines(NAME): the pipelines of the programs that show baked scenes. The two programs, with hot code
# in flash and in RAM, link the same object file, which takes the compiler most of a minute.
set(ZSTRIP_PICO_FOLDER ${CMAKE_CURRENT_LIST_DIR})
function(zstrip_add_baked_pipelines name)
  add_library(${name} OBJECT ${ZSTRIP_PICO_FOLDER}/baked_pipelines.cpp)
  target_include_directories(${name} PRIVATE ${ZSTRIP_PICO_FOLDER}/..)
  target_link_libraries(${name} PRIVATE zstrip::player zstrip::core)
  zstrip_configure_freestanding_target(${name})
  zstrip_optimise_link(${name})
endfunction()
