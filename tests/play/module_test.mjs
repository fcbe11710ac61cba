// The module of the playground in Node.js: pictures and files are those of the command, byte for byte.
//     node --test module_test.mjs     (environment: ZSTRIP the command, ZSTRIP_PAGE the page's folder)
import assert from 'node:assert/strict';
import {readFileSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {test} from 'node:test';
import {gzipSync} from 'node:zlib';

import {Command} from './command.mjs';

const page = process.env.ZSTRIP_PAGE;
// Emscripten's code for Node.js takes both from scripts that are no modules.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = page;
const {Drawing} = await import(join(page, 'drawing.mjs'));
const {examples, programs} = JSON.parse(readFileSync(join(page, 'contents.json'), 'utf8'));
const {bakeWordsOf, commandLineOf, kLooks, kPicoPrograms, kSettings, settingsOf} = await import(join(page, 'settings.mjs'));
const command = new Command(process.env.ZSTRIP, join(page, 'examples'));

const load = async () => {
  const wasmBinary = readFileSync(join(page, 'zstrip.wasm'));
  // Else Node.js ends with the status of a command that was refused.
  const quit = (status, exit) => { throw exit; };
  const drawing = await Drawing.load((await import(join(page, 'zstrip.mjs'))).default, {wasmBinary, quit});
  for (const {files} of examples) {
    drawing.addFiles((files ?? []).map((path) => ({path, bytes: readFileSync(join(page, 'examples', path))})));
  }
  return drawing;
};

// Frame 0 of one frame is what `zstrip render` draws.
const pngOf = async (drawing, scene, options) => {
  await drawing.open(scene, [...options, '--frames', '1']);
  await drawing.draw();
  return Buffer.from(drawing.png());
};

const kOptions = [
  ['--size', '240x240'],
  ['--size', '128x64', '--format', 'gray4', '--dither'],
  ['--size', '160x120', '--samples', '4', '--ram', '64K'],
  ['--size', '160x120', '--edges'],
  ['--panel', 'ssd1306', '--dither'],
  ['--depth-format', 'float'],
  ['--perspective', 'affine'],
];

test('all examples are drawn as the command draws them', async () => {
  const drawing = await load();
  for (const {scene} of examples) {
    const options = ['--size', '200x160'];
    assert.ok((await pngOf(drawing, scene, options)).equals(command.writes('render', scene, 'a.png', options)), scene);
  }
});

test('all options draw as those of the command', async () => {
  const drawing = await load();
  for (const options of kOptions) {
    for (const scene of ['teapot', 'room']) {
      const expected = command.writes('render', scene, 'a.png', options);
      assert.ok((await pngOf(drawing, scene, options)).equals(expected), `${scene} ${options.join(' ')}`);
    }
  }
});

test('visibility methods are refused', async () => {
  const drawing = await load();
  await assert.rejects(pngOf(drawing, 'room', ['--visibility', 'painter']), /visibility methods/);
});

test('the heat map is that of zstrip render --show accuracy', async () => {
  const drawing = await load();
  const cases = [
    ['teapot', ['--size', '120x90']],
    ['room', ['--size', '120x90', '--format', 'gray4', '--dither']],
    ['spheres.toml', ['--size', '96x96', '--samples', '4']],
    ['fog.toml', ['--size', '120x90', '--edges', '--format', 'xrgb8888']],
    ['figure/figure.gltf', ['--size', '60x90', '--ram', '20K']],
  ];
  for (const [scene, options] of cases) {
    await drawing.open(scene, [...options, '--frames', '1']);
    const {figures, pixels} = await drawing.draw({look: kLooks.indexOf('accuracy')});
    const expected = command.writes('render', scene, 'a.png', ['--show', 'accuracy', ...options]);
    assert.ok(Buffer.from(drawing.png()).equals(expected), scene);
    const {key, ...compared} = figures.accuracy;
    assert.deepEqual(compared, command.compares(scene, options), scene);
    assert.ok(compared.worst > compared.mean && compared.mean > 0 && compared.seen_percent > 0, scene);
    // A key begins with black and ends with white, and the worst pixel is as bright as any.
    assert.deepEqual([key[0], key.at(-1)], [[0, '#000000'], [20, '#ffffff']]);
    const brightness = (i) => pixels[4 * i] + pixels[4 * i + 1] + pixels[4 * i + 2];
    const worst = brightness(compared.worst_y * figures.width + compared.worst_x);
    for (let i = 0; i < figures.width * figures.height; ++i) assert.ok(brightness(i) <= worst, scene);
    assert.equal((await drawing.draw()).figures.accuracy, null);
  }
  await drawing.open('gallery/chess.toml', []);
  await assert.rejects(drawing.draw({look: 4}), (error) => error.status === 4 && /no truth can be drawn/.test(error.message));
});

test('a pixel is named in the words of zstrip render --pick', async () => {
  const drawing = await load();
  const named = new Set();
  for (const scene of ['teapot', 'room', 'gallery/train.toml', 'gallery/home.toml', 'figure/figure.gltf']) {
    const options = ['--size', '200x160', '--frames', '1'];
    await drawing.open(scene, options);
    await drawing.draw();
    for (const [x, y] of [[100, 80], [60, 100], [130, 120], [0, 0]]) {
      const words = await drawing.pick(x, y);
      assert.equal(`${x},${y}: ${words}`, command.picks(scene, x, y, options), scene);
      named.add(words.replace(/ .*/, ''));
    }
    await assert.rejects(drawing.pick(200, 80), /outside of the picture/);
  }
  assert.ok(named.has('instance') && named.has('background'));
  await drawing.open('csg.toml', ['--size', '60x60', '--frames', '1']);
  await drawing.draw();
  await assert.rejects(drawing.pick(30, 30), (error) => error.status === 2 && /cannot say which solid/.test(error.message));
});

test('estimates say which effects they leave out', async () => {
  const drawing = await load();
  for (const [scene, leftOut] of [['teapot', []], ['gallery/robot.toml', []], ['csg.toml', ['csg']]]) {
    await drawing.open(scene, ['--size', '60x60', '--frames', '1']);
    const {figures} = await drawing.draw();
    assert.deepEqual(figures.estimate_leaves_out, leftOut, scene);
    assert.equal(figures.text.some((line) => line.startsWith('the estimate leaves out: ')), leftOut.length > 0, scene);
  }
});

test('all examples are shown in all ways', async () => {
  const drawing = await load();
  for (const {scene} of examples) {
    await drawing.open(scene, ['--size', '64x48']);
    for (const look of ['wireframe', 'depth', 'overdraw']) {
      await drawing.draw({look: kLooks.indexOf(look)}).catch(({status, message}) => assert.fail(`${scene} ${look}: ${status}, ${message}`));
    }
  }
});

test('headers, programs and blobs are those of zstrip bake', async () => {
  const drawing = await load();
  for (const scene of ['teapot', 'fog.toml', 'gallery/chess.toml']) {
    for (const name of ['scene.hpp', 'scene.ino', 'main.cpp', 'scene.zsc']) {
      const words = ['bake', scene, '-o', name, '--turntable', '--quiet', '--size', '240x240', '--ram', '40K'];
      const {files: [file]} = await drawing.run(words, [name]);
      const expected = command.writes('bake', scene, name, ['--turntable', '--size', '240x240', '--ram', '40K']);
      assert.ok(Buffer.from(file.bytes).equals(expected), `${scene} ${name}`);
    }
  }
});

// What the page asks for, and `options`, those of the line that porting.md has.
const checkPicoFile = async (drawing, scene, name, options, pico) => {
  const settings = {scene, size: '128x64', format: 'gray4', ram: '40K', 'strip-rows': '5'};
  const {files: [file]} = await drawing.run([...bakeWordsOf(settings, name, pico), '--quiet'], [name]);
  assert.ok(Buffer.from(file.bytes).equals(command.writes('bake', scene, name, options)), `${scene} ${name}`);
};

test('files for the Pico are those of zstrip bake, whatever size is chosen', async () => {
  const drawing = await load();
  for (const scene of ['teapot', 'fog.toml', 'gallery/watch.toml']) {
    await checkPicoFile(drawing, scene, 'scene.uf2', []);
    await checkPicoFile(drawing, scene, 'scene.uf2', ['--board', 'pico2'], 'pico2');
  }
  await assert.rejects(
    drawing.run(bakeWordsOf({scene: 'perspective.toml'}, 'scene.uf2'), ['scene.uf2']),
    /leave 'perspective' out of the scene file/);
});

for (const [pico, name] of Object.entries(kPicoPrograms)) {
  test(`with ${name}, too`, {skip: !programs.includes(pico) && `the page has no ${name}`}, async () => {
    const drawing = await load();
    const program = join(page, name);
    drawing.addFiles([{path: name, bytes: readFileSync(program)}]);
    await checkPicoFile(drawing, 'teapot', 'both.uf2', ['--board', pico, '--with', program], pico);
  });
}

test('what is wrong is said, and the next scene is drawn', async () => {
  const drawing = await load();
  const refused = async (scene, options, status, words) => assert.rejects(
    pngOf(drawing, scene, options), (error) => error.status === status && words.test(error.message));
  await refused('teapot', ['--format', 'rgb56'], 2, /did you mean rgb565/);
  await refused('teapot', ['--ram', '1K'], 5, /bytes missing/);
  await refused('random10k', [], 2, /too large for a page/);
  await refused('nowhere.glb', [], 4, /nowhere\.glb/);
  await assert.rejects(drawing.run(['bake', 'teapot', '-o', 'a.hpp', '--json', '-']), /a page writes no JSON/);
  drawing.addFiles([
    {path: 'broken.glb', bytes: new TextEncoder().encode('glTF, or not')},
    {path: 'broken.toml', bytes: new TextEncoder().encode('[camera\n')},
    {path: '../../escaped.obj', bytes: new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')},
  ]);
  await refused('broken.glb', [], 4, /broken\.glb/);
  await refused('broken.toml', [], 4, /broken\.toml/);
  assert.ok((await pngOf(drawing, 'escaped.obj', [])).length > 100);
  assert.ok((await pngOf(drawing, 'teapot', [])).equals(command.writes('render', 'teapot', 'a.png')));
});

test('zstrip bake takes the command line that the page shows', async () => {
  const all = Object.fromEntries(kSettings.map(({name, kind, choices, hint}) => [name, kind === 'choice' ? choices[1] : hint ?? 'yes']));
  const settings = {...all, ram: '200K', scene: 'teapot', edges: ''};
  const [, , scene, , , ...options] = commandLineOf(bakeWordsOf(settings, 'scene.zsc')).split(' ');
  assert.ok(options.includes('--dither') && !options.includes('--panel'));
  assert.ok(command.writes('bake', scene, 'scene.zsc', options).length > 1000);
});

test('the page with its first scene is small', () => {
  const later = /^(examples|thumbnails|zstrip_pico2?_player\.uf2)$/;
  const [{files}] = examples.filter(({scene}) => scene === settingsOf('').settings.scene);
  const first = [...readdirSync(page).filter((name) => !later.test(name)), ...files.map((name) => join('examples', name))];
  const bytes = first.reduce((sum, name) => sum + gzipSync(readFileSync(join(page, name)), {level: 9}).length, 0);
  console.log(`${bytes} bytes gzipped`);
  assert.ok(bytes <= 1.5 * 1024 * 1024, `${bytes} bytes gzipped`);
});
