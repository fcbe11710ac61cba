// The Pico's firmware in an emulator of its chip.
//   node pico.mjs fetch WORK                        the emulator, into the folder WORK
//   node pico.mjs frames WORK UF2 PANEL             frames of the teapot are those of the host
//   node pico.mjs mutations WORK UF2 PANEL          each mistake is found, and each check finds one
//   node pico.mjs figures WORK UF2 [ZSTRIP SCENE]   a line of docs/measured/pico.csv; with the player of a scene
//   node pico.mjs stuck WORK UF2 PANEL              a bus that gets stuck ends in a panic and a reset
//   node pico.mjs baked WORK UF2 PANEL ZSTRIP SCENE...  the player shows what the command bakes and draws
//   node pico.mjs refused WORK UF2 PANEL ZSTRIP     what the player cannot show it says, and so does the command
//   node pico.mjs hot WORK UF2 HOT_UF2 ZSTRIP SCENE  with hot code in RAM the player misses the cache less often
//   node pico.mjs prediction WORK ELF ZSTRIP        cycles are those that `zstrip bench --board pico` predicts
// PANEL is the program of panel.cpp, ZSTRIP the command; UF2 has the teapot, or the player for baked scenes; ELF is the
// benchmark. Exit status: 0 yes, 1 no, 2 wrong words, 77 something is not to be had here.
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {fetchPackage, skip, skipMissing} from '../npm_package.mjs';

import {Board} from './board.mjs';
import {commandOf, kFrameBytes, shownOn, verdict, wrongWhenBaked} from './checks.mjs';
import {crc} from './boot_rom.mjs';
import {Counters, stackBytes} from './figures.mjs';
import {kMutations, kStuckMutations, mutationOf} from './mutations.mjs';
import {wrongPredictions} from './prediction.mjs';
import {flashOf} from './uf2.mjs';

const kHere = dirname(fileURLToPath(import.meta.url));
const kScene = 1 << 20;  // from the flash's beginning: docs/formats.md

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
  for (const file of ['board.mjs', 'boot_rom.mjs', 'chip.mjs', 'flash_interface.mjs', 'rules.mjs', 'systick.mjs']) {
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
  board.onFrame = (frame) => { if (frame === 1) board.in(0.02, () => board.stick(how)); };
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

/**
 * The mean of two frames of a program, and its stack: {cycles, waiting, misses, stack}; {wrong} where it does not get
 * so far. With `scene`, that is baked for it.
 */
function measured({library, uf2, folder, zstrip, scene}) {
  let flash = flashOf(uf2);
  if (scene) {
    const {run, file} = commandOf(zstrip, folder);
    run('bake', scene, '-o', 'both.uf2', '--samples', '1', '--no-edges', '--with', uf2);
    flash = flashOf(file('both.uf2'));
  }
  // Before its first frame the player opens the scene, and that frame is sent whole.
  const kFirst = 1, kFrames = kFirst + 2;
  const kStackTop = new DataView(flash.buffer).getUint32(0x100, true) - 0x20000000;
  const board = new Board(library, flash, kFrameBytes), {chip} = board;
  const counters = new Counters(chip), reached = [];
  board.onFrame = (frame) => {
    reached.push(counters.now());
    if (frame === kFrames) chip.end('frames');
  };
  chip.endIn(1 + kFrames, 'time');
  chip.run();
  if (chip.ended !== 'frames' || chip.complaints.length > 0)
    return {wrong: [`ended by ${chip.ended}`, ...chip.complaints]};
  const [cycles, waiting, misses] =
      reached[kFirst].map((first, column) => Math.round((reached[kFrames][column] - first) / 2));
  const stack = stackBytes(chip, kStackTop);
  // What is not seen is not measured: other registers, another address of the flash, another paint.
  const unseen = Object.entries({cycles, waiting, misses, stack}).filter(([, value]) => !(value > 0));
  if (stack === kStackTop) unseen.push(['the end of the stack']);
  if (unseen.length > 0) return {wrong: unseen.map(([what]) => `not seen: ${what}`)};
  return {cycles, waiting, misses, stack};
}

/** Prints them as a line of docs/measured/pico.csv. */
function figures(given) {
  const {wrong, cycles, waiting, misses, stack} = measured(given);
  if (wrong) return verdict(wrong);
  const name = basename(given.uf2, '.uf2').replace('zstrip_', '');
  const scene = given.scene ? basename(given.scene, '.toml') : 'teapot';
  console.log([name, scene, cycles, waiting, misses, stack].join());
  return 0;
}

/**
 * With hot code in RAM, HOT_UF2, a frame misses the flash's cache less often by a quarter, at least. How often it does
 * without is for the linker's placing to decide.
 */
function hot({hotUf2, ...given}) {
  const frames = [given, {...given, uf2: hotUf2}].map(measured), wrong = frames.flatMap((one) => one.wrong ?? []);
  if (wrong.length > 0) return verdict(wrong);
  const [usual, less] = frames.map(({misses}) => misses);
  console.log(`${usual} misses a frame, ${less} with hot code in RAM`);
  return 4 * less < 3 * usual ? 0 : 1;
}

function baked(given) {
  return verdict(given.scenes.flatMap((scene) => wrongWhenBaked(given, scene).map((line) => `${scene}: ${line}`)));
}

/** A scene blob as the flash behind the program has it; nothing for none. */
function wrongWhenRefused({library, flash, panel}, blob, says) {
  const filled = flash.slice();
  if (blob) filled.set(blob, kScene);
  const board = new Board(library, filled, kFrameBytes);
  board.chip.endIn(20, 'time');
  board.chip.run();
  const said = board.console.trimEnd();
  const shown = shownOn(panel, board, '--frame', '-', '--words', said).slice(0, -1), wrong = [...board.chip.complaints, ...shown];
  if (!says.test(said)) wrong.push(`the console says ${said}`);
  if (board.chip.ended !== 'watchdog') wrong.push(`ended by ${board.chip.ended}`);
  return wrong;
}

/** A scene that is too large for the player; the one with hot code in RAM has no room for one that the other shows. */
function largeFor(player, file) {
  if (player === 'zstrip_pico_player_hot') return 'random10k';
  // Tinted: colours in the mesh would take no memory.
  writeFileSync(file('large.toml'), 'model = [{ name = "all", built_in = "random10k" }]\n' +
      'material = [{ name = "red", colour = "#ff8080" }]\ninstance = [{ model = "all", material = "red" }]\n');
  return 'large.toml';
}

/** What is wrong if the command does not say, of itself, that the scene is too large for the player. */
function wrongWhenBakedWith({zstrip, uf2, folder}, player, scene) {
  const words = ['bake', scene, '-o', 'with.uf2', '--with', uf2];
  const {status, stderr} = spawnSync(zstrip, words, {cwd: folder, encoding: 'utf8'});
  return status === 5 && stderr.includes(`${player} has `) ? [] : [`zstrip bake ends with ${status}: ${stderr}`];
}

function refused(given) {
  const {run, file} = commandOf(given.zstrip, given.folder), player = basename(given.uf2, '.uf2');
  const option = player.endsWith('_hot') ? ' --board pico_hot' : '', large = largeFor(player, file);
  run('bake', 'cube', '-o', 'cube.zsc');
  run('bake', large, '-o', 'large.zsc');
  const damaged = readFileSync(file('cube.zsc'));
  damaged[damaged.length - 1] ^= 1;
  return verdict([
    ['no scene', undefined, new RegExp(
      '^panic: scene: no scene of version \\d+ at 10100000 in the flash\\. ' +
      `zstrip bake MODEL -o scene.uf2${option}, hold `)],
    ['damaged', damaged, /^panic: scene: these bytes are no whole scene: byte \d+ is wrong; bake it again$/],
    ['large', readFileSync(file('large.zsc')),
      /^panic: scene: \d+ bytes of memory are missing: the picture takes at least \d+, \d+ are left; most are for /],
  ].flatMap(([name, blob, says]) => wrongWhenRefused(given, blob, says).map((line) => `${name}: ${line}`))
      .concat(wrongWhenBakedWith(given, player, large)));
}

function prediction({library, elf, zstrip}) {
  const wrong = wrongPredictions(library, elf, zstrip);
  return wrong ? verdict(wrong) : 77;
}

// What each command takes behind WORK; the words of a name in brackets may be left out, those of one with dots are
// many.
const kCommands = {
  frames: [frames, 'uf2', 'panel'],
  mutations: [mutations, 'uf2', 'panel'],
  figures: [figures, 'uf2', '[zstrip]', '[scene]'],
  stuck: [stuck, 'uf2', 'panel'],
  baked: [baked, 'uf2', 'panel', 'zstrip', 'scenes...'],
  refused: [refused, 'uf2', 'panel', 'zstrip'],
  hot: [hot, 'uf2', 'hotUf2', 'zstrip', 'scene'],
  prediction: [prediction, 'elf', 'zstrip'],
};

/** The words by their names; nothing if there are too few or too many. */
function named(names, words) {
  const left = [...words], given = {};
  for (const name of names) {
    if (name.endsWith('...')) given[name.slice(0, -3)] = left.splice(0);
    else if (left.length > 0) given[name.replace(/[[\]]/g, '')] = left.shift();
    else if (!name.startsWith('[')) return undefined;
  }
  return left.length === 0 && given.scenes?.length !== 0 ? given : undefined;
}

async function main([command, work, ...words]) {
  if (command === 'fetch' && work && words.length === 0) return fetchEmulator(work);
  const [run, ...names] = kCommands[command] ?? [], given = run && work && named(names, words);
  if (!given) {
    console.error('pico.mjs: wrong words; its first lines say which there are');
    return 2;
  }
  if (existsSync(join(work, 'missing'))) return skip(work);
  const emulator = join(work, 'node_modules', 'rp2040js', 'dist', 'esm', 'index.js');
  const library = await import(pathToFileURL(emulator));
  const flash = given.uf2 && flashOf(given.uf2);
  // Of its own: tests run side by side.
  const folder = join(work, `${command}_${basename(words[0])}`);
  return run({library, work, folder, flash, ...given});
}

process.exitCode = await main(process.argv.slice(2));
