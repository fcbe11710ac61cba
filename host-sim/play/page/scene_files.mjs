// The files that the worker has: those of examples, fetched when they are chosen first, and the user's own.
import {call} from './calls.mjs';

let examples = [];
const files = new Map();  // bytes by their paths
let own = new Map();      // dropped, edited, or from a link

export const setExamples = (all) => { examples = all; };
export const isExample = (scene) => examples.some((each) => each.scene === scene);

export async function fetched(address, path) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${response.status} ${response.statusText}`);
  return {path, bytes: new Uint8Array(await response.arrayBuffer())};
}

async function add(added) {
  for (const {path, bytes} of added) files.set(path, bytes);
  await call('addFiles', added);
}

// The user's own files win over those of the example.
export async function fetchExample(scene) {
  const example = examples.find((each) => each.scene === scene);
  if (!example?.files || example.fetched) return;
  const all = await Promise.all(example.files.map((path) => fetched(`examples/${path}`, path)));
  example.text = all.find(({path}) => path === scene);
  await add(all.filter(({path}) => !own.has(path)));
  example.fetched = true;
}

// Dropped files replace the files that were dropped before, unless `replaces` is false.
export async function addOwn(added, replaces = true) {
  if (replaces) own = new Map();
  for (const {path, bytes} of added) own.set(path, bytes);
  await add(added);
}

export const isOwn = (scene) => own.has(scene);
export const isEdited = (scene) => isExample(scene) && own.has(scene);

export async function forgetEdits(scene) {
  const {text} = examples.find((each) => each.scene === scene);
  own.delete(scene);
  await add([text]);
}

// Returns the files that a link carries: those that the page does not have; of an example only its edited text.
export const ownFilesOf = (scene) => [...own].filter(([path]) => !isExample(scene) || path === scene)
  .map(([path, bytes]) => ({path, bytes}));

export function textOf(scene) {
  const bytes = files.get(scene);
  return bytes ? new TextDecoder().decode(bytes) : undefined;
}
