# Sources of the kernels' contract, for all programs that compare: without a test framework, without a library.
set(ZSTRIP_KERNELS_TEST ${CMAKE_CURRENT_LIST_DIR})
set(ZSTRIP_KERNELS_TEST_SOURCES contracts.cpp bilinear_contract.cpp bins_contract.cpp medium_triangle_contract.cpp
  meshlet_contract.cpp shadowed_strips_contract.cpp small_run_contract.cpp small_triangle_contract.cpp
  span_contract.cpp span_triangle_contract.cpp textured_run_contract.cpp transform_contract.cpp
  triangle_planes_contract.cpp)
list(TRANSFORM ZSTRIP_KERNELS_TEST_SOURCES PREPEND ${ZSTRIP_KERNELS_TEST}/)
# Those of the kernels for Helium, which compile quickly.
set(ZSTRIP_MVE_TEST_SOURCES small_run_contract.cpp textured_run_contract.cpp transform_contract.cpp)
list(TRANSFORM ZSTRIP_MVE_TEST_SOURCES PREPEND ${ZSTRIP_KERNELS_TEST}/)
