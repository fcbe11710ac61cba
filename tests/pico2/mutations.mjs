// Firmware of the Pico 2 with one mistake each, and what has to be said of it: as tests/pico/mutations.mjs, with the
// RP2350's registers.
const kPll = 0x40050000, kSpi = 0x40080000, kDma = 0x50000000;
const kPins = 0xd0000000, kSystick = 0xe000e000;
const kTime = 0xd00001b0, kCompare = 0xd00001b8;  // of the RISC-V platform timer
const kAfterVectorTable = 0x40;  // where the image definition of an Arm program is

const always = (value) => () => value;
const unless = (bits) => (value) => value === bits ? undefined : value;

const kEveryProcessors = [
  {says: 'clocks: the system runs at', at: kPll + 0x8, to: always(130)},
  {says: 'spi0: not 8 bits in mode 0', at: kSpi, to: always(0xf)},
  {says: 'spi0: it is off', at: kSpi + 0x4, to: always(0)},
  {says: 'the bus sends a bit in', at: kSpi + 0x10, to: always(8)},
  {says: 'the ST7789 has no command', at: kPins + 0x18, to: unless(1 << 20)},
  {says: 'got 115199 bytes', at: kDma + 8, to: (value) => value === 64 ? 63 : value, once: true},
  {says: 'pixels are not those of the host', at: kDma, to: (value) => value + 2},
  {says: 'the backlight is off', at: kPins + 0x18, to: unless(1 << 22)},
];
const kNotStarted = 'boot: the ROM does not start the program';
/** Changes a byte of the image definition, `at` from the flash's beginning. */
const changed = (at) => (flash) => { flash[at] ^= 1; };

export const kMutations = {
  arm: [
    ...kEveryProcessors,
    {says: kNotStarted, flash: changed(kAfterVectorTable)},
    {says: 'systick: its reference clock', at: kSystick + 0x10, to: (value) => value & ~4},
    {says: 'too early', at: kSystick + 0x14, to: always(100000)},
  ],
  riscv: [
    ...kEveryProcessors,
    {says: kNotStarted, flash: changed(0)},
    {says: 'too early', at: kCompare, to: (value) => value >>> 6, reads: [kTime, (value) => value << 6 >>> 0]},
  ],
};
