// The gauge of the package in the real LVGL on an Arm MPS2. Prints a line of JSON: what LVGL sent in each step, and the
// memory that it took. Exit status: 0; 1 after a fault, which is named before.
#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "cortex_m/stack.hpp"
#include "gauge_frames.hpp"
#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

// The baked scene, in flash; players need an address that is a multiple of 4.
asm(".pushsection .rodata.scene_blob, \"a\"\n"
    ".balign 8\n"
    ".global scene_blob, scene_blob_end\n"
    "scene_blob: .incbin \"" ZSTRIP_LVGL_SCENE
    "\"\n"
    "scene_blob_end:\n"
    ".popsection");
extern "C" const std::byte scene_blob[], scene_blob_end[];

namespace {

using namespace zstrip;

// The player refuses another set than clips.toml calls for, by name.
constexpr Effects kEffects =
    effect::lighting | effect::gouraud | effect::vertex_colours | effect::supersampled | effect::shade_gouraud;
constexpr zstrip_pipeline kPipeline{drawn_with<kEffects>};
constexpr zstrip_picker kPicker{pick_with<kEffects>};

alignas(8) std::array<std::byte, ZSTRIP_LVGL_MEMORY> memory;
alignas(4) std::array<std::byte, lvgl_test::GaugeFrames::kBufferBytes> rows;
constinit lvgl_test::GaugeFrames frames;

void print_member(const char* name, std::uint32_t value) {
  board::print(", \"");
  board::print(name);
  board::print("\": ");
  board::print_decimal(value);
}

}  // namespace

// LVGL's assertions call it.
extern "C" [[noreturn]] void abort() {
  board::print("abort\n");
  board::halt(1);
}

int main() {
  lv_log_register_print_cb([](lv_log_level_t, const char* words) { board::print(words); });
  const lv_zstrip_scene_t scene{scene_blob,    static_cast<std::size_t>(scene_blob_end - scene_blob),
                                memory.data(), memory.size(),
                                &kPipeline,    &kPicker};
  if (!frames.show(scene, rows)) return 1;
  board::print("{\"steps\": [");
  for (const lvgl_test::GaugeStep& step : lvgl_test::kGaugeSteps) {
    const lvgl_test::Sent sent = frames.run(step);
    board::print(&step == lvgl_test::kGaugeSteps ? "{\"name\": \"" : ", {\"name\": \"");
    board::print(step.name);
    board::print("\", \"crc32\": \"");
    board::print_hex(sent.crc32);
    board::print("\"");
    print_member("pixels", sent.pixels);
    board::print("}");
  }
  board::print("]");
  lv_mem_monitor_t heap;
  lv_mem_monitor(&heap);
  print_member("heap", static_cast<std::uint32_t>(heap.total_size));
  print_member("heap_used", static_cast<std::uint32_t>(heap.max_used));
  print_member("stack", board::stack_bytes_used());
  print_member("zstrip", memory.size());
  print_member("rows", rows.size());
  board::print("}\n");
  return 0;
}
