// The files that the page makes for a board, or to be shown.
import {call} from './calls.mjs';
import {fetched, textOf} from './scene_files.mjs';
import {bakeWordsOf, kPicoPrograms, turnWordsOf} from './settings.mjs';
import {zipOf} from './zip.mjs';

const kMaxFrames = 240;  // of a picture that moves

async function written(words, name) {
  const {files: [{bytes}], messages} = await call('run', {words: [...words, '--quiet'], names: [name]});
  return {bytes, messages};
}

async function baked(settings, name, pico) {
  const words = bakeWordsOf(settings, name, pico);
  const program = kPicoPrograms[pico];
  if (words.includes(program)) await call('addFiles', [await fetched(program, program)]);
  return written(words, name);
}

// Arduino wants a folder with the name of its sketch.
async function sketchFolder(settings, pico) {
  const all = [];
  for (const name of ['scene.ino', 'scene.hpp']) all.push({path: `scene/${name}`, ...await baked(settings, name, pico)});
  return {bytes: zipOf(all), messages: all[0].messages};
}

/** {bytes, messages} of the file of this name; `pico`: the board that a .uf2 file is for. */
export function fileOf(name, settings, frames, pico) {
  switch (name) {
    case 'picture.png': return call('png').then((bytes) => ({bytes, messages: []}));
    case 'turn.apng': return written(turnWordsOf(settings, name, Math.min(frames, kMaxFrames)), name);
    case 'scene.zip': return sketchFolder(settings, pico);
    case 'scene.toml': return Promise.resolve({bytes: new TextEncoder().encode(textOf(settings.scene)), messages: []});
    default: return baked(settings, name, pico);
  }
}

export function save(bytes, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
