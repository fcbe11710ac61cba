// Draws the examples small, by the module that the page gets.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Drawing} from './page/drawing.mjs';

const kSize = '144x144';

async function load(module) {
  // Emscripten's code for Node.js expects both names, which only scripts have, not modules.
  globalThis.require ??= createRequire(import.meta.url);
  globalThis.__dirname ??= dirname(module);
  const quit = (status, exit) => { throw exit; };  // else Node.js ends with the command's status
  const wasmBinary = readFileSync(module.replace(/\.mjs$/, '.wasm'));
  return Drawing.load((await import(pathToFileURL(module))).default, {wasmBinary, quit});
}

/** Names the `thumbnail` of each example, a file that is written below `folder`. `scenes`: where their files are. */
export async function drawThumbnails(module, examples, scenes, folder) {
  const drawing = await load(module);
  const drawn = (scene, ...options) =>
    drawing.run(['render', scene, '-o', 'a.png', '--size', kSize, '--quiet', ...options], ['a.png']);
  for (const example of examples) {
    drawing.addFiles((example.files ?? []).map((path) => ({path, bytes: readFileSync(join(scenes, path))})));
    // Not all scenes allow several samples.
    const {files: [{bytes}]} = await drawn(example.scene, '--samples', '4').catch(() => drawn(example.scene));
    example.thumbnail = `thumbnails/${example.scene.replaceAll('/', '_')}.png`;
    writeFileSync(join(folder, example.thumbnail), bytes);
  }
}
