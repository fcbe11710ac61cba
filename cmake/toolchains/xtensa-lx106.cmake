# Cross compiler for Xtensa's lx106, the processor of the ESP8266, with the C++ headers of the Arm compiler:
# -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/xtensa-lx106.cmake
# Its libgcc lacks multiplication and division of 64 bits and division of 32: the chip has them in its ROM.
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/libstdcxx_headers.cmake)
set(CMAKE_SYSTEM_PROCESSOR xtensa)
set(CMAKE_CXX_COMPILER xtensa-lx106-elf-g++)
# Constants lie before the code that loads them, within its reach of 256 KB.
set(CMAKE_CXX_FLAGS_INIT
  "-mlongcalls -mtext-section-literals -mauto-litpools -ffunction-sections -fdata-sections${zstrip_libstdcxx_flags}")
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")
