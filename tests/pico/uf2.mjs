// The flash as a .uf2 file fills it: blocks of 512 bytes, 256 of them for the flash.
import {readFileSync} from 'node:fs';

const kFlash = 0x10000000, kMagic = [0x0a324655, 0x9e5d5157], kEnd = 0x0ab16f30, kRp2040 = 0xe48bff56;

/** The bytes from the flash's beginning. */
export function flashOf(file) {
  const blocks = readFileSync(file);
  const view = new DataView(blocks.buffer, blocks.byteOffset, blocks.length);
  const flash = new Uint8Array(blocks.length / 2).fill(0xff);
  for (let at = 0; at < blocks.length; at += 512) {
    const word = (offset) => view.getUint32(at + offset, true);
    if (word(0) !== kMagic[0] || word(4) !== kMagic[1] || word(508) !== kEnd || word(28) !== kRp2040)
      throw new Error(`${file}: no block for an RP2040 at byte ${at}`);
    flash.set(blocks.subarray(at + 32, at + 32 + word(16)), word(12) - kFlash);
  }
  return flash;
}
