// What the chip requires of a program and the emulator forgives, block by block, and what the emulator always answers
// although the chip takes time for it. Source: RP2040 data sheet, chapters as named.

// 2.14.3: the order of the bits is that of the blocks; the addresses' upper bits.
const kBlocks = [
  ['adc', 0x4004c], ['busctrl', 0x40030], ['dma', 0x50000], ['i2c0', 0x40044], ['i2c1', 0x40048],
  ['io_bank0', 0x40014], ['io_qspi', 0x40018], ['jtag', 0], ['pads_bank0', 0x4001c], ['pads_qspi', 0x40020],
  ['pio0', 0x50200], ['pio1', 0x50300], ['pll_sys', 0x40028], ['pll_usb', 0x4002c], ['pwm', 0x40050],
  ['rtc', 0x4005c], ['spi0', 0x4003c], ['spi1', 0x40040], ['syscfg', 0x40004], ['sysinfo', 0x40000],
  ['tbman', 0x4006c], ['timer', 0x40054], ['uart0', 0x40034], ['uart1', 0x40038], ['usbctrl', 0x50110],
];
const kReadyNanos = 1000;  // from a reset's end; the chip takes some cycles
const kLockNanos = 50000, kCrystal = 12e6, kCrystalNanos = 1e6;

/** Registers of `peripheral` pass these: on(offset) of a read's or write's value gives what is read or written. */
function between(peripheral, {before = () => {}, reads = {}, writes = {}, after = () => {}}) {
  const read = peripheral.readUint32.bind(peripheral), write = peripheral.writeUint32.bind(peripheral);
  peripheral.readUint32 = (offset) => {
    before();
    const hook = reads[offset & 0xfff];
    return hook ? hook(() => read(offset)) : read(offset);
  };
  peripheral.writeUint32 = (offset, value) => {
    before();
    const hook = writes[offset];
    if (!hook || hook(value >>> 0) !== false) write(offset, value);
    after(offset);
  };
}

/** 2.14: nothing is touched while it is in reset, or before it says that it is ready. */
function resetRules({emulator, complain}) {
  const {clock} = emulator, block = emulator.peripherals[0x4000c];
  const released = kBlocks.map(() => 0);
  const bitOf = (name) => kBlocks.findIndex(([block]) => block === name);
  block.reset = 0x1ffffff;
  // The ROM has taken the pins of the flash out of it long ago.
  for (const bit of [bitOf('io_qspi'), bitOf('pads_qspi')]) {
    block.reset &= ~(1 << bit);
    released[bit] = -kReadyNanos;
  }
  const needsClock = (name) => /spi\d|uart/.test(name) && !/qspi/.test(name);
  const inReset = (bit) => (block.reset >>> bit & 1) !== 0;
  const ready = (bit) => !inReset(bit) && clock.nanos >= released[bit] + kReadyNanos &&
      (!needsClock(kBlocks[bit][0]) || emulator.clocks.periFreq > 0);
  const afterReset = {
    dma: () => emulator.dma.channels.forEach((channel) => { channel.abort(); channel.reset(); }),
    pll_sys: () => Object.assign(emulator.pllSys, {cs: 1, pwr: 0x2d, fbdivInt: 0, prim: 0x77000}),
    spi0: () => Object.assign(emulator.spi[0], {control0: 0, control1: 0, dmaControl: 0, clockDivisor: 0}),
  };
  between(block, {
    reads: {0x8: () => kBlocks.reduce((done, name, bit) => done | (ready(bit) ? 1 << bit : 0), 0)},
    writes: {
      0x0: (value) => kBlocks.forEach(([name], bit) => {
        const asserted = (value >>> bit & 1) !== 0;
        if (asserted && !inReset(bit)) afterReset[name]?.();
        if (!asserted && inReset(bit)) released[bit] = clock.nanos;
      }),
    },
  });
  kBlocks.forEach(([name, address], bit) => {
    if (!emulator.peripherals[address]) return;
    between(emulator.peripherals[address], {
      before: () => {
        if (inReset(bit)) complain(`${name}: touched while it is in reset`);
        else if (!ready(bit)) complain(`${name}: touched before its reset is done`);
      },
    });
  });
  return {inReset: (name) => inReset(bitOf(name))};
}

/** 2.16: the crystal takes its start-up delay; a Pico's takes a millisecond. */
function crystalRules({emulator, complain}, runs) {
  const {clock} = emulator, crystal = emulator.peripherals[0x40024];
  let stableAt = runs ? 0 : Infinity;
  between(crystal, {
    reads: {0x4: (read) => clock.nanos < stableAt ? read() & 0x7fffffff : read()},
    writes: {
      0x0: (value) => {
        if ((value & 0xfff) !== 0xaa0) complain('crystal: its range is not that of 12 MHz');
        const nanos = (crystal.startup & 0x3fff) * 256 / kCrystal * 1e9;
        if (nanos < kCrystalNanos) complain('crystal: it gets less than a millisecond to start');
        if (stableAt === Infinity) stableAt = clock.nanos + nanos;
      },
    },
  });
  return {stable: () => clock.nanos >= stableAt};
}

/** 2.18: limits of the PLL, and its lock. */
function pllRules({emulator, complain}, crystal) {
  const {clock, pllSys: pll, clocks} = emulator;
  let lockedAt = Infinity;
  const powered = () => (pll.pwr & 0x21) === 0;
  const inUse = () => (clocks.sysCtrl & 1) !== 0;
  const changed = () => { if (inUse()) complain('pll: changed while the system runs from it'); };
  between(pll, {
    reads: {0x0: (read) => clock.nanos < lockedAt ? read() & 0x7fffffff : read()},
    writes: {0x0: changed, 0x8: changed, 0xc: changed},
    after: () => {
      if (!powered()) return void(lockedAt = Infinity);
      if (lockedAt !== Infinity) return;
      lockedAt = clock.nanos + kLockNanos;
      const reference = kCrystal / pll.refdiv, vco = reference * pll.fbdiv;
      if (!crystal.stable()) complain('pll: the crystal is not stable');
      if (reference < 5e6 || pll.fbdiv < 16 || pll.fbdiv > 320 || vco < 750e6 || vco > 1600e6)
        complain(`pll: the VCO at ${vco / 1e6} MHz is not between 750 and 1600`);
    },
  });
  return {ready: () => powered() && clock.nanos >= lockedAt && (pll.pwr & 8) === 0};
}

/** 2.15: what clocks are made of runs when they are switched to it; 133 MHz at most. */
function clockRules({emulator, complain}, crystal, pll) {
  const {clocks} = emulator;
  between(clocks, {
    writes: {
      0x30: (value) => {
        if ((value & 3) === 2 && !crystal.stable())
          complain('clocks: the reference comes from a crystal that is not stable');
      },
      0x3c: (value) => {
        if ((clocks.sysCtrl & 1) !== 0 && ((clocks.sysCtrl ^ value) & 0xe0) !== 0)
          complain('clocks: the system\'s auxiliary source changes while it is in use');
        if ((value & 1) !== 0 && (value >>> 5 & 7) === 0 && !pll.ready())
          complain('clocks: the system is switched to a PLL that is not locked and powered');
      },
    },
    after: () => { if (clocks.sysFreq > 133e6) complain(`clocks: the system runs at ${clocks.sysFreq / 1e6} MHz`); },
  });
}

/** 2.19: what a pin does only if it was chosen for it. */
export function checkPin({emulator, complain}, resets, pin, wanted, what) {
  const {functionSelect, outputDisable} = emulator.gpio[pin];
  if (functionSelect !== wanted) complain(`pin ${pin}: it has function ${functionSelect}, ${what} is ${wanted}`);
  if (outputDisable) complain(`pin ${pin}: its output is off`);
  if (resets.inReset('pads_bank0')) complain(`pin ${pin}: its pad is in reset`);
}

/** 4.2: 115200 baud, 8 bits; a character takes its time. */
function uartRules(chip, resets) {
  const {emulator, complain} = chip, {clock} = emulator, uart = emulator.uart[0];
  let idleAt = 0;
  const nanos = () => 10e9 / uart.baudRate;
  const full = () => idleAt - clock.nanos > nanos();
  between(uart, {
    reads: {0x18: (read) => read() | (full() ? 1 << 5 : 0)},
    writes: {
      0x0: () => {
        checkPin(chip, resets, 0, 2, 'UART 0');
        if (Math.abs(uart.baudRate / 115200 - 1) > 0.02) complain(`uart0: ${uart.baudRate} baud`);
        if (!uart.enabled || !uart.txEnabled || uart.wordLength !== 8) complain('uart0: not set up for 8 bits');
        if (full()) complain('uart0: a character is written into a full register');
        idleAt = Math.max(idleAt, clock.nanos) + nanos();
      },
    },
  });
}

/** 4.4: an SPI that sends 8 bits in mode 0, as master; what it requests of the DMA. */
function spiRules(chip, resets) {
  const {emulator, complain} = chip, spi = emulator.spi[0];
  const whileOn = () => { if (spi.enabled) complain('spi0: set up while it is on'); };
  spi.updateDMATx = () => {
    if (spi.txFIFO.full || (spi.dmaControl & 2) === 0) emulator.dma.clearDREQ(spi.dreq.tx);
    else emulator.dma.setDREQ(spi.dreq.tx);
  };
  between(spi, {
    writes: {
      0x0: whileOn,
      0x4: (value) => {
        if ((value & 2) !== 0) return;
        [spi.txFIFO, spi.rxFIFO].forEach((fifo) => fifo.reset());
        spi.busy = false;
        rules.onOff();
      },
      0x8: () => { if (spi.txFIFO.full) complain('spi0: a byte is written into a full FIFO'); },
      0x10: whileOn,
    },
    after: () => spi.updateDMATx(),
  });
  const rules = {
    onOff() {},  // when it is switched off
    checkSend() {
      checkPin(chip, resets, 18, 1, 'SPI 0');
      checkPin(chip, resets, 19, 1, 'SPI 0');
      if (!spi.enabled) complain('spi0: it is off');
      if ((spi.control1 & 4) !== 0) complain('spi0: it is no master');
      if ((spi.control0 & 0xff) !== 7) complain('spi0: not 8 bits in mode 0');
      if (spi.clockDivisor < 2) complain('spi0: its prescaler is 0');
    },
    busy: () => spi.busy || !spi.txFIFO.empty,
  };
  return rules;
}

/** 2.5: a channel that is paced by who requests bytes; an abort takes a moment. */
function dmaRules({emulator, complain}) {
  const {dma} = emulator, spi = emulator.spi[0], [channel] = dma.channels;
  let aborted = 0;
  const whileBusy = () => { if (channel.active) complain('dma: a channel is changed while it is busy'); };
  between(dma, {
    reads: {0x444: () => [aborted, aborted = 0][0]},
    writes: {
      0x0: whileBusy,
      0x4: whileBusy,
      0x8: whileBusy,
      0xc: (value) => {
        whileBusy();
        if ((value & 1) === 0) return;
        if (channel.writeAddr !== 0x4003c008) complain('dma: it does not write to SPI 0\'s data');
        if ((value >>> 15 & 63) !== 16 || (value & 0x3c) !== 0x10) complain('dma: not bytes at the pace of SPI 0');
        if ((spi.dmaControl & 2) === 0) complain('dma: SPI 0 requests nothing');
        const from = channel.readAddr >>> 0, to = from + channel.transCountReload;
        const within = (first, bytes) => from >= first && to <= first + bytes;
        if (!within(0x10000000, 2 << 20) && !within(0x20000000, 264 << 10))
          complain('dma: it reads where no memory is');
      },
      0x444: (value) => { aborted = value; },
    },
  });
}

/** 4.7, 2.13: the watchdog counts microseconds and resets what needs it. */
function watchdogRules({emulator, complain}) {
  const watchdog = emulator.peripherals[0x40058], power = emulator.peripherals[0x40010];
  let cycles = 0;
  between(watchdog, {
    writes: {
      0x0: (value) => {
        if ((value & 1 << 30) === 0) return;
        if (!watchdog.tickEnable || cycles !== kCrystal / 1e6) complain('watchdog: its tick is not a microsecond');
        if (power.wdsel !== 0x1fffc) complain('watchdog: it does not reset all but the oscillators');
      },
      0x2c: (value) => { cycles = value & 0x1ff; },
    },
  });
}

/** `chip`: emulator and complain(); `crystalRuns`: a reset by the watchdog leaves it so. */
export function addRules(chip, crystalRuns) {
  const resets = resetRules(chip);
  const crystal = crystalRules(chip, crystalRuns);
  clockRules(chip, crystal, pllRules(chip, crystal));
  uartRules(chip, resets);
  dmaRules(chip);
  watchdogRules(chip);
  return {resets, spi: spiRules(chip, resets)};
}
