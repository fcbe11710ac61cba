// The widget lv_zstrip in the real LVGL on a Cortex-M3 in the emulator: LVGL sends the areas and pixels that it sends
// on the host, and everything fits the memory of a small board.
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "gauge_frames.hpp"
#include "player/baked.hpp"
#include "qemu.hpp"
#include "zstrip_player/any_player.hpp"
#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

namespace zstrip::lvgl_test {
namespace {

constexpr zstrip_pipeline kAnyPipeline{drawn_with_any};
constexpr zstrip_picker kAnyPicker{pick_with_any};

TEST(LvglWidgetBoard, SendsThePixelsOfTheHostOnACortexM3WithLittleMemory) {
  boards::Qemu board({.machine = "mps2-an385", .program = LVGL_PROGRAM, .words = {"gauge"}});
  const auto [output, status] = board.finish(boards::Qemu::Duration(300'000));
  ASSERT_EQ(status, 0) << output;
  const auto result = nlohmann::json::parse(output);

  test::Blob blob = test::blob_of("clips");
  const auto bytes = result["zstrip"].get<std::size_t>();
  test::Memory memory(2 * bytes);  // pointers of a PC are wider
  const lv_zstrip_scene_t scene{blob.data(), blob.size(), memory.span().data(), 2 * bytes, &kAnyPipeline, &kAnyPicker};
  alignas(4) std::array<std::byte, GaugeFrames::kBufferBytes> rows;
  GaugeFrames frames;
  ASSERT_TRUE(frames.show(scene, rows));
  std::size_t step = 0;
  for (const GaugeStep& each : kGaugeSteps) {
    const Sent sent = frames.run(each);
    const auto& measured = result["steps"].at(step++);
    EXPECT_EQ(measured["name"], each.name);
    EXPECT_EQ(measured["pixels"], sent.pixels) << each.name;
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", sent.crc32);
    EXPECT_EQ(measured["crc32"], digits) << each.name;
    EXPECT_GT(sent.pixels, 0U) << each.name;
  }
  lv_deinit();
  for (const char* const part : {"heap", "heap_used", "stack", "zstrip", "rows"}) {
    RecordProperty(part, result[part].dump());
  }
}

}  // namespace
}  // namespace zstrip::lvgl_test
