// The Raspberry Pi Pico, or a Pico 2, with the panel of firmware/boards/pico/pins.hpp at its pins: what the panel's
// lines carry, and when, and what the console says.
import {Chip as Rp2040} from './chip.mjs';

const kSelect = 17, kDataCommand = 20, kReset = 21, kLight = 22;
const kLow = 0, kHigh = 1;  // of GPIOPinState; all others are inputs
const kMemoryWrite = 0x2c;

export class Board {
  /** `pixelBytes`: of a frame on the bus. `Chip`: a class like that of chip.mjs; `options`: its options. */
  constructor(library, flash, pixelBytes, {Chip = Rp2040, ...options} = {}) {
    this.lines = [];   // for the panel's model (panel.cpp): nanoseconds, a word, its value
    this.burst = [];   // bytes that follow each other, whose line is not ended
    this.console = '';  // what was said
    this.frames = [];   // when each picture was complete, in nanoseconds, the blackened panel first;
                        // a frame that sent nothing is none
    this.stuck = '';   // the bus, bytes do not leave it: until it is switched off, or for ever
    this.chip = new Chip(library, flash, options);
    this.pixelBytes = pixelBytes;
    this.onFrame = () => {};
    const {emulator} = this.chip;
    emulator.uart[0].onByte = (byte) => { this.console += String.fromCharCode(byte); };
    this.wireUp(emulator);
    const {watchdog} = this.chip;
    watchdog.onWatchdogTrigger = () => {
      watchdog.alarm.enable = false;  // an expired one would never let time go on
      this.chip.end('watchdog');
    };
    this.chip.onWaiting(() => this.frameClockRead());
    this.chip.boot();
  }

  wireUp(emulator) {
    const levels = {};
    const busy = () => this.chip.rules.spi.busy();
    for (const [pin, name] of [[kSelect, 'select'], [kDataCommand, 'data'], [kReset, 'reset'], [kLight, 'light']]) {
      levels[pin] = emulator.gpio[pin].value;
      emulator.gpio[pin].addListener((level) => {
        if (busy() && (pin === kSelect || pin === kDataCommand))
          this.chip.complain(`panel: ${name} changes amid a byte`);
        levels[pin] = level;
        if (level === kLow || level === kHigh) this.line(name, level);
        if (pin === kSelect && level === kHigh) this.deselected();
      });
    }
    const spi = emulator.spi[0];
    let command = 0, cycle = 0;
    this.pixels = 0;
    const sent = emulator.clock.createAlarm(() => spi.completeTransmit(0xff));
    this.chip.rules.spi.onOff = () => {
      sent.cancel();
      if (this.stuck === 'until off') this.stuck = '';
    };
    spi.onTransmit = (byte) => {
      this.chip.rules.spi.checkSend();
      if (levels[kSelect] !== kLow) this.chip.complain('panel: bytes are sent while it is not selected');
      if (levels[kReset] !== kHigh) this.chip.complain('panel: bytes are sent while it is in reset');
      if (levels[kDataCommand] !== kLow && levels[kDataCommand] !== kHigh)
        this.chip.complain('panel: D/C is not driven');
      if (this.stuck) return;
      const nanos = 1e9 / spi.clockFrequency;
      if (nanos !== cycle) this.line('cycle', cycle = nanos);
      const isData = levels[kDataCommand] === kHigh;
      if (!isData) command = byte;
      else if (command === kMemoryWrite) ++this.pixels;
      if (this.burst.length === 0) this.burstBegan = this.chip.nanos;
      this.burst.push(byte);
      sent.schedule(8 * nanos);
    };
  }

  endBurst() {
    if (this.burst.length === 0) return;
    this.lines.push(`${Math.round(this.burstBegan)} bytes ${Buffer.from(this.burst).toString('hex')}`);
    this.burst = [];
  }

  /** Calls `then` after this time. */
  in(seconds, then) { this.chip.emulator.clock.createAlarm(then).schedule(seconds * 1e9); }

  /** From now on no byte is sent, `how` long: 'until off' is until the SPI is switched off, or for ever. */
  stick(how = 'for ever') {
    this.stuck = how;
    this.line('stuck', 1);
  }

  line(word, value) {
    this.endBurst();
    this.lines.push(`${Math.round(this.chip.nanos)} ${word} ${value}`);
  }

  /** The panel is blackened whole, before the frame clock runs. */
  deselected() {
    if (this.frames.length === 0 && this.pixels === this.pixelBytes) this.pictureEnds();
  }

  /** After each frame the program waits for its frame clock. */
  frameClockRead() {
    if (this.frames.length === 0 || this.pixels === 0) return;
    this.line('frame', this.frames.length);
    this.pictureEnds();
  }

  pictureEnds() {
    this.pixels = 0;
    this.frames.push(this.chip.nanos);
    this.onFrame(this.frames.length - 1);
  }

  /** All that the panel's lines carried. */
  wire() {
    this.endBurst();
    return this.lines.map((line) => line + '\n').join('');
  }
}
