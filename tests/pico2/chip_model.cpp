// Registers and what they do. Source: pico-sdk, src/rp2350/hardware_regs; RP2350 data sheet.
#include "chip_model.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "addresses.hpp"

extern "C" const char __executable_start, _end;  // set by the linker

namespace zstrip::pico2 {
namespace {

using sim::Nanoseconds;
using namespace std::chrono_literals;

constexpr std::uint32_t kCrystalHertz = 12'000'000, kRingHertz = 11'000'000;
constexpr Nanoseconds kAccess = 50ns, kResetTime = 1us, kLockTime = 50us;

constexpr unsigned kPins[] = {17, 20, 21, 22};  // select, D/C, reset, light
constexpr std::uint32_t kUartFunction = 2, kSpiFunction = 1, kSioFunction = 5;
constexpr std::size_t kFifo = 8;

/// The block without what makes an access set or clear bits.
std::uint32_t plain(std::uint32_t address) { return address >> 28 == 0xD ? address : address & ~0x3000U; }

constexpr std::uint32_t kBlockSize = 0x8000;
bool is_in(std::uint32_t block, std::uint32_t address) { return address - block < kBlockSize; }

}  // namespace

struct ResetBlock {
  const char* name;
  std::uint32_t address;
  unsigned bit;
  bool needs_peripheral_clock;
};

namespace {

constexpr ResetBlock kBlocks[] = {
    {"dma", kDma, 2, false},        {"io_bank0", 0x40028000, 6, false}, {"pads_bank0", 0x40038000, 9, false},
    {"pll_sys", kPllCs, 14, false}, {"spi0", kSpi, 18, true},           {"timer0", 0x400B0000, 23, false},
    {"uart0", kUart, 26, true}};

}  // namespace

Chip::Chip(Mutation mutation) : mutation_(std::move(mutation)) {
  registers_ = {{kReset, 0x1FFFFFFF}, {kXoscCtrl, 0},     {kXoscStartup, 0},
                {kRefCtrl, 0},        {kSysCtrl, 0x41},   {kPeriCtrl, 0},
                {kPllCs, 1},          {kPllPwr, 0x2D},    {kPllFbdiv, 0},
                {kPllPrim, 0x77000},  {kWdsel, 0},        {kWatchdogCtrl, 0x07000000},
                {kWatchdogLoad, 0},   {kTickCtrl, 0},     {kTickCycles, 0},
                {kSioSet, 0},         {kSioClear, 0},     {kSioEnable, 0},
                {kUart, 0},           {kUartInteger, 0},  {kUartFraction, 0},
                {kUartLine, 0},       {kUartCtrl, 0x300}, {kSpi, 0},
                {kSpiCr1, 0},         {kSpiDr, 0},        {kSpiCpsr, 0},
                {kSpiDmacr, 0},       {kDma, 0},          {kDmaWrite, 0},
                {kDmaCount, 0},       {kDmaTrigger, 0},   {kDmaAbort, 0},
                {kTimerUpper, 0},     {kTimerLower, 0},   {kTimerTickCtrl, 0},
                {kTimerTickCycles, 0}};
  for (unsigned pin = 0; pin < 30; ++pin) {
    registers_[function_of(pin)] = 0x1F;
    registers_[pad_of(pin)] = 0x116;
  }
}

void Chip::complain(const std::string& what) const { throw Complaint(what); }

std::uint32_t& Chip::at(std::uint32_t address) {
  const auto found = registers_.find(address == kDmaAlias ? kDmaTrigger : address);
  if (found == registers_.end()) complain("there is no register that this program needs");
  return found->second;
}

std::uint32_t Chip::stored(std::uint32_t address) const { return registers_.at(address); }

// Clocks.

std::uint32_t Chip::reference_hertz() const { return (stored(kRefCtrl) & 3) == 2 ? kCrystalHertz : kRingHertz; }

std::uint32_t Chip::pll_hertz() const {
  const std::uint32_t dividers = stored(kPllPrim);
  return kCrystalHertz / (stored(kPllCs) & 0x3F) * stored(kPllFbdiv) / (dividers >> 16 & 7) / (dividers >> 12 & 7);
}

std::uint32_t Chip::system_hertz() const {
  const std::uint32_t control = stored(kSysCtrl);
  if ((control & 1) == 0) return reference_hertz();
  return (control >> 5 & 7) == 0 ? pll_hertz() : kRingHertz;
}

bool Chip::has_peripheral_clock() const { return (stored(kPeriCtrl) & 0x8E0) == 0x800; }

void Chip::write_clocks(std::uint32_t address, std::uint32_t old, std::uint32_t value) {
  if (address == kXoscCtrl) {
    if ((value & 0xFFF) != 0xAA0) complain("crystal: its range is not that of 12 MHz");
    if (value >> 12 != 0xFAB) complain("crystal: not enabled");
    const Nanoseconds delay((stored(kXoscStartup) & 0x3FFF) * 256ULL * 1'000'000'000 / kCrystalHertz);
    if (delay < 1ms) complain("crystal: less than a millisecond to start");
    crystal_stable_ = now_ + delay;
  }
  if (address == kRefCtrl && (value & 3) == 2 && now_ < crystal_stable_)
    complain("reference: the crystal is not stable");
  if (address == kSysCtrl) {
    if ((old & 1) != 0 && ((old ^ value) & 0xE0) != 0) complain("system: the auxiliary source changes while in use");
    if ((value & 1) == 0) return;
    if ((value >> 5 & 7) != 0) complain("system: not from the PLL");
    if (now_ < pll_locked_ || (stored(kPllPwr) & 8) != 0) complain("system: the PLL is not locked and powered");
    if (system_hertz() > 150'000'000) complain("system: above 150 MHz");
  }
  if (address == kPeriCtrl && system_hertz() != 150'000'000) complain("peripherals: the clock changes afterwards");
}

void Chip::write_pll() {
  if ((stored(kSysCtrl) & 0xE1) == 1) complain("pll: changed while in use");
  if ((stored(kPllPwr) & 0x21) != 0) {
    pll_locked_ = Nanoseconds::max();
    return;
  }
  if (pll_locked_ != Nanoseconds::max()) return;
  if ((stored(kRefCtrl) & 3) != 2) complain("pll: the crystal does not run");
  const std::uint64_t divider = stored(kPllFbdiv), vco = kCrystalHertz / (stored(kPllCs) & 0x3F) * divider;
  if (divider < 16 || divider > 320 || vco < 750'000'000 || vco > 1'600'000'000) complain("pll: the VCO's limits");
  pll_locked_ = now_ + kLockTime;
}

// Resets.

bool Chip::is_ready(const ResetBlock& block) const {
  if ((stored(kReset) >> block.bit & 1) != 0) return false;
  const auto released = released_.find(block.bit);
  return released != released_.end() && now_ >= released->second + kResetTime &&
         (!block.needs_peripheral_clock || has_peripheral_clock());
}

void Chip::check_reset(std::uint32_t address) const {
  for (const ResetBlock& block : kBlocks) {
    if (is_in(block.address, address) && !is_ready(block)) complain(std::string(block.name) + ": touched in reset");
  }
}

// Pins.

void Chip::check_pin(unsigned pin, std::uint32_t function) const {
  const std::string name = "pin " + std::to_string(pin);
  if ((stored(function_of(pin)) & 0x1F) != function) complain(name + ": its function");
  if ((stored(pad_of(pin)) & 0x100) != 0) complain(name + ": isolated");
  if ((stored(pad_of(pin)) & 0x80) != 0) complain(name + ": its output is off");
}

void Chip::update_lines() {
  for (std::size_t line = 0; line < std::size(kPins); ++line) {
    const unsigned pin = kPins[line];
    const std::uint32_t pad = stored(pad_of(pin));
    if ((pad & 0x100) != 0) continue;  // what was driven stays
    const bool driven =
        (stored(function_of(pin)) & 0x1F) == kSioFunction && (enabled_ >> pin & 1) != 0 && (pad & 0x80) == 0;
    const int level = driven ? static_cast<int>(outputs_ >> pin & 1) : kFloating;
    if (level == levels_[line]) continue;
    if (line < 2 && is_sending()) complain("panel: D/C or select changes amid a byte");
    levels_[line] = level;
    if (line == 2 && level != kFloating) panel_.set_reset(level == 1);
  }
}

// Console.

void Chip::send_character(std::uint32_t value) {
  check_pin(0, kUartFunction);
  if ((stored(kUartCtrl) & 0x301) != 0x301 || (stored(kUartLine) & 0xE8) != 0x60)
    complain("uart: not set up for 8 bits");
  const double divisor = stored(kUartInteger) + stored(kUartFraction) / 64.0;
  const double baud = system_hertz() / (16 * divisor);
  if (baud < 115200 * 0.98 || baud > 115200 * 1.02) complain("uart: the baud rate");
  const Nanoseconds character(static_cast<std::int64_t>(10e9 / baud));
  if (console_idle_ > now_ + character) complain("uart: a character is lost");
  console_idle_ = std::max(console_idle_, now_) + character;
  console_ += static_cast<char>(value);
}

// SPI and DMA.

void Chip::write_spi(std::uint32_t address, std::uint32_t value) {
  const bool on = (stored(kSpiCr1) & 2) != 0;
  if (address == kSpiCr1 && (value & 2) == 0) {
    sending_.clear();
    received_ = 0;
    stuck_ = false;
  }
  if ((address == kSpi || address == kSpiCpsr) && on) complain("spi: changed while on");
  if (address != kSpiDr) return;
  if (!on || (stored(kSpiCr1) & 4) != 0) complain("spi: no master that is on");
  if ((stored(kSpi) & 0xFF) != 7) complain("spi: not 8 bits, mode 0");
  if (sending_.size() == kFifo) complain("spi: a byte is lost");
  check_pin(18, kSpiFunction);
  check_pin(19, kSpiFunction);
  for (const unsigned pin : kPins) check_pin(pin, kSioFunction);
  if (levels_[0] != 0) complain("panel: bytes while it is not selected");
  if (levels_[1] == kFloating) complain("panel: D/C is not driven");
  const std::uint32_t prescale = stored(kSpiCpsr);
  if (prescale < 2 || prescale % 2 != 0) complain("spi: the prescaler");
  const Nanoseconds bit(1'000'000'000ULL * prescale * (1 + (stored(kSpi) >> 8)) / system_hertz());
  panel_.clocked_at(bit);
  if (sending_.empty()) byte_done_ = now_ + 8 * bit;
  sending_.push_back(static_cast<std::uint8_t>(value));
}

void Chip::write_dma(std::uint32_t address, std::uint32_t value) {
  if (address == kDma) {
    const auto image = reinterpret_cast<std::uintptr_t>(&__executable_start);
    const auto image_end = reinterpret_cast<std::uintptr_t>(&_end);
    const bool is_in_ram = value >= ram_[0] && value < ram_[1], is_in_flash = value >= image && value < image_end;
    if (!is_in_ram && !is_in_flash) complain("dma: reads neither RAM nor flash");
    source_ = reinterpret_cast<const std::byte*>(static_cast<std::uintptr_t>(value));
  }
  if (address == kDmaAbort && (value & 1) != 0) {
    if ((stored(kDmaTrigger) & 1) != 0) complain("dma: an enabled channel is aborted");
    dma_busy_ = false;
    left_ = 0;
  }
  if (address != kDmaTrigger || (value & 1) == 0) return;
  if (dma_busy_) complain("dma: triggered while it is busy");
  if ((value >> 17 & 0x3F) != 24) complain("dma: not at the SPI's pace");
  if ((value >> 13 & 0xF) != 0) complain("dma: it starts another channel");
  if ((value & 0x1FFC) != 0x10) complain("dma: not bytes that follow each other to one place");
  if (stored(kDmaWrite) != kSpiDr) complain("dma: not to the SPI");
  if (stored(kDmaCount) >> 28 != 0) complain("dma: a mode of counting");
  left_ = stored(kDmaCount);
  dma_busy_ = left_ != 0;
}

void Chip::move_bytes() {
  for (;;) {
    if (dma_busy_ && (stored(kSpiDmacr) & 2) != 0 && sending_.size() < kFifo) {
      write_spi(kSpiDr, std::to_integer<std::uint32_t>(*source_++));
      dma_busy_ = --left_ != 0;
      continue;
    }
    if (stuck_ || sending_.empty() || now_ < byte_done_) return;
    const std::uint8_t byte = sending_.front();
    sending_.pop_front();
    received_ = std::min(received_ + 1, kFifo);
    deliver(byte);
    byte_done_ += Nanoseconds(8'000'000'000ULL * stored(kSpiCpsr) * (1 + (stored(kSpi) >> 8)) / system_hertz());
  }
}

void Chip::deliver(std::uint8_t byte) {
  const std::byte bytes[] = {std::byte{byte}};
  panel_.receive(levels_[1] == 1 ? sim::Wire::data : sim::Wire::command, bytes);
  if (!panel_.complaints().empty()) complain("panel: " + panel_.complaints().front());
}

// Timer and watchdog.

std::uint64_t Chip::timer_ticks() const {
  const std::uint32_t cycles = stored(kTimerTickCycles);
  if ((stored(kTimerTickCtrl) & 1) == 0 || cycles == 0) return 0;
  return static_cast<std::uint64_t>((now_ - timer_started_).count()) * (reference_hertz() / 1'000'000) / 1000 / cycles;
}

Nanoseconds Chip::watchdog_time() const {
  const bool runs = (stored(kWatchdogCtrl) >> 30 & 1) != 0 && (stored(kTickCtrl) & 1) != 0 && stored(kTickCycles) != 0;
  if (!runs) return Nanoseconds::max();
  return watchdog_loaded_ +
         Nanoseconds(1'000'000'000ULL * stored(kTickCycles) * stored(kWatchdogLoad) / reference_hertz());
}

void Chip::write_watchdog(std::uint32_t address, std::uint32_t old, std::uint32_t value) {
  const bool changes_timer = address == kTimerTickCycles && (stored(kTimerTickCtrl) & 1) != 0;
  if (changes_timer || (address == kTickCycles && (stored(kTickCtrl) & 1) != 0))
    complain("tick: changed while it runs");
  if (address == kTimerTickCtrl && (value & ~old & 1) != 0) timer_started_ = now_;
  if (address == kWatchdogLoad) {
    if (value >> 24 != 0) complain("watchdog: more than 24 bits");
    watchdog_loaded_ = now_;
  }
  if (address != kWatchdogCtrl || (value >> 30 & 1) == 0 || (old >> 30 & 1) != 0) return;
  if (stored(kWdsel) != 0x1FFFFF3) complain("watchdog: it resets not all but the oscillators");
}

// Accesses.

void Chip::pass(Nanoseconds time) {
  const Nanoseconds end = now_ + time;
  while (now_ < end) {
    const Nanoseconds step = std::min(end - now_, is_sending() || dma_busy_ ? Nanoseconds(100ns) : Nanoseconds(1h));
    now_ += step;
    panel_.elapse(step);
    move_bytes();
  }
}

std::uint32_t Chip::read(std::uint32_t address) {
  pass(kAccess);
  constexpr std::uint32_t kMostReads = 500'000;
  reads_ = address == last_read_ ? reads_ + 1 : 0;
  last_read_ = address;
  if (reads_ > kMostReads) complain("the program waits for ever");
  check_reset(address);
  std::uint32_t value = answer(address);
  if (mutation_.read) mutation_.read(address, value);
  return value;
}

std::uint32_t Chip::answer(std::uint32_t address) {
  switch (address) {
    case kResetDone: {
      std::uint32_t done = 0;
      for (const ResetBlock& block : kBlocks) done |= is_ready(block) ? 1U << block.bit : 0;
      return done;
    }
    case kXoscStatus: return now_ >= crystal_stable_ ? 1U << 31 : 0;
    case kRefSelected: return 1U << (stored(kRefCtrl) & 3);
    case kSysSelected: return 1U << (stored(kSysCtrl) & 1);
    case kPllCs: return at(address) | (now_ >= pll_locked_ ? 1U << 31 : 0);
    case kUartFlags: {
      if ((stored(pad_of(1)) & 0x14C) != 0x048) complain("pin 1: no input that is pulled up");
      return 1U << 4 | (console_idle_ > now_ ? 1U << 5 : 0);
    }
    case kSpiSr: return 1U | (sending_.size() < kFifo ? 2U : 0) | (received_ != 0 ? 4U : 0) | (is_sending() ? 16U : 0);
    case kSpiDr: received_ -= received_ != 0; return 0;
    case kTimerLower: {
      const std::uint64_t ticks = timer_ticks();
      at(kTimerUpper) = static_cast<std::uint32_t>(ticks >> 32);
      return static_cast<std::uint32_t>(ticks);
    }
    case kDmaAlias:
    case kDmaTrigger: return at(address) | (dma_busy_ ? 1U << 26 : 0);
    default: return at(address);
  }
}

void Chip::before_write(std::uint32_t address, std::uint32_t old, std::uint32_t value) {
  if (is_in(kSpi, address)) write_spi(address, value);
  if (is_in(0x40038000, address) && (value & 0x100) == 0) {
    const auto pin = static_cast<unsigned>((address - pad_of(0)) / 4);
    if ((stored(function_of(pin)) & 0x1F) == 0x1F)
      complain("pin " + std::to_string(pin) + ": connected without a function");
  }
  if (address == kReset) {
    for (const ResetBlock& block : kBlocks) {
      if (((old & ~value) >> block.bit & 1) != 0) released_[block.bit] = now_;
    }
  }
}

void Chip::after_write(std::uint32_t address, std::uint32_t old, std::uint32_t value) {
  write_clocks(address, old, value);
  if (is_in(kPllCs, address)) write_pll();
  if (address == kUart) send_character(value);
  if (is_in(kDma, address)) write_dma(address, value);
  write_watchdog(address, old, value);
  if (address == kSioSet) outputs_ |= value;
  if (address == kSioClear) outputs_ &= ~value;
  if (address == kSioEnable) enabled_ |= value;
  update_lines();
}

void Chip::write(std::uint32_t address, std::uint32_t value) {
  pass(kAccess);
  reads_ = 0;
  if (mutation_.write && !mutation_.write(address, value)) return;
  const std::uint32_t place = plain(address);
  check_reset(place);
  std::uint32_t& current = at(place);
  const std::uint32_t old = current;
  switch (place == address ? 0 : address >> 12 & 3) {
    case 1: value = old ^ value; break;
    case 2: value = old | value; break;
    case 3: value = old & ~value; break;
    default: break;
  }
  before_write(place, old, value);
  current = value;
  after_write(place, old, value);
  if (place == kDmaTrigger || place == kDmaAlias) current &= ~(3U << 29);  // faults are cleared by ones
  move_bytes();
}

}  // namespace zstrip::pico2
