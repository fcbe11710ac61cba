// An RP2350 in rp2350js, with the interface of tests/pico/chip.mjs. What the emulator gets wrong is corrected here, each
// trap where it stands; its own files stay as they are.
import {replaceSystick} from '../pico/systick.mjs';

import {execute} from './corrections.mjs';

const kUndefined = 0xa5;  // what RAM holds at power-on is not defined
const kFlash = 0x10000000, kRam = 0x20000000, kMaxBootSteps = 200000;
const kCrystal = 12e6;
const kSystemControl = 0x3c, kReferenceControl = 0x30;  // of the clocks, 8.1
const kSystemControlSpace = 0xe000, kPage = 0xfff;      // of the private peripheral bus
const kInterruptControl = 0xd04;                        // has the pending tick of the frame clock
const kCompare = 0x1b8;                                 // of the platform timer in the SIO, 3.1.8
const kInterruptEnable = 0x304, kTimerInterrupt = 1 << 7;  // a control register of RISC-V

/** Waits of the second core take the emulator as long as work: none is executed until the first one wakes it. */
const sleeps = (core) => core.waiting && !core.eventRegistered;

export class Chip {
  /**
   * `library`: of rp2350js. `flash`: its bytes from the beginning. `processors`: 'arm' or 'riscv'. `mutate(bus)`: changes
   * what is read and written.
   */
  constructor(library, flash, {processors = 'arm', mutate} = {}) {
    this.complaints = [];
    this.ended = '';
    const rp2350 = this.rp2350 = new library.RP2350({coreArch: processors});
    const {clock} = rp2350, [core] = rp2350.core;
    this.complain = (what) => {
      this.complaints.push(`${what} (${(clock.nanos / 1e6).toFixed(3)} ms, pc ${(core.PC >>> 0).toString(16)})`);
      this.ended ||= 'complaint';
    };
    // The boot ROM touches much that the emulator does not have; it answers with ones, as to a program's own registers
    // that only say "ready".
    rp2350.logger = {debug() {}, info() {}, warn() {}, error: (name, what) => this.complain(`${name}: ${what}`)};
    rp2350.flash.set(flash);
    rp2350.sram.fill(kUndefined);
    rp2350.clkSys = rp2350.clkPeri = kCrystal;  // about that of the ring oscillator
    this.followClocks();
    this.rules = {spi: this.spiRules()};
    this.watchdog.timer.frequency = 1e6;  // 12.9: a tick; the emulator has that of the RP2040, twice a tick
    this.emulator = {clock, gpio: rp2350.gpio, spi: rp2350.spi, uart: rp2350.uart};
    if (processors === 'arm') this.correctSystick();
    else this.addMachineTimer();
    mutate?.(rp2350);
  }

  /** The emulator runs at one frequency; here it is that of the registers, 8.1 and 8.6. */
  followClocks() {
    const {rp2350} = this, clocks = rp2350.peripherals[0x40010], pll = rp2350.peripherals[0x40050];
    const write = clocks.writeUint32.bind(clocks);
    clocks.writeUint32 = (offset, value) => {
      write(offset, value);
      if (offset !== kSystemControl && offset !== kReferenceControl) return;
      const fromPll = (clocks.sysCtrl & 1) !== 0 && (clocks.sysCtrl >>> 5 & 7) === 0;
      rp2350.clkSys = rp2350.clkPeri = fromPll ? pll.foutpostdiv : kCrystal;
      if (rp2350.clkSys > 150e6) this.complain(`clocks: the system runs at ${rp2350.clkSys / 1e6} MHz`);
    };
  }

  /** The emulator has SysTick's registers 0x10 bytes too high, and SysTick as in tests/pico/systick.mjs. */
  correctSystick() {
    const {rp2350} = this, {ppb} = rp2350, [core] = rp2350.core, [state] = ppb.coreState;
    const read = ppb.readUint32ViaCore.bind(ppb), write = ppb.writeUint32ViaCore.bind(ppb);
    const space = {
      systickTimer: state.systickTimer,
      readUint32: (offset) => read(kSystemControlSpace | offset, 0),
      writeUint32: (offset, value) => write(kSystemControlSpace | offset, value, 0),
    };
    const isSpace = (offset, number) => number === 0 && (offset & ~kPage) === kSystemControlSpace;
    ppb.readUint32ViaCore = (offset, number) =>
        isSpace(offset, number) ? space.readUint32(offset & kPage) : read(offset, number);
    ppb.writeUint32ViaCore = (offset, value, number) =>
        isSpace(offset, number) ? space.writeUint32(offset & kPage, value) : write(offset, value, number);
    Object.assign(this.emulator, {
      ppb: space,
      core: {
        set pendingSystick(value) { state.pendingSystick = value; },
        set interruptsUpdated(value) { core.interruptsUpdated = value; },
      },
    });
    Object.defineProperty(this.emulator, 'clkSys', {get: () => rp2350.clkSys});
    replaceSystick(this.emulator, this.complain);
    this.execute = () => execute(core, rp2350);
    this.isWoken = () => state.pendingSystick;
    this.onWaiting = (then) => {
      const readSpace = space.readUint32;
      space.readUint32 = (offset) => {
        if (offset === kInterruptControl) then();
        return readSpace(offset);
      };
    };
  }

  /** The emulator's platform timer ends no WFI. A program waits for a frame's end by setting the compare register. */
  addMachineTimer() {
    const {sio, core: [core]} = this.rp2350, write = sio.writeUint32.bind(sio);
    let compare = 0, then = () => {};
    sio.writeUint32 = (offset, value, number) => {
      write(offset, value, number);
      if (offset !== kCompare || number !== 0) return;
      compare = value >>> 0;
      then();
    };
    this.execute = () => core.executeInstruction();
    this.isWoken = () => (core.csrs[kInterruptEnable] & kTimerInterrupt) !== 0 && sio.mtimeTimer.counter >= compare;
    this.onWaiting = (wanted) => { then = wanted; };
  }

  /** 12.3: an SPI that sends 8 bits in mode 0, as master; switching it off empties it. */
  spiRules() {
    const {rp2350: {spi: [spi]}, complain} = this, write = spi.writeUint32.bind(spi);
    const rules = {
      onOff() {},
      checkSend() {
        if (!spi.enabled) complain('spi0: it is off');
        if ((spi.control0 & 0xff) !== 7) complain('spi0: not 8 bits in mode 0');
        if (spi.clockDivisor < 2) complain('spi0: its prescaler is 0');
      },
      busy: () => spi.busy || !spi.txFIFO.empty,
    };
    spi.writeUint32 = (offset, value) => {
      if (offset === 0x4 && (value & 2) === 0) {
        [spi.txFIFO, spi.rxFIFO].forEach((fifo) => fifo.reset());
        spi.busy = false;
        rules.onOff();
      }
      if (offset === 0x8 && spi.txFIFO.full) complain('spi0: a byte is written into a full FIFO');
      write(offset, value);
    };
    return rules;
  }

  get nanos() { return this.rp2350.clock.nanos; }
  get watchdog() { return this.rp2350.watchdog; }

  /** Calls end() of `why` after this time. */
  endIn(seconds, why) { this.rp2350.clock.createAlarm(() => this.end(why)).schedule(seconds * 1e9); }
  end(why) { this.ended ||= why; }

  /** Runs the boot ROM to its end, where the program in the flash begins. */
  boot() {
    const [core] = this.rp2350.core;
    let steps = 0;
    this.attempt(() => { while ((core.PC < kFlash || core.PC >= kRam) && ++steps < kMaxBootSteps) this.step(); });
    if (core.PC < kFlash || core.PC >= kRam) this.complain('boot: the ROM does not start the program in the flash');
  }

  /** What the emulator cannot execute ends the run. */
  attempt(run) {
    try {
      run();
    } catch (error) {
      this.complain(`the emulator: ${error.message}`);
    }
  }

  step() {
    const {rp2350} = this, [core, other] = rp2350.core;
    rp2350.currentCore = 0;
    const cycles = this.execute();
    if (sleeps(other)) {
      other.cycles = core.cycles;
    } else {
      rp2350.currentCore = 1;
      while (other.cycles < core.cycles && !sleeps(other)) other.executeInstruction();
      rp2350.currentCore = 0;
    }
    rp2350.clock.tick(cycles * 1e9 / rp2350.clkSys);
  }

  /**
   * Runs until it is ended. With interrupts masked, too, one that is pending ends WFI: the emulator sleeps on. Of a loop
   * of nothing but WFI the time passes at once.
   */
  run() {
    const {clock, core: [core]} = this.rp2350;
    let at = 0, cycles = 0;  // of the last WFI
    this.attempt(() => {
      while (!this.ended) {
        if (!core.waiting) {
          this.step();
        } else if (this.isWoken()) {
          core.waiting = false;
          if (core.PC === at && core.cycles - cycles <= 4) clock.tick(clock.nanosToNextAlarm);
          [at, cycles] = [core.PC, core.cycles];
        } else {
          clock.tick(clock.nanosToNextAlarm);
        }
      }
    });
  }
}
