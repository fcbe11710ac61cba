// The Pico 2's firmware in rp2350js, an emulator of its chip, from the boot ROM on; of programs whose names have _riscv_ on
// its RISC-V processors.
//   node pico2.mjs frames EMULATOR UF2 PANEL                  frames of the teapot are those of the host
//   node pico2.mjs mutations EMULATOR UF2 PANEL               each mistake is found
//   node pico2.mjs baked EMULATOR UF2 PANEL ZSTRIP WORK SCENE...   the player shows what the command bakes and draws
// EMULATOR is its folder, built, or empty; PANEL the program of tests/pico/panel.cpp. Exit status: 0 yes, 1 no, 2 wrong
// words, 77 there is no emulator.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, join, resolve} from 'node:path';

import {Board} from '../pico/board.mjs';
import {kFrameBytes, shownOn, verdict, wrongWhenBaked} from '../pico/checks.mjs';
import {mutationOf} from '../pico/mutations.mjs';
import {flashOf} from '../pico/uf2.mjs';

import {Chip} from './chip.mjs';
import {kMutations} from './mutations.mjs';

/** Eight frames, with ZSTRIP_LONG a whole turn. */
function frames({library, flash, panel, options}) {
  const count = process.env.ZSTRIP_LONG ? 64 : 8;
  const board = new Board(library, flash, kFrameBytes, options), {chip} = board;
  board.onFrame = (frame) => { if (frame === count) chip.end('frames'); };
  chip.endIn(1 + count, 'time');
  chip.run();
  const shown = shownOn(panel, board), wrong = [...chip.complaints];
  if (shown.pop() !== `${count + 1} pictures`) wrong.push(`not ${count} frames: ended by ${chip.ended}`);
  if (board.console !== '') wrong.push(`the console says ${board.console}`);
  console.log(`${count} frames`);
  return verdict([...wrong, ...shown]);
}

/** What is said of the first frame. */
function saidOfAFrame({library, flash, panel, options}, mutate) {
  const board = new Board(library, flash, kFrameBytes, {...options, mutate}), {chip} = board;
  board.onFrame = (frame) => { if (frame === 1) chip.end('frame'); };
  chip.endIn(0.7, 'time');
  chip.run();
  if (chip.complaints.length > 0) return chip.complaints;
  const shown = shownOn(panel, board);
  return shown.pop() === '2 pictures' ? shown : [...shown, `no frame: ended by ${chip.ended}`];
}

function mutations(given) {
  const wrong = [];
  const mistakes = kMutations[given.options.processors];
  for (const mutation of mistakes) {
    const flash = given.flash.slice();
    mutation.flash?.(flash);
    const said = saidOfAFrame({...given, flash}, mutationOf(mutation));
    if (!said.some((line) => line.includes(mutation.says)))
      wrong.push(`not found: ${mutation.says}; said: ${said.join('; ') || 'nothing'}`);
  }
  console.log(`${mistakes.length} mutations`);
  return verdict(wrong);
}

function baked(given) {
  const board = basename(given.uf2, '.uf2').endsWith('_hot') ? 'pico2_hot' : 'pico2';
  return verdict(given.scenes.flatMap((scene) =>
    wrongWhenBaked({...given, bakeFor: ['--board', board]}, scene).map((line) => `${scene}: ${line}`)));
}

function main([command, folder, uf2, panel, ...words]) {
  const run = {frames, mutations, baked}[command];
  if (!run || !panel || (command === 'baked' ? words.length < 3 : words.length > 0)) {
    console.error('pico2.mjs: wrong words; its first lines say which there are');
    return 2;
  }
  if (folder === '') {
    console.log('skipped: no emulator is given: -DZSTRIP_RP2350JS=FOLDER of CMake');
    return 77;
  }
  const file = join(resolve(folder), 'dist', 'cjs', 'rp2350.js');
  if (!existsSync(file)) {
    console.log(`skipped: there is no ${file}: build the emulator first, as its README says`);
    return 77;
  }
  const [zstrip, work, ...scenes] = words;
  const library = createRequire(import.meta.url)(file);
  const name = basename(uf2, '.uf2'), options = {Chip, processors: name.includes('_riscv_') ? 'riscv' : 'arm'};
  return run({library, uf2, panel, zstrip, scenes, options, flash: flashOf(uf2), folder: work && join(work, name)});
}

process.exitCode = main(process.argv.slice(2));
