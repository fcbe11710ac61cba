// The RP2040's flash interface and a Winbond W25Q16JV behind it, as far as a second boot stage uses them: the emulator
// has neither. Sources: RP2040 data sheet, 4.10 (SSI); W25Q16JV data sheet, 7.1 (status registers), 8.2 (instructions).
const kControl0 = 0x00, kControl1 = 0x04, kEnable = 0x08, kBaudRate = 0x14, kStatus = 0x28, kData = 0x60;
const kSampleDelay = 0xf0, kSpiControl0 = 0xf4;
const kBytesBothWays = 7 << 16, kReadFrames = 2 << 21 | 31 << 16 | 3 << 8;
const kAddressAndMode = 4 << 11 | 8 << 2, kCommandFirst = kAddressAndMode | 2 << 8 | 1;
const kNoCommand = (kAddressAndMode | 0xa0 << 24 | 2) >>> 0;
const kStatusWriteCycles = 20000;

class Flash {
  writing = 0;  // until when, cycles
  fourLines;
  writeEnabled = false;
  readsOn = false;  // the next read has no command

  constructor(fourLines) { this.fourLines = fourLines; }

  /** What it answers to the last of these bytes. */
  answer(bytes, now) {
    if (bytes.length < 2) return 0xff;
    if (bytes[0] === 0x05) return (now < this.writing ? 1 : 0) | (this.writeEnabled ? 2 : 0);
    return bytes[0] === 0x35 ? (this.fourLines ? 2 : 0) : 0xff;
  }
  /** It is no longer selected. */
  deselect(bytes, now) {
    if (bytes.length === 1 && bytes[0] === 0x06) this.writeEnabled = true;
    if (bytes.length !== 3 || bytes[0] !== 0x01 || !this.writeEnabled) return;
    this.fourLines = (bytes[2] & 2) !== 0;
    this.writeEnabled = false;
    this.writing = now + kStatusWriteCycles;
  }
}

class FlashInterface {
  flash;
  registers = new Map();
  sent = [];  // since the flash was selected
  received = [];
  busyUntil = 0;  // cycles

  constructor(chip, flash) { Object.assign(this, {chip, flash}); }
  get now() { return this.chip.emulator.core.cycles; }
  register(offset) { return this.registers.get(offset) ?? 0; }
  byteCycles() { return 8 * (this.register(kBaudRate) || 65536); }

  readUint32(offset) {
    this.finish();
    if (offset === kData) return this.received.shift() ?? 0;
    if (offset !== kStatus) return this.register(offset);
    const left = this.busyUntil - this.now;
    return (left > 0 ? 1 : 0) | 2 | (left <= this.byteCycles() ? 4 : 0) | (this.received.length > 0 ? 8 : 0);
  }
  writeUint32Atomic(offset, value) { this.writeUint32(offset, value >>> 0); }
  writeUint32(offset, value) {
    this.finish();
    if (offset === kData) return this.send(value);
    if (offset !== kEnable && this.register(kEnable) === 1)
      this.chip.complain('flash: its interface is set up while it is on');
    if (offset === kEnable && value === 0) this.received = [];
    this.registers.set(offset, value);
  }

  send(value) {
    if (this.register(kEnable) !== 1) return this.chip.complain('flash: a command while its interface is off');
    this.sent.push(value);
    this.busyUntil = Math.max(this.busyUntil, this.now) + this.byteCycles();
    if (this.now < this.flash.writing && this.sent[0] !== 0x05)
      this.chip.complain('flash: a command while it writes its status');
    if (this.register(kControl0) === kReadFrames) return;
    if (this.register(kControl0) !== kBytesBothWays)
      return this.chip.complain('flash: the interface does not send bytes and receive as many');
    this.received.push(this.flash.answer(this.sent, this.now));
  }
  /** What was sent before is over if nothing was added in time. */
  finish() {
    if (this.sent.length === 0 || this.now < this.busyUntil) return;
    const sent = this.sent;
    this.sent = [];
    if (this.register(kControl0) !== kReadFrames) return this.flash.deselect(sent, this.now);
    this.flash.readsOn = sent.length === 2 && sent[0] === 0xeb && sent[1] === 0xa0 &&
        this.register(kSpiControl0) === kCommandFirst && this.flash.fourLines;
  }

  /** Whether a program can be read in place when the system runs at 125 MHz. */
  check() {
    this.finish();
    const {chip} = this, divider = this.register(kBaudRate);
    if (this.register(kEnable) !== 1) return chip.complain('flash: its interface is off');
    if (!this.flash.fourLines) return chip.complain('flash: it does not allow four lines');
    if (!this.flash.readsOn) return chip.complain('flash: no read by four lines has said that no command follows');
    if (this.register(kControl0) !== kReadFrames || this.register(kControl1) !== 0)
      return chip.complain('flash: the interface does not read a word of 32 bits by four lines an access');
    if (this.register(kSpiControl0) !== kNoCommand)
      return chip.complain('flash: reads are not an address, a mode and four clocks of waiting');
    // EBh with these clocks of waiting: up to 104 MHz. Above 50 MHz data come too late for the edge that is usual.
    if (divider % 2 !== 0 || divider === 0 || 125e6 / divider > 104e6)
      return chip.complain('flash: its clock is too fast');
    if (125e6 / divider > 50e6 && this.register(kSampleDelay) !== 1)
      return chip.complain('flash: its data are sampled too early for this clock');
    const {peripherals} = chip.emulator, pad = (number) => peripherals[0x40020].readUint32(4 + 4 * number);
    if ((pad(0) & 1) === 0) chip.complain('flash: the clock\'s pad is not fast');
    if ([1, 2, 3, 4].some((data) => (pad(data) & 2) !== 0)) chip.complain('flash: a data pad has a Schmitt trigger');
  }
}

/**
 * Returns what is to be called where the program begins: it complains of a flash that cannot be read. `allowed`: whether
 * four lines are, which they are not in a flash that comes from its maker.
 */
export function replaceFlashInterface(chip, allowed) {
  const model = new FlashInterface(chip, new Flash(allowed));
  chip.emulator.peripherals[0x18000] = model;
  return () => model.check();
}
