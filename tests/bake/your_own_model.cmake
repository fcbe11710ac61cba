# "Your own model on a board" of docs/try.md, done: baked, built into a board's program, run in the emulator, the picture on
# its display compared with `zstrip render`.
find_program(ZSTRIP_QEMU_ARM qemu-system-arm)
if(NOT ZSTRIP_FIRMWARE OR NOT ZSTRIP_QEMU_ARM)
  message(STATUS "No test of one's own model on a board: it needs ZSTRIP_FIRMWARE (arm-none-eabi-g++) and qemu-system-arm")
  return()
endif()

set(model ${CMAKE_CURRENT_SOURCE_DIR}/models/house.obj)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/your_own_model)
set(view --size 128x64 --format gray4)

add_test(NAME BakeBoard.Bake COMMAND zstrip bake ${model} -o ${folder}/scene.hpp ${view} --ram 40K --turntable)
file(MAKE_DIRECTORY ${folder})
set_tests_properties(BakeBoard.Bake PROPERTIES FIXTURES_SETUP baked_scene LABELS board)

add_test(NAME BakeBoard.Build COMMAND ${CMAKE_CTEST_COMMAND}
  --build-and-test ${PROJECT_SOURCE_DIR} ${folder}/build
  --build-generator ${CMAKE_GENERATOR} --build-noclean --build-target zstrip_lm3s6965evb_scene
  --build-options -DCMAKE_TOOLCHAIN_FILE=${PROJECT_SOURCE_DIR}/cmake/toolchains/arm-none-eabi.cmake
    -DZSTRIP_CPU=cortex-m3 -DCMAKE_BUILD_TYPE=Release -DZSTRIP_HOST_SIM=OFF -DZSTRIP_TESTS=OFF
    -DZSTRIP_COMPILE_TOGETHER=whole-core  # the programs for boards have it compiled source by source
    -DZSTRIP_FIRMWARE_BINARIES=${folder} -DZSTRIP_SCENE=${folder}/scene.hpp)
zstrip_test_needs(BakeBoard.Bake zstrip)
zstrip_test_needs(BakeBoard.Build zstrip)
set_tests_properties(BakeBoard.Build PROPERTIES
  FIXTURES_REQUIRED baked_scene FIXTURES_SETUP baked_program TIMEOUT 900 LABELS board)

# Once more with a model that bends, in the same build.
set(figure ${PROJECT_SOURCE_DIR}/host-sim/scenes/figure/figure.gltf)
set(bending ${folder}/bending)
file(MAKE_DIRECTORY ${bending})
add_test(NAME BakeBoard.BakeSkin COMMAND zstrip bake ${figure} -o ${bending}/scene.hpp ${view} --ram 24K)
zstrip_test_needs(BakeBoard.BakeSkin zstrip)
set_tests_properties(BakeBoard.BakeSkin PROPERTIES FIXTURES_SETUP baked_skin LABELS board)
add_test(NAME BakeBoard.BuildSkin COMMAND ${CMAKE_CTEST_COMMAND}
  --build-and-test ${PROJECT_SOURCE_DIR} ${folder}/build
  --build-generator ${CMAKE_GENERATOR} --build-noclean --build-target zstrip_lm3s6965evb_scene
  --build-options -DZSTRIP_FIRMWARE_BINARIES=${bending} -DZSTRIP_SCENE=${bending}/scene.hpp)
zstrip_test_needs(BakeBoard.BuildSkin zstrip)
set_tests_properties(BakeBoard.BuildSkin PROPERTIES DEPENDS BakeBoard.Build
  FIXTURES_REQUIRED baked_skin FIXTURES_SETUP baked_program TIMEOUT 900 LABELS board)

add_executable(bake_board_test board_test.cpp)
target_include_directories(bake_board_test PRIVATE ../host-sim)
target_link_libraries(bake_board_test PRIVATE zstrip::core zstrip_emulator bake_command_report GTest::gtest_main)
target_compile_definitions(bake_board_test PRIVATE
  ZSTRIP_COMMAND="$<TARGET_FILE:zstrip>" ZSTRIP_NM="${CMAKE_NM}" BAKED_MODEL="${model}" BAKED_PROGRAM="${folder}/zstrip_lm3s6965evb_scene.elf"
  BENDING_MODEL="${figure}" BENDING_PROGRAM="${bending}/zstrip_lm3s6965evb_scene.elf")
zstrip_configure_test(bake_board_test)
add_dependencies(bake_board_test zstrip)
zstrip_discover_tests(bake_board_test PROPERTIES FIXTURES_REQUIRED baked_program TIMEOUT 120 LABELS board)
