// The Pico 2's sources (firmware/boards/pico, pico2) compiled for this machine, their registers in a model of the chip:
// start, console, timer, panel by DMA, a bus that gets stuck, watchdog. The program as a whole runs in an emulator
// (pico2.mjs), which accepts mistakes that this model does not (docs/hardware-review.md).
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "addresses.hpp"
#include "chip_model.hpp"
#include "cortex_m/board.hpp"
#include "cortex_m/systick.hpp"
#include "pico/panel_bus.hpp"
#include "pico/pins.hpp"
#include "pico/timer.hpp"
#include "portable/console_input.hpp"
#include "portable/pacing.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_hal/message_screen.hpp"
#include "zstrip_hal/st7789.hpp"

namespace zstrip::pico2 {
namespace {

Chip* chip = nullptr;
std::uint32_t systick_hertz = 0;

}  // namespace

std::uint32_t read_register(std::uint32_t address) { return chip->read(address); }
void write_register(std::uint32_t address, std::uint32_t value) { chip->write(address, value); }

}  // namespace zstrip::pico2

namespace zstrip::board {

void start_systick(std::uint32_t hertz, std::uint32_t) { pico2::systick_hertz = hertz; }
void wait_for_systick() {}

}  // namespace zstrip::board

namespace zstrip::pico2 {
namespace {

using namespace std::chrono_literals;

struct ModelClock {
  void wait(std::uint32_t microseconds) { chip->pass(std::chrono::microseconds(microseconds)); }
};

constexpr std::string_view kWords = "the words of this test";

/// In milliseconds; more than the lower word of the timer's microseconds can count.
constexpr std::uint32_t kLongTime = 5'000'000;

/// Whether the timer counts milliseconds all the time.
bool counts_milliseconds() {
  board::start_timer();
  const std::uint32_t before = board::milliseconds();
  chip->pass(std::chrono::milliseconds(kLongTime));
  const std::uint32_t passed = board::milliseconds() - before;
  return passed >= kLongTime && passed <= kLongTime + 1;
}

std::vector<std::uint8_t> expected_picture() {
  constexpr std::uint16_t kSide = 240;
  std::vector<std::byte> memory(std::size_t{2} * kSide * kSide);
  hal::Framebuffer display(memory, {kSide, kSide, hal::DisplayFormat::rgb565_swapped});
  EXPECT_EQ(hal::show_message(display, kWords), hal::Error::none);
  std::vector<std::uint8_t> lit;
  for (std::size_t at = 0; at < memory.size(); at += 2) lit.push_back(memory[at] == std::byte{0xFF});
  return lit;
}

std::vector<std::uint8_t> seen_picture() {
  const sim::RgbImage image = chip->panel().seen();
  std::vector<std::uint8_t> lit;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) lit.push_back(image.rgb[at] > 128);
  return lit;
}

/// Runs with its stack in the chip's RAM, where addresses have 32 bits.
void run_in_ram(Chip& model, std::function<void()> program) {
  constexpr std::size_t kRam = 520 * 1024;
  void* const ram = mmap(nullptr, kRam, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_32BIT, -1, 0);
  ASSERT_NE(ram, MAP_FAILED);
  model.has_ram(reinterpret_cast<std::uintptr_t>(ram), kRam);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, ram, kRam);
  pthread_t thread{};
  const auto run = [](void* function) -> void* {
    (*static_cast<std::function<void()>*>(function))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, &program), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  munmap(ram, kRam);
}

/// Start, a line on the console, and the words on the panel. Empty, or what is wrong.
std::string run_program(Chip& model, const std::function<void(board::PanelBus&)>& before_words = nullptr) {
  std::string wrong;
  run_in_ram(model, [&] {
    chip = &model;
    try {
      board::start();
      for (const char character : std::string_view("up\n")) board::put_character(character);
      char character = 0;
      if (board::take_character(character)) throw Complaint("something came from the console");
      board::PanelBus bus;
      bus.start();
      ModelClock clock;
      hal::St7789 panel(bus, clock);
      board::PanelReset reset;
      if (hal::reset_panel(reset, clock) != hal::Error::none) throw Complaint("reset of the panel");
      if (board::PanelLight{}.set(true) != hal::Error::none) throw Complaint("light of the panel");
      board::start_pacing();
      if (systick_hertz != model.system_hertz()) throw Complaint("the frame clock counts another frequency");
      if (!counts_milliseconds()) throw Complaint("timer: not milliseconds");
      if (panel.start() != hal::Error::none) throw Complaint("start of the panel");
      if (before_words) before_words(bus);
      if (hal::show_message(panel, kWords) != hal::Error::none) throw Complaint("words on the panel");
      if (panel.wait() != hal::Error::none) throw Complaint("end of the words");
      board::feed_watchdog();
    } catch (const Complaint& complaint) {
      wrong = complaint.what();
    }
    if (wrong.empty() && model.console() != "up\n") wrong = "console: " + model.console();
    if (wrong.empty() && !model.panel().darkness().empty()) wrong = model.panel().darkness();
    if (wrong.empty() && !model.is_lit()) wrong = "the backlight is off";
    if (wrong.empty() && seen_picture() != expected_picture()) wrong = "another picture";
    // 8 s: within a hundredth.
    const auto left = model.watchdog_time() - model.now();
    if (wrong.empty() && (left < 7920ms || left > 8080ms)) wrong = "watchdog: not 8 s";
  });
  return wrong;
}

TEST(Pico2Chip, TakesWhatTheProgramDoes) {
  Chip model;
  EXPECT_EQ(run_program(model), "");
  EXPECT_EQ(model.system_hertz(), 150'000'000U);
}

TEST(Pico2Chip, StuckBusEndsInATimeOutAndGoesOn) {
  Chip model;
  hal::Error error = hal::Error::none;
  EXPECT_EQ(run_program(model,
                        [&](board::PanelBus& bus) {
                          const std::byte nothing[] = {std::byte{0}}, bytes[64] = {};
                          EXPECT_EQ(bus.write_command(nothing), hal::Error::none);
                          model.stick();
                          EXPECT_EQ(bus.write_data(bytes), hal::Error::none);
                          error = bus.wait();
                          model.panel().interrupted();
                        }),
            "");
  EXPECT_EQ(error, hal::Error::timeout);
}

using Written = std::function<bool(std::uint32_t& address, std::uint32_t& value)>;

bool dropped(std::uint32_t&, std::uint32_t&) { return false; }
Written becomes(std::uint32_t other) {
  return [other](std::uint32_t&, std::uint32_t& value) {
    value = other;
    return true;
  };
}
Written with(std::uint32_t bits) {
  return [bits](std::uint32_t&, std::uint32_t& value) {
    value |= bits;
    return true;
  };
}
Written moves_to(std::uint32_t other) {
  return [other](std::uint32_t& address, std::uint32_t&) {
    address = other;
    return true;
  };
}
Written without(std::uint32_t one) {
  return [one](std::uint32_t&, std::uint32_t& value) { return value != one; };
}

struct Mistake {
  const char* what;
  const char* complaint;
  std::uint32_t written = 0;  // the address, with what makes it set or clear bits
  Written change{};
  std::uint32_t read = 0;  // the address, and what its value shows and hides
  std::uint32_t shows = 0, hides = 0;
  std::function<void(board::PanelBus&)> before_words{};
};

constexpr std::uint32_t kClearAlias = 0x3000;

void command_of_many_bytes(board::PanelBus& bus) {
  constexpr std::byte kNothing[16] = {};
  static_cast<void>(bus.write_command(kNothing));
}

void data_twice(board::PanelBus& bus) {
  constexpr std::byte kBytes[64] = {};
  static_cast<void>(bus.write_data(kBytes));
  static_cast<void>(bus.write_data(kBytes));
}

void stuck_data(board::PanelBus& bus) {
  constexpr std::byte kBytes[64] = {};
  chip->stick();
  static_cast<void>(bus.write_data(kBytes));
  static_cast<void>(bus.wait());
}

/// What an RP2040's program does, and other mistakes.
const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> kMistakes{
      {"resets stay", "the program waits for ever", kReset + kClearAlias, dropped},
      {"resets of an RP2040", "the program waits for ever", kReset + kClearAlias, becomes(1U << 5 | 1U << 8)},
      {"no wait for a reset", ": touched in reset", 0, {}, kResetDone, 0xFFFFFFFF},
      {"crystal's range", "crystal: its range is not that of 12 MHz", kXoscCtrl, becomes(0xFABAA1)},
      {"crystal is switched off", "crystal: not enabled", kXoscCtrl, becomes(0xD1EAA0)},
      {"crystal's delay", "crystal: less than a millisecond to start", kXoscStartup, becomes(10)},
      {"no wait for the crystal", "reference: the crystal is not stable", 0, {}, kXoscStatus, 1U << 31},
      {"system stays at the ring", "system: the auxiliary source changes while in use", kSysCtrl + kClearAlias, dropped,
       kSysSelected, 1},
      {"system from the crystal", "system: not from the PLL", kSysCtrl, becomes(0x60)},
      {"no wait for the PLL", "system: the PLL is not locked and powered", 0, {}, kPllCs, 1U << 31},
      {"reference stays at the ring", "pll: the crystal does not run", kRefCtrl, dropped, kRefSelected, 4},
      {"feedback", "pll: the VCO's limits", kPllFbdiv, becomes(150)},
      {"post-dividers", "system: above 150 MHz", kPllPrim, becomes(5U << 16 | 1U << 12)},
      {"PLL afterwards", "pll: changed while in use", kUartInteger, moves_to(kPllPrim)},
      {"clock of an RP2040", "peripherals: the clock changes afterwards", kPllPrim, becomes(6U << 16 | 2U << 12)},
      {"no clock of peripherals", "the program waits for ever", kPeriCtrl, dropped},
      {"baud rate of 125 MHz", "uart: the baud rate", kUartInteger, becomes(67)},
      {"word length", "uart: not set up for 8 bits", kUartLine, becomes(0x40)},
      {"no wait for a character", "uart: a character is lost", 0, {}, kUartFlags, 0, 1U << 5},
      {"console's output isolated", "pin 0: isolated", pad_of(0), dropped},
      {"console's input isolated", "pin 1: no input that is pulled up", pad_of(1), dropped},
      {"console's input pulled down", "pin 1: no input that is pulled up", pad_of(1), becomes(0x56)},
      {"serial clock isolated", "pin 18: isolated", pad_of(18), dropped},
      {"data isolated", "pin 19: isolated", pad_of(19), dropped},
      {"data off", "pin 19: its output is off", pad_of(19), becomes(0x96)},
      {"select isolated", "pin 17: isolated", pad_of(17), dropped},
      {"D/C isolated", "pin 20: isolated", pad_of(20), dropped},
      {"reset line isolated", "pin 21: isolated", pad_of(21), dropped},
      {"function of the serial clock", "pin 18: its function", function_of(18), becomes(5)},
      {"no function before the pad", "pin 17: connected without a function", function_of(17), dropped},
      {"output of D/C not enabled", "panel: D/C is not driven", kSioEnable, without(1U << 20)},
      {"set register of an RP2040", "there is no register that this program needs", kSioSet, moves_to(0xD0000014)},
      {"panel is not selected", "panel: bytes while it is not selected", kSioClear, without(1U << 17)},
      {"no wait for the last bit", "panel: D/C or select changes amid a byte", 0, {}, kSpiSr, 0, 1U << 4},
      {"serial clock", "panel: the bus sends a bit in", kSpiCpsr, becomes(8)},
      {"prescaler", "spi: the prescaler", kSpiCpsr, becomes(13)},
      {"size of data", "spi: not 8 bits, mode 0", kSpi, becomes(15)},
      {"SPI is on too early", "spi: changed while on", kSpiCr1, becomes(2)},
      {"SPI stays off", "spi: no master that is on", kSpiCr1, becomes(0)},
      {"no wait for room", "spi: a byte is lost", 0, {}, kSpiSr, 1U << 1, 0, command_of_many_bytes},
      {"no requests by the SPI", "start of the panel", kSpiDmacr, dropped},
      {"pace of an RP2040", "dma: not at the SPI's pace", kDmaTrigger, becomes(3U << 29 | 16U << 15 | 0x11)},
      {"another channel", "dma: it starts another channel", kDmaTrigger, with(1U << 13)},
      {"read address stands", "dma: not bytes that follow each other to one place", kDmaTrigger,
       becomes(24U << 17 | 1)},
      {"write address of an RP2040", "dma: not to the SPI", kDmaWrite, becomes(0x4003C008)},
      {"peripherals", "dma: reads neither RAM nor flash", kDma, becomes(kSpiDr)},
      {"mode of counting", "dma: a mode of counting", kDmaCount, with(1U << 28)},
      {"no wait before data", "dma: triggered while it is busy", 0, {}, 0, 0, 0, data_twice},
      {"erratum RP2350-E5", "dma: an enabled channel is aborted", kDmaAlias, dropped, 0, 0, 0, stuck_data},
      {"tick's cycles", "watchdog: not 8 s", kTickCycles, becomes(125)},
      {"no tick", "watchdog: not 8 s", kTickCtrl, dropped},
      {"tick afterwards", "tick: changed while it runs", kWatchdogLoad, moves_to(kTickCycles)},
      {"timer's cycles", "timer: not milliseconds", kTimerTickCycles, becomes(150)},
      {"no tick of the timer", "timer: not milliseconds", kTimerTickCtrl, dropped},
      {"timer's tick afterwards", "tick: changed while it runs", kWatchdogLoad, moves_to(kTimerTickCycles)},
      {"reset of an RP2040's timer", "timer0: touched in reset", kReset + kClearAlias, without(1U << 23)},
      {"twice a tick", "watchdog: not 8 s", kWatchdogLoad, becomes(16'000'000)},
      {"too long", "watchdog: more than 24 bits", kWatchdogLoad, becomes(1U << 24)},
      {"resets of an RP2040's watchdog", "watchdog: it resets not all but the oscillators", kWdsel, becomes(0x1FFFC)},
  };
  return kMistakes;
}

TEST(Pico2Chip, MistakesAreFound) {
  for (const Mistake& mistake : mistakes()) {
    Chip model({.write =
                    [&](std::uint32_t& address, std::uint32_t& value) {
                      return mistake.written == 0 || address != mistake.written || mistake.change(address, value);
                    },
                .read =
                    [&](std::uint32_t address, std::uint32_t& value) {
                      if (address == mistake.read) value = (value | mistake.shows) & ~mistake.hides;
                    }});
    const std::string wrong = run_program(model, mistake.before_words);
    EXPECT_NE(wrong.find(mistake.complaint), std::string::npos) << mistake.what << ": " << wrong;
  }
}

TEST(Pico2Chip, EachComplaintHasAMistake) {
  std::ifstream file(ZSTRIP_CHIP_MODEL);
  const std::string source(std::istreambuf_iterator<char>(file), {});
  static const std::regex complaint("complain\\([^\"\n]*\"([^\"]+)\"");
  std::size_t found = 0;
  for (std::sregex_iterator at(source.begin(), source.end(), complaint), end; at != end; ++at, ++found) {
    const std::string words = (*at)[1];
    EXPECT_TRUE(std::ranges::any_of(mistakes(), [&](const Mistake& mistake) {
      return std::string_view(mistake.complaint).find(words) != std::string_view::npos;
    })) << words;
  }
  EXPECT_GT(found, 30U);
}

}  // namespace
}  // namespace zstrip::pico2
