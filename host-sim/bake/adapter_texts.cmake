# Writes generated/bake/adapter_texts.hpp: the adapters that `zstrip bake` copies beside a program, as constants.
foreach(adapter tft_espi lovyangfx arduino_gfx pico_spi_dma esp_lcd)
  set(file ${CMAKE_CURRENT_LIST_DIR}/../../firmware/examples/adapters/${adapter}.hpp)
  file(READ ${file} ${adapter})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/adapter_texts.hpp.in generated/bake/adapter_texts.hpp @ONLY)
