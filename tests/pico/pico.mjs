// The Pico's firmware in an emulator of its chip.
//   node pico.mjs fetch WORK                        the emulator, into the folder WORK
//   node pico.mjs frames WORK UF2 PANEL             frames of the teapot are those of the host
//   node pico.mjs mutations WORK UF2 PANEL          each mistake is found, and each check finds one
//   node pico.mjs figures WORK UF2                  a line of docs/measured/pico.csv
//   node pico.mjs stuck WORK UF2 PANEL              a bus that gets stuck ends in a panic and a reset
// PANEL is the program of panel.cpp. Exit status: 0 yes, 1 no, 2 wrong words, 77 something is not to be had here.
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, rmSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {fetchPackage, skip, skipMissing} from '../npm_package.mjs';

import {Board} from './board.mjs';
import {crc} from './boot_rom.mjs';
import {Counters, stackBytes} from './figures.mjs';
import {kMutations, kStuckMutations, mutationOf} from './mutations.mjs';
import {flashOf} from './uf2.mjs';

const kHere = dirname(fileURLToPath(import.meta.url));
const kFrameBytes = 240 * 240 * 2;

function fetchEmulator(work) {
  mkdirSync(work, {recursive: true});
  rmSync(join(work, 'missing'), {force: true});
  try {
    fetchPackage(kHere, work);
    return 0;
  } catch (error) {
    return skipMissing(error, work);
  }
}

/** What the panel's model says of the lines, each a string. */
function shownOn(panel, board, ...words) {
  const {status, stdout, stderr} = spawnSync(panel, words, {input: board.wire(), encoding: 'utf8'});
  if (status !== 0 && status !== 1) throw new Error(`${panel}: ${stderr}`);
  return stdout.trim().split('\n');
}

/** Prints what is wrong. */
function verdict(wrong) {
  for (const line of wrong) console.log(line);
  return wrong.length === 0 ? 0 : 1;
}

/** Two frames, with ZSTRIP_LONG a whole turn; and the glass switched on before. */
function frames({library, flash, panel, work}) {
  const count = process.env.ZSTRIP_LONG ? 64 : 2;
  const board = new Board(library, flash, kFrameBytes);
  board.onFrame = (frame) => { if (frame === count) board.chip.end('frames'); };
  board.chip.endIn(1 + count, 'time');
  board.chip.run();
  const pictures = join(work, 'pictures');
  mkdirSync(pictures, {recursive: true});
  const shown = shownOn(panel, board, '--pictures', pictures), wrong = [...board.chip.complaints];
  if (shown.pop() !== `${count + 1} pictures`) wrong.push(`not ${count} frames: ended by ${board.chip.ended}`);
  if (board.console !== '') wrong.push(`the console says ${board.console}`);
  return verdict([...wrong, ...shown]);
}

/** Where the sources complain, each "FILE:LINE". */
function placesOfChecks() {
  const places = [];
  for (const file of ['board.mjs', 'boot_rom.mjs', 'chip.mjs', 'rules.mjs', 'systick.mjs']) {
    readFileSync(join(kHere, file), 'utf8').split('\n').forEach((line, index) => {
      if (/complain\(['`]/.test(line)) places.push(`${file}:${index + 1}`);
    });
  }
  return places;
}

function mutations({library, flash, panel}) {
  const wrong = [], unproven = new Set(placesOfChecks());
  for (const mutation of kMutations) {
    const changed = flash.slice();
    mutation.flash?.(changed, crc);
    const board = new Board(library, changed, kFrameBytes, {mutate: mutationOf(mutation)});
    if (mutation.stuck) board.stick();
    board.onFrame = (frame) => { if (frame === 1) board.chip.end('frame'); };
    board.chip.endIn(0.7, 'time');
    board.chip.run();
    const said = board.chip.complaints.length > 0 ? board.chip.complaints : shownOn(panel, board).slice(0, -1);
    if (!said.some((line) => line.includes(mutation.says)))
      wrong.push(`not found: ${mutation.says}; said: ${said.join('; ') || 'nothing'}; ended by ${board.chip.ended}`);
    board.chip.places.forEach((place) => unproven.delete(basename(place)));
  }
  console.log(`${kMutations.length} mutations`);
  return verdict([...wrong, ...[...unproven].map((place) => `no mutation proves the check at ${place}`)]);
}

const kPanic = 'panic: display: the bus did not get ready in time';
const kStuck = {
  'until off': {said: `${kPanic}\n`, shown: ['--words', kPanic]},
  'for ever': {said: `${kPanic}\npanic on the display: the bus did not get ready in time\n`, shown: []},
};

/** What is wrong if the bus gets stuck while frame 1 is sent, until the program switches it off or for ever. */
function wrongWhenStuck({library, flash, panel}, how, mutation) {
  const {said, shown} = kStuck[how];
  const board = new Board(library, flash, kFrameBytes, {mutate: mutation && mutationOf(mutation)}), {chip} = board;
  board.onFrame = (frame) => { if (frame === 1) board.in(0.05, () => board.stick(how)); };
  chip.endIn(20, 'time');
  chip.run();
  const seconds = (chip.nanos - board.frames[1]) / 1e9;
  const wrong = [...chip.complaints, ...shownOn(panel, board, ...shown).slice(0, -1)];
  if (board.console !== said) wrong.push(`the console says ${board.console}`);
  if (chip.ended !== 'watchdog' || Math.abs(seconds - 8) > 0.1)
    wrong.push(`${chip.ended} after ${seconds} s, not the watchdog after 8`);
  if (wrong.length > 0) return wrong;
  // RAM and crystal are as they were.
  const again = new Board(library, flash, kFrameBytes, {memory: chip.emulator.sram});
  again.onFrame = (frame) => { if (frame === 1) again.chip.end('frame'); };
  again.chip.endIn(2, 'time');
  again.chip.run();
  const after = shownOn(panel, again);
  return after.join() === '2 pictures' ? [] : [`after the reset ${[...again.chip.complaints, ...after]}`];
}

function stuck(given) {
  const wrong = Object.keys(kStuck).flatMap((how) => wrongWhenStuck(given, how).map((line) => `${how}: ${line}`));
  for (const {how, says, ...mutation} of kStuckMutations) {
    const said = wrongWhenStuck(given, how, mutation);
    if (!said.some((line) => line.includes(says))) wrong.push(`not found: ${says}; said: ${said.join('; ')}`);
  }
  return verdict(wrong);
}

/** Prints them as a line of docs/measured/pico.csv: the mean of two frames, and the stack. */
function figures({library, flash}) {
  const kFrames = 2, kStackTop = new DataView(flash.buffer).getUint32(0x100, true) - 0x20000000;
  const board = new Board(library, flash, kFrameBytes), {chip} = board;
  const counters = new Counters(chip), reached = [];
  board.onFrame = (frame) => {
    reached.push(counters.now());
    if (frame === kFrames) chip.end('frames');
  };
  chip.endIn(1 + kFrames, 'time');
  chip.run();
  if (chip.ended !== 'frames') return verdict([`ended by ${chip.ended}`, ...chip.complaints]);
  const means = reached[0].map((first, column) => Math.round((reached[kFrames][column] - first) / kFrames));
  console.log(['pico_show', 'teapot', ...means, stackBytes(chip, kStackTop)].join());
  return 0;
}

async function main([command, work, ...words]) {
  if (command === 'fetch' && work && words.length === 0) return fetchEmulator(work);
  const run = {frames, mutations, stuck, figures}[command];
  if (!run || words.length !== (run === figures ? 1 : 2)) {
    console.error('pico.mjs: wrong words; its first lines say which there are');
    return 2;
  }
  if (existsSync(join(work, 'missing'))) return skip(work);
  const emulator = join(work, 'node_modules', 'rp2040js', 'dist', 'esm', 'index.js');
  const library = await import(pathToFileURL(emulator));
  return run({library, work, flash: flashOf(words[0]), panel: words[1]});
}

process.exitCode = await main(process.argv.slice(2));
