// Whether the functions of a program that are in RAM are those that the linker script for hot code lists.
//   node hot_code.mjs NEEDED ELF    it has functions of NEEDED entries of the list, at least
// Exit status: 0 yes, 1 no.
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {readElf} from './elf.mjs';

const kScript = '../../firmware/boards/cortex_m/hot_in_ram/sections.ld';
const kRam = 0x20000000, kRamEnd = 0x20082000;

/** Of the script's input sections .text.NAME, as tests of a function's mangled name. */
function listed() {
  const script = readFileSync(join(dirname(fileURLToPath(import.meta.url)), kScript), 'utf8');
  return [...script.matchAll(/\.text\.([\w*]+)/g)].map(([, pattern]) => ({
    pattern,
    fits: new RegExp(`^${pattern.replaceAll('*', '.*')}$`),
  }));
}

/** What is wrong with where the functions of an ELF file are. */
function wrongPlaces(elf, needed) {
  const functions = [...readElf(elf).functions].filter(([name]) => !/_veneer$|\.cold/.test(name));
  const inRam = ([, {begin}]) => begin >= kRam && begin < kRamEnd;
  const patterns = listed(), fits = ([name]) => patterns.some((one) => one.fits.test(name));
  const found = patterns.filter((one) => functions.some(([name]) => one.fits.test(name)));
  const wrong = functions.filter((one) => inRam(one) !== fits(one))
      .map(([name, {begin}]) => `${elf}: ${name} is at ${begin.toString(16)}`);
  if (found.length < needed) wrong.push(`${elf}: only functions of ${found.map(({pattern}) => pattern).join()}`);
  return wrong;
}

const [needed, elf] = process.argv.slice(2), wrong = wrongPlaces(elf, Number(needed));
for (const line of wrong) console.log(line);
process.exitCode = wrong.length === 0 ? 0 : 1;
