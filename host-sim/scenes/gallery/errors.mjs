// Prints how far pictures of the gallery's scenes are from 256 samples a pixel: with one sample, two, four, and with
// edges. The truth is the scene at eight times the width and height with 4 samples a pixel, averaged.
// Run: node errors.mjs ZSTRIP [SCENE...], with the command as ZSTRIP
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

import {readPicture} from './pictures.mjs';

const kSize = 240, kTimes = 8, kFrames = 12, kPlain = 24;
const kSettings = {
  'one sample': ['--samples', '1', '--no-edges'],
  'two': ['--samples', '2', '--no-edges'],
  'four': ['--samples', '4', '--no-edges'],
  'edges': ['--samples', '1', '--edges'],
};
const [, , zstrip, ...named] = process.argv;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'zstrip-errors-'));

function frames(scene, size, options) {
  const output = path.join(folder, 'frames');
  fs.rmSync(output, {recursive: true, force: true});
  execFileSync(zstrip, [
    'render', `${scene}.toml`, '-o', output, '--frames', String(kFrames), '--image', 'ppm', '--size', `${size}x${size}`,
    '--ram', 'max', '--quiet', ...options
  ]);
  return fs.readdirSync(output).sort().map((name) => readPicture(path.join(output, name)).pixels);
}
// Returns the means of squares with kTimes pixels a side.
function smaller(pixels) {
  const means = new Float64Array(kSize * kSize * 3);
  for (let y = 0; y < kSize * kTimes; ++y) {
    for (let x = 0; x < kSize * kTimes; ++x) {
      const from = 3 * (y * kSize * kTimes + x), to = 3 * (Math.floor(y / kTimes) * kSize + Math.floor(x / kTimes));
      for (let k = 0; k < 3; ++k) means[to + k] += pixels[from + k] / kTimes ** 2;
    }
  }
  return means;
}
// The root of the mean square of all channels, and how many pixels have a channel that is off by more than kPlain.
function errors(shown, truth) {
  let squares = 0, plain = 0;
  shown.forEach((pixels, frame) => {
    for (let at = 0; at < pixels.length; at += 3) {
      const off = [0, 1, 2].map((k) => Math.abs(pixels[at + k] - truth[frame][at + k]));
      squares += off[0] ** 2 + off[1] ** 2 + off[2] ** 2;
      if (Math.max(...off) > kPlain) ++plain;
    }
  });
  return `${Math.sqrt(squares / (shown.length * shown[0].length)).toFixed(2)}, ${Math.round(plain / shown.length)}`;
}

for (const scene of named.length ? named : ['lighthouse', 'astronaut', 'train', 'robot', 'watch', 'chess']) {
  const truth = frames(scene, kSize * kTimes, kSettings.four).map(smaller);
  const cells = Object.entries(kSettings).map(([name, options]) => {
    return errors(frames(scene, kSize, options), truth);
  });
  console.log(`| \`${scene}\` | ${cells.join(' | ')} |`);
}
fs.rmSync(folder, {recursive: true});
