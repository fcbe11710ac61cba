// The playground: controls and what is dropped decide what the worker draws, and a link holds them all.
import {call} from './calls.mjs';
import {fileOf, save} from './downloads.mjs';
import {listenToText, markError, showText, shownText} from './editor.mjs';
import {clearFigures, showFigures} from './figures.mjs';
import {chosenFiles, droppedFiles, kScenes, sceneAmong} from './files.mjs';
import {kMaxPacked, pack, unpack} from './packed_files.mjs';
import {clearPicture, hasArrived, showPicture} from './picture.mjs';
import {addOwn, fetchExample, forgetEdits, isEdited, isOwn, ownFilesOf, setExamples, textOf} from './scene_files.mjs';
import {backgroundOf, lineOfError, sceneFileOf, withBackground, withLight} from './scene_text.mjs';
import {
  bakeWordsOf, commandLineOf, isModel, isText, kPicoPrograms, kStartView, linkOf, optionsOf, settingsOf
} from './settings.mjs';
import {makeSettings, showRefused, showSettings} from './settings_form.mjs';
import {listenToSteering} from './steering.mjs';
import {makeThumbnails, showChosen} from './thumbnails.mjs';
import {inWordsOfPage, settingOf} from './words.mjs';

const kLinkPause = 400;  // milliseconds
const kInternalError = 1, kTooLittleMemory = 5;  // exit statuses of the command

// A mark on the page's time line.
const kFirstPicture = 'first-picture';

const element = (id) => document.getElementById(id);

let settings, view, playing;
let opened;   // the answer of the worker about the scene
let drawn;    // by the worker, and its figures
let figures;
let isOpen = false;
let isNew = true;     // the scene has just been chosen: it may have more memory than was asked for
let isTyped = false;  // the text has just been edited: if it is wrong, the picture before stays
let programs = [];    // the boards whose program the page has
let packed = {};      // files in the link

// ---- messages ----
function say(text, messages = []) {
  element('status').ariaLive = playing ? 'off' : 'polite';  // not each frame
  element('status').textContent = inWordsOfPage(text);
  element('status').classList.remove('failed');
  element('messages').replaceChildren(...[...new Set(messages)].map((message) => {
    const item = document.createElement('li');
    item.textContent = inWordsOfPage(message);
    return item;
  }));
  showRefused();
  markError();
}

// Shows the error, also next to the setting or the line that it is about.
function fail(error) {
  say(error.message, (error.messages ?? []).filter((message) => message !== error.message));
  element('status').classList.add('failed');
  document.body.dataset.state = 'failed';
  showRefused(settingOf(error.message), inWordsOfPage(error.message));
  markError(lineOfError(error.message, settings.scene));
}

// ---- drawing ----
// One request is served at a time; of the requests that come meanwhile only the last one counts.
let busy = false;
let wanted;
async function update(what) {
  if (what === 'draw' && !isOpen) return;  // the message of the error stays
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
    if (isTyped && error.status !== kInternalError) {
      setDownloads(false);
    } else {
      clear();
    }
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
  isOpen = isTyped && isOpen;
  setDownloads(false);
  element('picked').textContent = '';
  if (!isTyped) say('Loading …');
  await fetchExample(settings.scene);
  await open();
  markError();
  await drawInEnoughMemory();
  isNew = isTyped = false;
  showControls();
}

// A scene that has just been chosen gets the memory that it needs.
async function drawInEnoughMemory() {
  try {
    await draw();
  } catch (error) {
    if (!isNew || error.status !== kTooLittleMemory || !settings.ram) throw error;
    const words = `“RAM at most” ${settings.ram} is too little for this scene, which gets as much as it needs`;
    settings.ram = '';
    await open();
    messages = [...messages, words];
    await draw();
  }
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

function show() {
  showPicture(drawn, element('borders').checked, Boolean(view.slow));
}

async function draw() {
  let refused;
  ({drawn, refused} = await drawnOrColours());
  figures = drawn.figures;
  show();
  if (performance.getEntriesByName(kFirstPicture).length === 0) performance.mark(kFirstPicture);
  if (element('text-error').hidden) {
    say(`${figures.width}x${figures.height}, frame ${figures.frame + 1} of ${opened.frames}, ` +
        `drawn in ${figures.strips.length || 'rotated'} ${figures.strips.length === 1 ? 'strip' : 'strips'}`,
        [...refused, ...messages, ...figures.messages]);
    setDownloads(true);
  }
  tell();
}

// Clears the page, so that it does not show the last scene under the name of the one that failed.
function clear() {
  isOpen = false;
  drawn = figures = undefined;
  clearPicture();
  clearFigures();
  element('command').textContent = '';
  setDownloads(false);
  showControls();
}

function setDownloads(on) {
  for (const button of document.querySelectorAll('[data-file]')) button.disabled = !on;
}

const kCommands = ['scene.hpp', 'scene.ino', 'main.cpp', 'scene.uf2'];
function tell() {
  showFigures(figures, settings.board, Boolean(view.slow));
  element('command').textContent = [
    ['view', settings.scene, ...optionsOf(settings)],
    ...kCommands.map((name) => bakeWordsOf(settings, name, element('pico').value)),
  ].map(commandLineOf).join('\n');
}

// ---- the link ----
// Browsers refuse frequent changes of the address, so it is changed after a delay.
let linking = 0;
function showLink() {
  linking ||= setTimeout(putLink, kLinkPause);
}

function putLink() {
  clearTimeout(linking);
  linking = 0;
  history.replaceState(null, '', linkOfPage());
  element('link').value = location.href;
  element('link-files').textContent = packed.words ?? '';
}
const linkOfPage = () => linkOf(settings, {...view, frame: playing ? undefined : view.frame}, packed.files);

// Packs the user's own files for the link.
async function packOwn() {
  const own = ownFilesOf(settings.scene);
  packed = {};
  if (own.length === 0) return showLink();
  const files = await pack(own);
  const names = own.length === 1 ? own[0].path : `${own.length} files`;
  const size = `${(files.length / 1024).toFixed(1)} KB packed`;
  packed = files.length <= kMaxPacked ?
    {files, words: `The link contains ${names}: ${size}.`} :
    {words: `The link does not contain ${names}: ${size}, and a link has at most ${kMaxPacked / 1024} KB.`};
  showLink();
}

// ---- scenes ----
async function addFiles(reading) {
  try {
    const files = await reading;
    if (files.length === 0) return;
    const scene = sceneAmong(files);
    if (!scene) throw new Error(`none of these files is a scene: ${kScenes.join(' ')}`);
    await addOwn(files);
    choose(scene);
  } catch (error) {
    setPlaying(false);  // the next frame would have other words
    fail(error);
  }
}

function choose(scene) {
  settings = {...settings, scene, background: '', light: '', animation: ''};
  view = {...kStartView, slow: view.slow};
  isNew = true;
  isTyped = false;
  showControls();
  update('open');
  packOwn();
}

async function edit(text) {
  isTyped = true;
  await addOwn([{path: settings.scene, bytes: new TextEncoder().encode(text)}], false);
  update('open');
  packOwn();
}

// A scene file for a model of the user.
async function begin() {
  const path = settings.scene.replace(/\.[^.]*$/, '.toml');
  await addOwn([{path, bytes: new TextEncoder().encode(sceneFileOf(settings.scene))}], false);
  choose(path);
}

async function restore() {
  await forgetEdits(settings.scene);
  showControls();
  update('open');
  packOwn();
}

// Sets all controls to the settings, the view and the text.
function showControls() {
  const text = isText(settings.scene) ? textOf(settings.scene) : undefined;
  showChosen(settings.scene);
  showSettings(settings, opened, text && backgroundOf(text));
  showText(text, isEdited(settings.scene), isModel(settings.scene) && isOwn(settings.scene));
  element('look').value = view.look;
  element('slow').checked = view.slow;
  element('frame-number').value = view.frame;
}

// Background and light of a scene file are changed in its text.
const kInText = {background: withBackground, light: withLight};

function change(name, value) {
  if (name in kInText && isText(settings.scene)) {
    if (value) edit(kInText[name](textOf(settings.scene), value));
    return;
  }
  settings[name] = value;
  isNew = isTyped = false;
  update('open');
}

// ---- playing ----
function setPlaying(on) {
  playing = on;
  element('play').setAttribute('aria-pressed', String(on));
  element('play').textContent = on ? 'Stop' : 'Play';
  stepped = 0;
  if (on) requestAnimationFrame(play);
}

let stepped = 0;
function play(now) {
  if (!playing) return;
  requestAnimationFrame(play);
  if (busy || !isOpen || !hasArrived()) return;
  const duration = opened.milliseconds / opened.frames;
  if (now - stepped < duration - 1) return;
  const frames = stepped === 0 ? 1 : Math.max(1, Math.round((now - stepped) / duration));
  view.frame = (view.frame + frames) % opened.frames;
  element('frame-number').value = view.frame;
  stepped = now;
  update('draw');
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

// Says what a pixel shows, as `zstrip view` does.
async function pick(x, y) {
  if (!isOpen) return;
  const words = await call('pick', {x, y}).catch((error) => error.message);
  element('picked').textContent = `${x},${y}: ${inWordsOfPage(words)}`;
}

// ---- controls ----
function listen() {
  listenToSteering(turn, zoom, pick);
  listenToText(() => edit(shownText()), restore, begin);
  for (const form of document.forms) form.addEventListener('submit', (event) => event.preventDefault());
  element('frame-number').addEventListener('input', ({target}) => {
    setPlaying(false);
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
  element('borders').addEventListener('change', () => drawn && show());
  element('slow').addEventListener('change', ({target}) => {
    view.slow = Number(target.checked);
    update('draw');
  });
  element('play').addEventListener('click', () => {
    setPlaying(!playing);
    showLink();
  });
  element('reset').addEventListener('click', () => {
    Object.assign(view, {yaw: 0, pitch: 0, zoom: 0});
    update('draw');
  });
  element('whole').addEventListener('click', () =>
    document.fullscreenElement ? document.exitFullscreen() : element('stage').requestFullscreen());
  element('files').addEventListener('change', ({target}) => addFiles(chosenFiles(target)));
  element('copy').addEventListener('click', () => {
    putLink();
    navigator.clipboard.writeText(location.href);
  });
  for (const name of ['dragover', 'dragleave', 'drop']) {
    document.addEventListener(name, (event) => {
      event.preventDefault();
      element('drop').classList.toggle('over', name === 'dragover');
    });
  }
  document.addEventListener('drop', ({dataTransfer}) => addFiles(droppedFiles(dataTransfer)));
  document.addEventListener('click', ({target}) => target.dataset?.file && download(target.dataset.file));
  window.addEventListener('hashchange', ({newURL}) => openLink(new URL(newURL).hash).catch(fail));
}

// Writes to an element for files, because the message about the picture changes with each frame.
function sayOfFile(words, isWrong = false) {
  element('saved').textContent = inWordsOfPage(words);
  element('saved').classList.toggle('failed', isWrong);
}

async function download(name) {
  try {
    sayOfFile(`${name}: being made …`);
    const {bytes, messages} = await fileOf(name, settings, opened.frames, element('pico').value);
    save(bytes, name);
    sayOfFile([`${name}: ${bytes.length.toLocaleString('en')} bytes`, ...messages].join('; '));
  } catch (error) {
    sayOfFile(error.message, true);
  }
}

// Describes the board's files, and which of them the page can make.
function showPico() {
  const {value: board, selectedOptions: [{text}]} = element('pico');
  for (const each of document.querySelectorAll('.with-program')) each.hidden = !programs.includes(board);
  element('pico-name').textContent = text;
  element('pico-program').textContent = kPicoPrograms[board];
}

async function openLink(hash) {
  const {plays, files, ...link} = settingsOf(hash);
  ({settings, view} = link);
  setPlaying(plays && !matchMedia('(prefers-reduced-motion: reduce)').matches);
  if (files) await addOwn(await unpack(files));
  isNew = false;
  isTyped = false;
  showControls();
  await Promise.all([update('open'), packOwn()]);
}

async function start() {
  const response = await fetch('contents.json');
  const contents = await response.json();
  setExamples(contents.examples);
  programs = contents.programs;
  showPico();
  const fetchThumbnails = makeThumbnails(contents.examples, choose);
  makeSettings(change);
  listen();
  await openLink(location.hash);
  fetchThumbnails();
}
start().catch(fail);
