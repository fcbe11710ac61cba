# Sources of the kernels' contract, for all programs that compare: without a test framework, without a library.
set(ZSTRIP_KERNELS_TEST ${CMAKE_CURRENT_LIST_DIR})
set(ZSTRIP_KERNELS_TEST_SOURCES contracts.cpp bilinear_contract.cpp bins_contract.cpp medium_triangle_contract.cpp
  meshlet_contract.cpp shadowed_strips_contract.cpp small_run_contract.cpp small_triangle_contract.cpp
  span_contract.cpp span_triangle_contract.cpp textured_run_contract.cpp transform_contract.cpp
  triangle_planes_contract.cpp)
list(TRANSFORM ZSTRIP_KERNELS_TEST_SOURCES PREPEND ${ZSTRIP_KERNELS_TEST}/)
# Those of the kernels for Helium, which compile quickly: kernels/mve/NAME.cpp has NAME_contract.cpp. Their number tells
# the program that compares them alone whether it names them all.
file(GLOB ZSTRIP_MVE_TEST_SOURCES CONFIGURE_DEPENDS ${ZSTRIP_KERNELS_TEST}/../../core/zstrip/kernels/mve/*.cpp)
list(LENGTH ZSTRIP_MVE_TEST_SOURCES ZSTRIP_MVE_KERNELS)
list(TRANSFORM ZSTRIP_MVE_TEST_SOURCES REPLACE "^.*/([^/]+)\\.cpp$" "${ZSTRIP_KERNELS_TEST}/\\1_contract.cpp")
