// The benchmark's board, firmware/boards/mps2, with the emulator's Cortex-M0+ instead of QEMU's processor: for cycles,
// which QEMU has not. Its code lies as at the beginning of a Pico's flash, behind a cache like a Pico's.
import {execute} from './cycles.mjs';
import {FlashCache} from './flash_cache.mjs';

const kMemoryBytes = 4 << 20, kRam = 0x20000000;
const kTimer = 0x40000000, kTimerValue = kTimer + 4, kTimerReload = kTimer + 8, kInstructionsPerTick = 40;
const kUart = 0x40004000, kUartState = kUart + 4, kUartControl = kUart + 8, kUartBaud = kUart + 16;
const kSemihosting = 0xab, kGetCommandLine = 0x15, kExitExtended = 0x20;

export class Mps2 {
  console = '';
  status;              // of the exit
  instructions = 0;    // all of them
  /** Of what is counted: between the functions that the benchmark draws between, as `zstrip bench --board` does. */
  counted = {instructions: 0, cycles: 0, misses: 0};
  #cache = new FlashCache();
  #counting = false;

  /** `program`: of readElf(); `words`: its command line. */
  constructor(library, {segments, functions}, words) {
    this.emulator = new library.RP2040();
    const {core} = this.emulator;
    this.words = words;
    const memories = [new DataView(new ArrayBuffer(kMemoryBytes)), new DataView(new ArrayBuffer(kMemoryBytes))];
    for (const {loadedAt, bytes} of segments) new Uint8Array(memories[0].buffer).set(bytes, loadedAt);
    for (const size of [8, 16, 32]) {
      const get = DataView.prototype[`getUint${size}`], set = DataView.prototype[`setUint${size}`];
      core[`readUint${size}`] = (address) => {
        address >>>= 0;
        if (address >= kTimer) return this.#readDevice(address);
        if (address >= kRam) return get.call(memories[1], address - kRam, true);
        if (this.#counting) this.#cache.read(address);
        return get.call(memories[0], address, true);
      };
      core[`writeUint${size}`] = (address, value) => {
        address >>>= 0;
        if (address >= kTimer) return this.#writeDevice(address, value);
        if (address < kRam) throw new Error(`a write to ${address.toString(16)}`);
        set.call(memories[1], address - kRam, value, true);
      };
    }
    this.emulator.onBreak = (number) => this.#callHost(number);
    const refuse = (name, what) => { throw new Error(`${name}: ${what}`); };
    this.emulator.logger = {debug() {}, info() {}, warn: refuse, error: refuse};
    const counter = (name) => functions.get(`_ZN6zstrip5board18InstructionCounter${name}`);
    [this.resume, this.pause] = [counter('6resumeEv'), counter('5pauseEv')];
    core.SP = core.readUint32(0);
    core.PC = core.readUint32(4) & ~1;
  }

  /** To its exit. */
  run() {
    const {emulator: {core}, resume, pause, counted} = this;
    while (this.status === undefined) {
      const {PC} = core, resumes = PC >= resume.begin && PC < resume.end;
      if (resumes || PC >= pause.begin && PC < pause.end) this.#counting = false;
      const cycles = execute(core);
      ++this.instructions;
      if (this.#counting) {
        ++counted.instructions;
        counted.cycles += cycles;
      } else if (resumes) {
        this.#counting = true;
      }
    }
    counted.misses = this.#cache.misses;
  }

  #readDevice(address) {
    if (address === kTimerValue) return 0xffffffff - Math.floor(this.instructions / kInstructionsPerTick);
    if (address === kUartState) return 0;
    throw new Error(`a read of ${address.toString(16)}`);
  }
  #writeDevice(address, value) {
    if (address === kUart) this.console += String.fromCharCode(value);
    else if (![kTimer, kTimerValue, kTimerReload, kUartControl, kUartBaud].includes(address))
      throw new Error(`a write to ${address.toString(16)}`);
  }

  #callHost(number) {
    const {core} = this.emulator, {registers} = core, block = registers[1];
    if (number !== kSemihosting) throw new Error(`a breakpoint ${number}`);
    if (registers[0] === kExitExtended) {
      this.status = core.readUint32(block + 4);
    } else if (registers[0] === kGetCommandLine) {
      const text = core.readUint32(block);
      [...this.words, '\0'].forEach((character, index) => core.writeUint8(text + index, character.charCodeAt(0)));
      core.writeUint32(block + 4, this.words.length);
      registers[0] = 0;
    } else {
      throw new Error(`a call of the host, ${registers[0]}`);
    }
  }
}
