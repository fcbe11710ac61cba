// What the tests of the Pico and of the Pico 2 share: the panel's verdict, the command, and baked scenes in the player.
import {spawnSync} from 'node:child_process';
import {mkdirSync, rmSync} from 'node:fs';
import {join} from 'node:path';

import {Board} from './board.mjs';
import {flashOf} from './uf2.mjs';

export const kFrameBytes = 240 * 240 * 2;

/** What the panel's model says of the lines, each a string. */
export function shownOn(panel, board, ...words) {
  const {status, stdout, stderr} = spawnSync(panel, words, {input: board.wire(), encoding: 'utf8'});
  if (status !== 0 && status !== 1) throw new Error(`${panel}: ${stderr}`);
  return stdout.trim().split('\n');
}

/** Prints what is wrong. */
export function verdict(wrong) {
  for (const line of wrong) console.log(line);
  return wrong.length === 0 ? 0 : 1;
}

/** `run(...words)` is the command; `file(name)` is one in an empty folder. */
export function commandOf(zstrip, folder) {
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
  return {
    file: (name) => join(folder, name),
    run(...words) {
      const {status, stderr} = spawnSync(zstrip, [...words, '--quiet'], {cwd: folder, encoding: 'utf8'});
      if (status !== 0) throw new Error(`zstrip ${words.join(' ')}: ${stderr}`);
    },
  };
}

const kSteps = 64;  // of the motion, where a host steps through it

/**
 * Frame 0, one in real time, and two steps, of a scene that is baked for the player; what is wrong. The files for the
 * loader, one with both or one after the other, fill the flash alike. `options`: of the board; `bakeFor`: the command's
 * words for it.
 */
export function wrongWhenBaked({library, uf2, panel, zstrip, folder, options, bakeFor = []}, scene) {
  const {run, file} = commandOf(zstrip, folder);
  const picture = ['--size', '240x240', '--format', 'rgb565_swapped'];
  run('bake', scene, '-o', 'both.uf2', '--samples', '1', '--no-edges', '--with', uf2, ...bakeFor);
  run('bake', scene, '-o', 'scene.uf2', '--samples', '1', '--no-edges', ...bakeFor);
  run('bake', scene, '-o', 'scene.zsc', '--samples', '1', '--no-edges', ...picture);
  run('render', 'scene.zsc', '-o', 'frames', '--frames', `${kSteps}`, '--image', 'ppm', ...picture);
  const flash = flashOf(file('both.uf2'));
  if (Buffer.compare(flash, flashOf(file('both.uf2'), uf2, file('scene.uf2'))) !== 0) return ['the flash differs'];

  const board = new Board(library, flash, kFrameBytes, options), {chip} = board;
  const type = (keys) => [...keys].forEach((key) => chip.emulator.uart[0].feedByte(key.charCodeAt(0)));
  board.onFrame = (frame) => {
    if (frame === 2) type('pn');
    if (frame === 3) type('n');
    if (frame === 4) chip.end('frames');
  };
  chip.endIn(20, 'time');
  chip.run();
  const said = board.console.split('\n').slice(0, -1).map((line) => Number(/^frame (\d+)$/.exec(line)?.[1]));
  const [first] = said, wrong = [...chip.complaints];
  if (said.length !== 2 || !(first >= 0) || said[1] !== first + 1) wrong.push(`the console says ${board.console}`);
  const fileOf = (step) => file(`frames/frame_${String(step % kSteps).padStart(4, '0')}.ppm`);
  const expected = [fileOf(0), '-', fileOf(first + 1), fileOf(first + 2)];
  const shown = shownOn(panel, board, ...expected.flatMap((name) => ['--frame', name]));
  if (shown.pop() !== '5 pictures') wrong.push(`not 4 frames: ended by ${chip.ended}`);
  return [...wrong, ...shown];
}
