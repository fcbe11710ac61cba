// The playground in headless Chromium, by mouse, keys and dropped files: what is shown is what the command draws.
//     node --test page_test.mjs
// Environment: ZSTRIP the command, ZSTRIP_PAGE the page's folder, ZSTRIP_SERVE serve.mjs, ZSTRIP_CHROMIUM,
// ZSTRIP_WORK a folder for what is written; with ZSTRIP_SCREENSHOTS also pictures of the page in three widths.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {Chromium} from './chromium.mjs';
import {Command} from './command.mjs';

const {ZSTRIP, ZSTRIP_PAGE, ZSTRIP_SERVE, ZSTRIP_CHROMIUM, ZSTRIP_WORK, ZSTRIP_SCREENSHOTS} = process.env;
const kPatience = 60;  // seconds
const command = new Command(ZSTRIP, join(ZSTRIP_PAGE, 'examples'));
let browser, server, address;

before(async () => {
  rmSync(ZSTRIP_WORK, {recursive: true, force: true});
  mkdirSync(join(ZSTRIP_WORK, 'downloads'), {recursive: true});
  server = await (await import(ZSTRIP_SERVE)).serve(ZSTRIP_PAGE);
  address = `http://127.0.0.1:${server.address().port}/`;
  browser = new Chromium(ZSTRIP_CHROMIUM, join(ZSTRIP_WORK, 'profile'));
  await browser.open(`${address}#scene=teapot&size=200x160&frame=0`);
  await drawn();
});
after(async () => {
  await browser.close();
  server.closeAllConnections();
  server.close();
});

const drawn = async (state = 'drawn') => browser.until(`document.body?.dataset.state === '${state}'`, kPatience,
  `the page is not ${state}: ${await browser.evaluate('document.getElementById("status")?.textContent')}`);

// {width, height, rgb} of the canvas.
async function canvas() {
  const {width, height, text} = await browser.evaluate(`(() => {
    const canvas = document.getElementById('canvas');
    const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let text = '';
    for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
    return {width: canvas.width, height: canvas.height, text: btoa(text)};
  })()`);
  return {width, height, rgb: Buffer.from(text, 'base64')};
}

// A model is framed for one picture or for a turn: here the page has one frame.
async function shows(scene, options) {
  const shown = await canvas();
  const expected = command.draws(scene, options);
  assert.deepEqual([shown.width, shown.height], [expected.width, expected.height]);
  assert.ok(shown.rgb.equals(expected.rgb), `${scene} ${options.join(' ')}`);
}

async function set(name, value) {
  const at = `#setting-${name}`;
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  if (await browser.evaluate(`document.querySelector('${at}').closest('details')?.open === false`)) await browser.click('summary');
  if (await browser.evaluate(`document.querySelector('${at}').type === 'checkbox'`)) return browser.click(at);
  if (await browser.evaluate(`document.querySelector('${at}').matches('select, [type=color]')`)) {
    // A list or a picker of the system, which a page cannot see: as keys choose in it.
    return browser.evaluate(`(() => {
      const control = document.querySelector('${at}');
      control.value = '${value}';
      for (const type of ['input', 'change']) control.dispatchEvent(new Event(type, {bubbles: true}));
    })()`);
  }
  await browser.click(at);
  await browser.evaluate(`document.querySelector('${at}').select()`);
  await browser.type(value);
  await browser.press('Enter', 13, '\r');
}

async function choose(scene) {
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.click(`[data-scene="${scene}"]`);
  await drawn();
}

const text = (selector) => browser.evaluate(`document.querySelector('${selector}').textContent`);
const download = async (name) => {
  const folder = join(ZSTRIP_WORK, 'downloads');
  await browser.call('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: folder});
  await browser.click(`[data-file="${name}"]`);
  const path = join(folder, name);
  for (let i = 0; i < 500 && !(existsSync(path) && statSync(path).size > 0); ++i) {
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  return readFileSync(path);
};

test('the first picture is the command\'s', async () => {
  await shows('teapot', ['--size', '200x160']);
  // With an empty cache, from this machine. Not a bound: other things may run here.
  const [{startTime}] = await browser.evaluate(`performance.getEntriesByName('first-picture').map(({startTime}) => ({startTime}))`);
  console.log(`first picture after ${Math.round(startTime)} ms`);
});

async function look(value) {
  await browser.evaluate(`(() => {
    document.body.dataset.state = 'asked';
    const select = document.getElementById('look');
    select.value = '${value}';
    select.dispatchEvent(new Event('change', {bubbles: true}));
  })()`);
  await drawn();
}

test('how often pixels are drawn is shown', async () => {
  await look(3);
  assert.equal(await browser.evaluate(`document.getElementById('look').value`), '3');
  assert.doesNotMatch(await text('#status'), /exclude/);
  await shows('teapot', ['--size', '200x160', '--show', 'overdraw']);
  await look(0);
  await shows('teapot', ['--size', '200x160']);
});

test('settings are those of the command', async () => {
  await set('size', '128x64');
  await drawn();
  await set('format', 'gray4');
  await drawn();
  await set('dither');
  await drawn();
  await shows('teapot', ['--size', '128x64', '--format', 'gray4', '--dither']);
  await set('depth-format', 'float');
  await drawn();
  await shows('teapot', ['--size', '128x64', '--format', 'gray4', '--dither', '--depth-format', 'float']);
});

// Nothing of a scene that was drawn before stays under a name or settings that failed.
async function isCleared() {
  const left = await browser.evaluate(`({
    rows: document.querySelectorAll('tbody tr').length,
    command: document.getElementById('command').textContent,
    leftOut: document.getElementById('left-out').textContent,
    downloads: document.querySelectorAll('[data-file]:enabled').length,
  })`);
  assert.deepEqual(left, {rows: 0, command: '', leftOut: '', downloads: 0});
  assert.ok((await canvas()).rgb.every((byte) => byte === 0));
}

test('a value that is wrong is said beside its setting in the words of the page, and nothing old stays', async () => {
  for (const [name, value, words] of [
    ['ram', '1K', /bytes missing/],
    ['ram', 'lots', /“RAM at most” 'lots' must be a number of bytes .* for example .*20K/],
    ['size', '240', /“Size” '240' must be WIDTHxHEIGHT.* for example 320x240/],
    ['strip-rows', 'some', /“Rows of a strip” 'some' must be a number of rows/],
    ['frames', 'all', /“Frames”.*1.*10000/],
  ]) {
    await set(name, value);
    await drawn('failed');
    assert.match(await text('#status'), words);
    assert.doesNotMatch(await text('#status'), /--/);
    assert.match(await text(`#refused-${name}`), words);
    assert.equal(await browser.evaluate(`document.querySelectorAll('[aria-invalid]').length`), 1);
    await isCleared();
    // Nothing is open: turning what is not there changes nothing.
    await browser.drag('#canvas', 40, 0);
    assert.match(await text('#status'), words);
    await screenshots(`refused-${name}-${value}`);
    await set(name, name === 'size' ? '128x64' : '');
    await drawn();
    assert.equal(await browser.evaluate(`document.querySelectorAll('[aria-invalid], .refused').length`), 0);
  }
  assert.equal(await browser.evaluate(`document.querySelectorAll('[data-file]:disabled').length`), 0);
});

const shownLabel = (name) => browser.evaluate(`(() => {
  const control = document.getElementById('setting-${name}');
  return control.selectedOptions ? control.selectedOptions[0].textContent : control.placeholder;
})()`);

test('a default is named by its value, which is that of the scene', async () => {
  await set('format', '');
  await drawn();
  assert.deepEqual(await Promise.all(['format', 'samples', 'depth-format', 'strip-rows', 'ram', 'background'].map(shownLabel)),
    ['rgb565 (default)', '1 (default)', 'float', 'auto (default)', '24K, or what it needs (default)', '']);
  await set('depth-format', '');  // the scenes of the gallery smooth edges, which float cannot
  await drawn();
  await choose('gallery/lighthouse.toml');
  assert.deepEqual(await Promise.all(['format', 'samples', 'light'].map(shownLabel)),
    ['rgb565_swapped (default)', '1 (default)', 'as the text says']);
  await choose('teapot');
  await set('format', 'gray4');
  await drawn();
});

test('a scene that needs more memory than was asked for gets it when it is chosen', async () => {
  await choose('fog.toml');
  await set('ram', '6K');
  await drawn();
  await choose('teapot');
  assert.match(await text('#messages'), /“RAM at most” 6K is too little for this scene/);
  assert.equal(await browser.evaluate(`document.getElementById('setting-ram').value`), '');
  await set('depth-format', 'float');
  await drawn();
});

test('a scene that cannot be drawn leaves nothing of the one before', async () => {
  const broken = join(ZSTRIP_WORK, 'broken.glb');
  writeFileSync(broken, 'glTF, or not');
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.drop('#drop', [broken]);
  await drawn('failed');
  assert.match(await text('#status'), /broken\.glb/);
  await isCleared();
  await screenshots('broken');
  await choose('teapot');
});

test('a heat map shows how different the picture is from the truth', async () => {
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.click('#reset');
  await drawn();
  await look(4);
  const options = ['--size', '128x64', '--format', 'gray4', '--dither', '--depth-format', 'float'];
  await shows('teapot', [...options, '--show', 'accuracy']);
  const {worst, worst_x, worst_y, seen_percent} = command.compares('teapot', options);
  assert.ok((await text('#accuracy-figures')).includes(`${worst.toPrecision(3)} at ${worst_x}, ${worst_y}`));
  assert.ok((await text('#accuracy-figures')).includes(`${seen_percent.toFixed(1)} %`));
  const colours = await browser.evaluate(`[...document.querySelectorAll('#accuracy-key li span')].map(
    (each) => getComputedStyle(each).backgroundColor)`);
  assert.equal(colours[0], 'rgb(0, 0, 0)');
  assert.equal(new Set(colours).size, 6);
  await screenshots('accuracy');
  await look(0);
  assert.equal(await browser.evaluate(`document.getElementById('accuracy').hidden`), true);
  await shows('teapot', options);
});

test('the link holds settings and view', async () => {
  await browser.call('Page.navigate', {url: `${address}#scene=gallery/robot.toml&size=160x120&frame=8&yaw=30`});
  await browser.evaluate(`document.body.dataset.state = 'old'`);
  await browser.call('Page.reload');
  await drawn();
  assert.match(await text('#status'), /160x120, frame 9 of/);
  await browser.until(`location.hash.includes('frame=8')`, kPatience, 'the link has no frame');
  const link = await browser.evaluate('location.hash');
  const before = await canvas();
  await browser.drag('#canvas', 40, 0);
  await browser.until(`location.hash.includes('yaw=46')`, kPatience, 'the drag turns nothing');
  await drawn();
  assert.notDeepEqual((await canvas()).rgb, before.rgb);
  await browser.evaluate(`document.body.dataset.state = 'asked', location.hash = ${JSON.stringify(link)}`);
  await drawn();
  assert.ok((await canvas()).rgb.equals(before.rgb));
});

test('a click on the picture names the part, a drag does not', async () => {
  const before = await browser.evaluate('location.hash');
  await browser.call('Page.navigate', {url: `${address}#scene=gallery/train.toml&size=160x120&frames=1&frame=0`});
  await browser.evaluate(`document.body.dataset.state = 'old'`);
  await browser.call('Page.reload');
  await drawn();
  assert.equal(await text('#picked'), '');
  const options = ['--size', '160x120', '--frames', '1'];
  const {width, height} = await browser.evaluate(`(({clientWidth: width, clientHeight: height}) => ({width, height}))(
    document.getElementById('canvas'))`);
  const scale = Math.min(width / 160, height / 120);
  for (const [x, y] of [[3, 3], [40, 90], [80, 60]]) {
    await browser.click('#canvas', (x - 79.5) * scale, (y - 59.5) * scale);
    await browser.until(`document.getElementById('picked').textContent.startsWith('${x},${y}: ')`, kPatience,
      'the click names nothing');
    assert.equal(await text('#picked'), command.picks('gallery/train.toml', x, y, options));
  }
  const named = await text('#picked');
  await screenshots('picked');
  // Beside the picture, and a drag.
  if (width / 160 > scale + 0.1) await browser.click('#canvas', 4 - width / 2, 0);
  await browser.drag('#canvas', 40, 0);
  await drawn();
  assert.equal(await text('#picked'), named);
  await browser.evaluate(`document.body.dataset.state = 'asked', location.hash = ${JSON.stringify(before)}`);
  await drawn();
  assert.equal(await text('#picked'), '');
});

// As keys do, but all at once.
async function write(toml) {
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.click('#text');
  await browser.evaluate(`document.getElementById('text').select()`);
  await browser.type(toml);
}
const textOfScene = () => browser.evaluate(`document.getElementById('text').value`);

test('the text of a scene is drawn while it is edited, and what is wrong is said with its line', async () => {
  await set('frames', '1');
  await drawn();
  await browser.click('#reset');
  await drawn();
  const original = await textOfScene();
  const edited = original.replace(/^background = .*$/m, 'background = "#204060"');
  assert.notEqual(edited, original);
  await write(edited);
  await drawn();
  const file = join(ZSTRIP_PAGE, 'examples/gallery/edited.toml');
  writeFileSync(file, edited);
  await shows('gallery/edited.toml', ['--size', '160x120']);
  const before = await canvas();
  await write(`${edited}[camera\n`);
  await drawn('failed');
  const line = edited.split('\n').length;
  assert.match(await text('#text-error'), new RegExp(`^Line ${line}: `));
  assert.ok((await canvas()).rgb.equals(before.rgb), 'the last good picture stays');
  assert.equal(await browser.evaluate(`document.querySelectorAll('[data-file]:enabled').length`), 0);
  await screenshots('text');
  await write(edited);
  await drawn();
  assert.equal(await browser.evaluate(`document.getElementById('text-error').hidden`), true);
  // By its control; the text has it, too.
  await set('background', '#406020');
  await drawn();
  assert.match(await textOfScene(), /^background = "#406020"$/m);
  writeFileSync(file, await textOfScene());
  await shows('gallery/edited.toml', ['--size', '160x120']);
  // A link brings the text to another page.
  await browser.until(`new Promise((resolve) => {
    const {hash} = location;  // at rest
    setTimeout(() => resolve(hash.includes('files=') && location.hash === hash), 1000);
  })`, kPatience, 'the text is not in the link');
  const shown = await canvas();
  await browser.evaluate(`document.body.dataset.state = 'old'`);
  await browser.call('Page.reload');
  await drawn();
  assert.match(await textOfScene(), /^background = "#406020"$/m);
  assert.ok((await canvas()).rgb.equals(shown.rgb));
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.click('#original');
  await drawn();
  assert.equal(await textOfScene(), original);
  await browser.until(`!location.hash.includes('files=')`, kPatience, 'the link has the text that is gone');
  rmSync(file);
  await set('frames', '');
  await drawn();
});

test('of what has no truth the colours stay, and why is said', async () => {
  const before = await canvas();
  await look(4);
  assert.match(await text('#messages'), /no truth can be drawn/);
  assert.equal(await browser.evaluate(`document.getElementById('look').value`), '0');
  assert.ok((await canvas()).rgb.equals(before.rgb));
});

test('keys turn the scene', async () => {
  await browser.evaluate(`document.getElementById('canvas').focus()`);
  await browser.press('ArrowRight', 39);
  await browser.until(`location.hash.includes('yaw=5')`, kPatience, 'the key turns nothing');
});

test('a dropped figure plays the animation that is named', async () => {
  const figure = fileURLToPath(new URL('../../host-sim/scenes/figure/figure.gltf', import.meta.url));
  await set('frames', '1');
  await drawn();
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.drop('#drop', [figure]);
  await drawn();
  await shows(figure, ['--size', '160x120']);
  await set('animation', 'wave');
  await drawn();
  await shows(figure, ['--size', '160x120', '--animation', 'wave']);
  await set('animation', 'run');
  await drawn('failed');
  assert.match(await text('#status'), /no animation 'run' in the file; it has 'walk', 'wave'/);
  for (const name of ['animation', 'frames']) {
    await set(name, '');
    await drawn();
  }
});

test('dropped files are drawn, with those beside them', async () => {
  await set('frames', '1');
  await drawn();
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  const models = join(ZSTRIP_PAGE, 'examples/models');
  await browser.drop('#drop', ['floor.obj', 'floor.mtl', 'tiles.png'].map((name) => join(models, name)));
  await drawn();
  await shows('models/floor.obj', ['--size', '160x120']);
  await set('background', '#102030');
  await drawn();
  await set('light', '-1,0.5,0.5');
  await drawn();
  await shows('models/floor.obj', ['--size', '160x120', '--background', '102030', '--light=-1,0.5,0.5']);
  await browser.click('#reset-background');
  await set('light', '');
  await drawn();
  await browser.until(`document.getElementById('link-files').textContent.startsWith('The link contains 3 files')`, kPatience,
    'the link has not the files');
});

test('the page writes a scene file for a dropped model', async () => {
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.click('#begin');
  await drawn();
  assert.match(await text('#status'), /160x120, frame 1 of 1/);
  assert.match(await textOfScene(), /^file = "floor.obj"$/m);
  await browser.until(`document.getElementById('link-files').textContent.startsWith('The link contains 4 files')`, kPatience,
    'the link has not the files');
  const file = join(ZSTRIP_PAGE, 'examples/models/written.toml');
  writeFileSync(file, await textOfScene());
  await shows('models/written.toml', ['--size', '160x120']);
  rmSync(file);
  const models = join(ZSTRIP_PAGE, 'examples/models');
  await browser.evaluate(`document.body.dataset.state = 'asked'`);
  await browser.drop('#drop', ['floor.obj', 'floor.mtl', 'tiles.png'].map((name) => join(models, name)));
  await drawn();
});

test('each kind of file that is read is named where files are dropped', async () => {
  const {kScenes} = await import(join(ZSTRIP_PAGE, 'files.mjs'));
  for (const ending of kScenes) assert.ok((await text('#drop')).includes(ending), ending);
});

test('downloads are the command\'s files', async () => {
  assert.ok((await download('picture.png')).equals(command.writes('render', 'models/floor.obj', 'p.png', ['--size', '160x120'])));
  for (const name of ['scene.zsc', 'scene.hpp', 'scene.ino', 'main.cpp']) {
    const expected = command.writes('bake', 'models/floor.obj', name, ['--size', '160x120', '--turntable']);
    // The header names the file that it was made of.
    const strip = (bytes) => bytes.toString('latin1').replaceAll('models/floor.obj', 'floor.obj');
    assert.equal(strip(await download(name)), strip(expected), name);
  }
});

test('the sketch is one zip file with its folder, and a picture has all frames', async () => {
  await download('scene.zip');
  const folder = join(ZSTRIP_WORK, 'downloads');
  execFileSync('cmake', ['-E', 'tar', 'xf', 'scene.zip'], {cwd: folder});
  for (const name of ['scene.ino', 'scene.hpp']) {
    assert.ok(readFileSync(join(folder, 'scene', name)).equals(readFileSync(join(folder, name))), name);
  }
  const expected = command.writes('render', 'models/floor.obj', 'turn.apng', ['--size', '160x120', '--frames', '1']);
  assert.ok((await download('turn.apng')).equals(expected));
});

test('files for the Picos are of the boot loaders\' kind', async () => {
  const {programs} = JSON.parse(readFileSync(join(ZSTRIP_PAGE, 'contents.json'), 'utf8'));
  for (const [board, family] of [['pico', 0xe48bff56], ['pico2', 0xe48bff59]]) {
    await browser.evaluate(`(() => {
      const select = document.querySelector('#pico');
      select.value = '${board}';
      select.dispatchEvent(new Event('change', {bubbles: true}));
    })()`);
    assert.equal(await text('#pico-program'), `zstrip_${board}_player.uf2`);
    assert.equal((await text('#command')).includes('--board pico2'), board === 'pico2');
    const hasProgram = programs.includes(board);
    assert.equal(await browser.evaluate(`document.querySelector('[data-file="both.uf2"]').hidden`), !hasProgram);
    for (const name of ['scene.uf2', ...(hasProgram ? ['both.uf2'] : [])]) {
      const file = await download(name);
      assert.equal(file.toString('latin1', 0, 4), 'UF2\n', name);
      assert.equal(file.length % 512, 0, name);
      for (let at = 0; at < file.length; at += 512) assert.equal(file.readUInt32LE(at + 28), family, name);
      // The other board's file has the name, too.
      rmSync(join(ZSTRIP_WORK, 'downloads', name));
    }
  }
});

const kWidths = [360, 800, 1400];
const resize = (width) =>
  browser.call('Emulation.setDeviceMetricsOverride', {width, height: 900, deviceScaleFactor: 1, mobile: width < 500});

// For people, of the whole page.
async function screenshots(name) {
  if (!ZSTRIP_SCREENSHOTS) return;
  for (const width of kWidths) {
    await resize(width);
    for (const scheme of ['light', 'dark']) {
      await browser.call('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: scheme}]});
      const {data} = await browser.call('Page.captureScreenshot', {format: 'png', captureBeyondViewport: true});
      writeFileSync(join(ZSTRIP_WORK, `${name}-${width}-${scheme}.png`), Buffer.from(data, 'base64'));
    }
  }
}

test('the page opens on the lighthouse, which plays in 22 KB, and the picture stays in sight', async () => {
  await browser.call('Page.navigate', {url: 'about:blank'});
  await browser.call('Page.navigate', {url: address});
  await browser.until(`document.body?.dataset.state === 'drawn'`, kPatience, 'nothing is drawn');
  const frame = await browser.evaluate(`document.getElementById('frame-number').value`);
  await browser.until(`document.getElementById('frame-number').value !== '${frame}'`, kPatience, 'it does not play');
  assert.equal(await shownLabel('board'), 'Raspberry Pi Pico');
  assert.match(await text('#headline'), /2[012] KB of RAM.*frames\/s.*on Raspberry Pi Pico/s);
  await browser.until(`location.hash.includes('board=pico')`, kPatience, 'the link has no board');
  assert.doesNotMatch(await browser.evaluate('location.hash'), /frame=/);
  await browser.click('#whole');
  await browser.until(`document.fullscreenElement?.id === 'stage'`, kPatience, 'the picture does not fill the screen');
  await browser.evaluate('document.exitFullscreen()');
  for (const width of kWidths) {
    await resize(width);
    const {top, bottom, height} = await browser.evaluate(`(() => {
      scrollTo(0, document.body.scrollHeight / 2);
      const {top, bottom} = document.getElementById('canvas').getBoundingClientRect();
      return {top, bottom, height: innerHeight};
    })()`);
    assert.ok(top >= 0 && bottom <= height, `${width}: the picture is at ${top} to ${bottom}`);
  }
  // What went wrong with a file stays said while frames pass.
  await choose('perspective.toml');
  await browser.click('[data-file="scene.uf2"]');
  const said = `/leave 'perspective' out of the scene file/.test(document.getElementById('saved').textContent)`;
  await browser.until(said, kPatience, 'why there is no file is not said');
  const now = await browser.evaluate(`document.getElementById('frame-number').value`);
  await browser.until(`document.getElementById('frame-number').value !== '${now}'`, kPatience, 'it does not play');
  assert.ok(await browser.evaluate(said));
  await browser.click('#play');
});

test('the page is legible in three widths', async () => {
  for (const width of kWidths) {
    await resize(width);
    assert.equal(await browser.evaluate('document.documentElement.scrollWidth'), width, 'it scrolls sideways');
    const unnamed = await browser.evaluate(`[...document.querySelectorAll('input, select, button')].filter(
      (each) => !(each.labels?.length || each.textContent || each.ariaLabel)).map((each) => each.id)`);
    assert.deepEqual(unnamed, [], 'a control has no label');
    const unexplained = `[...document.querySelectorAll('.setting')].filter((row) => !row.querySelector('.tip')?.textContent).length`;
    assert.equal(await browser.evaluate(unexplained), 0, 'a setting has no explanation');
  }
  await screenshots('page');
});

test('nothing went wrong in silence', () => assert.deepEqual(browser.errors, []));
