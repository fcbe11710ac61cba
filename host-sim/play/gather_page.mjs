// Gathers the page with the example scenes in a folder that any server of files can show:
//     node gather_page.mjs FOLDER MODULE...     (MODULE: the linked .mjs and .wasm, which also draw the thumbnails)
// ZSTRIP_PICO_PROGRAM names zstrip_pico_player.uf2, ZSTRIP_PICO2_PROGRAM zstrip_pico2_player.uf2. Without a name the
// page gets the program of the build tree; if that is missing, a line says so. Exit status: 0, or 1 if a named program
// or a module is not a file; then FOLDER does not change.
import {copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {basename, dirname, join, relative, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {drawThumbnails} from './draw_thumbnails.mjs';
import {kPicoPrograms} from './page/settings.mjs';

const kHere = dirname(fileURLToPath(import.meta.url));
const kScenes = join(kHere, '../scenes');
const kFigure = 'figure/figure.gltf';
const kBuiltPrograms = join(kHere, '../../build/host/firmware/bin');
const kBuiltIn = {
  teapot: 'the Utah teapot',
  knot: 'a knot of 5,120 triangles',
  room: 'a textured room',
  terrain: 'hills to the horizon',
  wires: 'a globe of thin wires',
  spheres: 'spheres, pixel by pixel',
  punctual: 'knots in the light of a point and a spot'
};

/** The files that a scene file or a model names, with what those name. Names without a file are left to the command. */
function withNamed(path) {
  const kNames = {
    '.toml': /(?:^|[{,])\s*(?:file|image|texture|environment)\s*=\s*"([^"]+)"/gm,
    '.obj': /^mtllib\s+(\S+)/gm,
    '.mtl': /^map_\w+\s+(\S+)/gm,
    '.gltf': /"uri"\s*:\s*"(?!data:)([^"]+)"/g,
  };
  const names = kNames[path.slice(path.lastIndexOf('.'))];
  if (!names) return [path];
  const named = [...readFileSync(path, 'utf8').matchAll(names)].map((match) => join(dirname(path), match[1]));
  return [path, ...named.filter(existsSync).flatMap(withNamed)];
}

/** A scene file's first line says what it shows. */
function example(path) {
  const scene = relative(kScenes, path);
  const [, words] = /^#\s*(.+)$/m.exec(readFileSync(path, 'utf8'));
  const title = words.split(/[:.]/)[0];
  const files = [...new Set(withNamed(path))].map((file) => relative(kScenes, file));
  return {scene, title: `${basename(scene, '.toml')}: ${title[0].toLowerCase()}${title.slice(1)}`, files};
}

const tomls = (folder) => readdirSync(folder).filter((name) => name.endsWith('.toml')).sort().map((name) => join(folder, name));

/** A module without the lines that are only a comment, which browsers need not load. */
const withoutComments = (text) => text.replace(/^ *(\/\/.*|\/\*\*.*\*\/)\n/gm, '');

const isFile = (path) => statSync(path, {throwIfNoEntry: false})?.isFile() ?? false;

/** The programs for the Picos that the page gets, as [board, file, path]; an Error if a named one is no file. */
function programFiles() {
  return Object.entries(kPicoPrograms).flatMap(([board, file]) => {
    const variable = `ZSTRIP_${board.toUpperCase()}_PROGRAM`, named = process.env[variable];
    const path = named || join(kBuiltPrograms, file);
    if (isFile(path)) return [[board, file, path]];
    if (named) throw new Error(`${variable}: there is no file '${named}'`);
    console.log(`zstrip: the page is without ${file}: the build tree lacks it, and ${variable} names none`);
    return [];
  });
}

const [folder, ...modules] = process.argv.slice(2);
let programs;
try {
  programs = programFiles();
  for (const path of modules) {
    if (!isFile(path)) throw new Error(`there is no module '${path}'`);
  }
} catch (error) {
  console.error(`zstrip: ${error.message}`);
  process.exit(1);
}
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
const examples = [
  ...tomls(join(kScenes, 'gallery')).map(example),
  ...Object.entries(kBuiltIn).map(([scene, words]) => ({scene, title: `${scene}: ${words}`})),
  ...tomls(kScenes).map(example),
  {scene: kFigure, title: 'figure: it walks, by a skin', files: [kFigure]},
];
for (const path of new Set(examples.flatMap(({files}) => files ?? []))) {
  const target = join(folder, 'examples', path);
  mkdirSync(dirname(target), {recursive: true});
  copyFileSync(join(kScenes, path), target);
}
const module = modules.find((path) => path.endsWith('.mjs'));
mkdirSync(join(folder, 'thumbnails'));
if (module) await drawThumbnails(resolve(module), examples, kScenes, folder);
for (const [, file, path] of programs) copyFileSync(path, join(folder, file));
writeFileSync(join(folder, 'contents.json'), JSON.stringify({examples, programs: programs.map(([board]) => board)}));
for (const name of readdirSync(join(kHere, 'page'))) {
  const text = readFileSync(join(kHere, 'page', name), 'utf8');
  writeFileSync(join(folder, name), name.endsWith('.mjs') ? withoutComments(text) : text);
}
for (const path of modules) copyFileSync(path, join(folder, basename(path)));
