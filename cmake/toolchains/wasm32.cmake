# Clang for WebAssembly, with the C++ headers of the Arm compiler: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/wasm32.cmake
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/libstdcxx_headers.cmake)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET wasm32)
# Newlib's headers have the byte order of the processors that they were made for, not this one's.
set(CMAKE_CXX_FLAGS_INIT "-D__IEEE_LITTLE_ENDIAN -ffunction-sections -fdata-sections${zstrip_libstdcxx_flags}")
# The host calls what the program exports; nothing is called main. All members of the libraries, of which the linker
# keeps what is used, because GNU ar makes no index for these objects.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--no-entry -Wl,--whole-archive -Wl,--fatal-warnings")
