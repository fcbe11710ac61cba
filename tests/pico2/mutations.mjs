// Firmware of the Pico 2 with one mistake each, and what has to be said of it: as tests/pico/mutations.mjs, with the
// RP2350's registers.
const kReset = 0x40020000, kClearBits = 0x3000, kPll = 0x40050000, kSpi = 0x40080000, kDma = 0x50000000;
const kPins = 0xd0000000, kSystick = 0xe000e000;
const kImageDefinition = 0x40;  // from the flash's beginning: after the vector table

const always = (value) => () => value;
const unless = (bits) => (value) => value === bits ? undefined : value;

export const kMutations = [
  {says: 'boot: the ROM does not start the program', flash: (flash) => { flash[kImageDefinition] ^= 1; }},
  {says: 'clocks: the system runs at', at: kPll + 0x8, to: always(130)},
  {says: 'spi0: not 8 bits in mode 0', at: kSpi, to: always(0xf)},
  {says: 'spi0: it is off', at: kSpi + 0x4, to: always(0)},
  {says: 'systick: its reference clock', at: kSystick + 0x10, to: (value) => value & ~4},
  {says: 'the bus sends a bit in', at: kSpi + 0x10, to: always(8)},
  {says: 'too early', at: kSystick + 0x14, to: always(100000)},
  {says: 'the ST7789 has no command', at: kPins + 0x18, to: unless(1 << 20)},
  {says: 'got 115199 bytes', at: kDma + 8, to: (value) => value === 64 ? 63 : value, once: true},
  {says: 'pixels are not those of the host', at: kDma, to: (value) => value + 2},
  {says: 'the backlight is off', at: kPins + 0x18, to: unless(1 << 22)},
];
