// The RP2040's cache of its flash, 2.6.3: 16 KB, two ways, 8 bytes a line; of a set the line goes that was not used
// last.
const kSets = 1024;

export class FlashCache {
  misses = 0;
  #lines = new Int32Array(2 * kSets).fill(-1);
  #last = new Uint8Array(kSets);  // the way that was used

  /** A read of this address, counted from the flash's beginning. */
  read(address) {
    const line = address >>> 3, set = line % kSets, lines = this.#lines;
    const way = lines[2 * set] === line ? 0 : lines[2 * set + 1] === line ? 1 : 1 - this.#last[set];
    this.#last[set] = way;
    if (lines[2 * set + way] === line) return;
    lines[2 * set + way] = line;
    ++this.misses;
  }
}
