// Makes the animated pictures of docs/gallery.md, one for each effect, from pictures that the command renders.
// Run: node effects.mjs ZSTRIP FOLDER [NAME...], with the command and docs/images; all if no names are given.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const kScenes = path.resolve(import.meta.dirname, '..');
const kAnimate = path.join(import.meta.dirname, 'animate.mjs');

// `turn`: number of frames of a full rotation; `swing`: number of frames to each side and back, five degrees each;
// `frames`: number of frames of the scene's own motion; `orbit`: the camera rotates instead. `beside`: options of
// pictures side by side. `times`: enlargement of the pixels.
const kEffects = {
  shading: {scene: 'shading.toml', swing: 3, size: '360x136'},
  perspective: {scene: 'perspective.toml', swing: 3, size: '178x136', beside: [[], ['--perspective', '16']]},
  fog: {scene: 'fog.toml', swing: 4},
  emissive: {scene: 'emissive.toml', swing: 4},
  specular: {scene: 'specular.toml', swing: 3},
  punctual: {scene: 'punctual', swing: 3},
  mask: {scene: 'alpha_test.toml', turn: 16, size: '200x150'},
  blend: {scene: 'transparency.toml', turn: 24},
  bilinear: {scene: 'bilinear.toml', swing: 3, size: '200x150'},
  palette: {scene: 'palette.toml', swing: 3, size: '320x120'},
  mipmaps: {scene: 'mipmaps.toml', swing: 2, size: '200x150', samples: 1},
  environment: {scene: 'environment.toml', swing: 3, size: '200x150'},
  per_pixel: {scene: 'per_pixel.toml', swing: 3},
  dithered: {scene: 'dithered.toml', swing: 4, size: '128x64', times: 3, samples: 1, colours: 2},
  samples: {
    scene: 'anti_aliasing.toml',
    swing: 3,
    size: '80x60',
    times: 3,
    samples: 0,
    beside: [['--samples', '1'], ['--samples', '2'], ['--samples', '4']]
  },
  edges: {
    scene: 'edges.toml',
    swing: 3,
    size: '80x60',
    times: 3,
    samples: 0,
    beside: [['--no-edges'], ['--edges'], ['--no-edges', '--samples', '4']]
  },
  overlay: {scene: 'overlay.toml', frames: 24, size: '160x120', times: 2},
  spheres: {scene: 'spheres.toml', turn: 18},
  billboards: {scene: 'billboards.toml', turn: 14, size: '200x150', colours: 24},
  skin: {scene: 'figure/figure.gltf', frames: 20},
  outlines: {scene: 'outlines.toml', turn: 18},
  shadows: {scene: 'shadows.toml', turn: 18},
  csg: {scene: 'csg.toml', turn: 18},
  lines: {scene: 'lines.toml', turn: 16, size: '200x150', samples: 1, colours: 8, orbit: [5.6, 28, 68]},
  directional: {scene: 'directional.toml', swing: 4},
  point: {scene: 'point.toml', swing: 4},
  spot: {scene: 'spot.toml', swing: 4},
  lamp: {scene: 'lamp.toml', swing: 4},
  fog_linear: {scene: 'fog_linear.toml', swing: 4},
  table: {scene: 'table.toml', turn: 18},
  rooms: {scene: 'rooms.toml', turn: 18},
  first_turns: {scene: 'first.toml', swing: 3, size: '200x150'},
  clips: {scene: 'clips.toml', frames: 48, size: '160x160', milliseconds: 167, colours: 64},
};

function read(file) {
  const bytes = fs.readFileSync(file),
        [head, width, height] = /^P[56]\s+(\d+)\s+(\d+)\s+255\s/.exec(bytes.latin1Slice(0, 32));
  return {width: Number(width), height: Number(height), pixels: bytes.subarray(head.length), grey: bytes[1] === 53};
}

// Puts pictures of one height side by side, enlarged, with a white line between them.
function joined(pictures, times) {
  const height = pictures[0].height * times;
  const width = pictures.reduce((sum, p) => sum + p.width * times, 0) + 4 * (pictures.length - 1);
  const pixels = Buffer.alloc(width * height * 3, 255);
  let left = 0;
  for (const p of pictures) {
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < p.width * times; ++x) {
        const at = Math.floor(y / times) * p.width + Math.floor(x / times);
        for (let k = 0; k < 3; ++k) pixels[3 * (y * width + left + x) + k] = p.pixels[p.grey ? at : 3 * at + k];
      }
    }
    left += p.width * times + 4;
  }
  return Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), pixels]);
}

/** Numbers of the command's frames, in the order in which they are shown. */
function order({swing, turn, frames}) {
  if (!swing) return [...Array(turn ?? frames).keys()];
  const there = [...Array(2 * swing).keys()].map((n) => n - swing);
  return [...there, ...there.map((n) => -n)].map((n) => (n + 72) % 72);
}

const [zstrip, images, ...names] = process.argv.slice(2);
const run = (words) => execFileSync(zstrip, words, {stdio: ['ignore', 'ignore', 'inherit']});
for (const name of names.length ? names : Object.keys(kEffects)) {
  const effect = kEffects[name], {size = '240x180', samples = 4, times = 1, beside = [[]], colours = 32} = effect;
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'effects-'));
  const shown = order(effect);
  const columns = beside.map((options, column) => {
    const folder = path.join(scratch, String(column));
    const words = [
      'render', path.join(kScenes, effect.scene), '-o', `${folder}/`, '--size', size, '--image', 'ppm', '--quiet',
      ...options
    ];
    if (!effect.scene.includes('.')) words[1] = effect.scene;
    if (samples) words.push('--samples', String(samples));
    fs.mkdirSync(folder);
    if (effect.orbit) {
      const [r, phi, theta] = effect.orbit;
      for (const n of shown) {
        words[3] = path.join(folder, `${String(n).padStart(3, '0')}.ppm`);
        run([...words, '--frames', '1', '--orbit', `${r},${phi + 360 * n / effect.turn},${theta}`]);
      }
    } else {
      run([...words, '--frames', String(effect.swing ? 72 : shown.length)]);
    }
    return fs.readdirSync(folder).sort().map((file) => path.join(folder, file));
  });
  const folder = path.join(scratch, 'shown');
  fs.mkdirSync(folder);
  shown.forEach(
      (frame, n) => fs.writeFileSync(
          path.join(folder, `${String(n).padStart(3, '0')}.ppm`),
          joined(columns.map((files) => read(files[frame])), times)));
  const file = path.join(images, `${name}.png`);
  execFileSync('node', [
    kAnimate, folder, String(shown.length * (effect.milliseconds ?? (effect.turn ? 160 : 110))), file, String(colours)
  ]);
  fs.rmSync(scratch, {recursive: true});
  console.log(`${file}: ${shown.length} frames, ${fs.statSync(file).size} bytes`);
}
