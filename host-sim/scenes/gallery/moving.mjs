// Makes the moving pictures of the gallery: what the command renders, in full colour, as animated WebP.
// Run: node moving.mjs ZSTRIP FOLDER [NAME...], with the command and docs/images; all if no names are given. It needs
// img2webp, of Debian's package webp.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const kFrames = {
  lighthouse: 60,
  astronaut: 60,
  train: 72,
  robot: 24,
  watch: 60,
  chess: 60,
  home: 60,
  fox: 40
};
const kQuality = 70;
const kBytes = 1.5e6;  // the README shows all of them

const [zstrip, images, ...names] = process.argv.slice(2);
for (const name of names.length ? names : Object.keys(kFrames)) {
  const scene = path.join(import.meta.dirname, `${name}.toml`);
  const frames = kFrames[name];
  const seconds = Number(/^duration = (.*)$/m.exec(fs.readFileSync(scene, 'utf8'))[1]);
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'moving-'));
  const file = path.join(images, `gallery-${name}.webp`);
  execFileSync(zstrip, ['render', scene, '-o', `${scratch}/`, '--frames', String(frames), '--quiet']);
  const pictures = fs.readdirSync(scratch).sort().map((picture) => path.join(scratch, picture));
  const milliseconds = String(Math.round(1000 * seconds / frames));
  execFileSync(
      'img2webp',
      ['-loop', '0', '-lossy', '-q', String(kQuality), '-m', '6', '-d', milliseconds, ...pictures, '-o', file],
      {stdio: 'ignore'});
  fs.rmSync(scratch, {recursive: true});
  console.log(`${file}: ${frames} frames, ${fs.statSync(file).size} bytes`);
}
const bytes = Object.keys(kFrames).reduce((sum, name) => sum + fs.statSync(`${images}/gallery-${name}.webp`).size, 0);
if (bytes > kBytes) throw Error(`the pictures take ${bytes} bytes, more than ${kBytes}`);
