// Shows for tests how a board handles a stuck bus or a fault of its program. The program draws the teapot. Within a
// frame, the character from the console selects the fault: 't', the controller is off for one transfer; 'd', it stays
// off; 'h', the bus never returns; 'f', the program faults; 'o', it uses more stack than there is; 'g', it faults and
// never returns afterwards; 's', it faults, and again while the panic is shown. Every case that can must end in a panic
// on the panel. Every case must end in a reset by the watchdog, after which the program reads the next character.
#include "cortex_m/registers.hpp"
#include "lm3s6965evb/chip.hpp"
#include "lm3s6965evb/show.hpp"
#include "portable/turntable_motion.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using namespace zstrip;

/// Switches the controller on or off. While it is off it keeps the bytes that it gets, until its FIFO is full.
void switch_controller(bool on) {
  board::register_at(board::chip::kSsi0 + board::chip::kSsiControl1) = on ? board::chip::kSsiOn : 0;
}

/// Recurses until the stack ends, far below 2^32 levels.
[[gnu::noinline]] std::uint32_t overflow_stack(std::uint32_t depth) {
  volatile std::uint32_t frame[16];
  frame[depth % 16] = depth;
  if (depth == 0xFFFFFFFF) return depth;
  return overflow_stack(depth + 1) + frame[depth % 16];
}

class StuckBus : public board::OledBus {
 public:
  explicit constexpr StuckBus(char fault) : fault_(fault) {}

  hal::Error write_data(std::span<const std::byte> bytes) {
    constexpr int kGood = 200;  // transfers before the fault: the start, and some strips
    if (++writes_ == kGood) {
      while (fault_ == 'h') asm volatile("");
      if (fault_ == 'f' || fault_ == 'g' || fault_ == 's') asm volatile("udf #0");
      if (fault_ == 'o') overflow_stack(0);
      switch_controller(false);
      hal::Error error = hal::Error::none;
      while (error == hal::Error::none) error = board::OledBus::write_data(bytes);
      switch_controller(fault_ == 't');
      return error;
    }
    while (fault_ == 'g' && writes_ > kGood) asm volatile("");
    if (fault_ == 's' && writes_ > kGood) asm volatile("udf #1");
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
  board::print("stuck bus: t, d, h, f, o, g or s?\n");
  char fault = 0;
  while (!board::take_character(fault)) {
  }
  StuckBus bus(fault);
  return board::show_on_oled<board::TurntableMotion<scenes::teapot, kView, kBudget>>(bus);
}
