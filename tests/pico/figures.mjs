// What frames take on the running Pico: cycles of the processor, those of them that it waits for the panel, misses of
// a cache like the chip's, and the stack.
const kDmaControl = 0x5000000c, kSpiStatus = 0x4003c00c, kPollCycles = 40;
const kPaint = 0xdeadbeef;  // firmware/boards/cortex_m/stack.hpp
const kSets = 1024;         // 2.6.3: 16 KB, two ways, 8 bytes a line

/** Counts from now on what the program of `chip` does; the emulator counts cycles as if its flash never waited. */
export class Counters {
  constructor({emulator}) {
    const {core} = emulator;
    this.core = core;
    this.waited = this.misses = 0;
    let poll = -Infinity;
    const lines = new Int32Array(2 * kSets).fill(-1), last = new Uint8Array(kSets);  // the way that was used
    const flash = (address) => {
      if (address >>> 24 !== 0x10) return;
      const line = (address & 0xffffff) >>> 3, set = line % kSets;
      const way = lines[2 * set] === line ? 0 : lines[2 * set + 1] === line ? 1 : 1 - last[set];
      last[set] = way;
      if (lines[2 * set + way] === line) return;
      lines[2 * set + way] = line;
      ++this.misses;
    };
    for (const name of ['readUint8', 'readUint16', 'readUint32']) {
      const read = core[name].bind(core);
      core[name] = (address) => {
        flash(address >>> 0);
        if (address >>> 0 === kDmaControl || address >>> 0 === kSpiStatus) {
          if (core.cycles - poll < kPollCycles) this.waited += core.cycles - poll;
          poll = core.cycles;
        }
        return read(address);
      };
    }
  }
  now() { return [this.core.cycles, this.waited, this.misses]; }
}

/** Bytes between the top of the stack and the deepest word that was ever written. */
export function stackBytes({emulator}, top) {
  let bottom = 0;
  while (4 * bottom < top && emulator.sramView.getUint32(4 * bottom, true) === kPaint) ++bottom;
  return top - 4 * bottom;
}
