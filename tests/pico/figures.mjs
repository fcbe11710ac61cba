// What frames take on the running Pico: cycles of the processor, those of them that it waits for the panel, misses of
// a cache like the chip's, and the stack.
import {FlashCache} from './flash_cache.mjs';

const kDmaControl = 0x5000000c, kSpiStatus = 0x4003c00c, kPollCycles = 40;
const kPaint = 0xdeadbeef;  // firmware/boards/cortex_m/stack.hpp

/** Counts from now on what the program of `chip` does; the emulator counts cycles as if its flash never waited. */
export class Counters {
  constructor({emulator}) {
    const {core} = emulator;
    this.core = core;
    this.cache = new FlashCache();
    this.waited = 0;
    let poll = -Infinity;
    for (const name of ['readUint8', 'readUint16', 'readUint32']) {
      const read = core[name].bind(core);
      core[name] = (address) => {
        if (address >>> 24 === 0x10) this.cache.read(address & 0xffffff);
        if (address >>> 0 === kDmaControl || address >>> 0 === kSpiStatus) {
          if (core.cycles - poll < kPollCycles) this.waited += core.cycles - poll;
          poll = core.cycles;
        }
        return read(address);
      };
    }
  }
  now() { return [this.core.cycles, this.waited, this.cache.misses]; }
}

/** Bytes between the top of the stack and the deepest word that was ever written. */
export function stackBytes({emulator}, top) {
  let bottom = 0;
  while (4 * bottom < top && emulator.sramView.getUint32(4 * bottom, true) === kPaint) ++bottom;
  return top - 4 * bottom;
}
