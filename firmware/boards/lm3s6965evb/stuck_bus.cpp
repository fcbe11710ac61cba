// What becomes of a board whose bus gets stuck, for tests. The teapot, whose bus does what the console asks for: 't',
// it times out once, amid a frame; 'h', it never returns. The one must end in a panic that shows, both in a reset by
// the watchdog, and the program asks again.
#include "lm3s6965evb/show.hpp"
#include "portable/turntable_motion.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using namespace zstrip;

class StuckBus : public board::OledBus {
 public:
  explicit constexpr StuckBus(char fault) : fault_(fault) {}

  hal::Error write_data(std::span<const std::byte> bytes) {
    constexpr int kGood = 200;  // the start, and some strips
    if (++writes_ == kGood) {
      while (fault_ == 'h') asm volatile("");
      return hal::Error::timeout;
    }
    return board::OledBus::write_data(bytes);
  }

 private:
  char fault_;
  int writes_ = 0;
};

constexpr View kView{128, 64, PixelFormat::gray4};
constexpr Budget kBudget{.bytes = 40 * 1024};

}  // namespace

int main() {
  board::print("stuck bus: t or h?\n");
  char fault = 0;
  while (!board::take_character(fault)) {
  }
  StuckBus bus(fault);
  return board::show_on_oled<board::TurntableMotion<scenes::teapot, kView, kBudget>>(bus);
}
