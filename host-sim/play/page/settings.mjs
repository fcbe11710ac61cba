// The settings: options of the command, controls of the page, and parts of a link.

// The first choice is the command's own, for which no option is given. `kind`: choice, flag or text;
// `isBaked`: `zstrip bake` has it, too.
export const kSettings = [
  {name: 'size', label: 'Size', option: '--size', isBaked: true, kind: 'text', hint: '240x240'},
  {
    name: 'format',
    label: 'Pixels',
    option: '--format', isBaked: true,
    kind: 'choice',
    choices: ['', 'rgb565', 'rgb565_swapped', 'rgb666', 'rgb444', 'xrgb8888', 'gray4', 'mono']
  },
  {name: 'dither', label: 'Dithering', option: '--dither', isBaked: true, kind: 'flag'},
  {name: 'ram', label: 'RAM at most', option: '--ram', isBaked: true, kind: 'text', hint: '20K or 1M'},
  {name: 'strip-rows', label: 'Rows of a strip', option: '--strip-rows', isBaked: true, kind: 'text', hint: 'auto'},
  {name: 'samples', label: 'Samples a pixel', option: '--samples', isBaked: true, kind: 'choice', choices: ['', '2', '4']},
  {name: 'edges', label: 'Smooth edges', option: '--edges', isBaked: true, kind: 'flag'},
  {
    name: 'depth-format',
    label: 'Depth',
    option: '--depth-format',
    kind: 'choice',
    choices: ['', 'float', 'z24']
  },
  {name: 'perspective', label: 'Textures exact every', option: '--perspective', kind: 'choice', choices: ['', '1', '8', 'affine']},
  {
    name: 'panel',
    label: 'Panel',
    option: '--panel',
    kind: 'choice',
    choices: ['', 'st7789', 'ili9341', 'st7735', 'ssd1351', 'ssd1306', 'ssd0323']
  },
  {name: 'rotation', label: 'Turned on the panel', option: '--rotation', kind: 'choice', choices: ['', '90', '180', '270']},
  {name: 'board', label: 'As fast as', option: '--board', kind: 'choice', choices: ['']},
  {name: 'frames', label: 'Frames', option: '--frames', kind: 'text', hint: '64'},
];

// How it is looked at, which the scene need not be read again for: `look` as zstrip_look has it.
export const kLooks = ['colours', 'wireframe', 'depth', 'overdraw', 'accuracy'];
export const kStartView = {look: 0, frame: 0, yaw: 0, pitch: 0, zoom: 0};
const kStart = {scene: 'teapot', size: '240x240'};

// The file for a Pico that has the program that shows it, too, and that program's file by the board's name.
const kBoth = 'both.uf2';
export const kPicoPrograms = {pico: 'zstrip_pico_player.uf2', pico2: 'zstrip_pico2_player.uf2'};

const isDigitsOf = (value) => /^-?[0-9]+(\.[0-9]+)?$/.test(value);

// The options of `zstrip view`; with `command` 'bake' those that `zstrip bake` has.
export function optionsOf(settings, command = 'view') {
  const options = [];
  for (const {name, option, kind, isBaked} of kSettings) {
    if (!settings[name] || (command === 'bake' && !isBaked)) continue;
    options.push(option);
    if (kind !== 'flag') options.push(settings[name]);
  }
  return options;
}

// The words after `zstrip` that write the file `name`; `pico`: the board that a .uf2 file is for. Its panel and memory are
// the command's own, not settings.
export function bakeWordsOf(settings, name, pico = 'pico') {
  const words = ['bake', settings.scene, '-o', name];
  if (!name.endsWith('.uf2')) return [...words, '--turntable', ...optionsOf(settings, 'bake')];
  if (pico !== 'pico') words.push('--board', pico);
  if (name === kBoth) words.push('--with', kPicoPrograms[pico]);
  return [...words, ...optionsOf({...settings, size: '', format: '', ram: '', 'strip-rows': ''}, 'bake')];
}

// For a shell.
export function commandLineOf(words) {
  return ['zstrip', ...words].map((word) => (/^[\w.,:=+/-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`)).join(' ');
}

// Returns the part of a link after its #; settings and view that are as at the start are left out.
export function linkOf(settings, view) {
  const pairs = [['scene', settings.scene ?? '']];
  for (const {name} of kSettings) {
    if ((settings[name] ?? '') !== (kStart[name] ?? '')) pairs.push([name, settings[name] ?? '']);
  }
  for (const [name, start] of Object.entries(kStartView)) {
    if (view[name] !== start) pairs.push([name, String(Math.round(view[name] * 100) / 100)]);
  }
  return '#' + new URLSearchParams(pairs);
}

// Whatever a link has that is not known is left out; the command judges values.
export function settingsOf(link) {
  const given = new URLSearchParams(link.replace(/^#/, ''));
  const settings = {...kStart};
  const view = {...kStartView};
  if (given.get('scene')) settings.scene = given.get('scene');
  for (const {name} of kSettings) {
    if (given.has(name)) settings[name] = given.get(name);
  }
  for (const name of Object.keys(view)) {
    const value = given.get(name);
    if (value !== null && isDigitsOf(value)) view[name] = Number(value);
  }
  if (!(view.look in kLooks)) view.look = 0;
  view.frame = Math.max(0, Math.floor(view.frame));
  return {settings, view};
}
