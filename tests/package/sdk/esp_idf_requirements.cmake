# cmake -DPACKAGE=folder -P esp_idf_requirements.cmake: reads a component as ESP-IDF does it first.
macro(idf_component_register)
  set(registered ON)
  return()
endmacro()
function(read_component)
  include(${PACKAGE}/CMakeLists.txt)
endfunction()
read_component()
