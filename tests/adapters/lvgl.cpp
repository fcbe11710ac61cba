// A stand-in for LVGL: a canvas whose rows have gaps, shown when it is invalidated.
#include "libraries.hpp"
#include "lvgl_canvas.hpp"

struct lv_obj_t {
  lv_draw_buf_t buffer;
};

namespace {

using namespace zstrip::adapters_test;

constexpr std::uint32_t kStride = 2 * kWidth + 6;

struct LvglParts {
  struct Adapter : adapters::LvglCanvas {
    using LvglCanvas::LvglCanvas;
    zstrip::hal::Error start() { return begin_frame(); }
  };
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(kStride * kHeight);
  lv_obj_t canvas{{.header = {.cf = screen().fault == Fault::format ? LV_COLOR_FORMAT_ARGB8888 : LV_COLOR_FORMAT_RGB565,
                              .w = kWidth,
                              .h = kHeight,
                              .stride = kStride},
                   .data = memory.data()}};
  Adapter adapter{&canvas};
};

}  // namespace

lv_draw_buf_t* lv_canvas_get_draw_buf(lv_obj_t* canvas) { return &canvas->buffer; }
void* lv_draw_buf_goto_xy(const lv_draw_buf_t* buffer, std::uint32_t x, std::uint32_t y) {
  return buffer->data + y * buffer->header.stride + 2 * x;
}
void lv_obj_invalidate(const lv_obj_t* canvas) {
  for (int row = 0; row < kHeight; ++row) {
    const void* first = lv_draw_buf_goto_xy(&canvas->buffer, 0, static_cast<std::uint32_t>(row));
    screen().draw(area_of(0, row, kWidth, 1), first, First::low);
  }
}

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_lvgl() { return std::make_unique<Opened<LvglParts>>(); }
}  // namespace zstrip::adapters_test
