# Cross compiler for RV32IMAC, with the C++ headers of the Arm compiler: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/rv32imac.cmake
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/libstdcxx_headers.cmake)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_CXX_FLAGS_INIT
  "-march=rv32imac -mabi=ilp32 -mcmodel=medany -ffunction-sections -fdata-sections${zstrip_libstdcxx_flags}")
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")
