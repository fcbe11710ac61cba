// The controls of the settings: each names its default by its value, explains itself, and says why it was refused.
import {hasAnimations, isModel, isText, kSettings} from './settings.mjs';

const element = (id) => document.getElementById(id);
const controlOf = (name) => element(`setting-${name}`);
const shortened = (description) => description.split(/[,;]/)[0];

let boards = {};

function labelOf({name, names, none, isOfModels}, choice, value, scene) {
  if (choice === '' && isOfModels && isText(scene)) return 'as the text says';
  if (choice !== '') return names?.[choice] ?? (name === 'board' ? shortened(boards[choice] ?? choice) : choice);
  return none ?? `${names?.[''] ?? value ?? ''} (default)`;
}

function controlFor({name, kind, choices}) {
  const control = document.createElement(kind === 'choice' ? 'select' : 'input');
  control.id = `setting-${name}`;
  control.setAttribute('aria-describedby', `tip-${name}`);
  if (kind === 'choice') for (const choice of choices) control.append(new Option('', choice));
  if (kind !== 'choice') control.type = {flag: 'checkbox', colour: 'color', text: 'text'}[kind];
  return control;
}

// `changed` is called with the name and the value of a setting.
function rowFor(setting, changed) {
  const {name, label, kind, tip} = setting;
  const row = document.createElement('div');
  row.className = 'setting';
  const text = document.createElement('label');
  text.htmlFor = `setting-${name}`;
  text.textContent = label;
  const control = controlFor(setting);
  const help = document.createElement('p');
  help.className = 'tip';
  help.id = `tip-${name}`;
  help.role = 'tooltip';
  help.textContent = tip;
  row.append(text, control);
  if (kind === 'colour') {
    const reset = document.createElement('button');
    reset.type = 'button';
    reset.id = `reset-${name}`;
    reset.textContent = 'Default';
    reset.addEventListener('click', () => changed(name, ''));
    row.append(reset);
  }
  row.append(help);
  control.addEventListener(kind === 'colour' ? 'input' : 'change', () => {
    changed(name, kind === 'flag' ? (control.checked ? 'yes' : 'no') : control.value.trim());
  });
  return row;
}

export function makeSettings(changed) {
  for (const setting of kSettings) element(setting.isRare ? 'rare-settings' : 'settings').append(rowFor(setting, changed));
}

/** `opened`: what the worker says of the scene, or undefined. `background`: of a scene file's text. */
export function showSettings(settings, opened, background) {
  if (opened) ({boards} = opened);
  const defaults = opened?.defaults ?? {};
  const hasLook = isModel(settings.scene) || isText(settings.scene);
  for (const setting of kSettings) {
    const {name, kind, choices, isOfModels, isOfAnimations} = setting;
    const control = controlOf(name), value = settings[name] ?? '';
    if (isOfModels) control.disabled = !hasLook;
    if (isOfAnimations) control.disabled = !hasAnimations(settings.scene);
    if (kind === 'flag') control.checked = value === '' ? Boolean(defaults[name]) : value !== 'no';
    if (kind === 'text') {
      control.value = value;
      control.placeholder = `${defaultOf(name, settings, defaults)} (default)`;
    }
    if (kind === 'colour') {
      control.value = value || background || defaults[name] || '#000000';
      element(`reset-${name}`).hidden = !value;
    }
    if (kind !== 'choice') continue;
    const all = [...new Set([...choices, ...(name === 'board' ? Object.keys(boards) : []), value])];
    control.replaceChildren(...all.map((choice) => new Option(labelOf(setting, choice, defaults[name], settings.scene), choice)));
    control.value = value;
  }
}

function defaultOf(name, {board}, defaults) {
  if (name in defaults) return defaults[name];
  if (name === 'animation') return 'the first';
  if (name !== 'ram') return 'auto';
  return board ? "the board's" : '24K, or what it needs';
}

/** The note beside the setting of this name; undefined: nothing is refused. */
export function showRefused(name, words) {
  for (const note of document.querySelectorAll('.refused')) note.remove();
  for (const {name: each} of kSettings) {
    controlOf(each).removeAttribute('aria-invalid');
    controlOf(each).setAttribute('aria-describedby', `tip-${each}`);
  }
  if (!name) return;
  const note = document.createElement('p');
  note.className = 'refused';
  note.id = `refused-${name}`;
  note.textContent = words;
  const control = controlOf(name);
  control.setAttribute('aria-invalid', 'true');
  control.setAttribute('aria-describedby', `${note.id} tip-${name}`);
  control.parentElement.append(note);
  if (kSettings.find((each) => each.name === name).isRare) element('rare').open = true;
}

export const nameOfBoard = (board) => shortened(boards[board] ?? board);
