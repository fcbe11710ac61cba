// Draws all pictures with three.js and with zstrip, and measures how far apart they are.
import {execFile} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join, relative} from 'node:path';
import {fileURLToPath} from 'node:url';

import {makeJobs} from './cases.mjs';
import {showPage} from './chromium.mjs';
import {coloursApart, erode, silhouettesApart, tilesApart, toRgb565} from './compare.mjs';
import {encodePng} from './png.mjs';

/** Far more than it takes: other tests may have both processors. */
const kSeconds = 1500;

/** Of frames, the one that shows a part of the animation. */
const kFrames = 4;

/** The exit status of `zstrip` for a file that it refuses. */
const kRefused = 4;

/** What the program says; `error`, if it refuses the file. It fails if it ends in any other way. */
function run(program, words) {
  return new Promise((resolve, reject) => {
    execFile(program, words, {timeout: 300000}, (error, _, said) => {
      if (!error) return resolve({warnings: said.trim()});
      if (error.code === kRefused) return resolve({error: said.trim()});
      reject(new Error(`${program} ${words.join(' ')} ended with ${error.code ?? error.signal}: ${said}`));
    });
  });
}

/** RGB565 in bytes, low one first, as red, green, blue, 255. */
function toRgba(raw) {
  const to = new Uint8Array(2 * raw.length);
  for (let i = 0; i < raw.length; i += 2) {
    const pixel = raw[i] | (raw[i + 1] << 8);
    const r = pixel >> 11, g = (pixel >> 5) & 63, b = pixel & 31;
    to.set([(r << 3) | (r >> 2), (g << 2) | (g >> 4), (b << 3) | (b >> 2), 255], 2 * i);
  }
  return to;
}

class Zstrip {
  constructor(program, work) {
    this.program = program;
    this.work = work;
  }

  /** `{ pixels }` or `{ error }`; `show`: depth instead of colour. */
  async draw(job, placed, show) {
    const folder = join(this.work, 'frames');
    rmSync(folder, {recursive: true, force: true});
    const frame = Math.round(job.time * kFrames);
    const camera = job.camera === undefined ?
        ['--eye', placed.eye.join(','), '--look-at', placed.target.join(','), '--fov', String(job.degrees)] :
        ['--camera', job.camera.name];
    const words = [
      'render', job.file, '-o', folder, '--frames', String(frame === 0 ? 1 : kFrames), '--image', 'raw', '--size',
      job.size.join('x'), '--threads', '1', '--quiet', '--background', '000000', ...camera,
      ...(show ? ['--show', show] : [])
    ];
    const {error, warnings} = await run(this.program, words);
    if (error) return {error};
    return {warnings, pixels: toRgba(readFileSync(join(folder, `frame_${String(frame).padStart(4, '0')}.raw`)))};
  }
}

const maskOf = (pixels, channels) =>
    Uint8Array.from({length: pixels.length / 4}, (_, i) => (channels.some((c) => pixels[4 * i + c] > 0) ? 1 : 0));

/** For people: three.js's picture, zstrip's, and in red where they are apart. */
function writeTrio(path, left, right, apart, [width, height]) {
  const pixels = new Uint8Array(3 * width * height * 4);
  const marks = Uint8Array.from({length: left.length}, (_, i) => (i % 4 === 0 && apart[i >> 2] ? 255 : right[i] >> 2));
  for (let y = 0; y < height; ++y) {
    [left, right, marks].forEach((picture, column) => {
      pixels.set(picture.subarray(4 * y * width, 4 * (y + 1) * width), 4 * width * (3 * y + column));
    });
  }
  for (let i = 3; i < pixels.length; i += 4) pixels[i] = 255;
  mkdirSync(dirname(path), {recursive: true});
  writeFileSync(path, encodePng(3 * width, height, pixels));
}

const pictureOf = (mask) => Uint8Array.from({length: 4 * mask.length}, (_, i) => (mask[i >> 2] ? 255 : 0));
const sumOf = (mask) => mask.reduce((a, b) => a + b, 0);

/** `options`: `zstrip` and `chromium`, programs; `models`, `three`, `work`, folders. Returns the measured rows. */
export async function drawAll(options) {
  mkdirSync(options.work, {recursive: true});
  for (const name of ['models', 'pairs']) rmSync(join(options.work, name), {recursive: true, force: true});
  const jobs = makeJobs(options.models, options.work);
  for (const job of jobs)
    job.url = `/files/${relative(options.work, job.file).split('/').map(encodeURIComponent).join('/')}`;
  writeFileSync(join(options.work, 'jobs.json'), JSON.stringify(jobs));

  const seen = new Map();
  const zstrip = new Zstrip(options.zstrip, options.work);
  const rows = [], masks = new Map();
  let queue = Promise.resolve();
  await showPage({
    chromium: options.chromium,
    profile: join(options.work, 'profile'),
    folders: {page: dirname(fileURLToPath(import.meta.url)), three: options.three, files: options.work},
    seconds: kSeconds,
    onPost: (_, body, information) => {
      const job = jobs.find((each) => each.id === information.id);
      seen.set(job.id, true);
      queue = queue.then(async () => rows.push(await measure(job, {...information, pixels: new Uint8Array(body)})));
      return queue;
    },
  });
  await queue;
  if (seen.size !== jobs.length) throw new Error(`the page drew ${seen.size} of ${jobs.length} pictures`);
  return rows.flat();

  async function measure(job, three) {
    const row = (aspect, value, more = {}) =>
        ({case: job.case, source: job.source, id: job.id, aspect, value, ...more});
    const area = {width: job.size[0], height: job.size[1], step: job.step};
    const isFirst = job.aspect === 'silhouette', isOutline = job.aspect !== 'colour' && job.aspect !== 'light';
    const placed = three.placed ?? {eye: [0, 0, 5], target: [0, 0, 0]};
    const own = await zstrip.draw(job, placed, isOutline ? 'depth' : undefined);
    const trio = (left, right, apart) =>
        writeTrio(join(options.work, 'pairs', `${job.id}.png`), left, right, apart, job.size);
    const unread =
        row('read', Boolean(three.error) === Boolean(own.error) ? 0 : 1,
            {three: three.error ?? '', zstrip: own.error ?? '', warnings: own.warnings});
    if (isFirst && (three.error || own.error)) return [unread];
    if (!isFirst && !masks.has(job.case)) return [];
    if (three.error || own.error) return [row(job.aspect, Infinity, {three: three.error, zstrip: own.error})];
    if (isOutline) {
      // What blends leaves no depth.
      const coloured = job.blends ? maskOf((await zstrip.draw(job, placed)).pixels, [0, 1, 2]) : null;
      const mask = maskOf(own.pixels, [0, 1, 2]).map((covered, i) => covered | (coloured?.[i] ?? 0));
      const theirs = maskOf(three.pixels, [3]);
      if (isFirst) masks.set(job.case, mask.map((covered, i) => covered & theirs[i]));
      const apart = silhouettesApart(mask, theirs, area);
      trio(pictureOf(theirs), pictureOf(mask), apart);
      return [...(isFirst ? [unread] : []), row(job.aspect, sumOf(apart))];
    }
    const both = erode(masks.get(job.case), area);
    const theirs = toRgb565(three.pixels);
    const apart = coloursApart(own.pixels, theirs, both, area);
    trio(theirs, own.pixels, apart);
    return [row(
        job.aspect, sumOf(apart),
        {tiles: tilesApart(own.pixels, theirs, both, area), pixels: sumOf(both), step: job.step})];
  }
}
