# What the toolchains of targets without an operating system share; included by them.
set(CMAKE_SYSTEM_NAME Generic)
# Test programs of CMake are not linked, because there is no C library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# In the cache before CMake's own default, which is -O3.
set(CMAKE_CXX_FLAGS_RELEASE "-O2" CACHE STRING "Flags of the Release build type")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
