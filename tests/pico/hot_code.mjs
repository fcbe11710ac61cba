// Whether the functions of a program that are in RAM are those that the linker script for hot code lists, and whether
// the program has functions of every entry of the list: one that is renamed would silently leave the RAM.
//   node hot_code.mjs THUMB ELF    THUMB: Thumb-1 or Thumb-2, of the program's processor
// An entry with the mark of the other one in the script must have no function. Other compilers than that of the figures
// may inline some: then most entries must have one. Exit status: 0 yes, 1 no, 2 wrong words.
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {readElf} from './elf.mjs';

const kHere = dirname(fileURLToPath(import.meta.url));
const kScript = join(kHere, '../../firmware/boards/cortex_m/hot_in_ram/sections.ld');
const kFigures = join(kHere, '../../docs/measured/pico.csv');
const kMarks = ['Thumb-1', 'Thumb-2'];
const kRam = 0x20000000, kRamEnd = 0x20082000;
const kMost = 0.75;

/** Of the script's input sections .text.NAME, as tests of a function's mangled name, and its mark. */
export function entriesOf(script) {
  return [...script.matchAll(/\*\(\.text\.([\w*]+)\)(?: \/\* (\S+) \*\/)?$/gm)].map(([, pattern, mark]) => ({
    pattern,
    mark,
    fits: new RegExp(`^${pattern.replaceAll('*', '.*')}$`),
  }));
}

/** What is wrong with the entries of a script for a program with these functions, and with where those are. */
export function complaintsOf(script, functions, thumb, inlines) {
  const entries = entriesOf(script), wrong = [];
  const count = script.match(/\*\(/g).length;
  if (entries.length !== count) wrong.push(`the script has ${count} entries, of which ${entries.length} can be read`);
  const own = [...functions].filter(([name]) => !/_veneer$|\.cold/.test(name));
  const has = ({fits}) => own.some(([name]) => fits.test(name));
  const missing = [];
  for (const entry of entries) {
    if (entry.mark && !kMarks.includes(entry.mark)) wrong.push(`unknown mark ${entry.mark}`);
    if (entry.mark && entry.mark !== thumb) {
      if (has(entry)) wrong.push(`${entry.pattern} is marked ${entry.mark}, and has functions on ${thumb}`);
    } else if (!has(entry)) {
      missing.push(entry.pattern);
    }
  }
  if (!inlines || missing.length > (1 - kMost) * entries.length)
    wrong.push(...missing.map((pattern) => `no function of ${pattern}`));
  const inRam = ({begin}) => begin >= kRam && begin < kRamEnd;
  for (const [name, place] of own) {
    const listed = entries.some(({fits}) => fits.test(name));
    if (inRam(place) !== listed) wrong.push(`${name} is at ${place.begin.toString(16)}`);
  }
  return wrong;
}

/** Whether the program is of another compiler than the figures. */
function isOfAnotherCompiler(elf) {
  const [, version] = /compiled by \S+ ([\d.]+)/.exec(readFileSync(kFigures, 'utf8'));
  return !readFileSync(elf, 'latin1').match(/GCC: \([^)]*\) [\d.]+/g)?.some((one) => one.endsWith(` ${version}`));
}

function main([thumb, elf, ...more]) {
  if (!kMarks.includes(thumb) || !elf || more.length > 0) {
    console.error('hot_code.mjs: wrong words; its first lines say which there are');
    return 2;
  }
  const wrong = complaintsOf(readFileSync(kScript, 'utf8'), readElf(elf).functions, thumb, isOfAnotherCompiler(elf));
  for (const line of wrong) console.log(`${elf}: ${line}`);
  return wrong.length === 0 ? 0 : 1;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) process.exitCode = main(process.argv.slice(2));
