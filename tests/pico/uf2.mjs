// The flash of a Pico or a Pico 2 as .uf2 files fill it, one after the other: blocks of 512 bytes, 256 of them for the
// flash.
import {readFileSync} from 'node:fs';

const kFlash = 0x10000000, kSector = 4096;
const kMagic = [0x0a324655, 0x9e5d5157], kEnd = 0x0ab16f30, kFamily = 28;
/** The bytes of a board's flash, by the family of its blocks: RP2040, RP2350 for Arm and for RISC-V. */
const kFlashBytes = new Map([[0xe48bff56, 2 << 20], [0xe48bff59, 4 << 20], [0xe48bff5a, 4 << 20]]);

/** All of its bytes; what no file fills is as a new part has it. */
export function flashOf(...files) {
  const family = readFileSync(files[0]).readUInt32LE(kFamily);
  const flash = new Uint8Array(kFlashBytes.get(family) ?? 0).fill(0xff);
  for (const file of files) {
    const blocks = readFileSync(file), count = blocks.length / 512;
    const view = new DataView(blocks.buffer, blocks.byteOffset, blocks.length);
    const erased = new Set();
    for (let number = 0; number < count; ++number) {
      const at = 512 * number, word = (offset) => view.getUint32(at + offset, true);
      if (word(0) !== kMagic[0] || word(4) !== kMagic[1] || word(508) !== kEnd || word(kFamily) !== family ||
          word(20) !== number || word(24) !== count)
        throw new Error(`${file}: no block for this board at byte ${at}`);
      const to = word(12) - kFlash, sector = Math.floor(to / kSector);
      // Which sector a block begins is found out from its number alone (erratum RP2040-E14).
      if (number % 16 === 0 && to % kSector !== 0) throw new Error(`${file}: block ${number} begins no sector`);
      if (!erased.has(sector)) flash.fill(0xff, sector * kSector, (sector + 1) * kSector);
      erased.add(sector);
      flash.set(blocks.subarray(at + 32, at + 32 + word(16)), to);
    }
  }
  return flash;
}
