// Firmware with one mistake each, and what has to be said of it. A mistake is made between the processor and its bus:
// it needs no compiler and finds its place in every build. What the program writes to a register is something else or
// does not arrive, or what it reads says that nothing has to be waited for.
//   at: the register, as the program addresses it; to(value): what is written instead, undefined is nothing
//   also: writes that follow; and: more of both; once: only the first time; reads: [register, what is read]
//   flash(bytes): what is in the file; stuck: no byte leaves the bus
const kReset = 0x4000c000, kSetBits = 0x2000, kClearBits = 0x3000, kDone = 0x4000c008;
const kCrystal = 0x40024000, kClocks = 0x40008000, kPll = 0x40028000, kUart = 0x40034000, kSpi = 0x4003c000;
const kDma = 0x50000000, kSsi = 0x18000000, kPins = 0xd0000000, kWatchdog = 0x40058000, kSystick = 0xe000e000;
const kFlashPads = 0x40020000;
const pin = (number) => 0x40014004 + 8 * number;
const pad = (number) => 0x4001c004 + 4 * number;

const always = (value) => () => value;
const without = (bits) => (value) => value & ~bits;
const unless = (bits) => (value) => value === bits ? undefined : value;
const lost = () => undefined;
/** Another value from the write of this number on. */
const from = (number, other) => {
  let count = 0;
  return (value) => ++count < number ? value : other;
};

/** The second boot stage with other code, and the checksum of that. */
const stage = (code) => (flash, crc) => {
  flash.set(code);
  new DataView(flash.buffer).setUint32(252, crc(flash.subarray(0, 252)), true);
};

export const kMutations = [
  {says: 'checksum of the second stage', flash: (flash) => { flash[10] ^= 1; }},
  {says: 'the second stage does not end', flash: stage([0xfe, 0xe7])},
  {says: 'flash: a command while its interface is off', at: kSsi + 0x08, to: always(0)},
  {says: 'flash: its interface is set up while it is on', at: kSsi + 0x08, to: always(1)},
  {says: 'flash: its interface is off', at: kSsi + 0x08, to: from(6, 0)},
  {says: 'flash: the interface does not send bytes', at: kSsi, to: unless(7 << 16)},
  {says: 'flash: a command while it writes its status', reads: [kSsi + 0x60, 0]},
  {says: 'flash: it does not allow four lines', at: kSsi + 0x60, to: unless(0x06)},
  {says: 'flash: it does not allow four lines', reads: [kSsi + 0x28, 4]},
  {says: 'flash: no read by four lines has said', at: kSsi + 0xf4, to: always(0xa0002022)},
  {says: 'flash: the interface does not read a word', at: kSsi + 0x04, to: always(1)},
  {says: 'flash: reads are not an address', at: kSsi + 0xf4, to: from(2, 0xa0001822)},
  {says: 'flash: its clock is too fast', at: kSsi + 0x14, to: always(1)},
  {says: 'flash: its data are sampled too early', at: kSsi + 0xf0, to: lost},
  {says: 'flash: the clock\'s pad is not fast', at: kFlashPads + 0x04, to: without(1)},
  {says: 'flash: a data pad has a Schmitt trigger', at: kFlashPads + 0x10, to: lost},
  {says: 'the vector table is not', at: kSystick + 0xd08, to: always(0x10000000)},
  {says: 'flash: a write to 10000200', at: kReset + kClearBits, also: [[0x10000200, 0]]},

  {says: 'uart0: touched while it is in reset', at: kReset + kClearBits, to: without(1 << 22),
    reads: [kDone, 0xffffffff]},
  {says: 'spi0: touched while it is in reset', at: kReset + kClearBits, to: without(1 << 16)},
  {says: 'dma: touched while it is in reset', at: kReset + kClearBits, to: without(1 << 2)},
  {says: 'touched before its reset is done', reads: [kDone, 0xffffffff]},
  {says: 'its pad is in reset', at: kReset + kClearBits, to: without(1 << 8),
    reads: [kDone, (value) => value | 1 << 8]},

  {says: 'crystal: its range', at: kCrystal, to: always(0xfabaa1)},
  {says: 'less than a millisecond to start', at: kCrystal + 0xc, to: always(10)},
  {says: 'comes from a crystal that is not stable', reads: [kCrystal + 4, 0xffffffff]},
  {says: 'pll: the crystal is not stable', at: kCrystal, to: lost,
    reads: [[kCrystal + 4, 0xffffffff], [kClocks + 0x38, 4]],
    and: [{at: kClocks + 0x30, to: lost}]},
  {says: 'the VCO at 1680 MHz', at: kPll + 8, to: always(140)},
  {says: 'the VCO at 720 MHz', at: kPll + 8, to: always(60)},
  {says: 'a PLL that is not locked', reads: [kPll, 0x80000001]},
  {says: 'not locked and powered', at: kPll + kClearBits + 4, to: unless(8)},
  {says: 'the system runs at 150 MHz', at: kPll + 0xc, to: always(5 << 16 | 2 << 12)},
  {says: 'changed while the system runs from it', at: kClocks + 0x48, also: [[kPll + 8, 100]]},
  {says: 'auxiliary source changes', at: kClocks + 0x48, also: [[kClocks + 0x3c, 1 | 1 << 5]]},

  {says: 'pin 0: it has function 5', at: pin(0), to: always(5), stuck: true},
  {says: 'baud', at: kUart + 0x24, to: always(60), stuck: true},
  {says: 'uart0: not set up for 8 bits', at: kUart + 0x2c, to: always(0x40), stuck: true},
  {says: 'a character is written into a full register', reads: [kUart + 0x18, 0x10], stuck: true},

  {says: 'pin 18: it has function 5', at: pin(18), to: always(5)},
  {says: 'pin 19: it has function 31', at: pin(19), to: lost},
  {says: 'pin 18: its output is off', at: pin(18), also: [[pad(18), 0xd6]]},
  {says: 'spi0: it is off', at: kSpi + 4, to: lost},
  {says: 'spi0: it is no master', at: kSpi + 4, to: (value) => value | 4},
  {says: 'spi0: not 8 bits in mode 0', at: kSpi, to: always(0x87)},
  {says: 'spi0: its prescaler is 0', at: kSpi + 0x10, to: lost},
  {says: 'spi0: set up while it is on', at: kSpi + 4, to: (value) => value || 2},
  {says: 'spi0: a byte is written into a full FIFO', at: kSpi + 8, also: Array(9).fill([kSpi + 8, 0])},
  {says: 'changes amid a byte', reads: [kSpi + 0xc, 2]},
  {says: 'bytes are sent while it is not selected', at: kPins + 0x18, to: unless(1 << 17)},
  {says: 'bytes are sent while it is in reset', at: kPins + 0x14, to: unless(1 << 21)},
  {says: 'D/C is not driven', at: pin(20), to: lost},

  {says: 'dma: SPI 0 requests nothing', at: kSpi + 0x24, to: always(0)},
  {says: 'dma: it does not write to SPI 0', at: kDma + 4, to: lost},
  {says: 'dma: not bytes at the pace', at: kDma + 0xc, to: (value) => value | 63 << 15},
  {says: 'dma: it reads where no memory is', at: kDma, to: always(0x30000000)},
  {says: 'dma: a channel is changed while it is busy', at: kDma + 0xc, also: [[kDma, 0x20000000]]},

  {says: 'watchdog: its tick', at: kWatchdog + 0x2c, to: always(1 << 9 | 10)},
  {says: 'watchdog: it does not reset', at: 0x40010008, to: lost},
  {says: 'systick: its reference clock', at: kSystick + 0x10, to: without(4)},

  // What the model of the panel says.
  {says: 'the bus sends a bit in 64 ns', at: kSpi + 0x10, to: always(8)},
  {says: 'too early', at: kSystick + 0x14, to: always(100000)},
  {says: 'the ST7789 has no command', at: kPins + 0x14, to: unless(1 << 20)},
  {says: 'got 115199 bytes', at: kDma + 8, to: (value) => value === 64 ? 63 : value, once: true},
  {says: 'pixels are not those of the host', at: kDma, to: (value) => value + 2},
  {says: 'the backlight is off', at: kPins + 0x14, to: unless(1 << 22)},
];

let panicked = false;

/** Of what a bus that is stuck, `how` long, ends in. */
export const kStuckMutations = [
  {how: 'for ever', says: 'not the watchdog after 8', at: kWatchdog, to: unless(1 << 30)},
  {how: 'for ever', says: 'not the watchdog after 8', at: kWatchdog + 4, to: always(2 * 7e6)},
  {how: 'until off', says: 'words: ', at: kUart, to: (value) => { panicked = true; return value; },
    and: [{at: kDma, to: (value) => panicked ? value + 2 : value}]},
];

const asList = (reads) => reads === undefined ? [] : Array.isArray(reads[0]) ? reads : [reads];

/** A chip's option `mutate`. */
export function mutationOf({at, to = (value) => value, also = [], reads, and = [], once}) {
  return (core) => {
    const write = core.writeUint32.bind(core), read = core.readUint32.bind(core);
    const writes = [{at, to, also}, ...and];
    let done = false;
    core.writeUint32 = (address, value) => {
      const found = writes.find((one) => one.at === address >>> 0);
      if (!found || done) return write(address, value);
      const changed = found.to(value >>> 0);
      if (once && changed !== value >>> 0) done = true;
      if (changed !== undefined) write(address, changed);
      for (const [other, word] of found.also ?? []) write(other, word);
    };
    core.readUint32 = (address) => {
      const found = asList(reads).find(([one]) => one === address >>> 0);
      if (!found) return read(address);
      return typeof found[1] === 'function' ? found[1](read(address)) : found[1];
    };
  };
}
