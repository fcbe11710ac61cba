// Files that were dropped or chosen: their relative paths, and the one that is the scene.

// The first kind of these that is among several files is the scene.
export const kScenes = ['.toml', '.glb', '.gltf', '.vrm', '.zsc', '.obj', '.ply', '.stl', '.3mf'];

// Returns a file, or all that is in a folder.
async function filesOf(entry, path = '') {
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    return [{path: path + entry.name, file}];
  }
  const reader = entry.createReader();
  const found = [];
  for (;;) {
    // A reader gives some at a time.
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return found;
    for (const each of some) found.push(...await filesOf(each, `${path}${entry.name}/`));
  }
}

const read = (files) => Promise.all(files.map(async ({path, file}) => ({path, bytes: new Uint8Array(await file.arrayBuffer())})));

// Both functions return [{path, bytes}].
export async function droppedFiles(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  const plain = [...transfer.files].map((file) => ({path: file.name, file}));
  const found = (await Promise.all(entries.map((entry) => filesOf(entry)))).flat();
  return read(found.length > 0 ? found : plain);
}
export const chosenFiles = (input) => read([...input.files].map((file) => ({path: file.name, file})));

// The path of the scene among files, the one that lies least deep; undefined if there is none.
export function sceneAmong(files) {
  const rank = ({path}) => kScenes.findIndex((ending) => path.toLowerCase().endsWith(ending));
  const depth = ({path}) => path.split('/').length;
  return files.filter((file) => rank(file) >= 0).sort((a, b) => rank(a) - rank(b) || depth(a) - depth(b))[0]?.path;
}
export const sceneEndings = () => kScenes.join(' ');
