// The Utah teapot rotates on the board's OLED.
#include "zstrip_scenes/teapot.hpp"
#include "lm3s6965evb/show.hpp"
#include "portable/turntable_motion.hpp"

namespace {
using namespace zstrip;
constexpr View kView{board::Oled::kWidth, board::Oled::kHeight, PixelFormat::gray4};
constexpr Budget kBudget{.bytes = 40 * 1024};
}  // namespace

int main() {
  board::OledBus bus;
  return board::show_on_oled<board::TurntableMotion<scenes::teapot, kView, kBudget>>(bus);
}
