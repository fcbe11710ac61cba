// A line for each program and scene.
#include "targets.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

#include "zstrip_scenes/scenes.hpp"
#include "zstrip_scenes/showroom.hpp"

namespace zstrip::budget {
namespace {

constexpr std::uint32_t kGuard = 256, kNoGuard = 0;
constexpr View kBench{320, 240, PixelFormat::rgb565};
constexpr View kMicrobit{240, 240, PixelFormat::rgb565_swapped};
constexpr View kDiscovery{128, 128, PixelFormat::rgb565_swapped};
constexpr View kLandscape{320, 240, PixelFormat::rgb565_swapped};
constexpr View kOled{128, 64, PixelFormat::gray4};
constexpr View kPanel{128, 64, PixelFormat::rgb565};  // the same, converted when it is sent
constexpr const char* kStm32 = "stm32vldiscovery";

constexpr Target kTargets[] = {
    {"micro:bit", "microbit_teapot", "microbit", "teapot_meshlets", "", kMicrobit, Report::turntable, kNoGuard},
    {"micro:bit", "microbit_knot", "microbit", "knot_textured", "", kMicrobit, Report::turntable, kNoGuard},
    {"micro:bit", "microbit_room", "microbit", "room", "", kMicrobit, Report::turntable, kNoGuard},
    {"STM32VLDISCOVERY", "stm32vldiscovery_teapot", kStm32, "teapot_meshlets", "", kDiscovery, Report::turntable,
     kGuard},
    {"STM32VLDISCOVERY", "stm32vldiscovery_room", kStm32, "room", "", kDiscovery, Report::turntable, kGuard},
    {"micro:bit", "microbit_show", "microbit", "teapot_meshlets", "", kMicrobit, Report::frames, kNoGuard, 35, 80, 0,
     false, 16},
    {"STM32VLDISCOVERY", "stm32vldiscovery_show", kStm32, "teapot_meshlets", "", kDiscovery, Report::frames, kGuard, 19,
     48},
    {"Netduino Plus 2", "netduinoplus2_show", "netduinoplus2", "teapot", "", kLandscape, Report::frames, kGuard, 60,
     320, 5},
    {"STM32F4 Discovery", "stm32f4discovery_show", nullptr, "teapot", "", kLandscape, Report::none, kGuard, 48, 320},
    {"Raspberry Pi Pico", "pico_show", nullptr, "teapot", "", kMicrobit, Report::recorded, kNoGuard, 16, 240, 0, true},
    {"Raspberry Pi Pico 2", "pico2_show", nullptr, "teapot", "", kMicrobit, Report::none, kGuard, 16, 240, 0, true},
    {"EK-LM3S6965", "lm3s6965evb_teapot", "lm3s6965evb", "teapot", "", kOled, Report::frames, kGuard, 64, 128},
    {"EK-LM3S6965", "lm3s6965evb_layers", "lm3s6965evb", "showroom", "", kPanel, Report::frames, kGuard, 16},
    {"MPS2, Cortex-M0", "bench_m0", "mps2-an385", "knot", "K5", kBench, Report::bench, kNoGuard},
    {"MPS2, Cortex-M0", "bench_m0", "mps2-an385", "cube", "CT", kBench, Report::bench, kNoGuard},
    {"MPS2, Cortex-M0", "bench_m0", "mps2-an385", "random50", "R50", kBench, Report::bench, kNoGuard},
    {"MPS2, Cortex-M0", "bench_m0", "mps2-an385", "random10k", "R10k", kBench, Report::bench, kNoGuard},
    {"MPS2, Cortex-M3", "bench_m3", "mps2-an385", "knot", "K5", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M3", "bench_m3", "mps2-an385", "cube", "CT", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M3", "bench_m3", "mps2-an385", "random50", "R50", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M3", "bench_m3", "mps2-an385", "random10k", "R10k", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M4F", "bench_m4f", "mps2-an386", "knot", "K5", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M4F", "bench_m4f", "mps2-an386", "cube", "CT", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M4F", "bench_m4f", "mps2-an386", "random50", "R50", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M4F", "bench_m4f", "mps2-an386", "random10k", "R10k", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M7", "bench_m7", "mps2-an500", "knot", "K5", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M7", "bench_m7", "mps2-an500", "cube", "CT", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M7", "bench_m7", "mps2-an500", "random50", "R50", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M7", "bench_m7", "mps2-an500", "random10k", "R10k", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M33", "bench_m33", "mps2-an505", "knot", "K5", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M33", "bench_m33", "mps2-an505", "cube", "CT", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M33", "bench_m33", "mps2-an505", "random50", "R50", kBench, Report::bench, kGuard},
    {"MPS2, Cortex-M33", "bench_m33", "mps2-an505", "random10k", "R10k", kBench, Report::bench, kGuard},
    {"MPS3, Cortex-M55", "bench_m55", "mps3-an547", "knot", "K5", kBench, Report::bench, kGuard},
    {"MPS3, Cortex-M55", "bench_m55", "mps3-an547", "cube", "CT", kBench, Report::bench, kGuard},
    {"MPS3, Cortex-M55", "bench_m55", "mps3-an547", "random50", "R50", kBench, Report::bench, kGuard},
    {"MPS3, Cortex-M55", "bench_m55", "mps3-an547", "random10k", "R10k", kBench, Report::bench, kGuard},
};

}  // namespace

std::span<const Target> targets() { return kTargets; }

Effects effects_of(const Target& target) {
  if (const scenes::BuiltIn* const scene = scenes::find(target.scene)) return effects_of(scene->scene, scene->camera);
  if (target.scene != std::string_view("showroom")) {
    throw std::runtime_error(std::string("there is no scene ").append(target.scene));
  }
  // One pipeline for both layers.
  const Instance teapot[] = {{.mesh = scenes::kShowroomTeapotMesh, .material = scenes::kShowroomTeapotMaterial}};
  return effects_of(scenes::kShowroomBackground, scenes::kShowroomCamera) |
         effects_of(scenes::showroom_scene(teapot), scenes::kShowroomCamera);
}

std::filesystem::path file_of(const Target& target, const std::filesystem::path& binaries) {
  return binaries / (std::string("zstrip_") + target.program + ".elf");
}

}  // namespace zstrip::budget
