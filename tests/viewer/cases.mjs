// Which files are drawn, and of each what is compared.
import {copyFileSync, mkdirSync, readdirSync, statSync} from 'node:fs';
import {basename, dirname, extname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {kGenerated} from './generated.mjs';
import {copyNeighbours, readGltf, whitened, withoutLight, writeGltf} from './gltf.mjs';
import {kKeyDirection, kLights} from './lights.mjs';

/** Cases whose light is looked at as the file says it; of assimp's files it is looked at with all white. */
const kLit = /^(light-.*|morph-cube|morph-stress|no-material|nested|no-normals|sphere)$/;
/** Cases whose light is looked at while they move, too. */
const kLitMoving = /^morph-/;
/** What glows or is lit fully: colours of a lit material. */
const kBright = /^(emissive|facing-light)-/;
/** The largest step of red and blue in RGB565; green has half of it. Texels are rounded to it, all else is cut. */
const kStep = 9;
/** What blends is cut to RGB565 twice; colours are multiplied as the screen shows them, not in proportion to light. */
const kTwoSteps = /-blend|-x-|^facing-light/;
/** All others of the generated files are flat things, which are best seen from the front. */
const kSolid = /^(sphere|nested|no-normals|light-|morph-cube|morph-stress|move-|texture-tilted)/;

const kPoseTimes = [1 / 4, 2 / 4, 3 / 4];
const kFromAside = [0.6, 0.5, 1];

/** Where the camera is, seen from the middle of a generated file. */
function directionTo(name) {
  if (name.startsWith('facing-light-')) return kKeyDirection;
  return kSolid.test(name) ? kFromAside : [0, 0, 1];
}

function filesBelow(folder) {
  return readdirSync(folder).sort().flatMap((name) => {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) return filesBelow(path);
    return ['.gltf', '.glb'].includes(extname(name)) ? [path] : [];
  });
}

/** Files by a short name: their own, or their folder's where several have the same. */
function named(paths) {
  const stem = (path) => basename(path, extname(path));
  return paths.map((path) => {
    const isOnly = paths.filter((other) => stem(other) === stem(path)).length === 1;
    return {name: isOnly ? stem(path) : basename(join(path, '..')), path};
  });
}

/** What a file is, as far as it can be told; a damaged one is nothing. */
function jsonOf(path) {
  try {
    return readGltf(path).json;
  } catch {
    return {};
  }
}

/** Writes a changed copy of a file beside its neighbours. Null where it is too damaged to be changed. */
function changedCopy(from, to, change) {
  try {
    const gltf = readGltf(from);
    change(gltf.json);
    writeGltf(to, gltf);
    return to;
  } catch {
    return null;
  }
}

/** Lines and points have no inside whose colour could be compared. */
function hasOnlyLines({meshes = []}) {
  const primitives = Object.values(meshes).flatMap((mesh) => mesh.primitives ?? []);
  return primitives.length > 0 && primitives.every(({mode = 4}) => mode < 4);
}

function jobsOf(source, path, name) {
  const json = jsonOf(path);
  const generated = source === 'generated';
  const degrees = 30, size = [256, 256], step = kTwoSteps.test(name) ? 2 * kStep : kStep;
  const base = {
    case: name,
    source,
    degrees,
    size,
    step,
    time: 0,
    lights: [],
    lambert: false,
    linear: false,
    blends: Array.isArray(json.materials) && json.materials.some(({alphaMode}) => alphaMode === 'BLEND'),
    from: generated ? directionTo(name) : kFromAside,
  };
  const job = (aspect, file, more = {}) => ({...base, aspect, file, id: `${name} ${aspect}`, ...more});
  const jobs = [job('silhouette', path)];
  if (hasOnlyLines(json)) return jobs;
  const copy = (what, change) => changedCopy(path, path.replace(/\.(\w+)$/, `.${what}.$1`), change);
  if (kBright.test(name)) {
    jobs.push(job('colour', path, {lambert: true, lights: kLights.none}));
  } else {
    const unlit = copy('unlit', withoutLight);
    if (unlit) jobs.push(job('colour', unlit));
  }
  if (generated ? kLit.test(name) : true) {
    const lit = generated ? path : copy('white', whitened);
    const lights = json.extensions?.KHR_lights_punctual ? kLights.own : kLights.none;
    if (lit) jobs.push(job('light', lit, {lambert: true, linear: true, lights}));
    for (const time of lit && kLitMoving.test(name) ? kPoseTimes : []) {
      jobs.push(job('light', lit, {lambert: true, linear: true, lights, time, id: `${name} light ${time}`}));
    }
  }
  if (Array.isArray(json.animations) && json.animations.length > 0) {
    for (const time of kPoseTimes) jobs.push(job('pose', path, {time, id: `${name} pose ${time}`}));
  }
  if (json.cameras) {
    json.nodes.forEach(({name: called, camera: index}, node) => {
      if (index === undefined) return;
      const camera = {index, name: called ?? `nodes[${node}]`};
      jobs.push(job('camera', path, {camera, size: [240, 160], id: `${name} camera ${camera.name}`}));
    });
  }
  return jobs;
}

/** Copies a file with what lies beside it into a folder of its name. */
function copied(path, folder, name) {
  const own = join(folder, name);
  copyNeighbours(path, own);
  const to = join(own, basename(path));
  copyFileSync(path, to);
  return to;
}

/**
 * All pictures that are to be drawn, in the order of cases. Copies all files into the folder `work`/models. A case's
 * first job is the file as it is.
 */
export function makeJobs(models, work) {
  const folder = join(work, 'models');
  const jobs = [];
  for (const {name, path} of named(filesBelow(models))) {
    jobs.push(...jobsOf('assimp-testmodels', copied(path, folder, name), name));
  }
  for (const path of filesBelow(join(dirname(fileURLToPath(import.meta.url)), 'blender'))) {
    const name = `blender-${basename(path, '.glb')}`;
    jobs.push(...jobsOf('blender', copied(path, folder, name), name));
  }
  for (const [name, make] of Object.entries(kGenerated)) {
    const path = join(folder, name, `${name}.gltf`);
    mkdirSync(join(folder, name), {recursive: true});
    writeGltf(path, {json: make()});
    jobs.push(...jobsOf('generated', path, name));
  }
  return jobs;
}
