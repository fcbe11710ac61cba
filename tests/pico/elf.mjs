// A program for a 32-bit processor as its ELF file has it: what is loaded, and where its functions are. Format: Tool
// Interface Standard 1.2.
import {readFileSync} from 'node:fs';

const kLoad = 1, kSymbols = 2, kFunction = 2;

/**
 * `segments`: {address, loadedAt, bytes}. `functions`: of their mangled names, {begin, end}, without the bit of Thumb.
 */
export function readElf(file) {
  const all = readFileSync(file);
  if (all.readUInt32BE(0) !== 0x7f454c46 || all[4] !== 1 || all[5] !== 1)
    throw new Error(`${file}: no 32-bit ELF file`);
  const word = (at) => all.readUInt32LE(at), half = (at) => all.readUInt16LE(at);
  const records = (first, bytes, count) => Array.from({length: count}, (none, index) => first + index * bytes);

  const segments = records(word(28), half(42), half(44)).filter((at) => word(at) === kLoad && word(at + 16) > 0)
      .map((at) => ({
        address: word(at + 8),
        loadedAt: word(at + 12),
        bytes: all.subarray(word(at + 4), word(at + 4) + word(at + 16)),
      }));
  const sections = records(word(32), half(46), half(48)), functions = new Map();
  const table = sections.find((at) => word(at + 4) === kSymbols);
  const names = word(sections[word(table + 24)] + 16);
  for (const at of records(word(table + 16), 16, word(table + 20) / 16)) {
    if ((all[at + 12] & 15) !== kFunction) continue;
    const name = all.toString('latin1', names + word(at), all.indexOf(0, names + word(at)));
    const begin = word(at + 4) & ~1;
    functions.set(name, {begin, end: begin + word(at + 8)});
  }
  return {segments, functions};
}
