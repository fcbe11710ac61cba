// The playground: controls and what is dropped decide what the worker draws, and a link holds them all.
import {call} from './calls.mjs';
import {clearFigures, showFigures} from './figures.mjs';
import {chosenFiles, droppedFiles, sceneAmong, sceneEndings} from './files.mjs';
import {clearPicture, showPicture} from './picture.mjs';
import {
  bakeWordsOf, commandLineOf, kPicoPrograms, kSettings, kStartView, linkOf, optionsOf, settingsOf
} from './settings.mjs';
import {inWordsOfPage, settingOf} from './words.mjs';

const kInternalError = 1;  // exit status of the command
const kDegreesOfPixel = 0.4;
const kDegreesOfKey = 5;

// A mark on the page's time line.
const kFirstPicture = 'first-picture';

const element = (id) => document.getElementById(id);
const canvas = element('canvas');

let {settings, view} = settingsOf(location.hash);
let opened = {frames: 64, milliseconds: 4000};
let drawn;  // by the worker, and its figures
let figures;
let isOpen = false;
let playing = false;
let examples = [];
let programs = [];  // the boards whose program the page has

// ---- what is said ----
function say(text, messages = []) {
  element('status').textContent = inWordsOfPage(text);
  element('status').classList.remove('failed');
  element('messages').replaceChildren(...[...new Set(messages)].map((message) => {
    const item = document.createElement('li');
    item.textContent = inWordsOfPage(message);
    return item;
  }));
  for (const note of document.querySelectorAll('#settings .refused')) note.remove();
  for (const control of element('settings').elements) {
    for (const name of ['aria-invalid', 'aria-describedby']) control.removeAttribute(name);
  }
}

// Beside the setting that it speaks of, too.
function fail(error) {
  say(error.message, (error.messages ?? []).filter((message) => message !== error.message));
  element('status').classList.add('failed');
  document.body.dataset.state = 'failed';
  const name = settingOf(error.message);
  if (!name) return;
  const control = element(`setting-${name}`);
  const note = document.createElement('p');
  note.className = 'refused';
  note.id = `refused-${name}`;
  note.textContent = inWordsOfPage(error.message);
  control.setAttribute('aria-invalid', 'true');
  control.setAttribute('aria-describedby', note.id);
  control.after(note);
}

// ---- drawing ----
// One thing after the other; of what is asked for meanwhile only the last counts.
let busy = false;
let wanted;
async function update(what) {
  if (what === 'draw' && !isOpen) return;  // what went wrong stays said
  wanted = wanted === 'open' ? 'open' : what;
  if (busy) return;
  busy = true;
  document.body.dataset.state = 'drawing';
  try {
    while (wanted) {
      const now = wanted;
      wanted = undefined;
      await (now === 'open' ? openAndDraw() : draw());
    }
    document.body.dataset.state = 'drawn';
  } catch (error) {
    wanted = undefined;
    setPlaying(false);
    clear();
    fail(error);
  }
  showLink();
  busy = false;
}

let messages = [];
async function open() {
  opened = await call('open', {scene: settings.scene, options: optionsOf(settings)});
  isOpen = true;
  messages = opened.messages;
  element('frame-number').max = opened.frames - 1;
  view.frame = Math.min(view.frame, opened.frames - 1);
}

async function openAndDraw() {
  isOpen = false;
  setDownloads(false);
  say('Loading …');
  await fetchExample();
  await open();
  await draw();
}

// A scene that cannot be drawn in this look gets its colours, and the reason.
async function drawnOrColours() {
  try {
    return {drawn: await call('draw', view), refused: []};
  } catch (error) {
    if (view.look === 0) throw error;
    view.look = 0;
    element('look').value = 0;
    if (error.status === kInternalError) await open();  // the module may have been started again
    return {drawn: await call('draw', view), refused: [error.message]};
  }
}

async function draw() {
  let refused;
  ({drawn, refused} = await drawnOrColours());
  figures = drawn.figures;
  showPicture(drawn, element('borders').checked);
  if (performance.getEntriesByName(kFirstPicture).length === 0) performance.mark(kFirstPicture);
  say(`${figures.width}x${figures.height}, frame ${figures.frame + 1} of ${opened.frames}, ` +
      `drawn in ${figures.strips.length || 'turned'} ${figures.strips.length === 1 ? 'strip' : 'strips'}`,
      [...refused, ...messages, ...figures.messages]);
  tell();
  setDownloads(true);
}

// Nothing of the scene before stays under the name of the one that failed.
function clear() {
  drawn = figures = undefined;
  clearPicture();
  clearFigures();
  element('command').textContent = '';
  setDownloads(false);
}

function setDownloads(on) {
  for (const button of element('downloads').children) button.disabled = !on;
}

function showLink() {
  history.replaceState(null, '', linkOf(settings, view));
  element('link').value = location.href;
}

function tell() {
  showFigures(figures);
  const choice = element('setting-board');
  for (const board of Object.keys(figures.rates)) {
    if (![...choice.options].some(({value}) => value === board)) choice.append(new Option(board, board));
  }
  element('command').textContent = [
    ['view', settings.scene, ...optionsOf(settings)],
    ...['scene.hpp', 'scene.ino', 'main.cpp', 'scene.uf2'].map((name) => bakeWordsOf(settings, name, element('pico').value)),
  ].map(commandLineOf).join('\n');
}

// ---- scenes ----
async function fetched(address, path) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${response.status} ${response.statusText}`);
  return {path, bytes: new Uint8Array(await response.arrayBuffer())};
}

// Examples are fetched when they are chosen first.
async function fetchExample() {
  const example = examples.find(({scene}) => scene === settings.scene);
  if (!example || !example.files || example.fetched) return;
  const files = await Promise.all(example.files.map((path) => fetched(`examples/${path}`, path)));
  await call('addFiles', files);
  example.fetched = true;
}

async function addFiles(reading) {
  try {
    const files = await reading;
    if (files.length === 0) return;
    const scene = sceneAmong(files);
    if (!scene) throw new Error(`none of these files is a scene: ${sceneEndings()}`);
    await call('addFiles', files);
    choose(scene);
  } catch (error) {
    fail(error);
  }
}

function choose(scene) {
  settings.scene = scene;
  view = {...kStartView};
  showChoice();
  update('open');
}

function showChoice() {
  const select = element('example');
  if (![...select.options].some(({value}) => value === settings.scene)) {
    select.append(new Option(settings.scene, settings.scene));
  }
  select.value = settings.scene;
  element('look').value = view.look;
  element('frame-number').value = view.frame;
}

// ---- controls ----
function addSetting({name, label, kind, choices, hint}) {
  const text = document.createElement('label');
  text.htmlFor = `setting-${name}`;
  text.textContent = label;
  const control = document.createElement(kind === 'choice' ? 'select' : 'input');
  control.id = `setting-${name}`;
  if (kind === 'choice') {
    for (const choice of choices) control.append(new Option(choice || 'as is', choice));
    if (settings[name] && !choices.includes(settings[name])) control.append(new Option(settings[name], settings[name]));
  }
  if (kind === 'flag') {
    control.type = 'checkbox';
    control.checked = Boolean(settings[name]);
  } else {
    control.value = settings[name] ?? '';
  }
  if (kind === 'text') control.placeholder = hint;
  control.addEventListener('change', () => {
    settings[name] = kind === 'flag' ? (control.checked ? 'yes' : '') : control.value.trim();
    update('open');
  });
  element('settings').append(text, control);
}

function setPlaying(on) {
  playing = on;
  element('play').setAttribute('aria-pressed', String(on));
  element('play').textContent = on ? 'Stop' : 'Play';
  if (on) requestAnimationFrame(play);
}

let stepped = 0;
function play(now) {
  if (!playing) return;
  const duration = opened.milliseconds / opened.frames;
  if (!busy && now - stepped >= duration) {
    const frames = stepped === 0 ? 1 : Math.max(1, Math.round((now - stepped) / duration));
    view.frame = (view.frame + frames) % opened.frames;
    element('frame-number').value = view.frame;
    stepped = now;
    update('draw');
  }
  requestAnimationFrame(play);
}

function turn(yaw, pitch) {
  view.yaw += yaw;
  view.pitch += pitch;
  update('draw');
}
function zoom(steps) {
  view.zoom += steps;
  update('draw');
}

const kKeys = {
  ArrowLeft: () => turn(-kDegreesOfKey, 0),
  ArrowRight: () => turn(kDegreesOfKey, 0),
  ArrowUp: () => turn(0, -kDegreesOfKey),
  ArrowDown: () => turn(0, kDegreesOfKey),
  '+': () => zoom(1),
  '-': () => zoom(-1),
};

function listen() {
  element('settings').addEventListener('submit', (event) => event.preventDefault());
  canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0) turn(event.movementX * kDegreesOfPixel, event.movementY * kDegreesOfPixel);
  });
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(-Math.sign(event.deltaY));
  }, {passive: false});
  canvas.addEventListener('keydown', (event) => {
    if (!(event.key in kKeys)) return;
    event.preventDefault();
    kKeys[event.key]();
  });
  element('frame-number').addEventListener('input', ({target}) => {
    view.frame = Number(target.value);
    update('draw');
  });
  element('look').addEventListener('change', ({target}) => {
    view.look = Number(target.value);
    update('draw');
  });
  element('pico').addEventListener('change', () => {
    showPico();
    if (figures) tell();
  });
  element('borders').addEventListener('change', () => drawn && showPicture(drawn, element('borders').checked));
  element('play').addEventListener('click', () => setPlaying(!playing));
  element('reset').addEventListener('click', () => {
    Object.assign(view, {yaw: 0, pitch: 0, zoom: 0});
    update('draw');
  });
  element('example').addEventListener('change', ({target}) => choose(target.value));
  element('files').addEventListener('change', ({target}) => addFiles(chosenFiles(target)));
  element('copy').addEventListener('click', () => navigator.clipboard.writeText(location.href));
  for (const name of ['dragover', 'dragleave', 'drop']) {
    document.addEventListener(name, (event) => {
      event.preventDefault();
      element('drop').classList.toggle('over', name === 'dragover');
    });
  }
  document.addEventListener('drop', ({dataTransfer}) => addFiles(droppedFiles(dataTransfer)));
  element('downloads').addEventListener('click', ({target}) => target.dataset.file && download(target.dataset.file));
  window.addEventListener('hashchange', () => {
    ({settings, view} = settingsOf(location.hash));
    element('settings').replaceChildren();
    kSettings.forEach(addSetting);
    showChoice();
    update('open');
  });
}

async function download(name) {
  try {
    const {bytes, messages} = name === 'picture.png' ? {bytes: await call('png')} : await baked(name);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    say(`${name}: ${bytes.length.toLocaleString('en')} bytes`, messages);
  } catch (error) {
    fail(error);
  }
}

// Describes the board's files, and which of them the page can make.
function showPico() {
  const {value: board, selectedOptions: [{text}]} = element('pico');
  for (const each of document.querySelectorAll('.with-program')) each.hidden = !programs.includes(board);
  element('pico-name').textContent = text;
  element('pico-program').textContent = kPicoPrograms[board];
}

// Returns the file that `zstrip bake` writes.
async function baked(name) {
  const words = bakeWordsOf(settings, name, element('pico').value);
  const program = kPicoPrograms[element('pico').value];
  if (words.includes(program)) await call('addFiles', [await fetched(program, program)]);
  const {files, messages} = await call('run', {words: [...words, '--quiet'], names: [name]});
  return {bytes: files[0].bytes, messages};
}

async function start() {
  const response = await fetch('contents.json');
  const contents = await response.json();
  examples = contents.examples;
  programs = contents.programs;
  showPico();
  for (const {scene, title} of examples) element('example').append(new Option(title, scene));
  kSettings.forEach(addSetting);
  showChoice();
  listen();
  update('open');
}
start().catch(fail);
