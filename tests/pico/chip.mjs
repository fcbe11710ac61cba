// An RP2040 in rp2040js, as strict as the chip where the emulator is not: what the chip would not take is a complaint,
// and ends the run. Traps of the emulator that are corrected here stand where they are.
import {boot} from './boot_rom.mjs';
import {execute} from './cycles.mjs';
import {replaceFlashInterface} from './flash_interface.mjs';
import {addRules} from './rules.mjs';
import {replaceSystick} from './systick.mjs';

const kInterruptControl = 0xd04;  // of the private peripheral bus: has the pending tick of the frame clock
const kUndefined = 0xa5;  // what RAM holds at power-on is not defined

export class Chip {
  /**
   * `library`: of rp2040js. `flash`: its bytes from the beginning. `memory`: of RAM, as a reset leaves it.
   * `mutate(core)`: changes what the program reads and writes.
   */
  constructor(library, flash, {memory, mutate} = {}) {
    this.complaints = [];
    this.places = [];  // of the checks that complained, each a file and line
    this.ended = '';  // why
    this.emulator = new library.RP2040();
    const {emulator} = this, {core, clock} = emulator;
    this.complain = (what) => {
      this.complaints.push(`${what} (${(clock.nanos / 1e6).toFixed(3)} ms, pc ${(core.PC >>> 0).toString(16)})`);
      this.places.push(/\(?([^(\s]+:\d+):\d+\)?$/.exec(new Error().stack.split('\n')[2])[1]);
      this.ended ||= 'complaint';
    };
    const complainOf = (name, what) => this.complain(`${name}: ${what}`);
    emulator.logger = {debug() {}, info() {}, warn: complainOf, error: complainOf};
    emulator.flash.set(flash);
    if (memory) emulator.sram.set(memory);
    else emulator.sram.fill(kUndefined);
    for (const pin of emulator.gpio) pin.padValue = 0x56;  // 2.19.6.3
    this.rules = addRules(this, memory !== undefined);
    replaceSystick(emulator, this.complain);
    this.checkFlashInterface = replaceFlashInterface(this, memory !== undefined);
    const write = core.writeUint32.bind(core);
    core.writeUint32 = (address, value) => {
      if (address >>> 0 < 0x18000000) this.complain(`flash: a write to ${(address >>> 0).toString(16)}`);
      write(address, value);
    };
    mutate?.(core);
    emulator.updateClocks();
  }

  get nanos() { return this.emulator.clock.nanos; }
  get watchdog() { return this.emulator.peripherals[0x40058]; }
  boot() { boot(this); }

  /** Calls `then` where the program looks whether its frame clock has ticked. */
  onWaiting(then) {
    const {ppb} = this.emulator, read = ppb.readUint32;
    ppb.readUint32 = (offset) => {
      if (offset === kInterruptControl) then();
      return read(offset);
    };
  }

  /** Calls end() of `why` after this time. */
  endIn(seconds, why) { this.emulator.clock.createAlarm(() => this.end(why)).schedule(seconds * 1e9); }
  end(why) { this.ended ||= why; }

  step() {
    const {emulator} = this;
    emulator.clock.tick(execute(emulator.core) * 1e9 / emulator.clkSys);
  }

  /**
   * Until it is ended. With interrupts masked, too, one that is pending ends WFI: the emulator sleeps on. A loop of
   * nothing but WFI then spins; its time passes at once.
   */
  run() {
    const {clock, core} = this.emulator;
    let at = 0, cycles = 0;  // of the last WFI
    while (!this.ended) {
      if (!core.waiting) {
        this.step();
      } else if (core.pendingSystick || (core.pendingInterrupts & core.enabledInterrupts) !== 0) {
        core.waiting = false;
        if (core.PC === at && core.cycles - cycles <= 4) clock.tick(clock.nanosToNextAlarm);
        [at, cycles] = [core.PC, core.cycles];
      } else {
        clock.tick(clock.nanosToNextAlarm);
      }
    }
  }
}
